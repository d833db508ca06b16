#include "knit/rhythm/joint_plan.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "knit/model/ties.h"
#include "knit/rhythm/joint_search.h"
#include "knit/rhythm/rhythm_plan.h"

namespace knit {

namespace {

struct Way {
  HalvesChange change;  // with its sign
  std::int32_t rounds = 0;
};

std::vector<Way> ways_to_shape(std::span<const RhythmSegment> segments) {
  std::vector<Way> ways;
  for (const RhythmSegment& segment : segments) {
    if (segment.change == 0) continue;
    const HalvesChange change{segment.front, segment.change - segment.front};
    const auto same =
        std::find_if(ways.begin(), ways.end(), [&](const Way& way) { return way.change == change; });
    if (same == ways.end())
      ways.push_back({change, segment.times});
    else
      same->rounds += segment.times;
  }
  return ways;
}

// The list, and once more with fewer ways to shape where it has too many.
std::optional<FoundJoint> with_few_ways(JointTask task) {
  std::optional<FoundJoint> found = find_joint_segments(task);
  if (!found) return found;
  std::vector<Way> ways = ways_to_shape(found->segments);
  if (ways.size() <= most_ways_to_shape) return found;
  std::stable_sort(ways.begin(), ways.end(), [](const Way& a, const Way& b) { return a.rounds > b.rounds; });
  ways.resize(most_ways_to_shape);
  std::vector<HalvesChange> growing, shrinking;
  for (const Way& way : ways) {
    if (way.change.front + way.change.back > 0)
      growing.push_back(way.change);
    else
      shrinking.push_back({-way.change.front, -way.change.back});
  }
  task.growing = growing;
  task.shrinking = shrinking;
  if (auto fewer = find_joint_segments(task)) return fewer;
  const std::span<const HalvesChange> plainest = std::span(halves_changes).first(3);
  task.growing = task.shrinking = plainest;
  return find_joint_segments(task);
}

// Of a half alone, where there is something to see (deviation.h).
double off_by(std::span<const std::int32_t> counts, std::span<const double> ideals) {
  constexpr double judged = 12.0;
  const double belt = *std::max_element(ideals.begin(), ideals.end());
  const std::vector<double> seen = seen_deviations(counts, ideals);
  double most = 0.0;
  for (std::size_t row = 0; row < seen.size(); ++row) {
    if (ideals[row] >= std::min(judged, belt / 2.0)) most = std::max(most, std::abs(seen[row]));
  }
  return 100.0 * most / belt;
}

RhythmPlan plan_of(FoundJoint found, const HalfIdeals& ideals, std::span<const double> whole,
                   const RhythmStart& start) {
  RhythmPlan plan;
  plan.segments = std::move(found.segments);
  plan.cost = found.cost;
  plan.counts = counts_of(found.first_front + found.first_back, plan.segments);
  plan.fronts = fronts_of(found.first_front, plan.segments);
  plan.roles = roles_of(plan.segments);
  plan.sections = 4;
  for (const RhythmSegment& segment : plan.segments)
    plan.changes = std::max(plan.changes, std::abs(segment.change));
  const auto from = static_cast<std::size_t>(start.row);
  std::vector<std::int32_t> backs;
  for (std::size_t i = 0; i < plan.counts.size(); ++i) backs.push_back(plan.counts[i] - plan.fronts[i]);
  plan.front_off = off_by(plan.fronts, std::span(ideals.front).subspan(from));
  plan.back_off = off_by(backs, std::span(ideals.back).subspan(from));
  plan.seen = seen_deviation(plan.counts, whole.subspan(from));
  plan.seen.row += start.row;
  plan.score = rhythm_score(plan, start);
  return plan;
}

}  // namespace

bool halves_read_better(const RhythmPlan& one, const RhythmPlan& other) {
  if (one.within != other.within) return one.within;
  const auto rank = [](const RhythmPlan& plan) {
    return 1.5 * std::max({plan.seen.worst(), plan.front_off, plan.back_off}) + 0.3 * plan.score;
  };
  return clearly_less(rank(one), rank(other), 1.0);
}

bool may_plan_jointly(const RhythmSettings& settings) {
  return settings.halves == RhythmHalves::by_themselves && settings.style == RhythmStyle::pairs &&
         settings.changes == 0;
}

bool wants_joint_plan(const HalfIdeals& ideals, const RhythmSettings& settings) {
  constexpr double most_off = 1.5;
  if (!may_plan_jointly(settings)) return false;
  double belt = 0.0;
  for (std::size_t row = 0; row < ideals.front.size(); ++row)
    belt = std::max(belt, ideals.front[row] + ideals.back[row]);
  if (clearly_less(belt, narrowest_in_halves, belt)) return false;
  for (std::size_t row = 0; row < ideals.front.size(); ++row) {
    // A half's quarter against a quarter of the whole.
    const double off = std::abs(ideals.front[row] - ideals.back[row]) / 4.0;
    if (clearly_less(most_off, off, ideals.front[row] + ideals.back[row])) return true;
  }
  return false;
}

std::optional<RhythmPlan> plan_joint(const HalfIdeals& ideals, const RhythmSettings& settings,
                                     const RhythmStart& start, std::int32_t start_front, const Heard& heard) {
  std::vector<double> whole;
  for (std::size_t row = 0; row < ideals.front.size(); ++row)
    whole.push_back(ideals.front[row] + ideals.back[row]);
  const std::span<const double> tried = settings.dial > 0.0 ? std::span(&settings.dial, 1) : rhythm_dials();
  std::optional<RhythmPlan> best;
  for (std::size_t i = 0; i < tried.size(); ++i) {
    const auto searches = static_cast<double>(tried.size()), searched = static_cast<double>(i);
    JointTask task{ideals.front, ideals.back, rhythm_prices({4, false, true}, tried[i], whole), start,
                   start_front};
    task.heard = part_of(heard, searched / searches, (searched + 1.0) / searches);
    std::optional<FoundJoint> found = with_few_ways(task);
    if (!found) return std::nullopt;
    RhythmPlan plan = plan_of(*std::move(found), ideals, whole, start);
    plan.dial = tried[i];
    plan.within = !clearly_less(settings.tolerance, plan.seen.worst(), 1.0);
    if (!best || halves_read_better(plan, *best)) best = std::move(plan);
  }
  return best;
}

}  // namespace knit
