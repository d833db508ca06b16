#include "app/checker/checker.h"

#include <algorithm>
#include <system_error>

#include "knit/base/number_text.h"
#include "knit/model/words.h"

namespace app {

std::optional<CheckedGauge> checked_gauge(std::string_view text) {
  const std::size_t cross = text.find('x');
  if (cross == std::string_view::npos) return std::nullopt;
  CheckedGauge gauge;
  const auto read = [](std::string_view part, double& value) {
    const auto result = knit::number_from(part.data(), part.data() + part.size(), value);
    return result.ec == std::errc() && result.ptr == part.data() + part.size() && value >= least_gauge &&
           value <= most_gauge;
  };
  if (!read(text.substr(0, cross), gauge.stitches) || !read(text.substr(cross + 1), gauge.rows))
    return std::nullopt;
  return gauge;
}

const knit::CheckedSize* Checker::shown() const {
  if (checked == nullptr || checked->sizes.empty()) return nullptr;
  return &checked->sizes[std::min(size, checked->sizes.size() - 1)];
}

const knit::CheckedLine* line_numbered(const knit::CheckedSize& size, std::size_t number) {
  const auto line = std::lower_bound(
      size.lines.begin(), size.lines.end(), number,
      [](const knit::CheckedLine& told, std::size_t wanted) { return told.number < wanted; });
  return line != size.lines.end() && line->number == number ? &*line : nullptr;
}

bool is_mistake(const knit::CheckedLine& line) {
  return line.verdict == knit::LineVerdict::does_not_add_up ||
         line.verdict == knit::LineVerdict::not_understood;
}

std::vector<const knit::CheckedLine*> mistakes_of(const knit::CheckedSize& size) {
  std::vector<const knit::CheckedLine*> mistakes;
  for (const knit::CheckedLine& line : size.lines)
    if (is_mistake(line)) mistakes.push_back(&line);
  return mistakes;
}

const knit::CheckedLine* mistake_from(const knit::CheckedSize& size, std::size_t line, int direction) {
  const auto mistakes = mistakes_of(size);
  if (mistakes.empty()) return nullptr;
  if (direction > 0) {
    const auto next = std::find_if(mistakes.begin(), mistakes.end(),
                                   [&](const knit::CheckedLine* mistake) { return mistake->number > line; });
    return next == mistakes.end() ? mistakes.front() : *next;
  }
  const auto last = std::find_if(mistakes.rbegin(), mistakes.rend(),
                                 [&](const knit::CheckedLine* mistake) { return mistake->number < line; });
  return last == mistakes.rend() ? mistakes.back() : *last;
}

TextCaret mark_of(const Checker& checker, const knit::CheckedLine& line) {
  if (line.word_length > 0) return {line.number, line.word_at, line.word_length};
  const auto starts = line_starts(*checker.text);
  if (line.number < 1 || line.number > starts.size()) return {};
  const std::size_t end = byte_of(starts, checker.text->size(), {line.number, checker.text->size(), 0});
  return {line.number, 0, end - starts[line.number - 1]};
}

std::vector<std::size_t> line_starts(std::string_view text) {
  std::vector<std::size_t> starts{0};
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '\n') starts.push_back(i + 1);
  return starts;
}

TextCaret caret_at(const std::vector<std::size_t>& starts, std::size_t byte) {
  const auto after = std::upper_bound(starts.begin(), starts.end(), byte);
  const auto line = static_cast<std::size_t>(after - starts.begin());
  return {line, byte - starts[line - 1], 0};
}

std::size_t byte_of(const std::vector<std::size_t>& starts, std::size_t bytes, const TextCaret& caret) {
  const std::size_t line = std::clamp<std::size_t>(caret.line, 1, starts.size());
  const std::size_t end = line < starts.size() ? starts[line] - 1 : bytes;
  return std::min(starts[line - 1] + caret.at, end);
}

std::string verdict_words(CheckVerdict verdict) {
  switch (verdict) {
    case CheckVerdict::holds:
      return "Every count holds";
    case CheckVerdict::does_not_add_up:
      return "Does not add up";
    case CheckVerdict::not_understood:
      return "Not all of it is understood";
  }
  return "";
}

std::string_view verdict_words(knit::LineVerdict verdict) {
  switch (verdict) {
    case knit::LineVerdict::holds:
      return "This line holds.";
    case knit::LineVerdict::does_not_add_up:
      return "This line does not add up.";
    case knit::LineVerdict::not_understood:
      return "This line is not understood.";
    case knit::LineVerdict::not_claimed:
      return "This line hangs on one that is not understood, so nothing is claimed about it.";
    case knit::LineVerdict::no_instruction:
      break;
  }
  return "No line of work.";
}

std::string summary_words(const Checker& checker) {
  if (checker.text->empty()) return "Type, paste or open a pattern.";
  if (checker.checked == nullptr) return "Reading it...";
  const knit::CheckedPattern& checked = *checker.checked;
  if (!checked.is_pattern)
    return checked.remark.empty() ? "There is no line of work in it; a pattern begins like \"CO 6 sts\", a "
                                    "round like \"Rnd 7:\"."
                                  : checked.remark;
  const auto counted = [](std::size_t count, std::string_view one, std::string_view many) {
    return knit::plural(static_cast<std::int64_t>(count), one, many);
  };
  std::size_t wrong = 0;
  if (const knit::CheckedSize* size = checker.shown())
    wrong = static_cast<std::size_t>(std::count_if(
        size->lines.begin(), size->lines.end(),
        [](const knit::CheckedLine& line) { return line.verdict == knit::LineVerdict::does_not_add_up; }));
  std::string words =
      verdict_words(checked.verdict) + ": " + counted(checked.rounds, "round", "rounds") + " worked";
  if (wrong > 0) words += ", " + counted(wrong, "line does", "lines do") + " not add up";
  if (checked.not_understood > 0)
    words +=
        ", " + counted(checked.not_understood, "line is", "lines are") + " not understood or not claimed";
  words += ".";
  return checked.remark.empty() ? words : words + " " + checked.remark;
}

}  // namespace app
