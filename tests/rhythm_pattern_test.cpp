// What a knitter is handed of a piece whose counts are in a rhythm: the pattern, its notes, and the report.
#include <algorithm>
#include <cmath>
#include <string_view>

#include "app/files/link.h"
#include "app/files/pattern_export.h"
#include "app/files/report.h"
#include "app/session/presets.h"
#include "app/session/remarks.h"
#include "knit/pattern/pattern_words.h"
#include "knit/pattern/rounds.h"
#include "knit/pattern/short_form.h"
#include "knit/quality/quality.h"
#include "knit/reader/limbs_reader.h"
#include "knit/reader/pattern_reader.h"
#include "tests/support/catch.h"
#include "tests/support/repeated.h"
#include "tests/support/session.h"

using namespace app;
using namespace test_support;

namespace {

// The example as the preset makes it, its stitches where they were placed.
Session by_hand(const std::string& example, knit::RhythmStyle style = knit::RhythmStyle::pairs) {
  Session session = example_session(example);
  knit::Parameters parameters = with_preset(*find_preset("hand"), session.document->timeline.parameters());
  parameters.settle.settling = knit::Settling::off;
  parameters.rhythm.style = style;
  apply(session, Tune{parameters});
  apply(session, ToLast{});
  REQUIRE(session.document->timeline.state().finished());
  return session;
}

std::string text_of_pattern(const Session& session) {
  return pattern_file_text(session, PatternFormat::text);
}

double wale_cv_of(const Session& session) {
  const knit::Timeline& timeline = session.document->timeline;
  const knit::StitchSize& stitch = timeline.parameters().stitch;
  return knit::measure_quality(timeline.input(), timeline.state(), stitch.width, stitch.height).wale.cv;
}

std::string short_text(const knit::Rounds& rounds) {
  knit::PatternOptions options;
  options.form = knit::PatternForm::short_form;
  return knit::pattern_as_text(knit::write_pattern(rounds, {22.0, 32.0}, options, "piece"));
}

bool is_one_repeat(const std::string& words, std::int32_t sections) {
  const std::string end = "] " + std::to_string(sections) + " times";
  return words.front() == '[' && words.ends_with(end) && std::count(words.begin(), words.end(), '[') == 1;
}

}  // namespace

TEST_CASE("round bodies of 12 cm: at most 16 lines, each shaping round one repeat, wales even") {
  std::size_t number = 0;
  for (const char* example : {"sphere", "egg", "vase", "capsule", "stretched-sphere", "cone"}) {
    for (const knit::RhythmStyle style : {knit::RhythmStyle::pairs, knit::RhythmStyle::lines}) {
      if (!test_support::is_tried(number++)) continue;
      CAPTURE(example, static_cast<int>(style));
      const Session session = by_hand(example, style);
      const knit::State& state = session.document->timeline.state();
      const knit::TubeRhythm* rhythm = rhythm_of_run(state);
      REQUIRE(rhythm != nullptr);
      CHECK(rhythm->plan.within);
      const knit::Rounds rounds = knit::rounds_of(state);
      for (const knit::RoundLine& line : knit::round_lines(rounds, {})) {
        CAPTURE(line.words);
        CHECK((line.words == "Knit" || is_one_repeat(line.words, rhythm->plan.sections)));
      }
      const auto form = knit::short_form(rounds, knit::stuffed_after(rounds));
      REQUIRE(form);
      CHECK(form->lines.size() + form->named.size() <= 16);
      const knit::ReadPattern read = knit::read_pattern(short_text(rounds));
      CHECK(read.mistakes.empty());
      CHECK(knit::graph_of(read.rounds) == knit::graph_of(state));
      if (style == knit::RhythmStyle::lines) CHECK(wale_cv_of(session) <= 0.07);
    }
  }
}

TEST_CASE("a pattern in a rhythm is short by itself, and written out where that is asked for") {
  Session session = by_hand("sphere");
  CHECK(text_of_pattern(session).find("\nInc rnd: ") != std::string::npos);
  CHECK(link_by_options(session)->find("--pattern-form") == std::string::npos);
  knit::PatternOptions options;
  options.form = knit::PatternForm::full;
  apply(session, SetPatternOptions{options});
  CHECK(text_of_pattern(session).find("\nInc rnd: ") == std::string::npos);
  CHECK(link_by_options(session)->find("--pattern-form full") != std::string::npos);
  apply(session, SetPatternOptions{});
  knit::Parameters whole = session.document->timeline.parameters();
  whole.rhythm.counts = knit::CountPlanning::whole;
  apply(session, Tune{whole});
  apply(session, ToLast{});
  CHECK(text_of_pattern(session).find("\nInc rnd: ") == std::string::npos);
  CHECK(report_json(session)["rhythm"].is_null());
}

