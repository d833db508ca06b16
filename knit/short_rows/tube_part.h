// The part of a mesh between two loops, cut out as a mesh of its own: an annulus, which a tube's chart is made on.
//
// The loops are level loops of the time, or the two rims of an open tube. Triangles that a loop crosses are cut along it; cut
// points keep 3 % of an edge away from its ends, so that no triangle gets as thin as a hair, and edges longer than 1.2 w are
// halved until none is. Limbs that are pruned, closed caps between the loops, stay in it. Mesh units.
// Cost: the triangles of the mesh, once a loop.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "knit/mesh/mesh.h"
#include "knit/model/heard.h"
#include "knit/model/ring.h"

namespace knit {

// Triangles all the same way round, so that the low loop runs in working order along their sides.
struct TubePart {
  std::vector<glm::dvec3> points;
  std::vector<Triangle> triangles;
  std::vector<VertexId> low, high;  // the rims in working order; low begins nowhere in particular
  glm::dvec3 beginning{0.0};        // near the low rim: where rounds begin
  [[nodiscard]] auto fields() const { return std::tie(points, triangles, low, high, beginning); }
  friend bool operator==(const TubePart&, const TubePart&) = default;
};

// A loop of the level set of `field` at `value`; the one that the curve is nearest to is meant.
struct LevelLoop {
  double value = 0.0;
  const Ring* curve = nullptr;
};

enum class NoPart : std::uint8_t {
  no_loop,    // the field has no loop at that value
  apart,      // no part of the mesh touches both loops
  no_annulus  // the part has other rims, or a handle
};
std::string sentence_of(NoPart why);

// Requires low.value < high.value, and curves in working order.
std::variant<TubePart, NoPart> cut_tube(const Input& input, const std::vector<double>& field,
                                        const LevelLoop& low, const LevelLoop& high, double stitch_width,
                                        const Heard& heard = {});

// A mesh that is an open tube itself: from the rim nearer to `bottom` to the other. Its triangles' outside tells the working
// order. Rounds begin on the side of `beginning`.
std::variant<TubePart, NoPart> whole_tube(const Input& input, const glm::dvec3& bottom,
                                          const glm::dvec3& beginning, double stitch_width);

}  // namespace knit
