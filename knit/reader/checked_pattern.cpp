#include "knit/reader/checked_pattern.h"

#include "knit/reader/pattern_reader.h"
#include "knit/reader/reader_text.h"

namespace knit {

CheckedPattern check_pattern(std::string_view text) {
  const ReadPattern read = read_pattern(text);
  CheckedPattern checked;
  CheckedSize& size = checked.sizes.emplace_back();
  for (const TextLine& line : pattern_lines(text)) {
    CheckedLine& told = size.lines.emplace_back();
    told.number = line.number;
    for (const PatternMistake& mistake : read.mistakes) {
      if (mistake.line != line.number) continue;
      told.verdict = LineVerdict::does_not_add_up;
      told.sentence = mistake.sentence;
    }
  }
  if (!read.mistakes.empty()) size.verdict = checked.verdict = PatternVerdict::does_not_add_up;
  checked.rounds = checked.worked = read.rounds_read;
  CheckedPiece& piece = size.pieces.emplace_back();
  piece.rounds.push_back({1, read.rounds.cast_on});
  for (const Round& round : read.rounds.rounds) piece.rounds.push_back({1, round.after});
  checked.is_pattern = read.rounds_read > 0 || !read.mistakes.empty();
  return checked;
}

}  // namespace knit
