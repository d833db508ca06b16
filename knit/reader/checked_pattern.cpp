#include "knit/reader/checked_pattern.h"

#include <algorithm>
#include <utility>

#include "knit/model/words.h"
#include "knit/reader/limbs_reader.h"
#include "knit/reader/named_rounds.h"
#include "knit/reader/pattern_reader.h"
#include "knit/reader/reader_grammar.h"
#include "knit/reader/reader_text.h"
#include "knit/reader/reader_work.h"
#include "knit/reader/short_needles.h"
#include "knit/reader/world_worker.h"

namespace knit {

namespace {

constexpr std::int64_t most_tried = 240;  // stitches that a stitch pattern without a cast on is tried on
constexpr std::size_t most_tried_text = 20'000;
constexpr std::size_t most_sizes = 40;
constexpr int most_workings = 6;             // of the whole text
constexpr std::int64_t most_steps = 20'000;  // of its rounds

std::vector<std::string_view> physical_lines(std::string_view text) {
  std::vector<std::string_view> lines;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + (text.substr(end, 2) == "\r\n" ? 2 : 1);
  }
  return lines;
}

bool casts_on(const Atoms& line) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i].is("co") ||
        (is_any(line[i], {"cast", "casting"}) && i + 1 < line.size() && line[i + 1].is("on")))
      return true;
    if (is_any(line[i], {"pick"}) && i + 1 < line.size() && line[i + 1].is("up")) return true;
    if (is_any(line[i], {"held", "holder"})) return true;
  }
  return false;
}

// "80 (88, 96)": the numbers, where a cast on tells them.
std::vector<std::int64_t> sizes_in(const Atoms& line) {
  for (std::size_t i = 0; i + 3 < line.size(); ++i) {
    if (!line[i].is_number() || !is_any(line[i + 1], {"(", "["}) || !line[i + 2].is_number()) continue;
    std::vector<std::int64_t> numbers{line[i].value};
    std::size_t j = i + 2;
    while (j < line.size() && line[j].is_number()) {
      numbers.push_back(line[j].value);
      ++j;
      if (j + 1 < line.size() && is_any(line[j], {",", ":", ";", "/", "-"}) && line[j + 1].is_number()) ++j;
      while (j + 2 < line.size() && is_any(line[j], {")", "]"}) && is_any(line[j + 1], {"(", "["}) &&
             line[j + 2].is_number())
        j += 2;
    }
    if (j < line.size() && is_any(line[j], {")", "]"}) && !(numbers.size() == 2 && numbers[0] == numbers[1]))
      return numbers;
  }
  return {};
}

// "multiple of 4 plus 1", "multiple of 6 sts + 2"
std::int64_t told_multiple(const std::vector<Atoms>& lines, std::string& words) {
  for (const Atoms& line : lines) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      if (!is_any(line[i], {"multiple", "multiples", "mult"})) continue;
      std::size_t j = i + 1;
      while (j < line.size() && !line[j].is_number() && j < i + 4) ++j;
      if (j >= line.size() || !line[j].is_number() || line[j].value < 1 || line[j].value > 1000) continue;
      const std::int64_t each = line[j].value;
      std::int64_t more = 0;
      for (std::size_t k = j + 1; k + 1 < std::min(line.size(), j + 6); ++k) {
        if (is_any(line[k], {"plus", "+"}) && line[k + 1].is_number()) more = line[k + 1].value;
      }
      words = "a multiple of " + std::to_string(each) + (more > 0 ? " plus " + std::to_string(more) : "");
      return each * 3 + more;
    }
  }
  return 0;
}

struct Text {
  std::vector<TextLine> lines;
  std::vector<Atoms> atoms;
  std::vector<std::string_view> physical;
};

void set_verdict(CheckedPattern& checked) {
  checked.verdict = PatternVerdict::holds;
  for (const CheckedSize& size : checked.sizes) {
    if (size.verdict == PatternVerdict::does_not_add_up) checked.verdict = size.verdict;
    if (size.verdict == PatternVerdict::not_understood && checked.verdict == PatternVerdict::holds)
      checked.verdict = size.verdict;
  }
}

void count_lines(CheckedPattern& checked, const Text& text) {
  std::size_t before = 0;
  for (const TextLine& line : text.lines) {
    if (line.number == before || line.number == 0 || line.number > text.physical.size()) continue;
    before = line.number;
    LineVerdict worst = LineVerdict::no_instruction;
    for (const CheckedSize& size : checked.sizes) {
      const LineVerdict verdict = size.lines[line.number - 1].verdict;
      if (worst == LineVerdict::no_instruction || verdict == LineVerdict::not_understood ||
          verdict == LineVerdict::not_claimed)
        worst = verdict;
    }
    if (worst == LineVerdict::no_instruction)
      ++checked.no_instructions;
    else if (worst == LineVerdict::not_understood || worst == LineVerdict::not_claimed)
      ++checked.not_understood;
    else
      ++checked.worked;
  }
}

