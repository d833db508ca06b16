#include "app/explain/rhythm_figures.h"

#include <algorithm>
#include <cmath>

#include "app/base/text.h"
#include "knit/model/words.h"
#include "knit/rhythm/deviation.h"
#include "knit/rows/contour_stage.h"

namespace app {

namespace {

// Of a tube of which nothing is made the rows come after all that are.
std::int32_t first_row_of(const knit::State& state, const knit::TubeRhythm& rhythm) {
  const auto& rows = state.fabric.rows();
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row->tube == rhythm.tube; });
  const std::int32_t lowest =
      found != rows.end() ? (*found)->id - (*found)->level : static_cast<std::int32_t>(rows.size()) + 1;
  return lowest + rhythm.from;
}

std::optional<RhythmFigures> figures_of_tube(const knit::State& state,
                                             const knit::Shared<knit::TubeRhythm>& rhythm) {
  const std::vector<double>& lengths = state.tubes->tube(rhythm->tube).lengths;
  const auto from = static_cast<std::size_t>(rhythm->from);
  const std::size_t rows = rhythm->plan.counts.size();
  if (rhythm->none != knit::NoRhythm::no || rows == 0 || lengths.size() < from + rows) return std::nullopt;
  RhythmFigures figures{rhythm, first_row_of(state, *rhythm), {}, {}, {}};
  for (std::size_t i = 0; i < rows; ++i) {
    figures.planned.push_back(rhythm->plan.counts[i]);
    figures.ideal.push_back(lengths[from + i] / rhythm->stitch_width);
  }
  figures.seen = knit::seen_deviations(rhythm->plan.counts, figures.ideal);
  return figures;
}

std::string stitches_more(std::int32_t change) {
  return knit::plural(std::abs(change), change > 0 ? "stitch more" : "stitch fewer",
                      change > 0 ? "more stitches" : "fewer stitches");
}

}  // namespace

std::vector<RhythmFigures> rhythm_figures_of(const knit::State& state) {
  std::vector<RhythmFigures> all;
  if (!state.tubes) return all;
  for (const auto& rhythm : state.rhythms) {
    if (knit::rhythm_of(state.rhythms, rhythm->tube) != &*rhythm) continue;  // planned anew since
    if (auto figures = figures_of_tube(state, rhythm)) all.push_back(std::move(*figures));
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& a, const auto& b) { return a.first_row < b.first_row; });
  return all;
}

const RhythmFigures* figures_at(const std::vector<RhythmFigures>& all, std::int32_t row) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const RhythmFigures& figures) { return figures.has(row); });
  if (found != all.end()) return &*found;
  return all.empty() ? nullptr : &all.front();
}

std::string deviation_words(const RhythmFigures& figures, std::int32_t row) {
  const auto i = static_cast<std::size_t>(row - figures.first_row);
  const double planned = figures.planned[i];
  const double ideal = figures.ideal[i];
  const double off = planned - ideal;
  const std::string by = fixed_text(std::abs(off), 1);
  std::string words = "Row " + std::to_string(row) + ": " + fixed_text(planned, 0) + " planned, " +
                      fixed_text(ideal, 1) + " ideal";
  if (by != "0.0")
    words += ": " + by + (off < 0.0 ? " fewer" : " more") + " (" +
             fixed_text(100.0 * std::abs(off) / ideal, 1) + " %)";
  const double seen = 100.0 * figures.seen[i] / ideal;
  const std::string seen_by = fixed_text(std::abs(seen), 1);
  words += ". Seen over six rows: ";
  return words + (seen_by == "0.0" ? "as wide as it should be."
                                   : seen_by + " % too " + (seen < 0.0 ? "narrow." : "wide."));
}

RhythmPlace place_in_rhythm(const knit::RhythmPlan& plan, std::size_t index) {
  RhythmPlace place;
  const auto& roles = plan.roles;
  const auto changes = [](knit::RowRole role) { return role == knit::RowRole::change; };
  const auto at = roles.begin() + static_cast<std::ptrdiff_t>(index);
  const auto next = std::find_if(at + 1, roles.end(), changes);
  if (next != roles.end()) {
    place.to_next = static_cast<std::int32_t>(next - at) - 1;
    const auto above = static_cast<std::size_t>(next - roles.begin());
    place.next_grows = plan.counts[above] > plan.counts[above - 1];
  }
  if (!changes(*at)) {
    const auto last = std::find_if(std::make_reverse_iterator(at), roles.rend(), changes);
    const auto begin = std::max(last.base(), roles.begin() + 1);  // the first row is no round between
    place.rest = static_cast<std::int32_t>(at - begin) + 1;
    place.rests = place.rest + static_cast<std::int32_t>(next - at) - 1;
    return place;
  }
  place.change = plan.counts[index] - plan.counts[index - 1];
  std::size_t begin = 1;  // the first row is of no segment
  for (const knit::RhythmSegment& segment : plan.segments) {
    const auto end = begin + static_cast<std::size_t>(segment.length());
    if (index < end) {
      place.turn = static_cast<std::int32_t>(index - begin) / segment.rows + 1;
      place.turns = segment.times;
      break;
    }
    begin = end;
  }
  return place;
}

std::string rhythm_place_words(const std::vector<RhythmFigures>& all, std::int32_t row) {
  const RhythmFigures* figures = figures_at(all, row);
  if (figures == nullptr || !figures->has(row)) return "";
  const auto i = static_cast<std::size_t>(row - figures->first_row);
  const RhythmPlace place = place_in_rhythm(figures->rhythm->plan, i);
  std::string words;
  if (place.change != 0)
    words = std::string(place.change > 0 ? "Increase" : "Decrease") + " round " + std::to_string(place.turn) +
            " of " + std::to_string(place.turns) + ", " + stitches_more(place.change);
  else if (i == 0)
    words = figures->rhythm->from == 0 ? "The rhythm begins" : "The rhythm is planned again from here";
  else
    words = "Knit round " + std::to_string(place.rest) + " of " + std::to_string(place.rests);
  if (!place.to_next) return words + "; nothing is shaped any more.";
  const std::string next = place.next_grows ? "increase" : "decrease";
  if (*place.to_next == 0)
    return words + "; the next round is " + (place.next_grows ? "an " : "a ") + next + " round.";
  return words + "; " + knit::plural(*place.to_next, "knit round", "knit rounds") + " until the next " +
         next + " round.";
}

}  // namespace app
