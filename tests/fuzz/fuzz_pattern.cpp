// The pattern reader and the checker: any text is read to its end, what is told of it agrees with itself, and what reads without
// a mistake is written and read again.
#include <algorithm>

#include "knit/model/stitch_size.h"
#include "knit/pattern/rounds.h"
#include "knit/pattern/written_pattern.h"
#include "knit/reader/checked_pattern.h"
#include "knit/reader/pattern_reader.h"
#include "tests/fuzz/bytes.h"

namespace {

using knit::LineVerdict;
using knit::PatternVerdict;

// Does not add up before not understood before holds.
int weight(PatternVerdict verdict) {
  return verdict == PatternVerdict::does_not_add_up ? 2 : verdict == PatternVerdict::not_understood ? 1 : 0;
}

void promise_size(const knit::CheckedSize& size, std::size_t lines) {
  fuzz::promise(size.lines.size() == lines, "every line of the text has its verdict, and no other");
  bool is_wrong = false, is_unknown = false;
  std::size_t number = 0;
  for (const knit::CheckedLine& line : size.lines) {
    fuzz::promise(line.number == ++number, "lines are told in their order");
    const bool does_not_add_up = line.verdict == LineVerdict::does_not_add_up;
    const bool not_understood = line.verdict == LineVerdict::not_understood;
    is_wrong = is_wrong || does_not_add_up;
    is_unknown = is_unknown || not_understood || line.verdict == LineVerdict::not_claimed;
    if (does_not_add_up || not_understood) fuzz::promise_sentence(line.sentence);
    fuzz::promise(!line.stitches || *line.stitches >= 0, "no needle holds fewer than no stitches");
  }
  fuzz::promise((size.verdict == PatternVerdict::does_not_add_up) == is_wrong,
                "a size does not add up if a line does not");
  fuzz::promise(size.verdict != PatternVerdict::holds || !is_unknown, "what is not understood does not hold");
  for (const knit::CheckedPiece& piece : size.pieces) {
    fuzz::promise(piece.made >= 1, "a piece is made once at least");
    for (const knit::CheckedRound& round : piece.rounds)
      fuzz::promise(round.stitches >= 0 && round.line >= 1 && round.line <= lines,
                    "a round stands in a line");
  }
}

void promise_checked(const std::string& text) {
  const knit::CheckedPattern checked = knit::check_pattern(text);
  fuzz::promise(!checked.sizes.empty(), "a pattern has a size");
  const std::size_t lines = checked.sizes.front().lines.size();
  const auto breaks = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  // Of which the last may be empty. A line may end in other signs too.
  const bool is_plain = text.find('\r') == std::string::npos;
  fuzz::promise(!is_plain || lines == breaks || lines == breaks + 1, "every line of the text has a verdict");
  PatternVerdict worst = PatternVerdict::holds;
  for (const knit::CheckedSize& size : checked.sizes) {
    promise_size(size, lines);
    if (weight(size.verdict) > weight(worst)) worst = size.verdict;
  }
  fuzz::promise(checked.verdict == worst, "the verdict of the whole is the worst of its sizes");
  fuzz::promise(checked.verdict != PatternVerdict::holds || checked.not_understood == 0,
                "what holds was all understood");
}

void promise_counts(const knit::ReadPattern& read) {
  std::int32_t there = read.rounds.cast_on;
  for (const knit::Round& round : read.rounds.rounds) {
    std::int32_t taken = 0, made = 0;
    for (const knit::Operation& operation : round.operations) {
      taken += knit::consumed_by(operation.hand);
      made += knit::made_by(operation.hand);
    }
    fuzz::promise(round.before == there && taken == there && made == round.after, "a round adds up");
    there = round.after;
  }
}

// One way of writing a run: either comes often enough.
void promise_the_same_again(const knit::Rounds& rounds, bool stars) {
  knit::PatternOptions options;
  options.stars = options.markers = stars;
  const auto written = knit::write_pattern(rounds, {22.0, 32.0}, options, "piece");
  const knit::ReadPattern again = knit::read_pattern(knit::pattern_as_text(written));
  fuzz::promise(again.mistakes.empty(),
                again.mistakes.empty() ? "" : "what was written reads: " + again.mistakes.front().sentence);
  fuzz::promise(knit::graph_of(again.rounds) == knit::graph_of(rounds),
                "what was written reads back the same");
}

void promise_read(const std::string& text) {
  const knit::ReadPattern read = knit::read_pattern(text);
  for (const knit::PatternMistake& mistake : read.mistakes) fuzz::promise_sentence(mistake.sentence);
  promise_counts(read);
  // Rows of fewer than three stitches are no rounds of ours; more than some hundreds would only be slow.
  bool ours = read.mistakes.empty() && read.rounds.cast_on >= 3 && !read.rounds.rounds.empty();
  for (const knit::Round& round : read.rounds.rounds) ours = ours && round.after >= 3;
  if (ours && read.stitches <= 1000) promise_the_same_again(read.rounds, text.size() % 2 == 1);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = fuzz::text_of(data, size);
  promise_checked(text);
  // Every second text, by its length: the checker reads our own form with the same reader.
  if (size % 2 == 1) promise_read(text);
  return 0;
}
