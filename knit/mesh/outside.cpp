#include "knit/mesh/outside.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace knit {

namespace {

constexpr std::uint8_t not_met = 2;

VertexId origin_of(const Input& input, HalfEdge h) { return input.twin[input.mesh.triangles[h / 3][h % 3]]; }

// Meets the piece of `first`, and turns the fewer of its triangles.
void turn_piece(const Input& input, std::uint32_t first, std::vector<std::uint8_t>& inward,
                std::vector<std::uint32_t>& piece) {
  piece.assign(1, first);
  inward[first] = 0;
  std::size_t turned = 0;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const std::uint32_t t = piece[i];
    turned += inward[t];
    for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
      const HalfEdge beyond = input.across[h];
      if (beyond == no_half_edge || inward[beyond / 3] != not_met) continue;
      const bool agree = origin_of(input, h) != origin_of(input, beyond);
      inward[beyond / 3] = static_cast<std::uint8_t>(agree ? inward[t] : 1 - inward[t]);
      piece.push_back(beyond / 3);
    }
  }
  if (2 * turned <= piece.size()) return;
  for (const std::uint32_t t : piece) inward[t] = static_cast<std::uint8_t>(1 - inward[t]);
}

// As nearly all meshes have it; told in one go through the half-edges.
bool neighbours_agree(const Input& input) {
  for (HalfEdge h = 0; h < input.across.size(); ++h) {
    const HalfEdge beyond = input.across[h];
    if (beyond != no_half_edge && origin_of(input, h) == origin_of(input, beyond)) return false;
  }
  return true;
}

// Whether more of the volume is outside than inside; a flat sheet has none.
bool inside_out(const Input& input, const std::vector<std::uint8_t>& inward) {
  constexpr double rounding = 1e-9;
  const glm::dvec3 centre = input.bounds.centre();
  double volume = 0.0, most = 0.0;
  for (std::size_t t = 0; t < inward.size(); ++t) {
    const auto& [a, b, c] = input.mesh.triangles[t];
    const auto& positions = input.mesh.positions;
    const double part =
        glm::dot(positions[a] - centre, glm::cross(positions[b] - centre, positions[c] - centre));
    volume += inward[t] != 0 ? -part : part;
    most += std::abs(part);
  }
  return volume < -rounding * most;
}

}  // namespace

std::vector<std::uint8_t> inward_triangles(const Input& input) {
  const bool agree = neighbours_agree(input);
  std::vector<std::uint8_t> inward(input.mesh.triangles.size(), agree ? 0 : not_met);
  std::vector<std::uint32_t> piece;
  for (std::uint32_t t = 0; !agree && t < inward.size(); ++t) {
    if (inward[t] == not_met) turn_piece(input, t, inward, piece);
  }
  if (inside_out(input, inward)) {
    for (std::uint8_t& in : inward) in = static_cast<std::uint8_t>(1 - in);
  }
  const bool none = std::none_of(inward.begin(), inward.end(), [](std::uint8_t in) { return in != 0; });
  return none ? std::vector<std::uint8_t>{} : inward;
}

}  // namespace knit
