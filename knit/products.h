// What the stages hand on: plain data, finished once, then immutable (`Shared<T>` in State).
//
// A row belongs to a tube; today there is one. Stitch order is working order: counter-clockwise seen along
// the direction of knitting, which is clockwise seen from the needles, right side out (a right-handed
// knitter's order).
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "knit/mesh.h"
#include "knit/shared.h"

namespace knit {

using TubeId = std::int32_t;

// --- timing
// -------------------------------------------------------------------------------------------------------

// Algorithm 1's line: t(v) = (v - origin) . direction / |direction|^2.
struct Ends {
  VertexId start = no_vertex;
  VertexId end = no_vertex;
  glm::dvec3 origin{0.0};
  glm::dvec3 direction{0.0};  // from start to end, not normalised
  [[nodiscard]] auto fields() const { return std::tie(start, end, origin, direction); }
  friend bool operator==(const Ends&, const Ends&) = default;
};

// The level at which the surface stops being one tube.
struct Split {
  std::int32_t level = 0;  // rows before this level are sound
  std::int32_t loops = 0;  // of the level set just above it
  VertexId vertex = no_vertex;
  double time = 0.0;
  [[nodiscard]] auto fields() const { return std::tie(level, loops, vertex, time); }
  friend bool operator==(const Split&, const Split&) = default;
};

// Vertices of equal time, level by level, rising.
struct Levels {
  std::vector<VertexId> vertices;    // level after level; within one by index
  std::vector<std::uint32_t> begin;  // first of each level, and the end
  std::vector<double> times;         // of each level: its lowest
  std::optional<Split> split;
  [[nodiscard]] std::int32_t count() const { return static_cast<std::int32_t>(times.size()); }
  [[nodiscard]] std::span<const VertexId> level(std::int32_t i) const {
    const auto at = static_cast<std::size_t>(i);
    return std::span(vertices).subspan(begin[at], begin[at + 1] - begin[at]);
  }
  [[nodiscard]] auto fields() const { return std::tie(vertices, begin, times, split); }
  friend bool operator==(const Levels&, const Levels&) = default;
};

struct Timing {
  Ends ends;
  std::vector<double> times;  // per vertex, clamped to [0, 1]
  std::int32_t outside = 0;   // vertices that had to be clamped
  Levels levels;
  [[nodiscard]] auto fields() const { return std::tie(ends, times, outside, levels); }
  friend bool operator==(const Timing&, const Timing&) = default;
};

// --- cast on, rows
// -------------------------------------------------------------------------------------------------

enum class OrderedBy : std::uint8_t { angle, edges };

// A level's vertices as a closed polyline in working order.
struct Ring {
  std::vector<VertexId> vertices;  // from the start direction on; copies of the first vertex come last
  std::vector<double> arc;  // of each vertex, along the polyline from the first; rising, within [0, length]
  double length = 0.0;      // of the closed polyline
  OrderedBy ordered_by = OrderedBy::angle;
  [[nodiscard]] auto fields() const { return std::tie(vertices, arc, length, ordered_by); }
  friend bool operator==(const Ring&, const Ring&) = default;
};

struct Stitch {
  glm::dvec3 position{0.0};
  VertexId vertex = no_vertex;  // the mesh vertex it was picked at; no_vertex when placed by arc
  [[nodiscard]] auto fields() const { return std::tie(position, vertex); }
  friend bool operator==(const Stitch&, const Stitch&) = default;
};

struct Row {
  TubeId tube = 0;
  std::int32_t number = 1;  // from 1, the cast on
  std::int32_t level = 0;
  double time = 0.0;
  Shared<Ring> ring;
  std::vector<Stitch> stitches;  // at least 3, working order
  [[nodiscard]] auto fields() const { return std::tie(tube, number, level, time, ring, stitches); }
  friend bool operator==(const Row&, const Row&) = default;
};

// --- stitch index
// --------------------------------------------------------------------------------------------------

// The thesis's integers.
enum class Label : std::uint8_t { knit = 0, m1r = 1, m1l = 2, k2tog = 3, ssk = 4, cast = 5, main = 6 };
inline bool is_increase(Label label) { return label == Label::m1r || label == Label::m1l; }
inline bool is_decrease(Label label) { return label == Label::k2tog || label == Label::ssk; }
inline bool is_shaping(Label label) { return is_increase(label) || is_decrease(label); }

// How mains were spaced; names as in docs/algorithm.md.
enum class Rule : std::uint8_t { from_cast_on, plain, equal, follow, remainder_last, dense, even };

struct PlacedLabel {
  std::int32_t cell = 0;
  Label label = Label::knit;
  [[nodiscard]] auto fields() const { return std::tie(cell, label); }
  friend bool operator==(const PlacedLabel&, const PlacedLabel&) = default;
};

// From one row to the next. Cells are those of the larger row: `above` when it grows, `below` when it
// shrinks.
struct Transition {
  TubeId tube = 0;
  std::int32_t row = 2;  // the row it makes, from row - 1
  std::int32_t below = 0, above = 0;
  Rule rule = Rule::plain;
  std::optional<Rule> tried;  // the rule that would have applied, had its sections had room
  std::int32_t spacing = 0, remainder = 0;
  std::vector<Label> labels;          // max(below, above) cells
  std::vector<PlacedLabel> placed;    // mains and shaping in the order of placing
  std::vector<std::int32_t> mains;    // cells of the mains in row `row`
  std::vector<std::int32_t> partner;  // per cell: the cell a shaping label works with, else the cell itself
  std::vector<std::int32_t> link;     // per cell: its stitch in the smaller row
  [[nodiscard]] std::int32_t change() const { return above - below; }
  [[nodiscard]] auto fields() const {
    return std::tie(tube, row, below, above, rule, tried, spacing, remainder, labels, placed, mains, partner,
                    link);
  }
  friend bool operator==(const Transition&, const Transition&) = default;
};

// --- faces
// ---------------------------------------------------------------------------------------------------------

// Corners are stitches counted through all rows (the knitting path), counter-clockwise seen from outside.
struct Face {
  std::array<std::uint32_t, 4> corners{};
  std::int32_t corner_count = 4;  // 3: the last corner is unused and 0
  std::int32_t cell = 0;          // of the transition
  Label label = Label::knit;
  [[nodiscard]] auto fields() const { return std::tie(corners, corner_count, cell, label); }
  friend bool operator==(const Face&, const Face&) = default;
};

// The faces between row - 1 and row.
struct Strip {
  std::int32_t row = 2;
  std::vector<Face> faces;
  std::vector<std::array<std::uint32_t, 2>> column_edges;  // lower stitch, upper stitch
  [[nodiscard]] auto fields() const { return std::tie(row, faces, column_edges); }
  friend bool operator==(const Strip&, const Strip&) = default;
};

// --- pattern
// -------------------------------------------------------------------------------------------------------

struct PatternLine {
  std::int32_t row = 1;
  std::string text;
  std::int32_t consumed = 0;  // stitches of the row before
  std::int32_t produced = 0;
  [[nodiscard]] auto fields() const { return std::tie(row, text, consumed, produced); }
  friend bool operator==(const PatternLine&, const PatternLine&) = default;
};

}  // namespace knit
