#include "knit/rhythm/few_rounds.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "knit/model/ties.h"
#include "knit/rhythm/segment_search.h"
#include "knit/rhythm/segment_states.h"

namespace knit {

namespace {

constexpr double no_repeat_costs = 9.0;
constexpr std::int32_t fewest = 3;

struct Count {
  std::int32_t stitches = 0;
  double cost = never;
  std::size_t from = 0;  // of the counts of the round before
};
using Counts = std::vector<Count>;

// What a round may have that is worked on `below` stitches.
bool may_follow(std::int32_t below, std::int32_t count) { return 2 * count >= below && count <= 2 * below; }

// Within reach of the ideal, and what comes nearest to it on each count of the round before.
Counts counts_near(double ideal, const Counts& before) {
  const double reach = std::max(2.0, ideal / 10.0);
  std::vector<std::int32_t> near;
  const auto first = static_cast<std::int32_t>(std::ceil(ideal - reach));
  const auto last = static_cast<std::int32_t>(std::floor(ideal + reach));
  for (std::int32_t count = std::max(fewest, first); count <= last; ++count) near.push_back(count);
  for (const Count& below : before) {
    const std::int32_t least = std::max(fewest, (below.stitches + 1) / 2);
    const auto nearest = static_cast<std::int32_t>(rounded(ideal));
    near.push_back(std::clamp(nearest, least, std::max(least, 2 * below.stitches)));
  }
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  Counts counts;
  for (const std::int32_t count : near) counts.push_back({count});
  return counts;
}

double cost_of(double ideal, std::int32_t below, std::int32_t count, bool in_pairs) {
  const double off = count - ideal;
  const bool one_repeat = count == below || sections_to_begin(below, count, in_pairs) > 0;
  return off * off + (one_repeat ? 0.0 : no_repeat_costs);
}

std::size_t cheapest(const Counts& counts) {
  std::size_t least = 0;
  for (std::size_t i = 1; i < counts.size(); ++i) {
    if (clearly_less(counts[i].cost, counts[least].cost, no_repeat_costs)) least = i;
  }
  return least;
}

}  // namespace

RhythmPlan plan_few_rounds(std::span<const double> ideals, std::int32_t live, bool in_pairs) {
  std::vector<Counts> rounds{{{live, 0.0}}};
  for (const double ideal : ideals) {
    const Counts& before = rounds.back();
    Counts counts = counts_near(ideal, before);
    for (Count& count : counts) {
      for (std::size_t i = 0; i < before.size(); ++i) {
        if (before[i].cost == never || !may_follow(before[i].stitches, count.stitches)) continue;
        const double cost = before[i].cost + cost_of(ideal, before[i].stitches, count.stitches, in_pairs);
        if (count.cost == never || clearly_less(cost, count.cost, no_repeat_costs))
          count = {count.stitches, cost, i};
      }
    }
    rounds.push_back(std::move(counts));
  }
  RhythmPlan plan;
  plan.sections = 1;
  std::size_t at = cheapest(rounds.back());
  for (std::size_t round = rounds.size() - 1; round > 0; --round) {
    const Count& here = rounds[round][at];
    const Count& below = rounds[round - 1][here.from];
    const bool first = round == 1;
    const bool plain = here.stitches == below.stitches;
    plan.counts.push_back(here.stitches);
    plan.roles.push_back(first ? RowRole::first : plain ? RowRole::plain : RowRole::change);
    plan.changes = std::max(plan.changes, std::abs(here.stitches - below.stitches));
    at = here.from;
  }
  std::reverse(plan.counts.begin(), plan.counts.end());
  std::reverse(plan.roles.begin(), plan.roles.end());
  return plan;
}

}  // namespace knit
