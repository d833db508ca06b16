#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "knit/relax/relax.h"

namespace knit {

namespace {

using Symmetric = std::array<std::array<double, 4>, 4>;

glm::dvec3 centre_of(std::span<const glm::dvec3> places) {
  glm::dvec3 sum(0.0);
  for (const glm::dvec3& place : places) sum += place;
  return sum / static_cast<double>(places.size());
}

// Jacobi's turns, which leave the matrix diagonal and in `axes`, column by column, what each number on it belongs to.
void turn_to_diagonal(Symmetric& m, Symmetric& axes) {
  constexpr int most_sweeps = 32;
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    double off = 0.0;
    for (std::size_t p = 0; p < 4; ++p) {
      for (std::size_t q = p + 1; q < 4; ++q) {
        off += std::abs(m[p][q]);
        if (m[p][q] == 0.0) continue;
        const double theta = (m[q][q] - m[p][p]) / (2.0 * m[p][q]);
        const double t = (theta < 0.0 ? -1.0 : 1.0) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
        const double c = 1.0 / std::sqrt(t * t + 1.0), s = t * c;
        for (std::size_t k = 0; k < 4; ++k) {
          const double kp = m[k][p], kq = m[k][q];
          m[k][p] = c * kp - s * kq;
          m[k][q] = s * kp + c * kq;
        }
        for (std::size_t k = 0; k < 4; ++k) {
          const double pk = m[p][k], qk = m[q][k];
          m[p][k] = c * pk - s * qk;
          m[q][k] = s * pk + c * qk;
        }
        for (auto& row : axes) {
          const double kp = row[p], kq = row[q];
          row[p] = c * kp - s * kq;
          row[q] = s * kp + c * kq;
        }
      }
    }
    if (off == 0.0) break;
  }
}

glm::dmat3 rotation(double w, double x, double y, double z) {
  return {{w * w + x * x - y * y - z * z, 2.0 * (x * y + w * z), 2.0 * (x * z - w * y)},
          {2.0 * (x * y - w * z), w * w - x * x + y * y - z * z, 2.0 * (y * z + w * x)},
          {2.0 * (x * z + w * y), 2.0 * (y * z - w * x), w * w - x * x - y * y + z * z}};
}

}  // namespace

std::vector<glm::dvec3> laid_onto(std::span<const glm::dvec3> places, std::span<const glm::dvec3> onto) {
  if (places.empty()) return {};
  const glm::dvec3 from = centre_of(places), to = centre_of(onto);
  glm::dmat3 s(0.0);  // s[i][j]: sum of a_i b_j
  for (std::size_t i = 0; i < places.size(); ++i) {
    const glm::dvec3 a = places[i] - from, b = onto[i] - to;
    s[0] += a.x * b;
    s[1] += a.y * b;
    s[2] += a.z * b;
  }
  Symmetric n{{{s[0][0] + s[1][1] + s[2][2], s[1][2] - s[2][1], s[2][0] - s[0][2], s[0][1] - s[1][0]},
               {s[1][2] - s[2][1], s[0][0] - s[1][1] - s[2][2], s[0][1] + s[1][0], s[2][0] + s[0][2]},
               {s[2][0] - s[0][2], s[0][1] + s[1][0], s[1][1] - s[0][0] - s[2][2], s[1][2] + s[2][1]},
               {s[0][1] - s[1][0], s[2][0] + s[0][2], s[1][2] + s[2][1], s[2][2] - s[0][0] - s[1][1]}}};
  Symmetric axes{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
  turn_to_diagonal(n, axes);
  std::size_t most = 0;
  for (std::size_t i = 1; i < 4; ++i) {
    if (n[i][i] > n[most][most]) most = i;
  }
  const glm::dmat3 turn = rotation(axes[0][most], axes[1][most], axes[2][most], axes[3][most]);
  std::vector<glm::dvec3> laid;
  laid.reserve(places.size());
  for (const glm::dvec3& place : places) laid.push_back(turn * (place - from) + to);
  return laid;
}

}  // namespace knit
