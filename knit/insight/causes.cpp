#include "knit/insight/causes.h"

#include <algorithm>

#include "knit/insight/cause_parts.h"
#include "knit/rows/rows.h"

namespace knit {

namespace {

// "Row 1 has 6 stitches": the thesis's cast on has so many unless a person says otherwise.
std::string why_cast_on(const Timeline& timeline) {
  const StepRange steps = steps_of_row(timeline, Stage::cast_on, 1);
  if (steps.begin == steps.end) return "";
  const Parameters& parameters = timeline.parameters_of_step(steps.end - 1);
  const auto* cycle = get_if<CycleFound>(timeline.step(steps.begin));
  const std::string holds = cycle == nullptr ? ""
                                             : " Its cycle is " + short_number(cycle->length) +
                                                   " long, which would hold " +
                                                   short_number(cycle->length / parameters.stitch.width) +
                                                   " of " + short_number(parameters.stitch.width) + ".";
  if (parameters.rows.cast_on > 0) return "so many were asked for to cast on." + holds;
  return "so many are cast on unless a person asks for others, whatever the length." + holds;
}

// The count that a row has, or has been given; 0: none so far.
std::int32_t count_of(const Timeline& timeline, std::int32_t row) {
  const State& run = timeline.furthest();
  if (const Row* made = run.fabric.find_row(row)) return size_of(*made);
  const auto decided = count_decided_by(timeline, row);
  if (!decided) return 0;
  const Event& what = timeline.step(*decided).what;
  if (const auto* closed = get_if<RowClosed>(what)) return closed->stitches;
  if (const auto* resampled = get_if<RowResampled>(what)) return resampled->to;
  if (const auto* chosen = get_if<CountChosen>(what)) return chosen->count;
  return 0;
}

bool is_cut(const Timeline& timeline, std::int32_t row) {
  const auto decided = count_decided_by(timeline, row);
  return decided && is<CountChosen>(timeline.step(*decided));
}

bool decides_count(const Event& what) {
  return is<RowClosed>(what) || is<RowResampled>(what) || is<CountChosen>(what) || is<JoinCounted>(what) ||
         is<GapShared>(what);
}

// The rule that spaced the mains, told of the first of them.
std::string why_spacing(const Timeline& timeline, std::int32_t row) {
  const Join* join = planned_join(timeline.furthest(), row);
  if (join == nullptr) return "";
  const auto first = std::find(join->labels.begin(), join->labels.end(), Label::main);
  if (first == join->labels.end()) return "";
  const std::string why = why_label(timeline, {row, static_cast<std::int32_t>(first - join->labels.begin())});
  const std::size_t of_the_first = why.find("; this one");
  return of_the_first == std::string::npos ? why : why.substr(0, of_the_first) + ".";
}

bool is_last_of_row(const Timeline& timeline, std::size_t step) {
  const Place& at = timeline.step(step).place;
  if (step + 1 == timeline.known()) return timeline.complete();
  const Place& next = timeline.step(step + 1).place;
  return next.stage != at.stage || next.row != at.row;
}

}  // namespace

std::string why_count(const Timeline& timeline, std::int32_t row) {
  const std::int32_t count = row >= 1 ? count_of(timeline, row) : 0;
  if (count == 0) return "";
  const std::string why = is_cut(timeline, row) ? why_contour_count(timeline, row)
                          : row == 1            ? why_cast_on(timeline)
                                                : why_picked(timeline, row);
  if (why.empty()) return "";
  return "Row " + std::to_string(row) + " has " + stitch_count_text(count) + ": " + why;
}

std::vector<std::size_t> refused_before(const Timeline& timeline, const StitchElement& stitch) {
  std::vector<std::size_t> refused;
  if (stitch.row < 2 || stitch.stitch < 1) return refused;
  const StepRange steps = steps_of_row(timeline, Stage::rows, stitch.row);
  VertexId taken = no_vertex;
  for (std::size_t i = steps.begin; i < steps.end; ++i) {
    const Event& what = timeline.step(i).what;
    const auto* measured = get_if<CandidateMeasured>(what);
    const auto* missed = get_if<BandMissed>(what);
    if (missed != nullptr && missed->stitch == stitch.stitch) taken = missed->taken;
    // An anchor's number counts from 1, so that the stitch after it has the same from 0.
    const bool between = measured != nullptr && measured->stitch == stitch.stitch &&
                         measured->verdict != Verdict::accepted &&
                         measured->candidate_order > measured->anchor_order;
    if (between) refused.push_back(i);
  }
  const auto is_taken = [&](std::size_t i) {
    return get_if<CandidateMeasured>(timeline.step(i))->candidate == taken;
  };
  refused.erase(std::remove_if(refused.begin(), refused.end(), is_taken), refused.end());
  return refused;
}

std::string why_refused_before(const Timeline& timeline, const StitchElement& stitch) {
  std::vector<std::size_t> steps = refused_before(timeline, stitch);
  if (steps.empty()) return "";
  const auto at = [&](std::size_t step) { return *get_if<CandidateMeasured>(timeline.step(step)); };
  const CandidateMeasured last = at(steps.back());
  const Parameters& parameters = timeline.parameters_of_step(steps.back());
  const Band band = band_of(parameters.rows, parameters.stitch);
  std::string text = "Just before it " + vertex_text(last.candidate) +
                     " was refused: " + short_number(last.distance) + " from stitch " +
                     std::to_string(last.stitch) + ", " +
                     (last.verdict == Verdict::too_near ? "nearer than " + short_number(band.low)
                                                        : "farther than " + short_number(band.high));
  steps.pop_back();
  constexpr std::size_t most = 3;
  for (std::size_t i = 0; i < std::min(most, steps.size()); ++i) {
    const CandidateMeasured other = at(steps[steps.size() - 1 - i]);
    text += std::string(i == 0 ? "; before that " : ", ") + std::to_string(other.candidate) + " (" +
            short_number(other.distance) + ")";
  }
  if (steps.size() > most) text += " and " + std::to_string(steps.size() - most) + " more";
  return text + ".";
}

std::string cause_of(const Timeline& timeline, std::size_t step) {
  if (step >= timeline.known()) return "";
  const Step& did = timeline.step(step);
  const auto* main = get_if<MainPlaced>(did);
  const auto* shaping = get_if<ShapingPlaced>(did);
  std::string text;
  if (main != nullptr) text = why_label(timeline, {did.place.row, main->cell});
  if (shaping != nullptr) text = why_label(timeline, {did.place.row, shaping->cell});
  if (is<SpacingChosen>(did)) text = why_spacing(timeline, did.place.row);
  if (did.place.row < 1 || !(decides_count(did.what) || is_last_of_row(timeline, step))) return text;
  const std::string count = why_count(timeline, did.place.row);
  return text + (text.empty() || count.empty() ? "" : " ") + count;
}

}  // namespace knit
