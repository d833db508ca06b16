// The graph of tubes (the Reeb graph): where the level sets of a field begin, part, meet and end, and the tubes between.
//
// Through each vertex where level curves part or meet, theirs is drawn on the surface, and cuts the triangles that it
// crosses; what still hangs together then are the tubes. Exact, no tolerance. Cost: the triangles, and those cut, summed
// over such vertices.
// Invariants: a node is a minimum (0 tubes below, 1 above), a split (1, 2), a join (2, 1) or a maximum (1, 0); minima -
// splits - joins + maxima is the Euler characteristic, and tubes - nodes + 1 = (2 - that) / 2, the genus.
// G. Reeb, 1946; K. Cole-McLaughlin et al., "Loops in Reeb graphs of 2-manifolds", 2003.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <tuple>
#include <vector>

#include "knit/model/shared.h"
#include "knit/tubes/morse.h"

namespace knit {

enum class NodeKind : std::uint8_t { minimum, split, join, maximum };

struct GraphNode {
  VertexId vertex = 0;  // of the Morse surface
  double value = 0.0;
  std::vector<std::int32_t> below, above;  // tubes that end and that begin here, rising
  bool rim = false;                        // the mesh is open here: a minimum or a maximum
  [[nodiscard]] NodeKind kind() const {
    if (below.empty()) return NodeKind::minimum;
    if (above.empty()) return NodeKind::maximum;
    return above.size() == 2 ? NodeKind::split : NodeKind::join;
  }
  [[nodiscard]] auto fields() const { return std::tie(vertex, value, below, above); }
  friend bool operator==(const GraphNode&, const GraphNode&) = default;
};

// Tubes are numbered in the order in which they begin.
struct GraphTube {
  std::int32_t bottom = 0, top = 0;  // nodes
  [[nodiscard]] auto fields() const { return std::tie(bottom, top); }
  friend bool operator==(const GraphTube&, const GraphTube&) = default;
};

// A triangle as far as it lies in a tube: between two ranks.
struct TubePiece {
  std::uint32_t triangle = 0;
  std::uint32_t low = 0, high = 0;
  [[nodiscard]] auto fields() const { return std::tie(triangle, low, high); }
  friend bool operator==(const TubePiece&, const TubePiece&) = default;
};

struct TubeGraph {
  MorseSurface surface;
  std::vector<GraphNode> nodes;  // by rank
  std::vector<GraphTube> tubes;
  std::vector<TubePiece> pieces;           // tube after tube, `low` rising within one
  std::vector<std::uint32_t> first_piece;  // of each tube, and the end
  [[nodiscard]] std::int32_t loops() const {
    return static_cast<std::int32_t>(tubes.size()) - static_cast<std::int32_t>(nodes.size()) + 1;
  }
  [[nodiscard]] auto fields() const { return std::tie(surface, nodes, tubes, pieces, first_piece); }
  friend bool operator==(const TubeGraph&, const TubeGraph&) = default;
};

// Of one connected closed surface.
TubeGraph find_tubes(MorseSurface surface, const Heard& heard = {});

// How high a tube is and how long its curves are: at rising values (about 150: quantiles of its vertices' values, equal
// steps, both ends), the height from its bottom, a running sum of area / mean length with exact areas, and between each two
// values the exact length of the curve midway.
struct TubeProfile {
  std::vector<double> values;   // at least two
  std::vector<double> heights;  // one a value, from 0
  std::vector<double> lengths;  // one fewer
  [[nodiscard]] double height() const { return heights.back(); }
  [[nodiscard]] double longest() const;
  [[nodiscard]] auto fields() const { return std::tie(values, heights, lengths); }
  friend bool operator==(const TubeProfile&, const TubeProfile&) = default;
};
TubeProfile profile_of(const TubeGraph& graph, std::int32_t tube, const Heard& heard = {});

// The tube's level curve at a value within it, as points in working order: the higher side is on the right, seen from
// outside. At least three points on a sound surface.
std::vector<glm::dvec3> curve_at(const TubeGraph& graph, std::int32_t tube, double value);

}  // namespace knit