TEST_CASE("report and notes say the rhythm, its cost and the width that it gives") {
  const Session session = by_hand("sphere");
  const auto rhythm = report_json(session)["rhythm"];
  CHECK(rhythm["first"] == 8);
  CHECK(rhythm["changes"] == 8);
  CHECK(rhythm["sections"] == 4);
  CHECK(rhythm["style"] == "pairs");
  REQUIRE(rhythm["segments"].size() == 5);
  CHECK(rhythm["segments"][3] ==
        nlohmann::ordered_json{{"kind", "change-first"}, {"rows", 3}, {"change", -8}, {"times", 3}});
  CHECK(std::abs(rhythm["seen"]["local"].get<double>() - 3.07) < 0.01);
  CHECK(rhythm["seen"]["rms"].get<double>() < 2.0);
  CHECK(rhythm["within"] == true);
  CHECK(rhythm["lines"] == 10);
  CHECK(rhythm["characters"]["short"].get<double>() < 0.5 * rhythm["characters"]["full"].get<double>());
  REQUIRE(rhythm["what"].size() == 3);
  const std::vector<std::string> notes = pattern_notes(session.document->timeline, nullptr);
  REQUIRE(notes.size() >= 3);
  for (std::size_t i = 0; i < 3; ++i) CHECK(rhythm["what"][i] == notes[i]);
}

TEST_CASE("the notes of a pattern in pieces say each rhythm once with all pieces that have it") {
  const std::string text = text_of_pattern(by_hand("trousers"));
  const auto at = text.find("- Rhythm of ");
  REQUIRE(at != std::string::npos);
  CHECK(text.substr(at).starts_with("- Rhythm of Limb A and Limb B: "));
  CHECK(text.find("Rhythm of Limb B") == std::string::npos);
  CHECK(text.find("Shaped in a rhythm") == std::string::npos);
  const knit::ReadLimbs read = knit::read_limbs(text);
  CHECK(read.mistakes.empty());
}

TEST_CASE("several counts in parentheses are explained where a line has them") {
  const std::string several = "Where several numbers stand there";
  Session session = by_hand("sphere");
  const auto has = [&](const std::string& words) {
    std::string text = text_of_pattern(session);
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text.find(words) != std::string::npos;
  };
  CHECK(has(several));
  knit::PatternOptions options;
  options.form = knit::PatternForm::full;
  apply(session, SetPatternOptions{options});
  CHECK_FALSE(has(several));
}

TEST_CASE("the report says the rhythm of each tube, as of a piece that is one") {
  const auto alone = report_json(by_hand("sphere"))["rhythm"];
  REQUIRE(alone["tubes"].size() == 1);
  CHECK(alone["tubes"][0]["name"] == "A");
  CHECK(alone["tubes"][0]["segments"] == alone["segments"]);
  const auto several = report_json(by_hand("y"))["rhythm"];
  REQUIRE(several["tubes"].size() == 3);
  CHECK_FALSE(several.contains("segments"));
  for (const auto& tube : several["tubes"]) {
    CAPTURE(tube.dump());
    CHECK(tube["none"].is_null());
    for (const char* key : {"from", "changes", "sections", "style", "segments", "seen", "within", "what"})
      CHECK(tube.contains(key));
    CHECK(tube["seen"]["local"].get<double>() >= 0.0);
  }
}

TEST_CASE("README shows the ball's pattern as it is written") {
  const std::string text = text_of_pattern(by_hand("sphere"));
  const std::size_t begin = text.find("INSTRUCTIONS\n");
  const std::size_t end = text.find("\n\nCHART\n");
  REQUIRE(begin < end);
  REQUIRE(end != std::string::npos);
  const std::string readme = read_text(std::string(KNIT_SOURCE_DIR) + "/README.md");
  CHECK(readme.find("\n" + text.substr(begin, end - begin) + "\n```\n") != std::string::npos);
}

TEST_CASE("a rhythm is told where short rows stand between its rounds") {
  Session session = by_hand("heel");
  apply(session, ToLast{});
  REQUIRE(session.document->timeline.state().finished());
  const nlohmann::ordered_json report = report_json(session);
  CHECK(report["short_rows"]["pairs"].get<int>() > 0);
  CHECK_FALSE(report["rhythm"].is_null());
  CHECK(rhythm_of_run(session.document->timeline.state()) != nullptr);
}

TEST_CASE("a rhythm that is given up on the way is none") {
  Session session = by_hand("sphere");
  apply(session, SeekPlace{{knit::Stage::rows, 12, 0}});
  knit::Parameters whole = session.document->timeline.parameters();
  whole.rhythm.counts = knit::CountPlanning::whole;
  apply(session, EditFromHere{whole});
  apply(session, ToLast{});
  REQUIRE(session.document->timeline.state().finished());
  CHECK(rhythm_of_run(session.document->timeline.state()) == nullptr);
  CHECK(report_json(session)["rhythm"].is_null());
}
