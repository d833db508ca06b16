// The pattern reader: any text is read to its end, and what reads without a mistake is written and read again.
#include "knit/model/stitch_size.h"
#include "knit/pattern/rounds.h"
#include "knit/pattern/written_pattern.h"
#include "knit/reader/pattern_reader.h"
#include "tests/fuzz/bytes.h"

namespace {

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

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const knit::ReadPattern read = knit::read_pattern(fuzz::text_of(data, size));
  for (const knit::PatternMistake& mistake : read.mistakes) fuzz::promise_sentence(mistake.sentence);
  promise_counts(read);
  // Rows of fewer than three stitches are no rounds of ours; more than some hundreds would only be slow.
  bool ours = read.mistakes.empty() && read.rounds.cast_on >= 3 && !read.rounds.rounds.empty();
  for (const knit::Round& round : read.rounds.rounds) ours = ours && round.after >= 3;
  if (ours && read.stitches <= 1000) promise_the_same_again(read.rounds, size % 2 == 1);
  return 0;
}
