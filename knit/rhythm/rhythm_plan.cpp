#include "knit/rhythm/rhythm_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "knit/model/ties.h"

namespace knit {

namespace {

constexpr std::array dials{8.0 / 3.0, 1.0, 7.0 / 15.0, 0.2, 0.08, 1.0 / 30.0};

// In microseconds, roughly and at most.
double microseconds_to_try_all(double rows, double belt) {
  constexpr double of_a_row_and_two_counts = 0.1;
  return of_a_row_and_two_counts * rows * belt * belt;
}
// A piece that would take longer is looked at in small first. A ball of 50 cm at 22 x 32 does not.
constexpr double longest_to_try_all = 4e6;

// By Newton from above, until rounding ends the descent; of 1 or more. The C library's differs from one to the next.
double cube_root(double of) {
  double root = of;
  for (double next = of;; root = next) {
    next = (2.0 * root + of / (root * root)) / 3.0;
    if (next >= root) return root;
  }
}

constexpr std::array one_a_section{4, 5, 6, 7, 8, 9, 10, 12};
constexpr std::array pairs_alone{2, 3, 4, 5, 6};
constexpr std::array pairs_or_halves{3, 4, 6};

std::vector<RhythmFamily> families_of(const RhythmSettings& settings) {
  std::vector<RhythmFamily> families;
  if (settings.style != RhythmStyle::pairs || settings.changes % 2 == 1) {
    if (settings.changes > 0) return {{settings.changes, true, false}};
    for (const std::int32_t sections : one_a_section) families.push_back({sections, true, false});
    return families;
  }
  if (settings.changes > 0) return {{settings.changes / 2, false, true}, {settings.changes / 2, true, true}};
  for (const std::int32_t sections : pairs_alone) families.push_back({sections, false, true});
  for (const std::int32_t sections : pairs_or_halves) families.push_back({sections, true, true});
  return families;
}

// What a piece of this width may be made of: enough stitches for a few shaping rounds. On a narrow one the smallest number
// of changes is all there is.
std::vector<RhythmFamily> families_for(const RhythmSettings& settings, double belt) {
  std::vector<RhythmFamily> families = families_of(settings);
  if (settings.changes > 0) return families;
  const auto too_many = [&](const RhythmFamily& family) { return family.changes() > belt / 3.4; };
  const RhythmFamily least = families.front();
  families.erase(std::remove_if(families.begin(), families.end(), too_many), families.end());
  if (!families.empty()) return families;
  return {least, {3, true, false}};
}

double belt_of(std::span<const double> ideals) { return *std::max_element(ideals.begin(), ideals.end()); }

// As it was asked for; and so that a number of stitches that the family has is exactly the widest row's, unless that is far.
std::vector<double> sizes_for(const RhythmFamily& family, double belt, bool may_change_size) {
  constexpr double least = 0.004;
  constexpr double most = 0.04;
  std::vector<double> sizes{1.0};
  const double size = family.sections * rounded(belt / family.sections) / belt;
  const double change = std::abs(size - 1.0);
  if (may_change_size && change > least && change <= most) sizes.push_back(size);
  return sizes;
}

// One search for segments; all of them are tried.
struct Attempt {
  RhythmFamily family;
  double size = 1.0;
  double dial = 0.0;
};

double preference(std::int32_t changes) {
  switch (changes) {
    case 4:
    case 6:
    case 8:
    case 12:
      return 0.0;
    case 3:
    case 5:
    case 9:
    case 10:
      return 0.5;
    case 7:
      return 1.0;
    default:
      return 2.0;
  }
}

std::vector<double> opening_half(std::span<const double> ideals) {
  std::vector<double> half;
  for (std::size_t row = 0; row < (ideals.size() + 1) / 2; ++row)
    half.push_back((ideals[row] + ideals[ideals.size() - 1 - row]) / 2.0);
  return half;
}

// Within the tolerance by what reads best, else by shape and words together.
bool is_better(const RhythmPlan& one, const RhythmPlan& other) {
  if (one.within != other.within) return one.within;
  const auto rank = [](const RhythmPlan& plan) {
    return plan.within ? plan.score : 1.5 * plan.seen.worst() + 0.3 * plan.score;
  };
  return clearly_less(rank(one), rank(other), 1.0);
}

struct Attempted {
  RhythmPlan plan;
  Attempt by;
};

// What the attempts come to, in their order; a rhythm that never comes near the widest row is left out, as long as there is another.
std::vector<Attempted> plans_of(const IdealsAt& ideals, const std::vector<Attempt>& attempts,
                                double tolerance, const RhythmStart& start, const Heard& heard) {
  std::vector<Attempted> plans;
  std::vector<double> sized;
  double size = 0.0;  // of `sized`
  for (std::size_t i = 0; i < attempts.size(); ++i) {
    const Attempt& attempt = attempts[i];
    if (attempt.size != size) {
      sized = ideals(attempt.size);
      size = attempt.size;
    }
    const auto all = static_cast<double>(attempts.size()), tried = static_cast<double>(i);
    const Heard part = part_of(heard, tried / all, (tried + 1.0) / all);
    std::optional<RhythmPlan> plan = plan_family(sized, attempt.family, attempt.dial, start, part);
    if (!plan) continue;
    plan->size = attempt.size;
    plan->score = rhythm_score(*plan, start);
    plan->within = !clearly_less(tolerance, plan->seen.worst(), 1.0);
    plans.push_back({*std::move(plan), attempt});
  }
  const double asked_belt = belt_of(ideals(1.0));
  const auto too_narrow = [&](const Attempted& made) {
    const RhythmPlan& plan = made.plan;
    return *std::max_element(plan.counts.begin(), plan.counts.end()) < 0.7 * plan.size * asked_belt;
  };
  if (!std::all_of(plans.begin(), plans.end(), too_narrow))
    plans.erase(std::remove_if(plans.begin(), plans.end(), too_narrow), plans.end());
  return plans;
}

const Attempted* best_of(const std::vector<Attempted>& plans) {
  const Attempted* best = nullptr;
  for (const Attempted& made : plans) {
    if (best == nullptr || is_better(made.plan, best->plan)) best = &made;
  }
  return best;
}

// The same piece so small that all attempts take tenths of a second: which family reads best hardly depends on the size. Of each
// dial the best is left to be tried on the piece itself.
std::vector<Attempt> promising(const IdealsAt& ideals, const std::vector<Attempt>& attempts, double tolerance,
                               double smaller, const Heard& heard) {
  constexpr std::ptrdiff_t alone = 2;  // where there is one dial
  const IdealsAt small = [&](double size) { return ideals(size / smaller); };
  std::vector<Attempted> plans = plans_of(small, attempts, tolerance, {}, heard);
  const bool one_dial = attempts.front().dial == attempts.back().dial;
  std::vector<Attempt> best;
  while (!plans.empty()) {
    const Attempted* next = best_of(plans);
    const Attempt by = next->by;
    plans.erase(plans.begin() + (next - plans.data()));
    const auto same_dial =
        std::count_if(best.begin(), best.end(), [&](const Attempt& other) { return other.dial == by.dial; });
    if (same_dial < (one_dial ? alone : 1)) best.push_back(by);
  }
  return best;
}

}  // namespace

IdealsAt resized_ideals(std::vector<double> ideals) {
  return [ideals = std::move(ideals)](double size) {
    const auto rows = ideals.size();
    if (size == 1.0 || rows < 3) {
      std::vector<double> scaled = ideals;
      for (double& ideal : scaled) ideal *= size;
      return scaled;
    }
    // The first and the last row stand one row from the ends.
    const auto resized_rows =
        static_cast<std::size_t>(std::max(3.0, rounded(size * (static_cast<double>(rows) + 1.0)) - 1.0));
    std::vector<double> resized;
    for (std::size_t row = 0; row < resized_rows; ++row) {
      const double at = (static_cast<double>(row) + 1.0) * (static_cast<double>(rows) + 1.0) /
                            (static_cast<double>(resized_rows) + 1.0) -
                        1.0;
      const double within = std::clamp(at, 0.0, static_cast<double>(rows - 1));
      const auto below = std::min(static_cast<std::size_t>(within), rows - 2);
      const double part = at - static_cast<double>(below);
      const double between = ideals[below] + part * (ideals[below + 1] - ideals[below]);
      resized.push_back(size * std::max(between, 0.1 * ideals[below]));
    }
    return resized;
  };
}

double rhythm_score(const RhythmPlan& plan, const RhythmStart& start) {
  // A round from the live stitches to a count of the rhythm is a line of its own, and a knitter counts it out where it is no repeat.
  double lines = 0.0;
  if (start.live > 0 && plan.counts.front() != start.live)
    lines = sections_to_begin(start.live, plan.counts.front(), true) > 0 ? 1.0 : 4.0;
  std::set<std::pair<std::int32_t, std::int32_t>> steps;
  for (const RhythmSegment& segment : plan.segments) {
    lines += segment.kind == SegmentKind::plain && segment.rows > 3 ? 0.4 : 1.0;
    if (segment.change != 0) steps.emplace(std::abs(segment.change), std::abs(segment.front));
  }
  const auto is_change = [&](std::size_t row) {
    return row < plan.roles.size() && plan.roles[row] == RowRole::change;
  };
  std::int32_t shaping = 0;
  std::int32_t unrested = 0;
  for (std::size_t row = 0; row < plan.roles.size(); ++row) {
    shaping += is_change(row) ? 1 : 0;
    unrested += is_change(row) && is_change(row + 1) ? 1 : 0;
  }
  const double more_steps = steps.empty() ? 0.0 : static_cast<double>(steps.size()) - 1.0;
  return lines + 0.3 * std::max(0, unrested - 2) + 0.04 * shaping + preference(plan.changes) + more_steps +
         15.0 * std::abs(plan.size - 1.0);
}

std::span<const double> rhythm_dials() { return dials; }

bool is_mirrored(std::span<const double> ideals) {
  constexpr double alike = 0.01;
  const double belt = belt_of(ideals);
  for (std::size_t row = 0; row < ideals.size() / 2; ++row) {
    if (!clearly_less(std::abs(ideals[row] - ideals[ideals.size() - 1 - row]), alike * belt, belt))
      return false;
  }
  return true;
}

std::optional<RhythmPlan> plan_family(std::span<const double> ideals, const RhythmFamily& family, double dial,
                                      const RhythmStart& start, const Heard& heard) {
  RhythmPlan plan;
  plan.sections = family.sections;
  plan.changes = family.changes();
  plan.dial = dial;
  plan.mirrored = start == RhythmStart{} && is_mirrored(ideals);
  const RhythmPrices prices = rhythm_prices(family, dial, ideals);
  const std::vector<double> half = plan.mirrored ? opening_half(ideals) : std::vector<double>{};
  const std::span<const double> planned = plan.mirrored ? std::span<const double>(half) : ideals;
  std::optional<FoundSegments> found =
      find_segments({planned, family, prices, start, plan.mirrored, 0, heard});
  if (!found) return {};
  plan.cost = found->cost;
  plan.segments = plan.mirrored
                      ? with_mirror(std::move(found->segments), static_cast<std::int32_t>(ideals.size()))
                      : std::move(found->segments);
  plan.counts = counts_of(found->first, plan.segments);
  plan.roles = roles_of(plan.segments);
  plan.seen = seen_deviation(plan.counts, ideals.subspan(static_cast<std::size_t>(start.row)));
  plan.seen.row += start.row;
  plan.score = rhythm_score(plan, start);
  return plan;
}

double microseconds_to_plan(double rows, double belt) {
  const double all = microseconds_to_try_all(rows, belt);
  return all > longest_to_try_all ? longest_to_try_all / 4.0 + all / 10.0 : all;
}

std::optional<RhythmPlan> plan_rhythm(const IdealsAt& ideals, const RhythmSettings& settings,
                                      const RhythmStart& start, const Heard& heard) {
  const std::vector<double> asked = ideals(1.0);
  const double belt = belt_of(asked);
  const std::span<const double> tried =
      settings.dial > 0.0 ? std::span(&settings.dial, 1) : std::span<const double>(dials);
  const bool may_change_size = settings.fit_size == FitSize::on && start == RhythmStart{};
  std::vector<Attempt> all;
  for (const RhythmFamily& family : families_for(settings, belt)) {
    for (const double size : sizes_for(family, belt, may_change_size)) {
      for (const double dial : tried) all.push_back({family, size, dial});
    }
  }
  const double too_long =
      microseconds_to_try_all(static_cast<double>(asked.size()), belt) / longest_to_try_all;
  Heard last = heard;
  if (too_long > 1.0 && all.size() > 1) {
    const double smaller = cube_root(4.0 * too_long);
    std::vector<Attempt> some = promising(ideals, all, settings.tolerance, smaller, part_of(heard, 0.0, 0.3));
    if (!some.empty()) all = std::move(some);
    last = part_of(heard, 0.3, 1.0);
  }
  const std::vector<Attempted> plans = plans_of(ideals, all, settings.tolerance, start, last);
  const Attempted* best = best_of(plans);
  return best != nullptr ? std::optional(best->plan) : std::nullopt;
}

}  // namespace knit
