#include "knit/stitches/index_stage.h"

#include <cmath>
#include <cstdlib>
#include <utility>

#include "knit/stitches/nearest.h"
#include "knit/stitches/stitch_index.h"

namespace knit {

namespace {

RowBelow row_below(const JoinAt& at) {
  RowBelow below{size_of(at.below), {}, at.before == nullptr};
  if (at.before != nullptr) below.mains = at.before->mains;
  return below;
}

Ended finish_join(const JoinAt& at, IndexWork& work, Shared<Join>& join) {
  join = work.plan;
  work = IndexWork{};
  return at.last ? Ended::stage : Ended::row;
}

TransitionCounted count(const StitchSettings& settings, const JoinAt& at, IndexWork& work) {
  const RowBelow below = row_below(at);
  const std::int32_t above = size_of(*at.above);
  work.phase = IndexPhase::space;
  const auto carried = static_cast<std::int32_t>(below.mains.size());
  const bool nearest = settings.placement == PlacementPolicy::nearest;
  return {below.size, above, above - below.size, nearest ? carried : mains_wanted(below.size, above),
          carried};
}

Join plan_nearest_join(const StitchSettings& settings, const StitchSize& stitch, const JoinAt& at) {
  const RowBelow below = row_below(at);
  const std::vector<std::uint8_t> shaped =
      at.before != nullptr ? shaped_by(*at.before) : std::vector<std::uint8_t>{};
  const double square = stitch.width * stitch.width;
  const NearestPenalties penalties{settings.stacking_penalty * square,
                                   settings.follow_mains == FollowMains::on ? square : 0.0};
  return plan_nearest({at.below.stitches, at.above->stitches, below.mains, shaped}, penalties, at.row);
}

Advanced<IndexEvent> space(const StitchSettings& settings, const StitchSize& stitch, const JoinAt& at,
                           IndexWork& work, Shared<Join>& join) {
  const bool nearest = settings.placement == PlacementPolicy::nearest;
  Join made = nearest ? plan_nearest_join(settings, stitch, at)
                      : plan_join(row_below(at), size_of(*at.above), at.row, settings.placement);
  made.from = at.from;
  work.plan = Shared(std::move(made));
  work.phase = IndexPhase::place;
  const Join& plan = *work.plan;
  std::int32_t mains = 0;
  for (const PlacedLabel& p : plan.placed) mains += p.label == Label::main ? 1 : 0;
  const IndexEvent step =
      nearest ? IndexEvent(RowsMatched{static_cast<std::int32_t>(plan.link.size()), std::abs(plan.change()),
                                       plan.sum_of_squares, std::sqrt(plan.longest_square)})
              : IndexEvent(SpacingChosen{plan.rule, plan.tried.value_or(plan.rule), plan.tried.has_value(),
                                         plan.spacing, plan.remainder, mains});
  return {step, plan.placed.empty() ? finish_join(at, work, join) : Ended::step};
}

Advanced<IndexEvent> place(const JoinAt& at, IndexWork& work, Shared<Join>& join) {
  const Shared<Join> planned = work.plan;
  const Join& plan = *planned;
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
  const Ended ended = last ? finish_join(at, work, join) : Ended::step;
  if (placed.label == Label::main) return {MainPlaced{placed.cell, mains}, ended};
  return {ShapingPlaced{placed.cell, partner, shaping, placed.label}, ended};
}

}  // namespace

Advanced<IndexEvent> advance_index(const StitchSettings& settings, const StitchSize& stitch, const JoinAt& at,
                                   IndexWork& work, Shared<Join>& join) {
  if (at.above == nullptr) {
    const std::int32_t only = size_of(at.below);
    return {TransitionCounted{only, only, 0, 0, 0}, Ended::stage};
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
