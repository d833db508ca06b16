// A plan of rhythms, and the one that a tube's rows are given from the row on at which it was planned (rhythm_plan.h makes it).
#pragma once

#include <cstdint>
#include <optional>
#include <tuple>
#include <vector>

#include "knit/mesh/mirror_plane.h"
#include "knit/model/rhythm_settings.h"
#include "knit/rhythm/deviation.h"
#include "knit/rhythm/no_rhythm.h"
#include "knit/rhythm/segments.h"

namespace knit {

struct RhythmPlan {
  std::vector<std::int32_t> counts;  // of all rows that were planned, the first among them
  std::vector<RowRole> roles;        // of the same rows
  std::vector<RhythmSegment> segments;
  // Where the halves are shaped apart: stitches of the front half, of the same rows; else empty. Its quarters then stand in for
  // sections: back main to side main, on to the front main, and the same the other way round.
  std::vector<std::int32_t> fronts;
  double front_off = 0.0, back_off = 0.0;  // the largest seen, of each half, in % of its own widest row
  std::int32_t sections = 0;               // M: a shaping round is one repeat, so many times
  std::int32_t changes = 0;                // k: the most that a round changes by
  double size = 1.0;                       // of the piece, against what was asked for
  double dial = 0.0;                       // that it was found with
  SeenDeviation seen;
  double score = 0.0;
  double cost = 0.0;      // of segment_search.h, of both halves of what mirrors
  bool mirrored = false;  // planned by half
  bool within = false;    // the tolerance
  [[nodiscard]] auto fields() const {
    return std::tie(counts, roles, segments, fronts, front_off, back_off, sections, changes, size, dial, seen,
                    score, cost, mirrored, within);
  }
  friend bool operator==(const RhythmPlan&, const RhythmPlan&) = default;
};

struct TubeRhythm {
  std::int32_t tube = 0;
  // Row of the tube, from 0: the first that was planned, or the one that was there already; -1: the live stitches that the tube
  // begins on.
  std::int32_t from = 0;
  RhythmSettings settings;
  double stitch_width = 0.0, stitch_height = 0.0;  // that it was planned for
  NoRhythm none = NoRhythm::no;
  RhythmPlan plan;             // counts.front() is that of row `from`
  bool mirror_sought = false;  // and found or not
  std::optional<MirrorPlane>
      mirror;  // of the whole mesh; rounds begin at its back where halves are shaped apart
  // Whether it says so of the row.
  [[nodiscard]] bool is_joint(std::int32_t row) const { return !plan.fronts.empty() && has(row); }
  [[nodiscard]] std::int32_t front(std::int32_t row) const {
    return plan.fronts[static_cast<std::size_t>(row - from)];
  }
  // Whether it says how many stitches the row has.
  [[nodiscard]] bool has(std::int32_t row) const {
    return row >= from && row - from < static_cast<std::int32_t>(plan.counts.size());
  }
  [[nodiscard]] std::int32_t count(std::int32_t row) const {
    return plan.counts[static_cast<std::size_t>(row - from)];
  }
  [[nodiscard]] RowRole role(std::int32_t row) const {
    return plan.roles[static_cast<std::size_t>(row - from)];
  }
  // Rows that shape, before this one.
  [[nodiscard]] std::int32_t turn(std::int32_t row) const;
  [[nodiscard]] auto fields() const {
    return std::tie(tube, from, settings.counts, settings.style, settings.changes, settings.tolerance,
                    settings.fit_size, settings.halves, settings.dial, stitch_width, stitch_height, none,
                    plan, mirror_sought, mirror);
  }
  friend bool operator==(const TubeRhythm&, const TubeRhythm&) = default;
};

}  // namespace knit
