// What one smallest step did, as plain data: where it stands and the numbers that decided.
//
// Sentences, highlighted pseudo-code, the candidate table and the list of problems are functions of steps;
// nothing is said twice. A step is at most 64 bytes, so that a run can be recorded whole.
#pragma once

#include <cstdint>
#include <variant>

#include "knit/model/label.h"
#include "knit/model/parameters.h"
#include "knit/model/products.h"
#include "knit/model/stage.h"

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
// One of the solves on the surface that a time is made from.
enum class FieldStep : std::uint8_t { net, heat, slopes, distance, harmonic };
struct FieldSolved {
  FieldStep which;
  VertexId vertex;     // the start; distance: the farthest vertex
  std::int64_t count;  // of triangles (net, slopes) or of unknowns
  double high;         // distance: the greatest, in mesh units
  friend bool operator==(const FieldSolved&, const FieldSolved&) = default;
};
struct HeightsMeasured {
  std::int32_t bands;  // of area between two levels
  double height;       // from start to end along the surface, mean over each level
  friend bool operator==(const HeightsMeasured&, const HeightsMeasured&) = default;
};
struct CriticalsFound {
  std::int32_t minima, saddles, maxima, euler;
  friend bool operator==(const CriticalsFound&, const CriticalsFound&) = default;
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

// rows from contours
struct RowsPlanned {
  std::int32_t rows, passed_over;
  double height, row_height, stitch_height;  // still to go along the surface; of a row; what was asked
  friend bool operator==(const RowsPlanned&, const RowsPlanned&) = default;
};
struct CutFound {
  std::int32_t level, edges, loops;
  double time;
  friend bool operator==(const CutFound&, const CutFound&) = default;
};
struct LoopClosed {
  std::int32_t points;
  friend bool operator==(const LoopClosed&, const LoopClosed&) = default;
};
struct LengthMeasured {
  double length, ideal;  // ideal: stitches of width w that it holds
  friend bool operator==(const LengthMeasured&, const LengthMeasured&) = default;
};
enum class CountReason : std::uint8_t {
  ideal,           // the length in stitch widths, rounded
  as_cast_on,      // the person said how many
  at_least_three,  // a round needs three
  at_most_double,  // of the row below
  at_least_half,   // of the row below
  room_ahead,      // so that the rows above come nearer to what they hold
};
struct CountChosen {
  std::int32_t count, below;  // below: 0 for the first row
  CountReason reason;
  double ideal, course;  // course: the stitch width that comes out
  friend bool operator==(const CountChosen&, const CountChosen&) = default;
};
struct StitchPlaced {
  std::int32_t stitch, of;
  double arc;
  friend bool operator==(const StitchPlaced&, const StitchPlaced&) = default;
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
// nearest: which stitch each cell of the larger row hangs on.
struct RowsMatched {
  std::int32_t links, doubled;     // doubled: stitches of the smaller row with two links
  double sum_of_squares, longest;  // of the wale edges
  friend bool operator==(const RowsMatched&, const RowsMatched&) = default;
};
struct MainPlaced {
  std::int32_t cell, of_mains;
  friend bool operator==(const MainPlaced&, const MainPlaced&) = default;
};
struct ShapingPlaced {
  std::int32_t cell, partner, count;  // count: shaping placed so far in this join
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
  too_fine,          // more rows or stitches than can be held
};
struct Stopped {
  StopReason reason;
  CriticalKind cause;                // of a split
  std::int32_t level, count, other;  // see narrate.cpp for each reason's reading
  VertexId vertex;
  double value, time;
  friend bool operator==(const Stopped&, const Stopped&) = default;
};

using Happening =
    std::variant<EndsFound, FieldSolved, HeightsMeasured, VertexTimed, CriticalsFound, LevelsGrouped,
                 CycleFound, StitchCastOn, CycleGathered, CycleOrdered, CandidateMeasured, BandMissed,
                 RowClosed, RowResampled, GapShared, RowsPlanned, CutFound, LoopClosed, LengthMeasured,
                 CountChosen, StitchPlaced, TransitionCounted, SpacingChosen, RowsMatched, MainPlaced,
                 ShapingPlaced, FaceMade, LineWritten, Stopped>;

struct Step {
  Place place;
  Happening what;
  friend bool operator==(const Step&, const Step&) = default;
};
static_assert(sizeof(Step) <= 64);

inline bool is_stop(const Step& step) { return std::holds_alternative<Stopped>(step.what); }

}  // namespace knit
