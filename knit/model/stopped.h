// The one event that every stage may have: it cannot go on with this mesh and these parameters.
#pragma once

#include <cstdint>
#include <string_view>

#include "knit/model/products.h"

namespace knit {

enum class StopReason : std::uint8_t {
  no_extent,         // start and end lie at the same time
  no_row_levels,     // no level between the ends makes a row, or only one; then `time` is its
  not_a_ring,        // the level's vertices form no single loop
  splits,            // the level set falls into several loops
  stall,             // nothing in the band, and the person asked to stop
  changes_too_much,  // more than double or less than half, and resampling is off
  too_many_tubes,    // the level sets fall into more tubes than a shape has
  too_fine,          // more rows or stitches than can be held
  open_edge,         // of an open mesh, and the time that is asked for does not run from edge to edge
};
std::string_view name_of(StopReason reason);  // "no extent"

// The sentences stand in the rooms of the stages that stop.
struct Stopped {
  static constexpr std::string_view kind = "stopped";
  StopReason reason;
  CriticalKind cause;                // of a split
  std::int32_t level, count, other;  // see the sentences for each reason's reading
  VertexId vertex;
  double value, time;
  friend bool operator==(const Stopped&, const Stopped&) = default;
};

}  // namespace knit
