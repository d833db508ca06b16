#include "knit/rows/contour_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "knit/model/ties.h"
#include "knit/rows/contour.h"
#include "knit/rows/ring.h"
#include "knit/timing/critical.h"
#include "knit/timing/heights.h"

namespace knit {

namespace {

std::int32_t rounded_stitches(const Ring& ring, double stitch_width) {
  return static_cast<std::int32_t>(std::clamp(rounded(ring.length / stitch_width), 3.0, 1e6));
}

bool is_tube(const Cut& cut) { return cut.loops.size() == 1; }
bool too_short(const Cut& cut, double stitch_width) {
  return cut.loops.empty() || (is_tube(cut) && too_short(*cut.loops.front(), stitch_width));
}

// Of the times where they are the field; rings do not ask for it.
HeightScale scale_of(const Input& input, const Timing& timing) {
  return timing.retimed ? timing.scale : measure_heights(input, timing.times);
}

double height_of_time(const Timing& timing, const HeightScale& scale, double time) {
  return timing.retimed ? time * scale.total() : height_at(scale, time);
}

double value_of_time(const Timing& timing, double time) {
  return timing.retimed ? value_at(timing.scale, time * timing.scale.total()) : time;
}

// Equal steps of time from `from` to 1, both left out.
std::vector<double> inner_times(double from, std::int32_t steps) {
  std::vector<double> times;
  for (std::int32_t i = 1; i < steps; ++i) times.push_back(from + (1.0 - from) * i / steps);
  return times;
}

// Leaves out cuts that are too short, at both ends, and what lies above the first of several loops.
void keep_rows(CutPlan& plan, double stitch_width) {
  const auto first = std::find_if_not(plan.cuts.begin(), plan.cuts.end(),
                                      [&](const Cut& cut) { return too_short(cut, stitch_width); });
  plan.passed_over = static_cast<std::int32_t>(first - plan.cuts.begin());
  plan.cuts.erase(plan.cuts.begin(), first);
  const auto split =
      std::find_if(plan.cuts.begin(), plan.cuts.end(), [](const Cut& c) { return c.loops.size() > 1; });
  if (split != plan.cuts.end()) plan.cuts.erase(split + 1, plan.cuts.end());
  while (!plan.cuts.empty() && too_short(plan.cuts.back(), stitch_width)) plan.cuts.pop_back();
}

void explain_end(const Input& input, const Timing& timing, CutPlan& plan) {
  if (plan.cuts.empty() || is_tube(plan.cuts.back())) return;
  const Cut& last = plan.cuts.back();
  Split split = explain_split(input, timing.times, timing.criticals, last.time);
  split.level = static_cast<std::int32_t>(plan.cuts.size()) - 1;
  split.loops = static_cast<std::int32_t>(last.loops.size());
  plan.split = split;
}

double stitches_in(const CutPlan& plan, double stitch_width) {
  double stitches = 0.0;
  for (const Cut& cut : plan.cuts) {
    if (is_tube(cut)) stitches += rounded(cut.loops.front()->length / stitch_width);
  }
  return stitches;
}

Stopped too_many_rows(const Timing& timing, double rows) {
  return {StopReason::too_fine, {},  0,  static_cast<std::int32_t>(rows), most_contour_rows,
          timing.ends.start,    0.0, 0.0};
}

Stopped too_many_stitches(const Timing& timing, double stitches) {
  return {StopReason::too_fine, {}, 0, 0, most_contour_stitches, timing.ends.start, stitches, 0.0};
}

// What a count costs: over its stitches, the squared share by which they come out too wide or too narrow.
double misfit(const Ring& ring, std::int32_t count, double stitch_width) {
  const double off = ring.length / (count * stitch_width) - 1.0;
  return count * off * off;
}

// Looks a few rows ahead, because a row that holds a stitch more or fewer may let its neighbours hold theirs.
class CountSearch {
 public:
  CountSearch(const CutPlan& plan, double stitch_width) : plan_(plan), stitch_width_(stitch_width) {}

