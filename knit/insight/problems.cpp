#include "knit/insight/problems.h"

#include <algorithm>
#include <cmath>

#include "knit/model/words.h"

namespace knit {

namespace {

// How many times larger the larger one is.
double ratio(std::int32_t a, std::int32_t b) {
  const auto [low, high] = std::minmax({std::max(a, 1), std::max(b, 1)});
  return static_cast<double>(high) / low;
}

struct KindName {
  std::string_view key, name, one, many;
};
constexpr std::array<KindName, problem_kinds> kind_names{
    KindName{"stops", "Stops", "stop", "stops"},
    {"left-out", "Left out", "part left out", "parts left out"},
    {"resampled", "Rows resampled", "row resampled", "rows resampled"},
    {"gaps-open", "Gaps left open", "gap left open", "gaps left open"},
    {"stalls", "Stalls", "stall", "stalls"},
    {"clamped", "Times clamped", "time clamped", "times clamped"},
    {"no-short-row", "Short rows left out", "short row left out", "short rows left out"}};

const KindName& names_of(ProblemKind kind) { return kind_names.at(static_cast<std::size_t>(kind)); }

}  // namespace

std::string_view key_of(ProblemKind kind) { return names_of(kind).key; }
std::string_view name_of(ProblemKind kind) { return names_of(kind).name; }

void ProblemCounts::take(const Step& step, const Parameters& parameters) {
  const auto problem = problem_of(step, 0, parameters);
  if (!problem) return;
  const auto* stop = get_if<Stopped>(step);
  const bool at_stall = stop != nullptr && stop->reason == StopReason::stall;
  ++of_.at(static_cast<std::size_t>(at_stall ? ProblemKind::band_missed : problem->kind));
}

std::string words_of(const ProblemCounts& counts) {
  std::string words;
  for (std::size_t i = 0; i < problem_kinds; ++i) {
    const auto kind = static_cast<ProblemKind>(i);
    const auto count = static_cast<std::int64_t>(counts.of(kind));
    if (count == 0) continue;
    words += (words.empty() ? "" : ", ") +
             plural(count, std::string(names_of(kind).one), std::string(names_of(kind).many));
  }
  return words;
}

std::optional<Problem> problem_of(const Step& step, std::size_t index, const Parameters& parameters) {
  if (!is_unusual(step, parameters)) return std::nullopt;
  const double width = parameters.stitch.width;
  if (const auto* resampled = get_if<RowResampled>(step))
    return Problem{index, ProblemKind::row_resampled, ratio(resampled->from, resampled->to)};
  if (const auto* shared = get_if<GapShared>(step))
    return Problem{index, ProblemKind::gap_left_open, std::abs(shared->gap_after - width) / width};
  if (const auto* missed = get_if<BandMissed>(step))
    return Problem{index, ProblemKind::band_missed, std::abs(missed->distance - width) / width};
  if (const auto* left = get_if<TubeLeftOut>(step)) {
    const auto stitches = static_cast<double>(left->rows) * static_cast<double>(left->stitches);
    return Problem{index, ProblemKind::left_out, stitches};
  }
  if (is<TubeCharted>(step)) return Problem{index, ProblemKind::no_short_row, 0.0};
  if (const auto* dropped = get_if<PairDropped>(step)) {
    const auto stitches = static_cast<double>(dropped->last - dropped->first + 1);
    return Problem{index, ProblemKind::no_short_row, stitches};
  }
  if (is<VertexTimed>(step)) return Problem{index, ProblemKind::time_clamped, 0.0};
  return Problem{index, ProblemKind::stopped, 0.0};
}

std::optional<Element> thing_of_problem(const Step& step) {
  if (const auto* missed = get_if<BandMissed>(step)) return VertexElement{missed->taken};
  if (const auto* left = get_if<TubeLeftOut>(step)) return VertexElement{left->vertex};
  if (const auto* timed = get_if<VertexTimed>(step)) return VertexElement{timed->vertex};
  if (const auto* shared = get_if<GapShared>(step))
    return RowEdgeElement{step.place.row, shared->stitches - 1};
  if (is<RowResampled>(step)) return StitchElement{step.place.row, 0};
  return std::nullopt;
}

void ProblemRanking::take(const Problem& problem) {
  by_kind_[static_cast<std::size_t>(problem.kind)].push_back(problem);
  ++size_;
  sorted_ = false;
}

void ProblemRanking::finish() {
  if (sorted_) return;
  for (auto& problems : by_kind_) {
    std::stable_sort(problems.begin(), problems.end(),
                     [](const Problem& a, const Problem& b) { return a.size > b.size; });
  }
  sorted_ = true;
}

const Problem& ProblemRanking::operator[](std::size_t i) const {
  std::size_t kind = 0;
  while (i >= by_kind_[kind].size()) i -= by_kind_[kind++].size();
  return by_kind_[kind][i];
}

namespace {

std::string height_text(double heights) { return short_number(std::round(heights * 10.0) / 10.0) + " h"; }

std::string part_words(const UncoveredPlace& place) {
  const std::string at = vertex_text(place.vertex);
  if (place.kind == UncoveredKind::flat) return "the flat part at " + at;
  if (place.kind == UncoveredKind::slid) return "the part at " + at + ", which the stitches slid off";
  return place.kind == UncoveredKind::limb ? "the limb at " + at + ", which is left out"
                                           : "the part at " + at;
}

// What was found to help: with geodesic timing contours go round the middle of a flat part; a limb is left out because
// it is smaller than a row.
std::string way_on(const UncoveredPlace& place, const Parameters& parameters) {
  const bool geodesic = parameters.timing.kind == TimingKind::geodesic;
  if (place.kind == UncoveredKind::slid) return " A greater weight of cover holds them there.";
  if (place.kind == UncoveredKind::limb) {
    return place.width_that_keeps > 0.0
               ? " Stitches narrower than about " + short_number(place.width_that_keeps) + " knit it."
               : " Narrower stitches may knit it.";
  }
  if (parameters.rows.source == RowSource::rings)
    return geodesic ? " Rows from contours follow it."
                    : " Rows from contours with geodesic timing follow it.";
  if (geodesic) return " Smaller stitches may reach it.";
  return place.kind == UncoveredKind::flat ? " Geodesic timing knits flat parts."
                                           : " Geodesic timing may reach it.";
}

// In stitch heights smaller stitches do not help, and often larger ones do.
std::string way_on(const Parameters& parameters) {
  const PlacementPolicy placement = parameters.stitches.placement;
  const bool rings = parameters.rows.source == RowSource::rings;
  if (placement == PlacementPolicy::thesis || placement == PlacementPolicy::even)
    return " Placement nearest hangs each stitch on the nearest ones below.";
  if (rings) return " Rows from contours lie one stitch height apart.";
  if (parameters.settle.settling != Settling::on) return " Settling evens them out.";
  return " Another timing or larger stitches may help.";
}

std::string rows_words(const Stretched& rows, std::size_t tubes, bool begins) {
  const std::string numbers = rows.from == rows.to
                                  ? "ow " + std::to_string(rows.from)
                                  : "ows " + std::to_string(rows.from) + " to " + std::to_string(rows.to);
  if (tubes > 1) return (begins ? "Tube " : "tube ") + tube_name(rows.tube) + ", r" + numbers;
  return (begins ? "R" : "r") + numbers;
}

std::vector<Stretched> remarkable_rows(const Coverage& coverage) {
  std::vector<Stretched> rows;
  std::copy_if(coverage.stretched.begin(), coverage.stretched.end(), std::back_inserter(rows), is_remarkable);
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Stretched& a, const Stretched& b) { return a.longest > b.longest; });
  return rows;
}

}  // namespace

