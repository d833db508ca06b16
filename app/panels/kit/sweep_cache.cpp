#include "app/panels/kit/sweep_cache.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "app/panels/kit/number_field.h"

namespace app {

namespace {

// Three significant digits: a range that a person would have typed.
double rounded(double value) {
  if (!(value > 0.0)) return value;
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 2.0);
  return std::round(value / unit) * unit;
}

// Of those that count one kind of problem.
knit::ProblemKind kind_of(SweepFigure figure) {
  switch (figure) {
    case SweepFigure::resampled:
      return knit::ProblemKind::row_resampled;
    case SweepFigure::gaps_open:
      return knit::ProblemKind::gap_left_open;
    case SweepFigure::clamped:
      return knit::ProblemKind::time_clamped;
    default:
      return knit::ProblemKind::band_missed;
  }
}

std::optional<double> figure_of(SweepFigure figure, const SweepRun& swept) {
  const RunFigures& f = swept.figures;
  switch (figure) {
    case SweepFigure::problems:
      return static_cast<double>(f.problems.total());
    case SweepFigure::stalls:
    case SweepFigure::resampled:
    case SweepFigure::gaps_open:
    case SweepFigure::clamped:
      return static_cast<double>(f.problems.of(kind_of(figure)));
    case SweepFigure::stitches:
      return static_cast<double>(f.stitches);
    case SweepFigure::course_cv:
      return f.course.count > 0 ? std::optional(f.course.cv) : std::nullopt;
    case SweepFigure::wale_cv:
      return f.wale.count > 0 ? std::optional(f.wale.cv) : std::nullopt;
    case SweepFigure::rows:
      return static_cast<double>(f.rows);
    case SweepFigure::most_in_a_row:
      return static_cast<double>(f.most_in_a_row);
    case SweepFigure::tubes:
      return static_cast<double>(swept.tubes.tubes);
    case SweepFigure::yarns:
      return static_cast<double>(swept.tubes.yarns);
    case SweepFigure::holders:
      return static_cast<double>(swept.tubes.holders);
    case SweepFigure::left_out:
      return static_cast<double>(swept.tubes.left_out);
    case SweepFigure::uncovered:
      return swept.uncovered ? std::optional(100.0 * *swept.uncovered) : std::nullopt;
  }
  return std::nullopt;
}

std::string_view none_of(SweepFigure figure) {
  switch (figure) {
    case SweepFigure::stalls:
      return "No stall";
    case SweepFigure::resampled:
      return "No row resampled";
    case SweepFigure::gaps_open:
      return "No gap left open";
    case SweepFigure::clamped:
      return "No time clamped";
    default:
      return "No problem";
  }
}

}  // namespace

std::optional<double> present_value(const knit::ParameterInfo& info, const knit::Parameters& parameters) {
  if (const auto* number = std::get_if<knit::Number>(&info.kind))
    return knit::effective_value(*number, parameters);
  const auto& count = std::get<knit::Count>(info.kind);
  if (count.get(parameters) > 0) return count.get(parameters);
  // Rings cast on six when they are not told; contours as many as there is room for.
  return parameters.rows.source == knit::RowSource::rings ? std::optional(6.0) : std::nullopt;
}

SweepAxis usual_axis(const knit::ParameterInfo& info, const knit::Parameters& parameters, int count) {
  // What only a run finds: about a dozen of what is counted, one of what is weighed.
  const bool counted = std::holds_alternative<knit::Count>(info.kind);
  const double value = present_value(info, parameters).value_or(counted ? 12.0 : 1.0);
  SweepAxis axis{std::string(info.key), 0.0, 1.0, count};
  if (const auto* whole = std::get_if<knit::Count>(&info.kind)) {
    axis.from = whole->low;
    axis.to = std::min<double>(whole->high, std::max(24.0, 2.0 * value));
    return axis;
  }
  const auto& number = std::get<knit::Number>(info.kind);
  if (value <= 0.0) return {axis.key, 0.0, std::min(1.0, number.high), count};
  axis.from = std::max(number.low, rounded(0.5 * value));
  axis.to = std::min(number.high, rounded(1.5 * value));
  // Beyond the stitch width nothing could be told apart.
  if (info.key == knit::keys::epsilon)
    axis.to = std::min(rounded(1.9 * value), rounded(0.98 * parameters.stitch.width));
  if (info.key == knit::keys::epsilon) axis.from = rounded(0.1 * value);
  return axis;
}

