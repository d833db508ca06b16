// The part of a mesh between two loops, cut out as a mesh of its own: an annulus, which a tube's chart is made on.
//
// The loops are level loops of the time, or the two rims of an open tube. Triangles that a loop crosses are cut along it; cut
// points keep 3 % of an edge away from its ends, so that no triangle gets as thin as a hair, and edges longer than 1.2 w are
// halved until none is. Mesh units.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "knit/mesh/mesh.h"
#include "knit/model/ring.h"

namespace knit {

// Triangles all the same way round, so that the low rim runs in working order along their sides; so that need not be
// the way that the mesh's face.
struct TubePart {
  std::vector<glm::dvec3> points;
  std::vector<Triangle> triangles;
  std::vector<VertexId> low, high;  // the rims in working order; low begins nowhere in particular
  glm::dvec3 beginning{0.0};        // near the low rim: where rounds begin
  [[nodiscard]] auto fields() const { return std::tie(points, triangles, low, high, beginning); }
  friend bool operator==(const TubePart&, const TubePart&) = default;
};

// A loop of the level set of the field at `value`; the one nearest to the curve is meant. Vertices at the value are above it.
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

// Cuts a mesh along loops, one after the other, and takes out the parts between two of them.
// Cost of a cut: the triangles of the mesh. Of a part: those of the part; once for all, an order of the mesh's sides.
class TubeCutter {
 public:
  TubeCutter(const Input& input, const std::vector<double>& field);

  // The number of the loop; none where the field has no loop at that value.
  std::optional<std::size_t> cut(const LevelLoop& loop);

  // Above one loop and below another, once all loops are cut. Limbs that are pruned and caps between the two stay in it.
  std::variant<TubePart, NoPart> part(std::size_t low, std::size_t high, double stitch_width);

 private:
  struct Loop {
    std::vector<std::array<VertexId, 2>> sides;  // of the triangles above it
    const Ring* curve;
  };
  std::vector<glm::dvec3> points_;
  std::vector<double> field_;
  std::vector<Triangle> triangles_;  // all the same way round
  std::vector<Loop> loops_;
  // Once parts are taken: the loops' sides, the lower number first, rising; and what lies across each side.
  std::vector<std::array<VertexId, 2>> barrier_;
  std::vector<HalfEdge> across_;
};

// Of one tube. Requires low.value < high.value, and curves in working order.
std::variant<TubePart, NoPart> cut_tube(const Input& input, const std::vector<double>& field,
                                        const LevelLoop& low, const LevelLoop& high, double stitch_width);

// A mesh that is an open tube itself: from the rim nearer to `bottom` to the other. Its triangles face out, which
// tells the working order. Rounds begin on the side of `beginning`.
std::variant<TubePart, NoPart> whole_tube(const Input& input, const glm::dvec3& bottom,
                                          const glm::dvec3& beginning, double stitch_width);

}  // namespace knit
