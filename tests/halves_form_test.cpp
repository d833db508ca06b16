// The short form of a piece whose halves are shaped apart: said in named rounds, and worked back to the same rounds.
#include <algorithm>
#include <string>

#include "knit/pattern/pattern_words.h"
#include "knit/pattern/rounds.h"
#include "knit/pattern/short_form.h"
#include "knit/pattern/written_pattern.h"
#include "knit/reader/checked_pattern.h"
#include "knit/reader/pattern_reader.h"
#include "knit/rhythm/joint_plan.h"
#include "knit/stitches/operations.h"
#include "knit/stitches/repeats.h"
#include "tests/support/belly.h"
#include "tests/support/catch.h"

using namespace knit;
using namespace test_support;

namespace {

Rounds rounds_of_plan(const RhythmPlan& plan) {
  Rounds rounds;
  rounds.cast_on = plan.counts.front();
  std::int32_t turn = 0;
  for (std::size_t row = 1; row < plan.counts.size(); ++row) {
    RepeatedRound round{plan.counts[row - 1], plan.counts[row], 4, RhythmStyle::pairs, turn};
    round.front_below = plan.fronts[row - 1];
    round.front_above = plan.fronts[row];
    turn += round.below == round.above ? 0 : 1;
    rounds.rounds.push_back(
        {static_cast<std::int32_t>(row) + 1, operations_of(plan_repeats(round)), round.below, round.above});
  }
  return rounds;
}

std::string short_text(const Rounds& rounds) {
  PatternOptions options;
  options.form = PatternForm::short_form;
  return pattern_as_text(write_pattern(rounds, {22.0, 32.0}, options, "belly"));
}

Rounds belly_rounds(double size) {
  const auto plan = plan_joint(belly_ideals(size), {CountPlanning::rhythm});
  REQUIRE(plan);
  return rounds_of_plan(*plan);
}

}  // namespace

TEST_CASE("a belly is told with markers at front and sides and read back to the same rounds") {
  for (const double size : {6.0, 9.0, 12.0}) {
    const Rounds rounds = belly_rounds(size);
    const auto form = short_form(rounds);
    REQUIRE(form);
    REQUIRE(form->marks.size() == 3);
    CHECK(form->named.size() <= most_ways_to_shape);
    const std::string text = short_text(rounds);
    CAPTURE(text);
    CHECK(text.find("Place markers (m) after ") != std::string::npos);
    CHECK(text.find(": side, front and side; the round begins at the back.") != std::string::npos);
    CHECK(text.find(" to front m, m1r, K1, m1l") != std::string::npos);
    const ReadPattern read = read_pattern(text);
    for (const auto& mistake : read.mistakes) {
      CAPTURE(mistake.sentence);
      CHECK(false);
    }
    CHECK(graph_of(read.rounds) == graph_of(rounds));
    std::size_t characters = 0;
    for (const RoundLine& line : round_lines(rounds, {})) characters += line.text().size();
    std::size_t told = 0;
    for (const NamedRound& named : form->named) told += named.text().size();
    for (const RoundLine& line : form->lines) told += line.text().size();
    CHECK(told < characters);
  }
}

TEST_CASE("the checker reads a piece told by halves, and finds a changed number in it") {
  const std::string text = short_text(belly_rounds(9.0));
  const CheckedPattern checked = check_pattern(text);
  for (const CheckedLine& line : checked.sizes.front().lines) CHECK(line.sentence.empty());
  CHECK(checked.verdict == PatternVerdict::holds);
  CHECK(checked.not_understood == 0);
  CHECK(checked.rounds == belly_rounds(9.0).rounds.size());
  std::string changed = text;
  const std::size_t at = changed.find(", m1r, K1, m1l");
  REQUIRE(at != std::string::npos);
  changed.replace(at, 5, "");
  CHECK(check_pattern(changed).verdict == PatternVerdict::does_not_add_up);
}

TEST_CASE("a marker that is set elsewhere or a named round that is changed is found out") {
  const std::string text = short_text(belly_rounds(12.0));
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    const std::size_t at = changed.find(from);
    REQUIRE(at != std::string::npos);
    return changed.replace(at, from.size(), to);
  };
  const Rounds rounds = belly_rounds(12.0);
  const auto same = [&](const std::string& changed) {
    const ReadPattern read = read_pattern(changed);
    return read.mistakes.empty() && graph_of(read.rounds) == graph_of(rounds);
  };
  CHECK(same(text));
  CHECK_FALSE(same(with(": side, front and side", ": front, side and side")));
  CHECK_FALSE(same(with(" to front m, m1r, K1, m1l", " to side m, m1r, K1, m1l")));
  CHECK_FALSE(same(with("Place markers (m) after ", "Place markers (m) after 9")));
}
