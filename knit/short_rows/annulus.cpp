#include "knit/short_rows/annulus.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <span>
#include <utility>

#include "knit/short_rows/sides.h"
#include "knit/timing/dissection.h"
#include "knit/timing/elimination.h"

namespace knit {

namespace {

// The lower half of the Laplacian, in the order of elimination.
struct Laplacian {
  std::vector<int> unknown;  // of each point
  std::vector<int> first, row;
  std::vector<double> value;
  [[nodiscard]] std::size_t size() const { return first.size() - 1; }
};

struct Pin {
  int unknown;
  double value;
};

std::array<double, 3> cotangents_at(const TubePart& part, const Triangle& triangle) {
  std::array<double, 3> cotangents{};
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec3 u = part.points[triangle[(k + 1) % 3]] - part.points[triangle[k]],
                     v = part.points[triangle[(k + 2) % 3]] - part.points[triangle[k]];
    const double scale = std::sqrt(glm::dot(u, u) * glm::dot(v, v));
    cotangents[k] = glm::dot(u, v) / std::max(glm::length(glm::cross(u, v)), 1e-12 * scale);
  }
  return cotangents;
}

std::vector<int> order_of(const TubePart& part, const std::vector<HalfEdge>& across) {
  Spokes spokes{std::vector<std::uint32_t>(part.points.size() + 1, 0), {}};
  // Both ends of a rim's side, and each end of an inner side once from either triangle.
  const auto each = [&](const auto& visit) {
    for (std::uint32_t h = 0; h < across.size(); ++h) {
      const VertexId a = part.triangles[h / 3][h % 3], b = part.triangles[h / 3][(h + 1) % 3];
      visit(a, b);
      if (across[h] == no_half_edge) visit(b, a);
    }
  };
  each([&](VertexId a, VertexId) { ++spokes.first[a + 1]; });
  std::partial_sum(spokes.first.begin(), spokes.first.end(), spokes.first.begin());
  spokes.spokes.resize(spokes.first.back());
  std::vector<std::uint32_t> next(spokes.first.begin(), spokes.first.end() - 1);
  each([&](VertexId a, VertexId b) { spokes.spokes[next[a]++] = {b, 0.0}; });
  std::vector<int> unknown(part.points.size(), -1);
  int count = 0;
  for (const VertexId v : order_by_dissection(spokes, part.points)) unknown[v] = count++;
  return unknown;
}

Laplacian make_laplacian(const TubePart& part, const std::vector<HalfEdge>& across,
                         const std::vector<std::array<double, 3>>& cotangents) {
  struct Entry {
    int row;
    double value;
  };
  Laplacian made{order_of(part, across), {}, {}, {}};
  const std::size_t size = part.points.size();
  std::vector<std::vector<Entry>> columns(size);
  std::vector<double> diagonal(size, 0.0);
  for (std::size_t t = 0; t < part.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int i = made.unknown[part.triangles[t][(k + 1) % 3]],
                j = made.unknown[part.triangles[t][(k + 2) % 3]];
      const double weight = 0.5 * cotangents[t][k];
      auto& column = columns[static_cast<std::size_t>(std::min(i, j))];
      const auto at = std::find_if(column.begin(), column.end(),
                                   [row = std::max(i, j)](const Entry& entry) { return entry.row == row; });
      if (at == column.end()) {
        column.push_back({std::max(i, j), -weight});
      } else {
        at->value -= weight;
      }
      diagonal[static_cast<std::size_t>(i)] += weight;
      diagonal[static_cast<std::size_t>(j)] += weight;
    }
  }
  made.first.push_back(0);
  for (std::size_t j = 0; j < size; ++j) {
    std::sort(columns[j].begin(), columns[j].end(),
              [](const Entry& a, const Entry& b) { return a.row < b.row; });
    made.row.push_back(static_cast<int>(j));
    made.value.push_back(diagonal[j]);
    for (const Entry& entry : columns[j]) {
      made.row.push_back(entry.row);
      made.value.push_back(entry.value);
    }
    made.first.push_back(static_cast<int>(made.row.size()));
  }
  return made;
}

