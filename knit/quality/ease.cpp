#include "knit/quality/ease.h"

#include <glm/geometric.hpp>

#include "knit/mesh/triangle_tree.h"
#include "knit/settle/surface.h"

namespace knit {

State placed_state(const State& state) {
  State placed = state;
  placed.fabric = placed_fabric(state);
  placed.placed = {};
  return placed;
}

std::optional<EaseMoves> measure_moves(const State& state) {
  if (!state.placed) return std::nullopt;
  const std::vector<glm::dvec3> from = knitting_path(placed_fabric(state)), to = knitting_path(state.fabric);
  EaseMoves moves;
  std::uint32_t farthest = 0;
  for (std::uint32_t i = 0; i < to.size(); ++i) {
    const double move = glm::distance(from[i], to[i]);
    moves.mean += move;
    if (move <= moves.most) continue;
    moves.most = move;
    farthest = i;
  }
  if (!to.empty()) moves.mean /= static_cast<double>(to.size());
  if (!to.empty()) moves.of = KnittingPath(state.fabric).at(farthest);
  return moves;
}

std::optional<StitchMove> move_of(const State& state, const StitchRef& stitch) {
  if (!state.placed) return std::nullopt;
  return StitchMove{placed_fabric(state).position(stitch), state.fabric.position(stitch)};
}

namespace {

// A face's middle, and across it towards where its corners go round counter-clockwise.
struct FaceLie {
  glm::dvec3 middle, across;
};

FaceLie lie_of(const Face& face, const std::vector<glm::dvec3>& path) {
  const auto at = [&](std::size_t corner) { return path[face.corners[corner]]; };
  if (face.corner_count == 4)
    return {(at(0) + at(1) + at(2) + at(3)) / 4.0, glm::cross(at(2) - at(0), at(3) - at(1))};
  return {(at(0) + at(1) + at(2)) / 3.0, glm::cross(at(1) - at(0), at(2) - at(0))};
}

}  // namespace

TurnedFaces measure_turned(const Input& input, const State& state) {
  if (input.mesh.triangles.empty() || state.fabric.strips().empty()) return {};
  const TriangleTree tree(input.mesh.positions, input.mesh.triangles);
  const VertexNormals normals = vertex_normals(input);
  const std::vector<glm::dvec3> path = knitting_path(state.fabric);
  // Inside out one may be most of them, where the whole fabric is.
  std::size_t out = 0, in = 0;
  std::uint32_t first_out = 0, first_in = 0;
  const auto look = [&](const std::vector<Face>& faces) {
    for (const Face& face : faces) {
      const FaceLie lie = lie_of(face, path);
      const SurfacePlace place = tree.nearest(lie.middle);
      const glm::dvec3 normal = normal_at(input, normals, place.triangle, place.point, lie.across);
      const bool outward = glm::dot(lie.across, normal) >= 0.0;
      std::uint32_t& first = outward ? first_out : first_in;
      if ((outward ? out : in)++ == 0) first = face.corners[0];
    }
  };
  for (const auto& strip : state.fabric.strips()) look(strip->faces);
  for (const auto& deal : state.fabric.deals()) look(deal->faces);
  const bool inside_out = in > out;
  const std::size_t turned = inside_out ? out : in;
  if (turned == 0) return {};
  return {turned, KnittingPath(state.fabric).at(inside_out ? first_out : first_in)};
}

}  // namespace knit
