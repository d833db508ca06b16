#include "app/compare/compare_runs.h"

#include <algorithm>
#include <cmath>

#include "app/base/text.h"
#include "knit/model/settings_table.h"
#include "knit/model/words.h"

namespace app {

namespace {

constexpr std::string_view no_figure = "\xE2\x80\x93";  // of what is not there

FigureLine count_line(const char* key, const char* name, double a, double b) {
  FigureLine line{key, name, fixed_text(a, 0), fixed_text(b, 0), ""};
  if (a != b) line.difference = (b > a ? "+" : "") + fixed_text(b - a, 0);
  return line;
}

// What is not there yet has no value.
FigureLine spread_line(const char* key, const char* name, const knit::LengthFigures& a,
                       const knit::LengthFigures& b, double knit::LengthFigures::*field, int decimals,
                       double unit_a = 1.0, double unit_b = 1.0) {
  const std::string none(no_figure);
  const double value_a = a.*field / unit_a;
  const double value_b = b.*field / unit_b;
  FigureLine line{key, name, a.count > 0 ? fixed_text(value_a, decimals) : none,
                  b.count > 0 ? fixed_text(value_b, decimals) : none, ""};
  if (a.count == 0 || b.count == 0) line.difference = none;
  if (a.count == 0 || b.count == 0 || value_a == value_b) return line;
  const std::string text = fixed_text(value_b - value_a, decimals);
  // What is smaller than the last digit shown is said to be.
  const bool seen = text.find_first_of("123456789") != std::string::npos;
  line.difference = seen ? (value_b > value_a ? "+" : "") + text : "~0";
  return line;
}

// Of one tube from end to end nothing is to be said, if it is so in both.
void add_tube_lines(std::vector<FigureLine>& lines, const RunEnd& a, const RunEnd& b) {
  const TubeFigures fa = tube_figures_of(a.state);
  const TubeFigures fb = tube_figures_of(b.state);
  const auto count = [&](const char* key, const char* name, std::int32_t TubeFigures::*field) {
    lines.push_back(count_line(key, name, fa.*field, fb.*field));
  };
  if (std::max(fa.tubes, fb.tubes) > 1) {
    count("tubes", "Tubes", &TubeFigures::tubes);
    count("splits", "Splits", &TubeFigures::splits);
    count("joins", "Joins", &TubeFigures::joins);
    count("genus", "Genus", &TubeFigures::genus);
    count("yarns", "Yarns", &TubeFigures::yarns);
    count("holders", "Holders at once", &TubeFigures::holders);
  }
  if (fa.left_out > 0 || fb.left_out > 0) count("left-out", "Left out", &TubeFigures::left_out);
  if (!a.uncovered && !b.uncovered) return;
  const auto share = [](const RunEnd& run) {
    return run.uncovered ? knit::percent_text(*run.uncovered) : std::string(no_figure);
  };
  FigureLine line{"uncovered", "Uncovered", share(a), share(b), ""};
  if (!a.uncovered || !b.uncovered) line.difference = no_figure;
  if (a.uncovered && b.uncovered && *a.uncovered != *b.uncovered) {
    const double difference = *b.uncovered - *a.uncovered;
    line.difference =
        line.a == line.b ? "~0" : (difference > 0.0 ? "+" : "") + fixed_text(100.0 * difference, 1);
  }
  lines.push_back(std::move(line));
}

// Of the kinds that either run has, after all of them: "Stalls".
void add_kind_lines(std::vector<FigureLine>& lines, const knit::ProblemCounts& a,
                    const knit::ProblemCounts& b) {
  auto at = std::find_if(lines.begin(), lines.end(), [](const FigureLine& l) { return l.key == "problems"; });
  for (std::size_t i = 0; i < knit::problem_kinds; ++i) {
    const auto kind = static_cast<knit::ProblemKind>(i);
    // The parts left out have a line among those of tubes, and a stop says more than a number.
    const bool told = kind == knit::ProblemKind::left_out || kind == knit::ProblemKind::stopped;
    if (told || (a.of(kind) == 0 && b.of(kind) == 0)) continue;
    const std::string key(knit::key_of(kind));
    const std::string name(knit::name_of(kind));
    at = lines.insert(at + 1, count_line(key.c_str(), name.c_str(), static_cast<double>(a.of(kind)),
                                         static_cast<double>(b.of(kind))));
  }
}

std::vector<FigureLine> figure_lines(const RunEnd& a, const RunEnd& b) {
  const auto count = [&](const char* key, const char* name, auto RunFigures::*field) {
    return count_line(key, name, static_cast<double>(a.figures.*field),
                      static_cast<double>(b.figures.*field));
  };
  const knit::Parameters& pa = parameters_at(a.knobs, a.state.next);
  const knit::Parameters& pb = parameters_at(b.knobs, b.state.next);
  const RunFigures& fa = a.figures;
  const RunFigures& fb = b.figures;
  std::vector<FigureLine> lines{
      count("rows", "Rows", &RunFigures::rows),
      count("stitches", "Stitches", &RunFigures::stitches),
      count("increases", "Increases", &RunFigures::increases),
      count("decreases", "Decreases", &RunFigures::decreases),
      count("most", "Most shaping a row", &RunFigures::most_in_a_row),
      count_line("problems", "Problems", static_cast<double>(fa.problems.total()),
                 static_cast<double>(fb.problems.total())),
      spread_line("course-mean", "Course / w", fa.course, fb.course, &knit::LengthFigures::mean, 3,
                  pa.stitch.width, pb.stitch.width),
      spread_line("course-cv", "Course CV", fa.course, fb.course, &knit::LengthFigures::cv, 3),
      spread_line("wale-mean", "Wale / h", fa.wale, fb.wale, &knit::LengthFigures::mean, 3, pa.stitch.height,
                  pb.stitch.height),
      spread_line("wale-cv", "Wale CV", fa.wale, fb.wale, &knit::LengthFigures::cv, 3),
      count("steps", "Steps", &RunFigures::steps)};
  add_kind_lines(lines, fa.problems, fb.problems);
  add_tube_lines(lines, a, b);
  return lines;
}

std::int32_t size_in(const knit::Fabric& fabric, knit::RowId id) {
  const knit::Row* row = fabric.find_row(id);
  return row != nullptr ? knit::size_of(*row) : 0;
}

// How a row that both have differs; none: it is the same.
std::optional<FirstRow> difference_at(const knit::Fabric& a, const knit::Fabric& b, knit::RowId id) {
  FirstRow row{id, RowDiffers::size, size_in(a, id), size_in(b, id)};
  if (row.a != row.b) return row;
  row.how = RowDiffers::places;
  const bool same = a.shared_row(id).content_hash() == b.shared_row(id).content_hash();
  if (!same && a.row(id).stitches != b.row(id).stitches) return row;
  // Worked on the same stitches otherwise dealt, it is made otherwise.
  row.how = RowDiffers::shaping;
  if (a.row(id).on != b.row(id).on) return row;
  const knit::Join* in_a = a.join_into(id);
  const knit::Join* in_b = b.join_into(id);
  if ((in_a == nullptr) != (in_b == nullptr)) return row;
  if (in_a != nullptr && in_a->labels != in_b->labels) return row;
  return std::nullopt;
}

void compare_rows(const knit::Fabric& a, const knit::Fabric& b, RunDifference& result) {
  const knit::RowId both = std::min(a.row_count(), b.row_count());
  result.rows = std::max(a.row_count(), b.row_count());
  result.rows_differ = result.rows - both;
  for (knit::RowId id = 1; id <= both; ++id) {
    const auto row = difference_at(a, b, id);
    if (!row) continue;
    ++result.rows_differ;
    if (!result.first_row) result.first_row = row;
  }
  if (!result.first_row && a.row_count() != b.row_count())
    result.first_row = FirstRow{both + 1, RowDiffers::missing, size_in(a, both + 1), size_in(b, both + 1)};
}

std::string padded(std::string text, std::size_t width, bool to_right) {
  // Only signs beyond ASCII take more bytes than places.
  const auto places = static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
  const std::string space(places < width ? width - places : 0, ' ');
  return to_right ? space + text : text + space;
}

}  // namespace

bool FigureLine::differs() const {
  return !difference.empty() && !(difference == no_figure && a == no_figure && b == no_figure);
}

bool RunDifference::any() const {
  return !same_mesh || !parameters.empty() || edits_differ || first_row || stop_a != stop_b ||
         std::any_of(figures.begin(), figures.end(), [](const FigureLine& f) { return f.differs(); });
}

RunDifference difference_of(const RunEnd& a, const RunEnd& b) {
  RunDifference result;
  const knit::Mesh& mesh_a = a.input.mesh;
  const knit::Mesh& mesh_b = b.input.mesh;
  result.same_mesh =
      &a.input == &b.input || (mesh_a.positions == mesh_b.positions && mesh_a.triangles == mesh_b.triangles);
  for (const knit::ParameterInfo& info : knit::parameter_table()) {
    std::string in_a = knit::value_text(info, a.knobs.base);
    std::string in_b = knit::value_text(info, b.knobs.base);
    if (in_a == in_b) continue;
    // The view of the stitch size that only follows would say everything twice.
    const auto view = knit::view_of(info);
    const knit::SizesFrom given = a.knobs.base.size.from();
    if (view && *view != given && given == b.knobs.base.size.from()) continue;
    result.parameters.push_back(
        {std::string(info.key), std::string(info.label), std::move(in_a), std::move(in_b)});
  }
  result.edits_differ = a.knobs.edits != b.knobs.edits;
  compare_rows(a.state.fabric, b.state.fabric, result);
  result.figures = figure_lines(a, b);
  result.tubes = tube_lines(a.state, b.state, result.same_mesh);
  result.stop_a = a.figures.stop;
  result.stop_b = b.figures.stop;
  return result;
}

namespace {

std::string first_words(const FirstRow& row, const RunNames& names) {
  switch (row.how) {
    case RowDiffers::size:
      return knit::plural(row.a, "stitch", "stitches") + " and " + std::to_string(row.b) + ".";
    case RowDiffers::places:
      return knit::plural(row.a, "stitch", "stitches") + " in both, in other places.";
    case RowDiffers::shaping:
      return knit::plural(row.a, "stitch", "stitches") + " in both, made by other increases or decreases.";
    case RowDiffers::missing:
      break;
  }
  return "only " + std::string(row.a > 0 ? names.a : names.b) + " has it.";
}

}  // namespace

std::string rows_words(const RunDifference& difference, const RunNames& names) {
  if (!difference.first_row) return "All rows are the same, stitch by stitch.";
  const std::int32_t differ = difference.rows_differ;
  return std::to_string(differ) + " of " + knit::plural(difference.rows, "row", "rows") +
         (differ == 1 ? " differs" : " differ") + ", first row " + std::to_string(difference.first_row->row) +
         ": " + first_words(*difference.first_row, names);
}

std::string text_of(const RunDifference& difference, std::string_view a_name, std::string_view b_name) {
  if (!difference.any()) return "Nothing differs.\n";
  std::string text;
  if (!difference.same_mesh) text += "The meshes differ.\n";
  text += rows_words(difference) + "\n";
  for (const TubeLine& line : difference.tubes) {
    if (line.differs()) text += words_of(line) + "\n";
  }
  if (difference.edits_differ) text += "The changes on the way differ.\n";
  if (!difference.stop_a.empty()) text += std::string(a_name) + " stopped: " + difference.stop_a + "\n";
  if (!difference.stop_b.empty()) text += std::string(b_name) + " stopped: " + difference.stop_b + "\n";
  std::vector<std::array<std::string, 4>> lines{{"", std::string(a_name), std::string(b_name), ""}};
  for (const ParameterLine& line : difference.parameters)
    lines.push_back({"--" + line.key, line.a, line.b, ""});
  for (const FigureLine& line : difference.figures)
    lines.push_back({line.name, line.a, line.b, line.difference});
  std::array<std::size_t, 4> widths{};
  for (const auto& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
  }
  for (const auto& line : lines) {
    std::string words = padded(line[0], widths[0], false);
    for (std::size_t i = 1; i < line.size(); ++i) words += "  " + padded(line[i], widths[i], true);
    words.erase(words.find_last_not_of(' ') + 1);
    text += words + "\n";
  }
  return text;
}

}  // namespace app
