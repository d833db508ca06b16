#include <cmath>
#include <cstdlib>
#include <utility>

#include "knit/run/machine.h"
#include "knit/stitches/nearest.h"
#include "knit/stitches/stitch_index.h"

namespace knit {

namespace {

// What row `row` is worked on.
RowBelow row_below(const State& state, std::int32_t row) {
  const Row& on = *state.fabric.row_below(row);
  const Join* into = state.fabric.join_into(on.id);
  RowBelow below{size_of(on), {}, into == nullptr};
  if (into != nullptr) below.mains = into->mains;
  return below;
}

void finish_join(State& state, const IndexWork& work) {
  state.fabric.add(work.plan);
  if (const RowId row = state.next.row + 1; state.fabric.has_row(row)) {
    state.work = IndexWork{};
    state.next = {Stage::stitches, row, 0};
  } else {
    state.work = FacesWork{};
    state.next = {Stage::faces, 2, 0};
  }
}

Happening count(const Parameters& parameters, const State& state, IndexWork& work) {
  const RowBelow below = row_below(state, state.next.row);
  const std::int32_t above = size_of(state.fabric.row(state.next.row));
  work.phase = IndexPhase::space;
  const auto carried = static_cast<std::int32_t>(below.mains.size());
  const bool nearest = parameters.placement == PlacementPolicy::nearest;
  return TransitionCounted{below.size, above, above - below.size,
                           nearest ? carried : mains_wanted(below.size, above), carried};
}

Join plan_nearest_join(const Parameters& parameters, const State& state, std::int32_t row) {
  const RowBelow below = row_below(state, row);
  const Row& on = *state.fabric.row_below(row);
  const Join* into = state.fabric.join_into(on.id);
  const std::vector<std::uint8_t> shaped = into != nullptr ? shaped_by(*into) : std::vector<std::uint8_t>{};
  const double square = parameters.stitch_width * parameters.stitch_width;
  const NearestPenalties penalties{parameters.stacking_penalty * square,
                                   parameters.follow_mains == FollowMains::on ? square : 0.0};
  return plan_nearest({on.stitches, state.fabric.row(row).stitches, below.mains, shaped}, penalties, row);
}

Happening space(const Parameters& parameters, State& state, IndexWork& work) {
  const std::int32_t row = state.next.row;
  const std::int32_t above = size_of(state.fabric.row(row));
  const bool nearest = parameters.placement == PlacementPolicy::nearest;
  Join made = nearest ? plan_nearest_join(parameters, state, row)
                      : plan_join(row_below(state, row), above, row, parameters.placement);
  made.from = state.fabric.live_below(row);
  work.plan = Shared(std::move(made));
  work.phase = IndexPhase::place;
  const Join& plan = *work.plan;
  std::int32_t mains = 0;
  for (const PlacedLabel& p : plan.placed) mains += p.label == Label::main ? 1 : 0;
  const Happening step =
      nearest ? Happening(RowsMatched{static_cast<std::int32_t>(plan.link.size()), std::abs(plan.change()),
                                      plan.sum_of_squares, std::sqrt(plan.longest_square)})
              : Happening(SpacingChosen{plan.rule, plan.tried.value_or(plan.rule), plan.tried.has_value(),
                                        plan.spacing, plan.remainder, mains});
  if (plan.placed.empty()) finish_join(state, IndexWork{work});
  return step;
}

Happening place(State& state, IndexWork& work) {
  const Join& plan = *work.plan;
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
  if (last) finish_join(state, IndexWork{work});
  if (placed.label == Label::main) return MainPlaced{placed.cell, mains};
  return ShapingPlaced{placed.cell, partner, shaping, placed.label};
}

}  // namespace

Happening advance_stitches(const Parameters& parameters, State& state) {
  // A single row has no join: its only step says so, and nothing is placed.
  if (state.fabric.row_count() < 2) {
    const std::int32_t only = state.fabric.live().size();
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