bool tells_short_row(const TextLine& line) { return short_row_line(tokens_of(line.text)).has_value(); }

// "Place markers (m) after 8, 16 and 24 sts: side, front and side": rounds are then told by halves, to markers by name.
bool names_markers(const TextLine& line) { return named_markers_in(tokens_of(line.text)).has_value(); }

bool names_round(const TextLine& line) { return named_words_in(tokens_of(line.text)).has_value(); }

// This program's words, which are worked to the graph of stitches: pieces, short rows, and rounds by halves.
CheckedPattern checked_graph(const ReadPattern& read, const Text& text, const Lexicon& lexicon) {
  CheckedPattern checked;
  CheckedSize& size = checked.sizes.emplace_back();
  size.lines.resize(text.physical.size());
  for (std::size_t i = 0; i < size.lines.size(); ++i) size.lines[i].number = i + 1;
  for (std::size_t i = 0; i < text.lines.size(); ++i) {
    const std::size_t number = text.lines[i].number;
    if (number == 0 || number > size.lines.size()) continue;
    CheckedLine& line = size.lines[number - 1];
    Atoms copy = text.atoms[i];
    const bool is_short = tells_short_row(text.lines[i]);
    if (is_short || names_round(text.lines[i]) || label_of(tokens_of(text.lines[i].text))) {
      line.verdict = LineVerdict::holds;
      if (!is_short && !names_round(text.lines[i])) line.stitches = take_count(copy, lexicon).total;
    } else if (const auto label = world_label(copy, lexicon);
               label && looks_like_work(copy, lexicon) && !label->bare_number) {
      line.verdict = LineVerdict::not_understood;
      line.sentence = "line " + std::to_string(number) +
                      ": how this round begins is not understood here; say \"Rnd 7:\".";
      size.verdict = PatternVerdict::not_understood;
    }
  }
  for (const PatternMistake& mistake : read.mistakes) {
    if (mistake.line == 0 || mistake.line > size.lines.size()) continue;
    CheckedLine& line = size.lines[mistake.line - 1];
    line.verdict = LineVerdict::does_not_add_up;
    if (line.sentence.empty()) line.sentence = mistake.sentence;
  }
  if (!read.mistakes.empty()) size.verdict = PatternVerdict::does_not_add_up;
  checked.rounds = read.rounds_read;
  checked.is_pattern = read.rounds_read > 0 || !read.mistakes.empty();
  CheckedPiece* piece = nullptr;
  for (const TextLine& line : text.lines) {
    const auto& told = size.lines[line.number - 1];
    if (told.verdict == LineVerdict::no_instruction || !told.stitches) continue;
    const auto label = label_of(tokens_of(line.text));
    if (piece == nullptr || (label && label->first == std::int64_t{1})) piece = &size.pieces.emplace_back();
    const std::int64_t times =
        label && label->first ? std::min<std::int64_t>(label->last - *label->first + 1, 1000) : 1;
    for (std::int64_t i = 0; i < times; ++i) piece->rounds.push_back({line.number, *told.stitches});
  }
  return checked;
}

CheckedSize worked(const Lexicon& lexicon, const Text& text, std::size_t size, std::size_t sizes,
                   std::int64_t start, CheckedPattern& told) {
  WorldWorker worker(lexicon, size, sizes);
  CheckedSize checked = worker.run(text.lines, text.atoms, text.physical, start);
  if (size > 0) return checked;
  told.rounds = worker.rounds();
  if (start == 0) told.remark = worker.left_over();
  return checked;
}

// Whether a start could make it hold: one line alone does not, since no stitches are cast on, and nothing is closed.
bool lacks_only_its_start(const WorldWorker& worker, const CheckedSize& size) {
  std::size_t wrong = 0;
  for (const CheckedLine& line : size.lines) {
    if (line.verdict == LineVerdict::not_understood) return false;
    wrong += line.verdict == LineVerdict::does_not_add_up ? 1 : 0;
  }
  return wrong == 1 && !worker.ends();
}

// Rows without a cast on: on the repeat that is told, or the least on which all of them come out as they began.
//
// `unstarted` has worked the text on stitches that nobody counted. Its rounds, parsed, are tried on each number in
// turn; only a number on which they can be worked is tried on the text itself, and few of those. So the cost is that of
// a few workings of the text and of at most `most_steps` steps on a needle.
void work_on_repeat(CheckedPattern& checked, const Lexicon& lexicon, const Text& text, std::size_t length,
                    const WorldWorker& unstarted) {
  std::string words;
  const std::int64_t told = told_multiple(text.atoms, words);
  if (told > 0) {
    checked.sizes = {worked(lexicon, text, 0, 1, told, checked)};
    checked.remark = "No stitches are cast on; it is worked on " + stitches_text(told) + ", " + words + ".";
    return;
  }
  if (length > most_tried_text || !lacks_only_its_start(unstarted, checked.sizes.front())) return;
  std::int64_t budget = most_steps;
  int tried = 0;
  for (std::int64_t start = 2; start <= most_tried && tried < most_workings && budget > 0; ++start) {
    if (!unstarted.may_start_with(start, budget)) continue;
    ++tried;
    WorldWorker worker(lexicon, 0, 1);
    worker.stop_at_trouble();
    CheckedSize size = worker.run(text.lines, text.atoms, text.physical, start);
    if (size.verdict != PatternVerdict::holds || worker.ends() || worker.stitches_left() != start ||
        worker.rounds() < 1)
      continue;
    checked.rounds = worker.rounds();
    checked.sizes = {std::move(size)};
    checked.remark = "No stitches are cast on; it is worked on " + stitches_text(start) +
                     ", the fewest on which it comes out.";
    return;
  }
}

