// The list of segments with the least cost for a body whose front and back are not alike: one rhythm for both halves, each
// with its own counts, so that shaping stands only where the surface asks for it.
//
// Four mains, at the back, the sides and the front, part a round into quarters that mirror each other in pairs: front counts f
// and back counts b are even. A segment is a pre or a post of segments.h whose turn changes the halves by (df, db), each 0,
// 2 or 4, never one up and the other down: 2 is a pair at the half's own main, 4 another one at the side mains.
//   J = sum over rows of weight_r [(f_r - cf_r)^2 + (b_r - cb_r)^2] + the prices of segment_search.h
//       + 1/6 of a rhythm's price for a segment with df != db,                     weight_r = min(1, c_r / 12)
// State: (row, f, b, how the last segment ended), each within reach of its ideal. As in segment_search.h, a segment goes on
// from its last turn in constant time. Cost: rows x states x 16 changes x 11 turns x their times; so of each row only the
// `beam` states with the least cost go on. Ties: the first found; rows, f, b and ends rising, plain before changes, those in the
// order of `halves_changes`, + before -, by p, pre before post, by q.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "knit/model/heard.h"
#include "knit/rhythm/segment_search.h"
#include "knit/rhythm/segments.h"

namespace knit {

struct HalvesChange {
  std::int32_t front = 0, back = 0;
  friend bool operator==(const HalvesChange&, const HalvesChange&) = default;
};
// Growing; shrinking they are the same with the other sign.
inline constexpr std::array<HalvesChange, 8> halves_changes{
    {{2, 2}, {2, 0}, {0, 2}, {4, 4}, {4, 0}, {0, 4}, {4, 2}, {2, 4}}};

// What is enough for a piece of some dozen rows and stitches; 0: all states go on.
inline constexpr std::size_t joint_beam = 120;

struct JointTask {
  std::span<const double> front, back;  // ideals of each half, of the same rows
  RhythmPrices prices;
  RhythmStart start = {};
  std::int32_t start_front = 0;  // of start.count, where that is given; 0: any
  std::size_t beam = joint_beam;
  std::span<const HalvesChange> growing = halves_changes, shrinking = halves_changes;
  Heard heard = {};
};
struct FoundJoint {
  double cost = 0.0;
  std::int32_t first_front = 0, first_back = 0;
  std::vector<RhythmSegment> segments;
};
// None: no list of segments leads from the start to the end.
std::optional<FoundJoint> find_joint_segments(const JointTask& task);

// Whether a half of so many stitches may change so: pairs beside mains that stay.
bool may_change_half(std::int32_t half, std::int32_t change);

}  // namespace knit
