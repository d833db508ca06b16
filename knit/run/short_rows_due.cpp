#include "knit/run/short_rows_due.h"

#include <algorithm>

namespace knit {

namespace {

constexpr std::int32_t fewest_rows = 4;  // of a chart

// Pieces of one tube only: where loops part, lag is partly the saddle's own.
bool can_be_charted(const TubePlan& plan, TubeId tube) {
  return plan.tubes.size() == 1 && plan.tube(tube).rows() >= fewest_rows;
}

bool is_planned_for(const PlannedPairs& pairs, const StitchSize& stitch) {
  return pairs.stitch_width == stitch.width && pairs.stitch_height == stitch.height;
}

}  // namespace

const PlannedPairs* pairs_of(const State& state, TubeId tube) {
  for (const Shared<PlannedPairs>& pairs : state.short_rows.tubes) {
    if (pairs->tube == tube) return &*pairs;
  }
  return nullptr;
}

KeptRows rows_kept(const TubePlan& /*plan*/, TubeId /*tube*/) { return {}; }

const Row* last_round(const Fabric& fabric, TubeId tube) {
  for (RowId id = fabric.row_count(); id > 0; --id) {
    if (const Row& row = fabric.row(id); row.tube == tube && !is_short(row)) return &row;
  }
  return nullptr;
}

ShortRowsDue short_rows_due(const Parameters& parameters, const State& state) {
  const auto* work = std::get_if<ContourWork>(&state.work);
  if (work == nullptr || work->taken == 0) return ShortRowsDue::none;
  const TubeId id = current_tube(*state.tubes, *work);
  const PlannedPairs* pairs = pairs_of(state, id);
  if (pairs == nullptr) {
    const bool due = parameters.short_rows.rows == ShortRows::automatic && work->phase == ContourPhase::cut &&
                     work->row == 0 && can_be_charted(*state.tubes, id);
    return due ? ShortRowsDue::plan : ShortRowsDue::none;
  }
  const bool between =
      work->phase == ContourPhase::take && work->row > 0 && work->row < state.tubes->tube(id).rows();
  if (!between || !is_planned_for(*pairs, parameters.stitch) || pairs->arcs_over(work->row - 1).empty())
    return ShortRowsDue::none;
  const GapWork& gap = state.short_rows.gap;
  return gap.is_for(id, work->row) && gap.done() ? ShortRowsDue::none : ShortRowsDue::gap;
}

bool begins_on_curve(const Parameters& parameters, const State& state, const ContourWork& work) {
  if (work.taken == 0) return false;
  const PlannedPairs* pairs = pairs_of(state, current_tube(*state.tubes, work));
  return pairs != nullptr && pairs->none == NoChart::no && !parameters.rows.start_direction &&
         parameters.rows.round_start == RoundStart::follow;
}

}  // namespace knit
