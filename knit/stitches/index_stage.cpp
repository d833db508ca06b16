#include "knit/stitches/index_stage.h"

#include <cmath>
#include <cstdlib>
#include <utility>

#include "knit/stitches/placement.h"
#include "knit/stitches/short_join.h"
#include "knit/stitches/stitch_index.h"

namespace knit {

namespace {

std::int32_t count_of(std::span<const Stitch> stitches) { return static_cast<std::int32_t>(stitches.size()); }

RowBelow row_below(const JoinAt& at) {
  return {count_of(at.below), {at.mains.begin(), at.mains.end()}, at.cast_on};
}

Ended finish_join(const JoinAt& at, IndexWork& work, Shared<Join>& join) {
  join = work.plan;
  work = IndexWork{};
  return at.last ? Ended::stage : Ended::row;
}

JoinCounted count(const StitchSettings& settings, const JoinAt& at, IndexWork& work) {
  const RowBelow below = row_below(at);
  const std::int32_t above = size_of(*at.above);
  work.phase = IndexPhase::space;
  const auto carried = static_cast<std::int32_t>(below.mains.size());
  if (is_short(*at.above)) return {below.size, above, 0, carried, carried};
  if (at.repeat) return {below.size, above, above - below.size, at.repeat->sections, carried};
  const bool by_place = placement_of(settings.placement).by_place;
  return {below.size, above, above - below.size, by_place ? carried : mains_wanted(below.size, above),
          carried};
}

Advanced<IndexEvent> space(const StitchSettings& settings, const StitchSize& stitch, const JoinAt& at,
                           IndexWork& work, Shared<Join>& join) {
  Join made = plan_row_join(settings, stitch, at);
  made.from = at.from;
  work.plan = Shared(std::move(made));
  work.phase = IndexPhase::place;
  const Join& planned = *work.plan;
  std::int32_t mains = 0;
  for (const PlacedLabel& p : planned.placed) mains += p.label == Label::main ? 1 : 0;
  const IndexEvent step =
      !at.repeat && !is_short(*at.above) && placement_of(settings.placement).by_place
          ? IndexEvent(RowsMatched{static_cast<std::int32_t>(planned.link.size()), std::abs(planned.change()),
                                   planned.sum_of_squares, std::sqrt(planned.longest_square)})
          : IndexEvent(SpacingChosen{planned.rule, planned.tried.value_or(planned.rule),
                                     planned.tried.has_value(), planned.spacing, planned.remainder, mains});
  return {step, planned.placed.empty() ? finish_join(at, work, join) : Ended::step};
}

Advanced<IndexEvent> place(const JoinAt& at, IndexWork& work, Shared<Join>& join) {
  const Shared<Join> planned = work.plan;
  const Join& plan = *planned;
  const PlacedLabel placed = plan.placed[static_cast<std::size_t>(work.placed)];
  ++work.placed;
  std::int32_t shaping = 0;
  std::int32_t mains = 0;
  for (std::int32_t i = 0; i < work.placed; ++i) {
    const Label label = plan.placed[static_cast<std::size_t>(i)].label;
    if (label == Label::main) ++mains;
    if (is_shaping(label)) ++shaping;
  }
  const std::int32_t partner = plan.partner[static_cast<std::size_t>(placed.cell)];
  const bool last = work.placed == static_cast<std::int32_t>(plan.placed.size());
  const Ended ended = last ? finish_join(at, work, join) : Ended::step;
  if (placed.label == Label::main) return {MainPlaced{placed.cell, mains}, ended};
  if (!is_shaping(placed.label)) return {TurnPlaced{placed.cell, placed.label}, ended};
  return {ShapingPlaced{placed.cell, partner, shaping, placed.label}, ended};
}

}  // namespace

namespace {

Join plan_round_join(const StitchSettings& settings, const StitchSize& stitch, const JoinAt& at) {
  if (at.repeat) return plan_repeats(*at.repeat);
  const Placement& placement = placement_of(settings.placement);
  const RowBelow below = row_below(at);
  if (!placement.by_place) return placement.plan({below, size_of(*at.above), at.row});
  const double square = stitch.width * stitch.width;
  const NearestPenalties penalties{settings.stacking_penalty * square,
                                   settings.follow_mains == FollowMains::on ? square : 0.0};
  return placement.plan(
      {below, size_of(*at.above), at.row, at.below, at.above->stitches, at.shaped, penalties, at.follows});
}

}  // namespace

Join plan_row_join(const StitchSettings& settings, const StitchSize& stitch, const JoinAt& at) {
  Join join =
      is_short(*at.above) ? plan_short_join(at.mains, *at.above) : plan_round_join(settings, stitch, at);
  mark_turns(join, at.marked);
  return join;
}

Advanced<IndexEvent> advance_index(const StitchSettings& settings, const StitchSize& stitch, const JoinAt& at,
                                   IndexWork& work, Shared<Join>& join) {
  if (at.above == nullptr) {
    const std::int32_t only = count_of(at.below);
    return {JoinCounted{only, only, 0, 0, 0}, Ended::stage};
  }
  switch (work.phase) {
    case IndexPhase::count:
      return count(settings, at, work);
    case IndexPhase::space:
      return space(settings, stitch, at, work, join);
    case IndexPhase::place:
      break;
  }
  return place(at, work, join);
}

}  // namespace knit
