// Short rows in the stages cast on and rows, one smallest step at a time.
//
//   before a tube's first row     its chart and its full rounds; then gap by gap the lag, and the best arc again and again
//                                 while it pays; at last the tube's curves are those of its full rounds
//   before a round over arcs      its pairs are placed on the stitches of the round below, by how the round will hang on
//                                 them; then each is worked, out on the right side and back on the wrong side
// Each stitch of a short row stands on the flow line of the one below, the rows of a place evenly between the two rounds.
#pragma once

#include <cstdint>
#include <optional>
#include <tuple>

#include "knit/fabric/fabric.h"
#include "knit/mesh/mesh.h"
#include "knit/model/event.h"
#include "knit/model/heard.h"
#include "knit/model/settings.h"
#include "knit/short_rows/planned_pairs.h"
#include "knit/short_rows/short_row_events.h"
#include "knit/tubes/plan.h"

namespace knit {

// Rows that a tube keeps as they are at either end.
struct KeptRows {
  std::int32_t low = 0, high = 0;
};

struct ChartAt {
  const Input& input;
  const std::vector<double>& field;  // that the tube's curves are levels of
  const TubePlan& plan;
  TubeId tube;
  KeptRows kept;
  const StitchSize& stitch;
  const ShortRowSettings& settings;
  bool middle;                                       // rounds begin in the middle of the arcs
  std::span<const Shared<PlannedPairs>> ahead = {};  // plans that are known: their charts are not made again
};
// Requires kept.low + kept.high + 4 <= rows of the tube. `work` is empty before the first step. `done`: the last one was taken.
struct PlanningStep {
  ShortRowEvent what;
  bool done = false;
};
PlanningStep advance_planning(const ChartAt& at, std::optional<PlannedPairs>& work, const Heard& heard = {});

// The tube with its full rounds in place of the rows between the kept ones.
TubePlan with_full_rounds(const TubePlan& plan, const PlannedPairs& pairs, const KeptRows& kept);

// The plan of the same tube between the same rows, for the same stitch and prices; null: none is known.
const PlannedPairs* planned_ahead(const ChartAt& at);

// The gap over a round, from the placing of its pairs on.
struct GapWork {
  std::int32_t tube = -1, row = -1;      // of the tube: the round over the gap
  Shared<PairPlans> plans;               // of this gap
  Shared<std::vector<double>> columns;   // of the stitches of the round below, as pairs_over found them
  std::int32_t dropped = 0, worked = 0;  // of plans: told of
  bool placed = false, out = false;      // of the pair at `worked`
  [[nodiscard]] bool is_for(std::int32_t of_tube, std::int32_t of_row) const {
    return tube == of_tube && row == of_row && plans;
  }
  [[nodiscard]] bool done() const {
    return plans && dropped == static_cast<std::int32_t>(plans->dropped.size()) &&
           worked == static_cast<std::int32_t>(plans->pairs.size());
  }
  [[nodiscard]] auto fields() const {
    return std::tie(tube, row, plans, columns, dropped, worked, placed, out);
  }
  friend bool operator==(const GapWork&, const GapWork&) = default;
};

// Of the round below, in columns of the chart, rising from the round's first stitch on.
std::vector<double> columns_of(const PlannedPairs& pairs, const Row& below);

// `plain`: per stitch of the round below, whether the round to come works it one to one.
PairPlans pairs_over(const PlannedPairs& pairs, const Row& below, std::span<const double> columns,
                     std::span<const std::uint8_t> plain);

// Requires !work.done(). `row`: a short row, once it is worked; what the fabric has of the tube is `below` and the short rows on it.
Advanced<ShortRowEvent> advance_gap(const PlannedPairs& pairs, const Fabric& fabric, const Row& below,
                                    GapWork& work, std::optional<Row>& row);

}  // namespace knit