// What kind of text it is, from all of its lines.
struct Survey {
  std::size_t crochet = 0, knitting = 0;  // lines
  bool cast = false;                      // stitches are cast on
  std::vector<std::int64_t> sizes;        // of the first cast on that tells them
  std::size_t groups = 0;                 // lines that tell as many numbers

  [[nodiscard]] bool is_crochet() const { return crochet >= 2 && crochet > knitting; }
};

Survey survey_of(const std::vector<Atoms>& lines, const Lexicon& lexicon) {
  Survey survey;
  for (const Atoms& line : lines) {
    const bool crochet = crochet_words(line) > 0;
    const bool begins = casts_on(line);
    survey.crochet += crochet ? 1 : 0;
    survey.cast = survey.cast || begins;
    survey.knitting += begins || (!crochet && world_label(line, lexicon)) ? 1 : 0;
    const std::vector<std::int64_t> here = sizes_in(line);
    if (survey.sizes.empty() && begins) survey.sizes = here;
    if (!here.empty() && here.size() == survey.sizes.size()) ++survey.groups;
  }
  return survey;
}

// Each size that the cast on tells; the first alone where no other line tells them.
void work_sizes(CheckedPattern& checked, const Lexicon& lexicon, const Text& text, const Survey& survey) {
  const std::size_t told = survey.sizes.size();
  const bool only_first = told > 1 && survey.groups < 2;
  const std::size_t number = only_first ? 1 : std::min(told, most_sizes);
  for (std::size_t i = 0; i < number; ++i) {
    CheckedSize size = worked(lexicon, text, i, told, 0, checked);
    size.name = std::to_string(survey.sizes[i]);
    checked.sizes.push_back(std::move(size));
  }
  if (only_first)
    checked.remark =
        "Only the cast on tells sizes; the first one, " + std::to_string(survey.sizes[0]) + ", is worked.";
}

void refuse_crochet(CheckedSize& size) {
  size.verdict = PatternVerdict::not_understood;
  size.pieces.clear();
  for (CheckedLine& line : size.lines) {
    if (line.verdict == LineVerdict::no_instruction) continue;
    line = {line.number,
            LineVerdict::not_understood,
            std::nullopt,
            "line " + std::to_string(line.number) + ": this is crochet, and only knitting is worked here.",
            0,
            0};
  }
}

// Patterns of the world, worked on the counts of stitches.
CheckedPattern checked_world(const Text& text, const Lexicon& lexicon, std::size_t length) {
  const Survey survey = survey_of(text.atoms, lexicon);
  CheckedPattern checked;
  WorldWorker unstarted(lexicon, 0, 1);
  if (survey.sizes.empty()) {
    checked.sizes.push_back(unstarted.run(text.lines, text.atoms, text.physical, 0));
    checked.rounds = unstarted.rounds();
    if (survey.cast) checked.remark = unstarted.left_over();
  } else {
    work_sizes(checked, lexicon, text, survey);
  }
  if (survey.is_crochet()) {
    checked.remark = "This is crochet, and only knitting is worked here.";
    for (CheckedSize& size : checked.sizes) refuse_crochet(size);
  } else if (!survey.cast) {
    work_on_repeat(checked, lexicon, text, length, unstarted);
  }
  return checked;
}

}  // namespace

CheckedPattern check_pattern(std::string_view text) {
  const Lexicon lexicon;
  Text parted{pattern_lines(text), {}, physical_lines(text)};
  parted.atoms.reserve(parted.lines.size());
  for (const TextLine& line : parted.lines) parted.atoms.push_back(atoms_of(line.text));
  const bool pieces = has_limb_headings(text);
  const bool graph =
      pieces || std::any_of(parted.lines.begin(), parted.lines.end(), [](const TextLine& line) {
        return tells_short_row(line) || names_markers(line);
      });
  CheckedPattern checked =
      graph ? checked_graph(pieces ? as_pattern(read_limbs(text)) : read_pattern(text), parted, lexicon)
            : checked_world(parted, lexicon, text.size());
  set_verdict(checked);
  count_lines(checked, parted);
  if (!graph) checked.is_pattern = checked.rounds > 0 || checked.verdict != PatternVerdict::holds;
  return checked;
}

}  // namespace knit
