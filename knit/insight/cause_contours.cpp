// Why a row that is cut through the surface has its number of stitches: what its length holds, what the stitches below allow,
// what the rows above hold, and whose loops it is worked on. Part of causes.
#include <algorithm>
#include <cmath>
#include <span>

#include "knit/insight/cause_parts.h"
#include "knit/model/ties.h"
#include "knit/rows/lasting_counts.h"

namespace knit {

namespace {

// What a row's steps say of its count.
struct CountRead {
  const CutFound* cut = nullptr;
  const LengthMeasured* measured = nullptr;
  const CountChosen* chosen = nullptr;
  double width = 0.0;
};

CountRead read_count(const Timeline& timeline, std::int32_t row) {
  CountRead read;
  const StepRange steps = steps_of_row(timeline, stage_of_row(row), row);
  for (std::size_t i = steps.begin; i < steps.end; ++i) {
    const Event& what = timeline.step(i).what;
    if (const auto* cut = get_if<CutFound>(what)) read.cut = cut;
    if (const auto* measured = get_if<LengthMeasured>(what)) read.measured = measured;
    const auto* chosen = get_if<CountChosen>(what);
    if (chosen == nullptr) continue;
    read.chosen = chosen;
    read.width = timeline.parameters_of_step(i).stitch.width;
  }
  return read;
}

std::int32_t fewest_on(std::int32_t below) { return std::max(3, (below + 1) / 2); }

// "its length, 3.31, holds 33.1 stitches of 0.1": twins share what is their mean.
std::string holds_text(const CountRead& read) {
  const double counted = read.chosen->ideal * read.width;
  const bool as_twins = std::abs(counted - read.measured->length) > 1e-6 * counted;
  return std::string(as_twins ? "loops of tubes that are alike are " : "its loop is ") +
         short_number(counted) + (as_twins ? " long on average" : " long") + ", which holds " +
         short_number(read.chosen->ideal) + " stitches of " + short_number(read.width);
}

std::string limits_text(std::int32_t below) {
  return "on the " + whole_text(below) + " below there may be " + whole_text(fewest_on(below)) + " to " +
         whole_text(2 * below);
}

// What the rows above hold, in stitches; as far as they are looked at.
std::vector<double> ideals_above(const State& run, const CountRead& read) {
  constexpr std::size_t looked_at = 3;
  std::vector<double> ideals;
  if (!run.tubes || read.cut == nullptr) return ideals;
  const std::vector<double>& lengths = run.tubes->tube(read.cut->tube).lengths;
  for (auto i = static_cast<std::size_t>(read.cut->level) + 1;
       i < lengths.size() && ideals.size() < looked_at; ++i)
    ideals.push_back(lengths[i] / read.width);
  return ideals;
}

std::string ahead_text(const std::vector<double>& ideals, std::int32_t row, const CountChosen& chosen) {
  if (ideals.empty()) return "";
  std::string text = ideals.size() == 1 ? "The row above holds " : "The rows above hold ";
  for (std::size_t i = 0; i < ideals.size(); ++i)
    text += (i == 0 ? "" : i + 1 == ideals.size() ? " and " : ", ") + short_number(ideals[i]);
  text += "; ";
  const auto own = static_cast<std::int32_t>(rounded(chosen.ideal));
  const auto next = static_cast<std::int32_t>(rounded(ideals.front()));
  const std::string then = "row " + whole_text(row + 1) + " could have ";
  if (next > 2 * own)
    return text + "on " + whole_text(own) + " " + then + "at most " + whole_text(2 * own) + ", on " +
           whole_text(chosen.count) + " up to " + whole_text(2 * chosen.count) + ".";
  if (next < fewest_on(own))
    return text + "on " + whole_text(own) + " " + then + "no fewer than " + whole_text(fewest_on(own)) +
           ", on " + whole_text(chosen.count) + " as few as " + whole_text(fewest_on(chosen.count)) + ".";
  return text + "with " + whole_text(chosen.count) +
         " here all of them together come nearest to what they hold.";
}

// "Rounds 26 to 34 hold 80.2 to 82.9 and have 82 all of them: ...": those around the row that have its count.
std::string lasting_text(const State& run, std::int32_t row, const CountRead& read) {
  if (!run.tubes || read.cut == nullptr) return "";
  std::vector<double> ideals;
  for (const double length : run.tubes->tube(read.cut->tube).lengths) ideals.push_back(length / read.width);
  const std::vector<std::int32_t> counts = lasting_counts(ideals);
  const auto at = static_cast<std::size_t>(read.cut->level);
  std::size_t first = at, end = at + 1;
  while (first > 0 && counts[first - 1] == counts[at]) --first;
  while (end < counts.size() && counts[end] == counts[at]) ++end;
  const auto [low, high] = std::minmax_element(ideals.begin() + static_cast<std::ptrdiff_t>(first),
                                               ideals.begin() + static_cast<std::ptrdiff_t>(end));
  // By the numbers that rows have, short rows between them counted too; those to come as if they had none.
  const auto named = [&](std::size_t level) {
    for (const auto& made : run.fabric.rows()) {
      if (made->tube == read.cut->tube && !is_short(*made) && made->level == static_cast<std::int32_t>(level))
        return whole_text(made->id);
    }
    return whole_text(row + static_cast<std::int32_t>(level) - static_cast<std::int32_t>(at));
  };
  const std::string undone = "a change would be undone within " + whole_text(lasting_rounds) + " rounds.";
  if (end - first == 1) return "With what each row hereabouts holds, " + undone;
  return "Rows " + named(first) + " to " + named(end - 1) + " hold " + short_number(*low) + " to " +
         short_number(*high) + " and all have " + whole_text(counts[at]) + ": with what each holds, " +
         undone;
}

std::string reason_text(const State& run, std::int32_t row, const CountRead& read) {
  const CountChosen& chosen = *read.chosen;
  const std::string holds = holds_text(read);
  const std::string limits = chosen.below > 0 ? limits_text(chosen.below) : "";
  switch (chosen.reason) {
    case CountReason::ideal:
      return holds + ", rounded" + (limits.empty() ? "." : "; " + limits + ".");
    case CountReason::as_cast_on:
      return "so many were asked for to cast on; " + holds + ".";
    case CountReason::at_least_three:
      return holds + ", but a round needs 3.";
    case CountReason::at_most_double:
      return holds + ", but a row at most doubles what it is worked on: 2 x " + whole_text(chosen.below) +
             " = " + whole_text(2 * chosen.below) + ".";
    case CountReason::at_least_half:
      return holds + ", but a row has at least half of what it is worked on: " + whole_text(chosen.below) +
             " / 2 = " + short_number(0.5 * chosen.below) + ".";
    case CountReason::room_ahead:
      return holds + (limits.empty() ? "" : "; " + limits) + ". " +
             ahead_text(ideals_above(run, read), row, chosen);
    case CountReason::would_be_undone:
      return holds + (limits.empty() ? "" : "; " + limits) + ". " + lasting_text(run, row, read);
    case CountReason::undone:
      return holds + ", rounded; that changes the other way within " + whole_text(lasting_rounds) +
             " rounds, but the loops there grow and shrink too fast for a count that lasts and is at most " +
             short_number(100.0 * lasting_tolerance) + " % off.";
    case CountReason::rhythm_change:
      if (chosen.below == 0) return "its rhythm begins with so many; " + holds + ".";
      return "its rhythm changes here, by " + whole_text(chosen.count - chosen.below) + "; " + holds + ".";
    case CountReason::rhythm_rest:
      return "its rhythm rests here, as many as below; " + holds + ".";
    case CountReason::rhythm_begins:
      return "its rhythm begins here, with " + whole_text(chosen.count) + ", which one round makes of the " +
             whole_text(chosen.below) + " below; " + holds + ".";
  }
  return holds + ".";
}

// Once a deal has given the loop: " It is worked on 12 stitches of row 5 and 8 of the bridge of deal 1."
std::string loops_text(const Fabric& fabric, std::int32_t row, const LiveStitches& on) {
  const Row* below = fabric.row_below(row);
  const Row* made = fabric.find_row(row);
  if (on.empty() || made == nullptr || (below != nullptr && below->tube == made->tube)) return "";
  std::vector<std::pair<RowId, std::int32_t>> parts;  // a row, or a bridge below 0, and stitches of it
  for (const StitchSpan& span : on.spans) {
    const auto same =
        std::find_if(parts.begin(), parts.end(), [&](const auto& p) { return p.first == span.row; });
    if (same == parts.end())
      parts.emplace_back(span.row, span.count);
    else
      same->second += span.count;
  }
  std::string text = " It is the first row of tube " + tube_name(made->tube) + ", worked on ";
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto [from, count] = parts[i];
    text += (i == 0                  ? ""
             : i + 1 == parts.size() ? " and "
                                     : ", ") +
            (i == 0 ? stitch_count_text(count) : whole_text(count)) + " of ";
    const Row* of = fabric.find_row(from);
    text += of == nullptr ? "the bridge of deal " + whole_text(-from)
                          : "row " + whole_text(from) + " (tube " + tube_name(of->tube) + ")";
  }
  return text + ".";
}

}  // namespace

std::string why_contour_count(const Timeline& timeline, std::int32_t row) {
  const CountRead read = read_count(timeline, row);
  if (read.chosen == nullptr || read.measured == nullptr) return "";
  const State& run = timeline.furthest();
  const Row* made = run.fabric.find_row(row);
  const std::string loops = made == nullptr ? "" : loops_text(run.fabric, row, made->on);
  return reason_text(run, row, read) + loops;
}

}  // namespace knit
