// What rows leave uncovered, and which rows are stretched to reach: what a run must not pass over in silence.
//
// A point of the mesh is covered if it lies within one stitch height h of the knit mesh's faces that look the same way as
// it does, so that the other wall of a thin sheet does not cover it: a row covers what it reaches to either side. Round
// and bent shapes are then covered to the last point; at 3/4 h a capsule's two ends would not be (0.8 %), and at 3/2 h
// flat ends shrink by a sixth. A row of few stitches at an end is drawn together, so its hole counts as closed.
//
// Stitches that have settled are looked at where they settled; from a part that they covered where they were placed they
// have slid.
//
// A wale is stretched where it is longer than 3/2 h: rows of a tube stand at most 5/4 h apart [knit/tubes/plan.h].
//
// Lengths are in mesh units, areas as shares of the mesh's.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "knit/mesh/mesh.h"
#include "knit/quality/ease.h"
#include "knit/run/state.h"

namespace knit {

inline constexpr double covered_within = 1.0;    // h
inline constexpr double stretched_above = 1.5;   // h
inline constexpr std::size_t most_places = 8;    // uncovered ones that are told one by one
inline constexpr double tiny_place = 4.0;        // stitches: smaller ones are not told
inline constexpr std::size_t most_closing = 12;  // stitches: as many as the pattern draws together

// Why no row is there, as far as it can be told.
enum class UncoveredKind : std::uint8_t {
  flat,  // the time hardly changes on it: less than a row's worth
  limb,  // of a limb or handle that was left out
  other,
  slid  // rows were placed on most of it, and settled elsewhere
};

// A connected part without rows.
struct UncoveredPlace {
  VertexId vertex = no_vertex;  // of the mesh, nearest to its middle
  glm::dvec3 at{0.0};           // of the part, nearest to its middle
  double share = 0.0;
  UncoveredKind kind = UncoveredKind::other;
  double width_that_keeps = 0.0;  // limb: narrower stitches would knit it; 0: not known
};

struct Uncovered {
  double share = 0.0;                  // tiny parts too
  std::vector<UncoveredPlace> places;  // the largest first
};

// Rows of one tube that follow each other, each with stretched wales.
struct Stretched {
  TubeId tube = 0;
  RowId from = 1, to = 1;
  double longest = 0.0;  // wale, in h
  double share = 0.0;    // of these rows' wales: stretched ones
  StitchRef at;          // the upper end of the longest
};

struct Coverage {
  Uncovered uncovered;
  std::vector<Stretched> stretched;  // in working order
  std::size_t tubes = 1;             // that have rows
  TurnedFaces turned;
};

// Nothing before all faces are made. Requires a stitch of a size above 0. Takes about 2 microseconds a triangle and
// some a stitch; meant for a worker.
std::optional<Coverage> measure_coverage(const Input& input, const State& state, double stitch_width,
                                         double stitch_height);

// The two parts of it, of any state.
Uncovered measure_uncovered(const Input& input, const State& state, double stitch_width,
                            double stitch_height);
std::vector<Stretched> stretched_rows(const State& state, double stitch_height);

}  // namespace knit