namespace {

// "3 faces lie turned over, the first at row 12."
std::string turned_words(const TurnedFaces& turned) {
  std::string words = turned.faces == 1 ? "A face lies" : std::to_string(turned.faces) + " faces lie";
  words += turned.faces == 1 ? " turned over" : " turned over, the first";
  const std::int32_t row = turned.at.row;
  return words + (row > 0 ? " at row " + std::to_string(row) : " at deal " + std::to_string(-row)) + ".";
}

// Where stitches are not moved, they are best let settle.
std::string turned_way_on(const Parameters& parameters) {
  return parameters.settle.settling == Settling::on ? " A greater weight of folds turns them back."
                                                    : " Settling may turn them back.";
}

}  // namespace

std::vector<Remark> remarks_on(const Coverage& coverage, const Parameters& parameters) {
  std::vector<Remark> remarks;
  for (const UncoveredPlace& place : coverage.uncovered.places) {
    remarks.push_back({RemarkKind::uncovered,
                       percent_text(place.share) + " of the surface is covered by no row: " +
                           part_words(place) + "." + way_on(place, parameters),
                       std::nullopt, place.vertex});
  }
  if (coverage.turned.faces > 0)
    remarks.push_back(
        {RemarkKind::turned, turned_words(coverage.turned) + turned_way_on(parameters), coverage.turned.at});
  const std::vector<Stretched> rows = remarkable_rows(coverage);
  for (std::size_t i = 0; i < std::min(rows.size(), most_stretched); ++i) {
    remarks.push_back({RemarkKind::stretched,
                       rows_words(rows[i], coverage.tubes, true) + ": wales up to " +
                           height_text(rows[i].longest) + " long." + way_on(parameters),
                       rows[i].at});
  }
  if (rows.size() <= most_stretched) return remarks;
  const Stretched& next = rows[most_stretched];
  remarks.push_back({RemarkKind::stretched,
                     "Stretched too: " +
                         plural(static_cast<std::int64_t>(rows.size() - most_stretched),
                                "more stretch of rows", "more stretches of rows") +
                         ", with wales up to " + height_text(next.longest) + " long.",
                     next.at});
  return remarks;
}

std::string summary_of(const Coverage& coverage) {
  std::string words;
  const std::vector<UncoveredPlace>& places = coverage.uncovered.places;
  if (!places.empty()) {
    words = percent_text(coverage.uncovered.share) +
            " of the surface is covered by no row: " + part_words(places.front());
    const auto more = static_cast<std::int64_t>(places.size()) - 1;
    if (more > 0) words += " and " + plural(more, "more part", "more parts");
  }
  const std::vector<Stretched> rows = remarkable_rows(coverage);
  if (rows.empty()) return words.empty() ? words : words + ".";
  words += (words.empty() ? "Wales are up to " : "; wales are up to ") + height_text(rows.front().longest) +
           " long in " + rows_words(rows.front(), coverage.tubes, false);
  const auto more = static_cast<std::int64_t>(rows.size()) - 1;
  if (more > 0) words += " and in " + plural(more, "more stretch of rows", "more stretches of rows");
  return words + ".";
}

}  // namespace knit