// Solves L x = right with some values given, by unknowns. Their columns move to the right side.
bool solve_pinned(Laplacian laplacian, std::span<const Pin> pins, std::vector<double>& right,
                  const Heard& heard) {
  std::vector<const Pin*> pin_at(laplacian.size(), nullptr);
  for (const Pin& pin : pins) pin_at[static_cast<std::size_t>(pin.unknown)] = &pin;
  for (std::size_t j = 0; j < laplacian.size(); ++j) {
    for (auto at = static_cast<std::size_t>(laplacian.first[j]) + 1;
         at < static_cast<std::size_t>(laplacian.first[j + 1]); ++at) {
      const auto i = static_cast<std::size_t>(laplacian.row[at]);
      if (pin_at[i] == nullptr && pin_at[j] == nullptr) continue;
      if (pin_at[j] != nullptr) right[i] -= laplacian.value[at] * pin_at[j]->value;
      if (pin_at[i] != nullptr) right[j] -= laplacian.value[at] * pin_at[i]->value;
      laplacian.value[at] = 0.0;
    }
  }
  for (const Pin& pin : pins) {
    const auto j = static_cast<std::size_t>(pin.unknown);
    laplacian.value[static_cast<std::size_t>(laplacian.first[j])] = 1.0;
    right[j] = pin.value;
  }
  const Elimination factors({laplacian.first, laplacian.row, laplacian.value}, heard);
  if (!factors.factored()) return false;
  factors.solve(right);
  return std::all_of(right.begin(), right.end(), [](double x) { return std::isfinite(x); });
}

std::vector<double> by_point(const Laplacian& laplacian, const std::vector<double>& values) {
  std::vector<double> result(values.size());
  for (std::size_t v = 0; v < result.size(); ++v)
    result[v] = values[static_cast<std::size_t>(laplacian.unknown[v])];
  return result;
}

std::optional<std::vector<double>> solve_time(const TubePart& part, const Laplacian& laplacian,
                                              const Heard& heard) {
  std::vector<Pin> pins;
  for (const VertexId v : part.low) pins.push_back({laplacian.unknown[v], 0.0});
  for (const VertexId v : part.high) pins.push_back({laplacian.unknown[v], 1.0});
  std::vector<double> values(part.points.size(), 0.0);
  if (!solve_pinned(laplacian, pins, values, heard)) return std::nullopt;
  return by_point(laplacian, values);
}

// What changes along the sides of a triangle: side k is opposite corner k, from corner k + 1 to corner k + 2.
using AlongSides = std::array<double, 3>;

// n: a shortest path of triangles from the low rim's first side to the high rim. Sides are crossed from below.
std::vector<AlongSides> period_of(const TubePart& part, const std::vector<HalfEdge>& across) {
  std::vector<std::uint8_t> is_high(part.points.size(), 0);
  for (const VertexId v : part.high) is_high[v] = 1;
  const auto corner = [&](std::uint32_t h) { return part.triangles[h / 3][h % 3]; };
  std::uint32_t start = 0;
  while (start < across.size() &&
         !(corner(start) == part.low[0] && corner(next_in_triangle(start)) == part.low[1]))
    ++start;
  std::vector<std::uint32_t> entry(part.triangles.size(), no_half_edge), queue{start / 3};
  entry[start / 3] = start;
  std::uint32_t last = no_half_edge;  // on the high rim
  for (std::size_t i = 0; i < queue.size() && last == no_half_edge; ++i) {
    for (std::uint32_t h = 3 * queue[i]; h < 3 * queue[i] + 3; ++h) {
      const std::uint32_t beyond = across[h];
      if (beyond == no_half_edge) {
        if (is_high[corner(h)] != 0) last = h;
      } else if (entry[beyond / 3] == no_half_edge) {
        entry[beyond / 3] = beyond;
        queue.push_back(beyond / 3);
      }
    }
  }
  std::vector<AlongSides> period(part.triangles.size(), AlongSides{});
  while (last != no_half_edge) {
    const std::uint32_t t = last / 3, in = entry[t];
    period[t][(last % 3 + 2) % 3] -= 1.0;  // the side from corner k is opposite corner k + 2
    period[t][(in % 3 + 2) % 3] += 1.0;
    last = in == start ? no_half_edge : across[in];
  }
  return period;
}

