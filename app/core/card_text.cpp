#include "app/core/card_text.h"

#include "app/core/card_figures.h"
#include "app/core/fixed_text.h"
#include "app/core/work_beside.h"

namespace app {

namespace {

constexpr std::size_t words_width = 36;
constexpr std::size_t number_width = 10;

std::string right(const std::string& text, std::size_t width) {
  return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}
std::string left(const std::string& text, std::size_t width) {
  return text.size() < width ? text + std::string(width - text.size(), ' ') : text;
}

std::string line_text(const CardLine& line) {
  std::string text = left(line.words + (line.unit.empty() ? "" : " " + line.unit), words_width);
  if (!line.missing.empty()) return text + right("-", number_width) + "  " + line.missing + "\n";
  for (const auto& figure : line.figures) {
    // A star marks what a knitter would rather not see.
    const std::string number = figure ? figure->text + (figure->outside ? "*" : " ") : "";
    text += right(number, number_width);
  }
  while (text.back() == ' ') text.pop_back();
  return text + "\n";
}

std::string rows_text(const knit::Quality& quality) {
  std::string text = "\n" + left("row", 6) + right("stitches", number_width) + right("length / w", 12) +
                     right("course CV", 12) + "\n";
  for (const knit::RowFit& row : quality.rows) {
    text += left(std::to_string(row.row), 6) + right(std::to_string(row.stitches), number_width) +
            right(fixed_text(row.ideal, 2), 12) + right(fixed_text(row.course_cv, 4), 12) + "\n";
  }
  return text;
}

}  // namespace

std::string card_text(const Session& session) {
  const knit::Timeline& timeline = *session.timeline;
  const knit::Parameters& p = timeline.parameters();
  const knit::Quality quality =
      knit::measure_quality(timeline.input(), timeline.state(), p.stitch_width, knit::stitch_height_of(p));
  const auto closeness = closeness_now(session);
  std::string text = "Report card of " + timeline.input().mesh.name +
                     ": stitch width w = " + knit::number_text(quality.stitch_width) +
                     ", stitch height h = " + knit::number_text(quality.stitch_height) + " mesh units\n\n";
  text += left("", words_width);
  for (const char* column : {"mean ", "CV ", "95 % ", "max "}) text += right(column, number_width);
  text.pop_back();
  text += "\n";
  for (const CardGroup& group : card_groups(&quality, closeness.get(), false)) {
    for (const CardLine& line : group.lines) text += line_text(line);
  }
  return text + "* more than a knitter would want\n" + rows_text(quality);
}

}  // namespace app
