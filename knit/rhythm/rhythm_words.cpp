#include "knit/rhythm/rhythm_words.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "knit/model/words.h"

namespace knit {

namespace {

std::string every_so_many(std::int32_t rounds) {
  if (rounds == 1) return "every round";
  const bool teens = rounds % 100 >= 11 && rounds % 100 <= 13;
  const std::int32_t last = teens ? 0 : rounds % 10;
  const char* const ending = last == 1 ? "st" : last == 2 ? "nd" : last == 3 ? "rd" : "th";
  return "every " + std::to_string(rounds) + ending + " round";
}

std::string times_text(std::int32_t times) {
  return times == 1 ? "once" : times == 2 ? "twice" : std::to_string(times) + " times";
}

std::string so_often(const RhythmSegment& segment) {
  if (segment.times == 1) return "once";
  return every_so_many(segment.rows) + " " + times_text(segment.times);
}

// The same change as in the segment before, with another rest between them.
std::string and_then(const RhythmSegment& before, const RhythmSegment& segment) {
  if (segment.times == 1) return ", once more";
  if (segment.rows == before.rows && before.times > 1) return " and again " + times_text(segment.times);
  return ", " + so_often(segment);
}

// Of a share in %, to a tenth, never less than it is.
std::string no_less_percent(double percent) {
  return short_number(std::ceil(10.0 * percent - 1e-6) / 10.0) + " %";
}

std::string which_half(const RhythmSegment& segment) {
  if (segment.front == segment.change) return "in front";
  if (segment.front == 0) return "at the back";
  if (2 * segment.front == segment.change) return "in front and back alike";
  return "(" + std::to_string(std::abs(segment.front)) + " in front)";
}

// Of halves that are shaped apart.
std::string halves_sentence(const RhythmPlan& plan) {
  std::int32_t front = 0, back = 0;
  for (std::size_t row = 0; row < plan.counts.size(); ++row) {
    front = std::max(front, plan.fronts[row]);
    back = std::max(back, plan.counts[row] - plan.fronts[row]);
  }
  return "Front and back halves differ: the front has " + stitch_count_text(front) +
         " at its widest, the back " + std::to_string(back) + "; they are never seen more than " +
         no_less_percent(plan.front_off) + " and " + no_less_percent(plan.back_off) +
         " off. The round begins at the middle of the back.";
}

std::string width_sentence(std::int32_t widest, double widest_ideal, double stitches_in_10_cm) {
  const auto around = [&](double stitches) {
    return short_number(std::round(100.0 * stitches / stitches_in_10_cm) / 10.0) + " cm";
  };
  const std::string made = around(widest), asked = around(widest_ideal);
  return "The widest round has " + stitch_count_text(widest) + ", so the piece is " + made + " around" +
         (made == asked ? ", just as the shape has it." : "; the shape has " + asked + ".");
}

// Shaping rounds of one direction, one after the other.
struct Stretch {
  bool grows = true;
  std::int32_t rounds = 0, last = 0;       // of them; the number of the last
  std::int32_t fewest = 0, most = 0;       // stitches in one
  std::int32_t nearest = 0, furthest = 0;  // from one to the next
};

void add_change(std::vector<Stretch>& stretches, std::int32_t row, std::int32_t change) {
  const std::int32_t stitches = std::abs(change);
  if (stretches.empty() || stretches.back().grows != (change > 0)) {
    stretches.push_back({change > 0, 1, row, stitches, stitches});
    return;
  }
  Stretch& stretch = stretches.back();
  const std::int32_t apart = row - stretch.last;
  stretch.nearest = stretch.rounds == 1 ? apart : std::min(stretch.nearest, apart);
  stretch.furthest = std::max(stretch.furthest, apart);
  stretch.fewest = std::min(stretch.fewest, stitches);
  stretch.most = std::max(stretch.most, stitches);
  stretch.last = row;
  ++stretch.rounds;
}

std::string from_to(std::int32_t low, std::int32_t high) {
  return low == high ? std::to_string(low) : std::to_string(low) + " to " + std::to_string(high);
}

// "9 rounds of 6 increases, 1 to 4 rounds apart, then 8 rounds of 6 decreases, 2 to 3 rounds apart"
std::string stretches_sentence(std::span<const RhythmSegment> segments) {
  std::vector<Stretch> stretches;
  std::int32_t row = 0;
  for (const RhythmSegment& segment : segments) {
    for (std::int32_t turn = 0; turn < segment.times; ++turn, row += segment.rows) {
      const std::int32_t within = segment.kind == SegmentKind::post ? 1 : segment.rows;
      if (segment.change != 0) add_change(stretches, row + within, segment.change);
    }
  }
  std::string words;
  for (const Stretch& stretch : stretches) {
    words += (words.empty() ? "" : ", then ") + plural(stretch.rounds, "round", "rounds") + " of " +
             from_to(stretch.fewest, stretch.most) + (stretch.grows ? " increase" : " decrease") +
             (stretch.most == 1 ? "" : "s");
    if (stretch.rounds == 1) continue;
    words += stretch.furthest == 1 ? ", one after the other"
                                   : ", " + from_to(stretch.nearest, stretch.furthest) + " rounds apart";
  }
  return words;
}

// More of them nobody keeps in mind; the instructions say them one by one.
constexpr std::ptrdiff_t most_in_mind = 6;

}  // namespace

std::string segments_sentence(std::span<const RhythmSegment> segments, bool halves) {
  const auto shapes = [](const RhythmSegment& segment) { return segment.change != 0; };
  if (!halves && std::count_if(segments.begin(), segments.end(), shapes) > most_in_mind)
    return stretches_sentence(segments);
  std::string words;
  const RhythmSegment* before = nullptr;
  for (const RhythmSegment& segment : segments) {
    if (segment.change == 0) continue;
    if (before != nullptr && segment.change == before->change && segment.front == before->front) {
      words += and_then(*before, segment);
      before = &segment;
      continue;
    }
    const std::int32_t stitches = std::abs(segment.change);
    words += (words.empty() ? "" : ", then ") +
             (segment.change > 0 ? plural(stitches, "increase", "increases")
                                 : plural(stitches, "decrease", "decreases")) +
             (halves ? " " + which_half(segment) : "") + " " + so_often(segment);
    before = &segment;
  }
  return words;
}

std::vector<std::string> rhythm_sentences(const TubeRhythm& rhythm, double widest_ideal,
                                          double stitches_in_10_cm) {
  if (rhythm.none != NoRhythm::no || rhythm.plan.counts.empty()) return {};
  const RhythmPlan& plan = rhythm.plan;
  std::vector<std::string> sentences;
  const std::string shaping = segments_sentence(plan.segments, !plan.fronts.empty());
  const std::string from =
      rhythm.from > 0 ? "From round " + std::to_string(rhythm.from + 1) + " on shaped" : "Shaped";
  if (!shaping.empty()) sentences.push_back(from + " in a rhythm: " + shaping + ".");
  if (!plan.fronts.empty()) sentences.push_back(halves_sentence(plan));
  const std::string off = no_less_percent(plan.seen.worst());
  if (plan.within) {
    sentences.push_back("The circumference is never seen more than " + off + " off the shape's.");
  } else {
    sentences.push_back("No rhythm stays within " + short_number(rhythm.settings.tolerance) +
                        " %: this one is off by " + off + " at round " + std::to_string(plan.seen.row + 1) +
                        ". Smaller stitches come nearer; a tolerance of " + off + " accepts it.");
  }
  const std::int32_t widest = *std::max_element(plan.counts.begin(), plan.counts.end());
  sentences.push_back(width_sentence(widest, widest_ideal, stitches_in_10_cm));
  return sentences;
}

}  // namespace knit
