#include "knit/run/short_rows_due.h"

#include <algorithm>

namespace knit {

namespace {

constexpr std::int32_t fewest_rows = 4;  // of a chart

bool choice_is_due(const Parameters& parameters, const State& state, const ContourWork& work) {
  if (parameters.short_rows.rows == ShortRows::off || parameters.short_rows.kept != KeptBeside::by_itself)
    return false;
  return work.taken == 0 && work.phase == ContourPhase::take && state.fabric.empty() &&
         !(state.short_rows.kept && state.short_rows.chosen_for == to_choose_for(parameters));
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

KeptRows rows_kept(const TubePlan& plan, TubeId id, std::int32_t beside) {
  const Tube& tube = plan.tube(id);
  KeptRows kept{plan.event(tube.bottom).kind == EventKind::cast_on ? 0 : beside,
                plan.event(tube.top).kind == EventKind::bind_off ? 0 : beside};
  const auto left = [&] { return tube.rows() - kept.low - kept.high; };
  const auto short_at = [&](std::int32_t row) {
    return too_short(*tube.curves[static_cast<std::size_t>(row)], plan.stitch_width);
  };
  while (left() > 1 && short_at(kept.low)) ++kept.low;
  while (left() > 1 && short_at(tube.rows() - 1 - kept.high)) ++kept.high;
  return kept;
}

bool can_be_charted(const TubePlan& plan, TubeId id, std::int32_t beside) {
  const KeptRows kept = rows_kept(plan, id, beside);
  return plan.tube(id).rows() - kept.low - kept.high >= fewest_rows;
}

ChosenFor to_choose_for(const Parameters& parameters) {
  const ShortRowSettings& settings = parameters.short_rows;
  return {parameters.stitch.width,
          parameters.stitch.height,
          {settings.turn_cost, settings.turn_step, settings.shortest}};
}

std::int32_t rows_beside_events(const Parameters& parameters, const State& state) {
  switch (parameters.short_rows.kept) {
    case KeptBeside::none:
      return 0;
    case KeptBeside::one:
      return 1;
    case KeptBeside::two:
      return 2;
    case KeptBeside::by_itself:
      break;
  }
  // With the first row the choice is made: tubes to come keep it, for another stitch too.
  if (state.fabric.empty() && state.short_rows.chosen_for != to_choose_for(parameters)) return no_short_rows;
  return state.short_rows.kept.value_or(no_short_rows);
}

bool begins_in_middle(const Parameters& parameters, const TubePlan& plan, TubeId tube, const KeptRows& kept) {
  return kept.low == 0 && plan.event(plan.tube(tube).bottom).kind == EventKind::cast_on &&
         !parameters.rows.start_direction && parameters.rows.round_start == RoundStart::follow;
}

const Row* last_round(const Fabric& fabric, TubeId tube) {
  for (RowId id = fabric.row_count(); id > 0; --id) {
    if (const Row& row = fabric.row(id); row.tube == tube && !is_short(row)) return &row;
  }
  return nullptr;
}

ShortRowsDue short_rows_due(const Parameters& parameters, const State& state) {
  const auto* work = std::get_if<ContourWork>(&state.work);
  if (work == nullptr) return ShortRowsDue::none;
  if (choice_is_due(parameters, state, *work)) return ShortRowsDue::choice;
  if (work->taken == 0) return ShortRowsDue::none;
  const TubeId id = current_tube(*state.tubes, *work);
  const PlannedPairs* pairs = pairs_of(state, id);
  if (pairs == nullptr) {
    const std::int32_t beside = rows_beside_events(parameters, state);
    const bool due = parameters.short_rows.rows == ShortRows::automatic && beside >= 0 &&
                     work->phase == ContourPhase::cut && work->row == 0 &&
                     can_be_charted(*state.tubes, id, beside);
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
  const TubeId tube = current_tube(*state.tubes, work);
  const PlannedPairs* pairs = pairs_of(state, tube);
  return pairs != nullptr && pairs->none == NoChart::no && work.row <= pairs->rounds.gaps() &&
         begins_in_middle(parameters, *state.tubes, tube, {pairs->low_row, 0});
}

}  // namespace knit
