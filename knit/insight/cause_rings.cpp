// Why Algorithm 2 picked so many stitches: how many vertices it went on from stitch to stitch, and how far the last one that
// it passed over and the one that it took lay. Part of causes.
#include <algorithm>
#include <map>
#include <optional>

#include "knit/insight/cause_parts.h"
#include "knit/insight/narrate.h"
#include "knit/rows/rows.h"

namespace knit {

namespace {

struct RingDistances {
  double least = 0.0, most = 0.0;
  std::int32_t count = 0;
  void take(double distance) {
    least = count == 0 ? distance : std::min(least, distance);
    most = count == 0 ? distance : std::max(most, distance);
    ++count;
  }
  [[nodiscard]] std::string text() const {
    const std::string low = short_number(least), high = short_number(most);
    return low == high ? low : low + " to " + high;
  }
};

// Of stitches that stand `every` vertices after the one before: how far those taken lie, and those just before them.
struct Pace {
  std::int32_t every = 1;
  RingDistances taken, refused;
};

// A row's walk along its cycle, read from its steps.
struct WalkRead {
  std::int32_t vertices = 0, picked = 0, missed = 0;
  double gap = 0.0;
  bool dropped_last = false, closed = false;
  std::vector<Pace> paces;  // the most frequent first, of equals the shorter
  std::optional<std::size_t> resampled;
  Band band{};
  [[nodiscard]] std::int32_t strides() const {
    std::int32_t sum = 0;
    for (const Pace& pace : paces) sum += pace.taken.count;
    return sum;
  }
};

class WalkReader {
 public:
  explicit WalkReader(const Timeline& timeline) : timeline_(timeline) {}

  WalkRead read(std::int32_t row) {
    const StepRange steps = steps_of_row(timeline_, Stage::rows, row);
    for (std::size_t i = steps.begin; i < steps.end; ++i) take(timeline_.step(i).what, i);
    if (steps.begin < steps.end) {
      const Parameters& parameters = timeline_.parameters_of_step(steps.end - 1);
      walk_.band = band_of(parameters.rows, parameters.stitch);
    }
    for (auto& [every, pace] : paces_) walk_.paces.push_back(pace);
    std::stable_sort(walk_.paces.begin(), walk_.paces.end(),
                     [](const Pace& a, const Pace& b) { return a.taken.count > b.taken.count; });
    return walk_;
  }

 private:
  void take(const Event& what, std::size_t step) {
    if (const auto* ordered = get_if<CycleOrdered>(what)) walk_.vertices = ordered->vertices;
    if (const auto* measured = get_if<CandidateMeasured>(what)) take(*measured);
    if (is<BandMissed>(what)) ++walk_.missed;
    if (is<RowResampled>(what)) walk_.resampled = step;
    const auto* closed = get_if<RowClosed>(what);
    if (closed == nullptr) return;
    walk_.closed = true;
    walk_.picked = closed->stitches;
    walk_.gap = closed->gap;
    walk_.dropped_last = closed->dropped_last;
  }
  void take(const CandidateMeasured& measured) {
    if (measured.verdict == Verdict::accepted) {
      const std::int32_t every = measured.candidate_order - measured.anchor_order;
      Pace& pace = paces_[every];
      pace.every = every;
      pace.taken.take(measured.distance);
      if (every > 1 && before_order_ + 1 == measured.candidate_order) pace.refused.take(before_);
    }
    before_order_ = measured.candidate_order;
    before_ = measured.distance;
  }

  const Timeline& timeline_;
  WalkRead walk_;
  std::map<std::int32_t, Pace> paces_;
  std::int32_t before_order_ = -1;  // of the candidate measured last, and its distance
  double before_ = 0.0;
};

std::string every_text(std::int32_t every) { return every == 1 ? "every" : "every " + nth_text(every); }
std::string that_one_text(std::int32_t nth) { return nth == 1 ? "the next" : "the " + nth_text(nth); }

// "the first of the 129 vertices of its cycle and every 4th after it."
std::string picks_text(const WalkRead& walk) {
  const std::string vertices = std::to_string(walk.vertices) + " vertices of its cycle";
  const Pace& main = walk.paces.front();
  const bool even = walk.paces.size() == 1 && walk.missed == 0;
  if (even && main.every == 1) return "all of the " + vertices + ", one after the other.";
  const std::string first = "the first of the " + vertices + " and ";
  if (even) return first + every_text(main.every) + " after it.";
  return first + "then mostly " + every_text(main.every) + " (" + std::to_string(main.taken.count) + " of " +
         plural(walk.strides() + walk.missed, "time", "times") + ").";
}

// " The 4th after a stitch is 0.065 away, at least 0.05 as the band asks; the 3rd only 0.0488, too near."
std::string distances_text(const WalkRead& walk) {
  const Pace& main = walk.paces.front();
  const std::string low = short_number(walk.band.low);
  if (main.every == 1)
    return " The next vertex is already " + main.taken.text() + " away, and the band begins at " + low + ".";
  std::string text = " The " + nth_text(main.every) + " after a stitch is " + main.taken.text() +
                     " away, the first in the band, which begins at " + low;
  if (main.refused.count > 0)
    text += "; " + that_one_text(main.every - 1) + " is only " + main.refused.text() + " away, too near";
  return text + ".";
}

// The nearest row that goes on otherwise, and what decided there.
std::string other_row_text(const Timeline& timeline, std::int32_t row, const WalkRead& walk) {
  constexpr std::int32_t far = 12;
  const std::int32_t every = walk.paces.front().every;
  for (std::int32_t away = 1; away <= far; ++away) {
    for (const std::int32_t other : {row - away, row + away}) {
      if (other < 2 || other > timeline.furthest().fabric.row_count()) continue;
      const WalkRead there = WalkReader(timeline).read(other);
      if (!there.closed || there.paces.empty() || there.paces.front().every == every) continue;
      const Pace& pace = there.paces.front();
      const std::string head = " Row " + std::to_string(other) + " takes " + every_text(pace.every) + " of " +
                               std::to_string(there.vertices) + ": there ";
      if (pace.every > every && pace.refused.count > 0)
        return head + that_one_text(pace.every - 1) + " is only " + pace.refused.text() + " away.";
      return head + that_one_text(pace.every) + " is already " + pace.taken.text() + " away.";
    }
  }
  return "";
}

std::string leftover_text(const WalkRead& walk) {
  std::string text;
  if (walk.missed > 0) {
    text += " " + plural(walk.missed, "time", "times") + " nothing lay within " +
            short_number(walk.band.low) + " to " + short_number(walk.band.high) +
            ", and the vertex nearest to the stitch width was taken.";
  }
  if (walk.gap == 0.0) text += " The last stands on the first, of which the cycle's last vertex is a copy.";
  if (walk.dropped_last) text += " One more, too near the first stitch, was dropped.";
  return text;
}

}  // namespace

std::string why_picked(const Timeline& timeline, std::int32_t row) {
  const WalkRead walk = WalkReader(timeline).read(row);
  if (!walk.closed) return "";
  std::string text;
  if (walk.resampled) {
    const std::size_t step = *walk.resampled;
    const std::string told = narrate(timeline.step(step), timeline.parameters_of_step(step));
    text = "they are spread evenly. " + told;
    if (walk.paces.empty()) return text;
    text += " Before, ";
  }
  if (walk.paces.empty()) return text + "nothing within the band was found." + leftover_text(walk);
  text += picks_text(walk) + distances_text(walk) + leftover_text(walk);
  return walk.resampled ? text : text + other_row_text(timeline, row, walk);
}

}  // namespace knit