std::string_view name_of(SweepFigure figure) {
  constexpr std::array<std::string_view, sweep_figures> names{
      "Problems", "Stalls",    "Rows resampled",  "Gaps left open", "Times clamped",
      "Stitches", "Course CV", "Wale CV",         "Rows",           "Most shaping a row",
      "Tubes",    "Yarns",     "Holders at once", "Left out",       "Uncovered, %"};
  return names.at(static_cast<std::size_t>(figure));
}

std::string_view key_of(SweepFigure figure) {
  constexpr std::array<std::string_view, sweep_figures> keys{
      "problems", "stalls",        "resampled", "gaps-open", "clamped", "stitches", "course-cv", "wale-cv",
      "rows",     "most-in-a-row", "tubes",     "yarns",     "holders", "left-out", "uncovered"};
  return keys.at(static_cast<std::size_t>(figure));
}

int decimals_of(SweepFigure figure) {
  if (figure == SweepFigure::uncovered) return 1;
  return figure == SweepFigure::course_cv || figure == SweepFigure::wale_cv ? 3 : 0;
}

void SweepCache::refresh(const std::shared_ptr<SweepWork>& work) {
  if (work != work_) {
    *this = SweepCache();
    work_ = work;
    if (work == nullptr) return;
    outcomes_.assign(work->total(), SweepOutcome::pending);
    for (Values& values : values_) values.assign(work->total(), std::nullopt);
    low_.fill(std::numeric_limits<double>::infinity());
    high_.fill(-std::numeric_limits<double>::infinity());
  }
  if (work == nullptr || work->done() == done_) return;
  done_ = work->done();
  for (std::size_t i = 0; i < outcomes_.size(); ++i) {
    if (outcomes_[i] != SweepOutcome::pending) continue;
    if (const SweepRun* run = work->run(i)) read(i, *run);
  }
}

void SweepCache::read(std::size_t index, const SweepRun& run) {
  if (!run.refused.empty()) {
    outcomes_[index] = SweepOutcome::refused;
    ++refused_;
    return;
  }
  outcomes_[index] = run.figures.finished ? SweepOutcome::finished : SweepOutcome::stopped;
  if (!run.figures.finished) ++stopped_;
  for (std::size_t f = 0; f < sweep_figures; ++f) {
    const auto value = figure_of(static_cast<SweepFigure>(f), run);
    values_[f][index] = value;
    if (!value) continue;
    low_[f] = std::min(low_[f], *value);
    high_[f] = std::max(high_[f], *value);
  }
}

std::optional<QuietStretch> quiet_stretch(const SweepWork& work, const SweepCache& cache,
                                          SweepFigure figure) {
  if (work.done() < work.total()) return std::nullopt;
  const auto kind = figure == SweepFigure::problems ? std::nullopt : std::optional(kind_of(figure));
  if (const QuietStretch* narrowed = work.quiet(kind)) return *narrowed;
  std::vector<bool> quiet;
  for (std::size_t i = 0; i < work.first_values().size(); ++i) {
    const auto& count = cache.of(figure)[i];
    quiet.push_back(cache.outcomes()[i] == SweepOutcome::finished && count && *count == 0.0);
  }
  return longest_quiet(work.first_values(), quiet);
}

std::string words_of(const QuietStretch& quiet, SweepFigure figure) {
  const std::string none(none_of(figure));
  if (quiet.from_first && quiet.to_last)
    return none + " from " + shown_number(quiet.from) + " to " + shown_number(quiet.to) + ".";
  const std::string before = quiet.not_yet ? ", at " + shown_number(*quiet.not_yet) + " not yet" : "";
  if (quiet.to_last) return none + " from " + shown_number(quiet.from) + " on" + before + ".";
  if (quiet.from_first) return none + " up to " + shown_number(quiet.to) + ".";
  return none + " from " + shown_number(quiet.from) + " to " + shown_number(quiet.to) + ".";
}

}  // namespace app
