// The rhythm of a whole piece: of all numbers of sections, dials and sizes the plan that reads best within the tolerance.
//
//   score = lines + 0.3 max(0, changes without a rest - 2) + 0.04 shaping rounds + preference of k + (step sizes - 1)
//           + 0.15 |change of size in %|
// lines: 1 for a segment, 0.4 for a plain one of more than 3 rows. If no plan is within the tolerance: the one with the least
// 1.5 x deviation in % + 0.3 score. What mirrors (ideals alike within 1 % of the widest from both ends) is planned by half.
// Segments: segment_search.h. Preferred: 4, 6, 8 and 12 changes, as published patterns have them.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "knit/model/rhythm_settings.h"
#include "knit/rhythm/deviation.h"
#include "knit/rhythm/segment_search.h"
#include "knit/rhythm/segments.h"

namespace knit {

struct RhythmPlan {
  std::vector<std::int32_t> counts;  // of all rows that were planned, the first among them
  std::vector<RowRole> roles;        // of the same rows
  std::vector<Segment> segments;
  std::int32_t sections = 0;  // M: a shaping round is one repeat, so many times
  std::int32_t changes = 0;   // k: the most that a round changes by
  double size = 1.0;          // of the piece, against what was asked for
  double dial = 0.0;          // that it was found with
  SeenDeviation seen;
  double score = 0.0;
  double cost = 0.0;      // of segment_search.h, of both halves of what mirrors
  bool mirrored = false;  // planned by half
  bool within = false;    // the tolerance
  [[nodiscard]] auto fields() const {
    return std::tie(counts, roles, segments, sections, changes, size, dial, seen, score, cost, mirrored,
                    within);
  }
  friend bool operator==(const RhythmPlan&, const RhythmPlan&) = default;
};

// What the rows hold, in stitches, if the piece is made `size` times as large. Positive, at least one row.
using IdealsAt = std::function<std::vector<double>(double size)>;
// Of what was measured at its own size: rows as far apart, so there are more or fewer of them, and straight lines between.
IdealsAt resized_ideals(std::vector<double> ideals);

// What a person may ask for; size is kept with a start after the first row. None: no number of sections fits what is asked.
std::optional<RhythmPlan> plan_rhythm(const IdealsAt& ideals, const RhythmSettings& settings,
                                      const RhythmStart& start = {});

// The six dials that are tried, few rhythms first.
std::span<const double> rhythm_dials();
// The plan of one family at one dial: no choice but that of segments.
std::optional<RhythmPlan> plan_family(std::span<const double> ideals, const RhythmFamily& family, double dial,
                                      const RhythmStart& start = {});

// Whether the piece is alike from both ends.
bool is_mirrored(std::span<const double> ideals);

}  // namespace knit
