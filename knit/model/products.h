// What the stages hand on beside the fabric (knit/fabric): plain data, finished once, then immutable (`Shared<T>` in
// State).
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "knit/mesh/mesh.h"
#include "knit/model/ring.h"
#include "knit/model/settings.h"
#include "knit/model/shared.h"

namespace knit {

// --- timing
// -------------------------------------------------------------------------------------------------------

// Algorithm 1's line: t(v) = (v - origin) . direction / |direction|^2.
struct Ends {
  VertexId start = no_vertex;
  VertexId end = no_vertex;
  glm::dvec3 origin{0.0};
  glm::dvec3 direction{0.0};  // from start to end, not normalised
  // Of an open mesh: the rim (Input::rims) that is the start or the end, whose first vertex stands for it; -1: a vertex.
  // They follow from the mesh and the settings.
  std::int32_t start_rim = -1, end_rim = -1;
  [[nodiscard]] auto fields() const { return std::tie(start, end, origin, direction); }
  friend bool operator==(const Ends&, const Ends&) = default;
};

enum class CriticalKind : std::uint8_t { minimum, saddle, maximum };

// Where the level sets of the time begin, part, join or end. A flat part of the surface counts as one point,
// its lowest-numbered vertex.
struct CriticalPoint {
  VertexId vertex = no_vertex;
  CriticalKind kind = CriticalKind::saddle;
  std::int32_t multiplicity = 1;  // of a saddle: 2 for one where three loops meet
  double time = 0.0;
  [[nodiscard]] auto fields() const { return std::tie(vertex, kind, multiplicity, time); }
  friend bool operator==(const CriticalPoint&, const CriticalPoint&) = default;
};

// By time, rising. minima - saddles + maxima equals the Euler characteristic, which is counted apart.
struct Criticals {
  std::vector<CriticalPoint> points;
  std::int32_t minima = 0, saddles = 0, maxima = 0;  // saddles with their multiplicity
  std::int32_t euler = 0;                            // vertices - edges + triangles of the mesh
  [[nodiscard]] auto fields() const { return std::tie(points, minima, saddles, maxima, euler); }
  friend bool operator==(const Criticals&, const Criticals&) = default;
};

// A level set of several loops, which one tube cannot follow, and the saddle that tells why.
struct Split {
  std::int32_t level = 0;  // rows before this level are sound
  std::int32_t loops = 0;
  // saddle: the tube parts there, below. minimum: another end of the shape has begun, and joins the first at
  // the saddle, above.
  CriticalKind cause = CriticalKind::saddle;
  VertexId vertex = no_vertex;  // of the saddle
  double time = 0.0;
  [[nodiscard]] auto fields() const { return std::tie(level, loops, cause, vertex, time); }
  friend bool operator==(const Split&, const Split&) = default;
};

// How far up the surface a level lies: a rising, piecewise linear map from the field that orders the vertices
// to the mean height along the surface.
struct HeightScale {
  std::vector<double> values;   // of the field, rising strictly from 0 to 1
  std::vector<double> heights;  // rising from 0
  [[nodiscard]] double total() const { return heights.empty() ? 0.0 : heights.back(); }
  [[nodiscard]] auto fields() const { return std::tie(values, heights); }
  friend bool operator==(const HeightScale&, const HeightScale&) = default;
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
  TimingKind kind = TimingKind::linear;  // what was given, or chosen
  // What a time is read from: cuts are made in it, because it is what runs straight across a triangle. Empty:
  // the times themselves.
  std::vector<double> field;
  HeightScale scale;          // of the field
  bool retimed = false;       // time = height / total height, else the field itself
  std::vector<double> times;  // per vertex, clamped to [0, 1]
  std::int32_t outside = 0;   // vertices that had to be clamped
  Criticals criticals;
  Levels levels;
  [[nodiscard]] const std::vector<double>& cut_field() const { return field.empty() ? times : field; }
  [[nodiscard]] auto fields() const {
    return std::tie(ends, kind, field, scale, retimed, times, outside, criticals, levels);
  }
  friend bool operator==(const Timing&, const Timing&) = default;
};

// --- what rows stand on
// -------------------------------------------------------------------------------------------------

// The surface cut at one time.
struct Cut {
  double time = 0.0;
  std::int32_t edges = 0;           // of the mesh, cut through
  std::vector<Shared<Ring>> loops;  // one where a tube is; the longest first
  [[nodiscard]] auto fields() const { return std::tie(time, edges, loops); }
  friend bool operator==(const Cut&, const Cut&) = default;
};

// --- pattern
// -------------------------------------------------------------------------------------------------------

// A line of the written pattern, counted; its words are knit/pattern's.
struct CountedLine {
  std::int32_t row = 1;
  std::int32_t consumed = 0;  // stitches of the row before
  std::int32_t produced = 0;
  [[nodiscard]] auto fields() const { return std::tie(row, consumed, produced); }
  friend bool operator==(const CountedLine&, const CountedLine&) = default;
};

}  // namespace knit