  struct Best {
    std::int32_t count = 0;
    double cost = 0.0;
  };
  // For the current cut above a row of `below` stitches (0: any count is free).
  [[nodiscard]] Best best_for(std::size_t cut, std::int32_t below, int depth) const {
    if (depth == 0 || cut >= plan_.cuts.size() || !is_tube(plan_.cuts[cut])) return {};
    const Ring& ring = *plan_.cuts[cut].loops.front();
    Best best{0, std::numeric_limits<double>::infinity()};
    for (const std::int32_t wanted : candidates(cut)) {
      const std::int32_t count = within_limits(wanted, below);
      const double cost = misfit(ring, count, stitch_width_) + best_for(cut + 1, count, depth - 1).cost;
      if (clearly_less(cost, best.cost, 1.0)) best = {count, cost};
    }
    return best;
  }

 private:
  [[nodiscard]] static std::int32_t within_limits(std::int32_t count, std::int32_t below) {
    if (below == 0) return std::max(count, 3);
    return std::clamp(count, std::max(3, (below + 1) / 2), 2 * below);
  }
  // The rounded count first, so that it wins a tie.
  [[nodiscard]] std::array<std::int32_t, 5> candidates(std::size_t cut) const {
    const std::int32_t here = rounded_stitches(*plan_.cuts[cut].loops.front(), stitch_width_);
    const bool last = cut + 1 >= plan_.cuts.size() || !is_tube(plan_.cuts[cut + 1]);
    const std::int32_t next =
        last ? here : rounded_stitches(*plan_.cuts[cut + 1].loops.front(), stitch_width_);
    return {here, here - 1, here + 1, 2 * next, (next + 1) / 2};
  }

  const CutPlan& plan_;
  double stitch_width_;
};

}  // namespace

std::variant<CutPlan, Stopped> plan_cuts(const Input& input, const Timing& timing, const RowsSettings& rows,
                                         const StitchSize& stitch, double from_time) {
  CutPlan plan;
  plan.from_time = from_time;
  plan.stitch_height = stitch.height;
  const HeightScale scale = scale_of(input, timing);
  plan.height = scale.total() - height_of_time(timing, scale, from_time);
  const double wanted = std::clamp(rounded(plan.height / plan.stitch_height), 1.0, 1e9);
  if (wanted > most_contour_rows) return too_many_rows(timing, wanted);
  const auto steps = static_cast<std::int32_t>(from_time > 0.0 ? wanted : std::max(wanted, 2.0));
  plan.row_height = plan.height / steps;
  const std::vector<double> times = inner_times(from_time, steps);
  std::vector<double> values;
  values.reserve(times.size());
  for (const double time : times) values.push_back(value_of_time(timing, time));
  const RowFrame frame = row_frame(timing.ends.direction, rows.start_direction);
  plan.cuts = cut_surface(input, timing.cut_field(), values, times, frame);
  keep_rows(plan, stitch.width);
  explain_end(input, timing, plan);
  if (const double stitches = stitches_in(plan, stitch.width); stitches > most_contour_stitches)
    return too_many_stitches(timing, stitches);
  if (plan.cuts.empty() && from_time == 0.0) {
    return Stopped{StopReason::no_row_levels, {},           steps - 1, plan.passed_over, 0,
                   timing.ends.start,         stitch.width, 0.0};
  }
  return plan;
}

ChosenCount choose_count(const CutPlan& plan, std::int32_t cut, std::int32_t below, const RowsSettings& rows,
                         const StitchSize& stitch) {
  const Ring& ring = *plan.cuts[static_cast<std::size_t>(cut)].loops.front();
  ChosenCount chosen;
  chosen.ideal = ring.length / stitch.width;
  if (below == 0 && rows.cast_on > 0) return {rows.cast_on, CountReason::as_cast_on, chosen.ideal};
  chosen.count = rounded_stitches(ring, stitch.width);
  if (chosen.ideal < 2.5) chosen.reason = CountReason::at_least_three;
  constexpr int rows_ahead = 4;
  const std::int32_t rounded = chosen.count;
  chosen.count =
      CountSearch(plan, stitch.width).best_for(static_cast<std::size_t>(cut), below, rows_ahead).count;
  if (chosen.count == rounded) return chosen;
  chosen.reason = CountReason::room_ahead;
  if (chosen.count < rounded && chosen.count == 2 * below) chosen.reason = CountReason::at_most_double;
  if (chosen.count > rounded && below > 0 && chosen.count == (below + 1) / 2)
    chosen.reason = CountReason::at_least_half;
  return chosen;
}

}  // namespace knit
