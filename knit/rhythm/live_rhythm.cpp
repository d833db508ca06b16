#include "knit/rhythm/live_rhythm.h"

#include <utility>
#include <vector>

#include "knit/model/ties.h"
#include "knit/rhythm/rhythm_plan.h"

namespace knit {

namespace {

// As plan_rhythm chooses among its own.
bool reads_better(const RhythmPlan& one, const RhythmPlan& other) {
  if (one.within != other.within) return one.within;
  const auto rank = [](const RhythmPlan& plan) {
    return plan.within ? plan.score : 1.5 * plan.seen.worst() + 0.3 * plan.score;
  };
  return clearly_less(rank(one), rank(other), 1.0);
}

}  // namespace

std::optional<LiveRhythm> plan_rhythm_on(std::span<const double> ideals, const RhythmSettings& settings,
                                         const BeginsOn& on, const Heard& heard) {
  const std::vector<double> rows(ideals.begin(), ideals.end());
  std::optional<LiveRhythm> best;
  const RhythmStart first_round{0, 0, SegmentEnd::start, on.live};
  if (auto plan = plan_rhythm(resized_ideals(rows), settings, first_round, part_of(heard, 0.0, 0.5)))
    best = {0, *std::move(plan)};
  if (on.shared && best) return best;
  std::vector<double> with_live = rows;
  with_live.insert(with_live.begin(), static_cast<double>(on.live));
  auto plan = plan_rhythm(resized_ideals(std::move(with_live)), settings, {0, on.live, SegmentEnd::start, 0},
                          part_of(heard, 0.5, 1.0));
  if (!plan || (best && !reads_better(*plan, best->plan))) return best;
  if (plan->seen.row > 0) --plan->seen.row;
  return LiveRhythm{-1, *std::move(plan)};
}

std::optional<LiveRhythm> plan_halves_on(const HalfIdeals& ideals, const RhythmSettings& settings,
                                         const BeginsOn& on, const Heard& heard) {
  std::optional<LiveRhythm> best;
  const RhythmStart first_round{0, 0, SegmentEnd::start, on.live};
  if (auto plan = plan_joint(ideals, settings, first_round, 0, part_of(heard, 0.0, 0.5)))
    best = {0, *std::move(plan)};
  if (on.shared || on.live % 2 != 0) return best;
  HalfIdeals with_live = ideals;
  const double behind = ideals.back.front() / (ideals.front.front() + ideals.back.front());
  with_live.front.insert(with_live.front.begin(), (1.0 - behind) * on.live);
  with_live.back.insert(with_live.back.begin(), behind * on.live);
  auto plan =
      plan_joint(with_live, settings, {0, on.live, SegmentEnd::start, 0}, 0, part_of(heard, 0.5, 1.0));
  if (!plan || (best && !halves_read_better(*plan, best->plan))) return best;
  if (plan->seen.row > 0) --plan->seen.row;
  return LiveRhythm{-1, *std::move(plan)};
}

bool may_begin_on(const RhythmPlan& plan, std::int32_t live) {
  const std::int32_t first = plan.counts.front();
  return live == 0 || (2 * first >= live && first <= 2 * live);
}

}  // namespace knit
