#include <cmath>
#include <cstdlib>
#include <utility>

#include "knit/run/machine.h"
#include "knit/stitches/nearest.h"
#include "knit/stitches/stitch_index.h"

namespace knit {

namespace {

// The transition into row `row`, counted from 1.
RowBelow row_below(const State& state, std::int32_t row) {
  const auto i = static_cast<std::size_t>(row) - 2;
  RowBelow below{size_of(*state.rows[i]), {}, i == 0};
  if (i > 0) below.mains = state.transitions[i - 1]->mains;
  return below;
}

void finish_transition(State& state, const IndexWork& work) {
  state.transitions.push_back(work.plan);
  if (state.transitions.size() + 1 < state.rows.size()) {
    const std::int32_t row = state.next.row + 1;
    state.work = IndexWork{};
    state.next = {Stage::stitches, row, 0};
  } else {
    state.work = FacesWork{};
    state.next = {Stage::faces, 2, 0};
  }
}

Happening count(const Parameters& parameters, const State& state, IndexWork& work) {
  const RowBelow below = row_below(state, state.next.row);
  const std::int32_t above = size_of(*state.rows[static_cast<std::size_t>(state.next.row) - 1]);
  work.phase = IndexPhase::space;
  const auto carried = static_cast<std::int32_t>(below.mains.size());
  const bool nearest = parameters.placement == PlacementPolicy::nearest;
  return TransitionCounted{below.size, above, above - below.size,
                           nearest ? carried : mains_wanted(below.size, above), carried};
}

Transition plan_nearest_transition(const Parameters& parameters, const State& state, std::int32_t row) {
  const auto i = static_cast<std::size_t>(row) - 2;
  const RowBelow below = row_below(state, row);
  const std::vector<std::uint8_t> shaped =
      i > 0 ? shaped_by(*state.transitions[i - 1]) : std::vector<std::uint8_t>{};
  const double square = parameters.stitch_width * parameters.stitch_width;
  const NearestPenalties penalties{parameters.stacking_penalty * square,
                                   parameters.follow_mains == FollowMains::on ? square : 0.0};
  return plan_nearest({state.rows[i]->stitches, state.rows[i + 1]->stitches, below.mains, shaped}, penalties,
                      row);
}

Happening space(const Parameters& parameters, State& state, IndexWork& work) {
  const std::int32_t row = state.next.row;
  const std::int32_t above = size_of(*state.rows[static_cast<std::size_t>(row) - 1]);
  const bool nearest = parameters.placement == PlacementPolicy::nearest;
  work.plan = Shared(nearest ? plan_nearest_transition(parameters, state, row)
                             : plan_transition(row_below(state, row), above, row, parameters.placement));
  work.phase = IndexPhase::place;
  const Transition& plan = *work.plan;
  std::int32_t mains = 0;
  for (const PlacedLabel& p : plan.placed) mains += p.label == Label::main ? 1 : 0;
  const Happening step =
      nearest ? Happening(RowsMatched{static_cast<std::int32_t>(plan.link.size()), std::abs(plan.change()),
                                      plan.sum_of_squares, std::sqrt(plan.longest_square)})
              : Happening(SpacingChosen{plan.rule, plan.tried.value_or(plan.rule), plan.tried.has_value(),
                                        plan.spacing, plan.remainder, mains});
  if (plan.placed.empty()) finish_transition(state, IndexWork{work});
  return step;
}

Happening place(State& state, IndexWork& work) {
  const Transition& plan = *work.plan;
  const PlacedLabel placed = plan.placed[static_cast<std::size_t>(work.placed)];
  ++work.placed;
  std::int32_t shaping = 0;
  std::int32_t mains = 0;
  for (std::int32_t i = 0; i < work.placed; ++i) {
    const bool main = plan.placed[static_cast<std::size_t>(i)].label == Label::main;
    (main ? mains : shaping) += 1;
  }
  const std::int32_t partner = plan.partner[static_cast<std::size_t>(placed.cell)];
  const bool last = work.placed == static_cast<std::int32_t>(plan.placed.size());
  if (last) finish_transition(state, IndexWork{work});
  if (placed.label == Label::main) return MainPlaced{placed.cell, mains};
  return ShapingPlaced{placed.cell, partner, shaping, placed.label};
}

}  // namespace

Happening advance_stitches(const Parameters& parameters, State& state) {
  // A single row has no transition: its only step says so, and nothing is placed.
  if (state.rows.size() < 2) {
    const std::int32_t only = size_of(*state.rows.front());
    state.work = PatternWork{};
    state.next = {Stage::pattern, 1, 0};
    return TransitionCounted{only, only, 0, 0, 0};
  }
  auto& work = std::get<IndexWork>(state.work);
  switch (work.phase) {
    case IndexPhase::count:
      return count(parameters, state, work);
    case IndexPhase::space:
      return space(parameters, state, work);
    case IndexPhase::place:
      break;
  }
  return place(state, work);
}

}  // namespace knit
