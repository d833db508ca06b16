// What one smallest step did, as plain data: where it stands and the numbers that decided.
//
// Sentences, highlighted pseudo-code, the candidate table and the list of problems are functions of steps;
// nothing is said twice. A step is at most 64 bytes, so that a run can be recorded whole.
#pragma once

#include <cstdint>
#include <variant>

#include "knit/parameters.h"
#include "knit/products.h"
#include "knit/stage.h"

namespace knit {

// timing
struct EndsFound {
  VertexId start, end;
  double length;
  friend bool operator==(const EndsFound&, const EndsFound&) = default;
};
struct VertexTimed {
  VertexId vertex;
  bool clamped;
  double time;
  friend bool operator==(const VertexTimed&, const VertexTimed&) = default;
};
struct LevelsGrouped {
  std::int32_t levels, outside, split_level, split_loops;  // split_level -1: one tube all the way
  double tolerance;
  friend bool operator==(const LevelsGrouped&, const LevelsGrouped&) = default;
};

// cast on
struct CycleFound {
  std::int32_t level, last_level, vertices, passed_over;
  double time, length;
  friend bool operator==(const CycleFound&, const CycleFound&) = default;
};
struct StitchCastOn {
  std::int32_t stitch, of;
  double arc;
  friend bool operator==(const StitchCastOn&, const StitchCastOn&) = default;
};

// rows: Algorithm 2
struct CycleGathered {
  std::int32_t level, vertices;
  double time;
  friend bool operator==(const CycleGathered&, const CycleGathered&) = default;
};
struct CycleOrdered {
  VertexId first;
  std::int32_t vertices;
  OrderedBy by;
  double length;
  friend bool operator==(const CycleOrdered&, const CycleOrdered&) = default;
};
enum class Verdict : std::uint8_t { too_near, accepted, too_far };
struct CandidateMeasured {
  VertexId anchor, candidate;
  std::int32_t anchor_order, candidate_order;  // places in the ring
  std::int32_t stitch;                         // the anchor's number in the row, from 1
  Verdict verdict;
  double distance;
  friend bool operator==(const CandidateMeasured&, const CandidateMeasured&) = default;
};
// Nothing lay in the band; the robust continuation took the vertex nearest to the stitch width.
struct BandMissed {
  VertexId anchor, taken;
  std::int32_t stitch, taken_order;
  double distance, skipped_distance;  // of the taken; of the other one at the band (negative: there was none)
  friend bool operator==(const BandMissed&, const BandMissed&) = default;
};
struct RowClosed {
  std::int32_t stitches;
  bool in_band, dropped_last;
  double gap;
  friend bool operator==(const RowClosed&, const RowClosed&) = default;
};
enum class ResampleReason : std::uint8_t { too_few, more_than_double, less_than_half };
struct RowResampled {
  std::int32_t from, to, below;
  ResampleReason reason;
  double length;
  friend bool operator==(const RowResampled&, const RowResampled&) = default;
};
struct GapShared {
  std::int32_t stitches;
  Closing how;
  bool shared;        // false: left as it was
  bool resampled;     // left because the row had been spread evenly already
  double per_stitch;  // thesis: each stitch moves by its number times this; arc: the even spacing
  double gap_before, gap_after;
  friend bool operator==(const GapShared&, const GapShared&) = default;
};

// stitch index
struct TransitionCounted {
  std::int32_t below, above, change, mains_wanted, mains_before;
  friend bool operator==(const TransitionCounted&, const TransitionCounted&) = default;
};
struct SpacingChosen {
  Rule rule, tried;
  bool fell_back;
  std::int32_t spacing, remainder, mains;
  friend bool operator==(const SpacingChosen&, const SpacingChosen&) = default;
};
struct MainPlaced {
  std::int32_t cell, of_mains;
  friend bool operator==(const MainPlaced&, const MainPlaced&) = default;
};
struct ShapingPlaced {
  std::int32_t cell, partner, count;  // count: shaping placed so far in this transition
  Label label;
  friend bool operator==(const ShapingPlaced&, const ShapingPlaced&) = default;
};

// faces
struct FaceMade {
  std::int32_t index, of;  // in its strip
  Label label;
  std::int32_t corner_count;
  friend bool operator==(const FaceMade&, const FaceMade&) = default;
};

// pattern
struct LineWritten {
  std::int32_t consumed, produced;
  friend bool operator==(const LineWritten&, const LineWritten&) = default;
};

// The machine cannot go on with this mesh and these parameters; the state stays as it was.
enum class StopReason : std::uint8_t {
  no_extent,         // start and end lie at the same time
  no_row_levels,     // no level between the ends makes a row
  not_a_ring,        // the level's vertices form no single loop
  splits,            // the level set falls into several loops
  stall,             // nothing in the band, and the person asked to stop
  changes_too_much,  // more than double or less than half, and resampling is off
};
struct Stopped {
  StopReason reason;
  std::int32_t level, count, other;  // see narrate.cpp for each reason's reading
  VertexId vertex;
  double value, time;
  friend bool operator==(const Stopped&, const Stopped&) = default;
};

using Happening =
    std::variant<EndsFound, VertexTimed, LevelsGrouped, CycleFound, StitchCastOn, CycleGathered, CycleOrdered,
                 CandidateMeasured, BandMissed, RowClosed, RowResampled, GapShared, TransitionCounted,
                 SpacingChosen, MainPlaced, ShapingPlaced, FaceMade, LineWritten, Stopped>;

struct Step {
  Place place;
  Happening what;
  friend bool operator==(const Step&, const Step&) = default;
};
static_assert(sizeof(Step) <= 64);

inline bool is_stop(const Step& step) { return std::holds_alternative<Stopped>(step.what); }

}  // namespace knit
