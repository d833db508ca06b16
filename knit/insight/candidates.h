// The candidates of a row: what Algorithm 2 measured along a ring, vertex by vertex, with its verdicts.
#pragma once

#include <cstddef>
#include <limits>
#include <string_view>
#include <vector>

#include "knit/rows/rows.h"
#include "knit/run/timeline.h"

namespace knit {

enum class CandidateVerdict : std::uint8_t {
  first,     // the row begins here
  accepted,  // in the band
  taken,     // nothing was in the band, and it was nearest to it
  too_near,
  too_far,
  never_reached,
};
std::string_view name_of(CandidateVerdict verdict);  // "too near"

inline constexpr std::size_t no_step = std::numeric_limits<std::size_t>::max();

// By its last measuring.
struct Candidate {
  std::int32_t order = 0;  // in the ring
  VertexId vertex = no_vertex;
  std::int32_t anchor_order = 0;
  std::int32_t stitch = 0;  // the anchor's number in the row, from 1
  double distance = 0.0;    // to the anchor
  CandidateVerdict verdict = CandidateVerdict::never_reached;
  std::size_t step = no_step;  // that decided
};

// Why a row has none.
enum class NoCandidates : std::uint8_t {
  has_some,
  no_row,
  cast_on,  // spread evenly along its cycle
  cut,      // spread evenly along a cut through the surface
  not_yet,  // its ring is not ordered so far
};

struct CandidateTable {
  std::int32_t row = 0;
  NoCandidates none = NoCandidates::no_row;
  Band band{0.0, 0.0};  // in force where the row was last measured
  double stitch_width = 0.0;
  std::vector<Candidate> candidates;  // [i]: place i in the ring
};

// Of a row as far as it is known, wherever the timeline stands.
CandidateTable candidates_of(const Timeline& timeline, std::int32_t row);

}  // namespace knit