// Moves all corners so that the angle is 0 where rounds begin.
void begin_at(const TubePart& part, const std::vector<HalfEdge>& across,
              std::vector<std::array<double, 3>>& angle) {
  std::vector<std::uint8_t> is_low(part.points.size(), 0);
  for (const VertexId v : part.low) is_low[v] = 1;
  double nearest = INFINITY, origin = 0.0;
  for (std::uint32_t h = 0; h < across.size(); ++h) {
    const Triangle& triangle = part.triangles[h / 3];
    const std::size_t k = h % 3, l = (k + 1) % 3;
    if (across[h] != no_half_edge || is_low[triangle[k]] == 0) continue;
    const glm::dvec3 a = part.points[triangle[k]], side = part.points[triangle[l]] - a;
    const double along = std::clamp(glm::dot(part.beginning - a, side) / glm::dot(side, side), 0.0, 1.0);
    const glm::dvec3 off = a + along * side - part.beginning;
    if (glm::dot(off, off) >= nearest) continue;
    nearest = glm::dot(off, off);
    origin = (1.0 - along) * angle[h / 3][k] + along * angle[h / 3][l];
  }
  for (auto& corners : angle)
    for (double& s : corners) s -= origin;
}

}  // namespace

std::optional<AnnulusFields> solve_annulus(const TubePart& part, const Heard& heard) {
  std::vector<std::array<double, 3>> cotangents;
  cotangents.reserve(part.triangles.size());
  for (const Triangle& triangle : part.triangles) cotangents.push_back(cotangents_at(part, triangle));
  const std::vector<HalfEdge> across = across_sides(part.triangles);
  const Laplacian laplacian = make_laplacian(part, across, cotangents);
  hear(heard, 0.2);
  std::optional<std::vector<double>> time = solve_time(part, laplacian, part_of(heard, 0.2, 0.6));
  if (!time) return std::nullopt;

  std::vector<AlongSides> wanted = period_of(part, across);  // q - n, of which n is here
  double flux = 0.0;
  for (std::size_t t = 0; t < part.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double change = (*time)[part.triangles[t][(k + 2) % 3]] - (*time)[part.triangles[t][(k + 1) % 3]];
      flux += 0.5 * cotangents[t][k] * change * change;
    }
  }
  std::vector<double> right(part.points.size(), 0.0);
  std::vector<AlongSides> target(part.triangles.size());
  for (std::size_t t = 0; t < part.triangles.size(); ++t) {
    const Triangle& triangle = part.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      const double up = (*time)[triangle[k]];
      target[t][k] =
          (cotangents[t][i] * (up - (*time)[triangle[j]]) + cotangents[t][j] * (up - (*time)[triangle[i]])) /
          flux;
      const double flow = 0.5 * cotangents[t][k] * (target[t][k] - wanted[t][k]);
      right[static_cast<std::size_t>(laplacian.unknown[triangle[j]])] += flow;
      right[static_cast<std::size_t>(laplacian.unknown[triangle[i]])] -= flow;
    }
  }
  const Pin pin{laplacian.unknown[part.low[0]], 0.0};
  if (!solve_pinned(laplacian, {&pin, 1}, right, part_of(heard, 0.6, 1.0))) return std::nullopt;
  const std::vector<double> angle = by_point(laplacian, right);

  AnnulusFields fields{std::move(*time), {}, 0.0};
  double missed = 0.0, whole = 0.0;
  for (std::size_t t = 0; t < part.triangles.size(); ++t) {
    const Triangle& triangle = part.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) {
      const double off =
          angle[triangle[(k + 2) % 3]] - angle[triangle[(k + 1) % 3]] + wanted[t][k] - target[t][k];
      missed += 0.5 * cotangents[t][k] * off * off;
      whole += 0.5 * cotangents[t][k] * target[t][k] * target[t][k];
    }
    // Side 2 leads from corner 0 to corner 1, side 0 on to corner 2.
    fields.angle.push_back({angle[triangle[0]], angle[triangle[1]] + wanted[t][2],
                            angle[triangle[2]] + wanted[t][2] + wanted[t][0]});
  }
  fields.residual = missed / whole;
  begin_at(part, across, fields.angle);
  hear(heard, 1.0);
  return fields;
}

}  // namespace knit
