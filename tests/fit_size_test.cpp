// The finished size fitted to the rhythm: the size alone, the settings, and a whole run.
#include "app/explain/fit_size.h"

#include <algorithm>
#include <cmath>

#include "app/script/command_line.h"
#include "app/session/presets.h"
#include "app/session/remarks.h"
#include "knit/model/stitch_size.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace app;
using namespace test_support;

namespace {

Session by_hand(const std::string& example, knit::RhythmStyle style = knit::RhythmStyle::lines) {
  Session session = example_session(example);
  knit::Parameters parameters = with_preset(*find_preset("hand"), session.document->timeline.parameters());
  parameters.settle.settling = knit::Settling::off;
  parameters.rhythm.style = style;
  apply(session, Tune{parameters});
  apply(session, ToLast{});
  return session;
}

std::vector<double> ideals_of(const Session& session) {
  const knit::Timeline& timeline = session.document->timeline;
  std::vector<double> ideals;
  for (const double length : timeline.furthest().tubes->tubes.front().lengths)
    ideals.push_back(length / timeline.parameters().stitch.width);
  return ideals;
}

std::string why_none(const Session& session) {
  const auto fitted = fitted_size(session.document->timeline);
  return std::holds_alternative<std::string>(fitted) ? std::get<std::string>(fitted) : "";
}

}  // namespace

TEST_CASE("a size is taken at which the widest row has just what it holds and the rhythm reads better") {
  const Session session = by_hand("egg");
  const std::vector<double> ideals = ideals_of(session);
  const double belt = *std::max_element(ideals.begin(), ideals.end());
  const auto fit = knit::fit_size(ideals, session.document->timeline.parameters().rhythm);
  REQUIRE(fit);
  CHECK(fit->asked.size == 1.0);
  CHECK(std::abs(fit->fitted.size - 1.0) > 0.004);
  CHECK(std::abs(fit->fitted.size - 1.0) <= 0.04);
  const double room = fit->fitted.size * belt / fit->fitted.sections;
  CHECK(std::abs(room - std::round(room)) < 1e-9);
  CHECK(fit->fitted.score < fit->asked.score);
  CHECK(fit->fitted.within);
}

TEST_CASE("a size that reads best already is left as it is") {
  const Session session = by_hand("sphere");
  CHECK_FALSE(knit::fit_size(ideals_of(session), session.document->timeline.parameters().rhythm));
  const auto fitted = fitted_size(session.document->timeline);
  REQUIRE(std::holds_alternative<FittedSize>(fitted));
  CHECK(std::get<FittedSize>(fitted).parameters == session.document->timeline.parameters());
  CHECK(std::get<FittedSize>(fitted).words.starts_with("No other size"));
}

TEST_CASE("a piece made larger is higher by its gauge and of smaller stitches by its mesh") {
  knit::Parameters p;
  knit::give_gauge(p, {20.0, 30.0});
  p.size.height_cm = 12.0;
  knit::give_size(p, 1.025);
  CHECK(p.size.height_cm == 12.3);
  CHECK(p.stitch.gauge == knit::Gauge{20.0, 30.0});
  knit::Parameters follows;
  knit::give_width(follows, 0.2);
  knit::give_size(follows, 1.25);
  CHECK(std::abs(follows.stitch.width - 0.16) < 1e-12);
  CHECK(follows.stitch.height_follows);
  knit::Parameters own = follows;
  knit::give_height(own, 0.1);
  knit::give_size(own, 1.25);
  CHECK(std::abs(own.stitch.height - 0.08) < 1e-12);
  CHECK_FALSE(own.stitch.height_follows);
}

TEST_CASE("the egg of 12 cm becomes a little higher, in a shorter pattern, and nothing else is changed") {
  Session session = by_hand("egg");
  const knit::Parameters asked = session.document->timeline.parameters();
  const auto fitted = fitted_size(session.document->timeline);
  REQUIRE(std::holds_alternative<FittedSize>(fitted));
  const FittedSize& fit = std::get<FittedSize>(fitted);
  CHECK(
      fit.words.starts_with("Fitted: 12 cm asked, 12.11 cm taken. The widest row has room for 63 stitches"));
  knit::Parameters back = fit.parameters;
  back.size.height_cm = asked.size.height_cm;
  CHECK(back == asked);
  const double score = rhythm_of_run(session.document->timeline.state())->plan.score;
  apply(session, Tune{fit.parameters});
  apply(session, ToLast{});
  const knit::TubeRhythm* rhythm = rhythm_of_run(session.document->timeline.state());
  REQUIRE(rhythm != nullptr);
  CHECK(rhythm->plan.within);
  CHECK(rhythm->plan.score < score);
  CHECK(rhythm_sentences_of(session.document->timeline.state(), asked.stitch.gauge)
            .back()
            .ends_with("just as the shape has it."));
}

TEST_CASE("what cannot be fitted says why and what to do") {
  Session session = by_hand("egg");
  const knit::Parameters parameters = session.document->timeline.parameters();
  knit::Parameters whole = parameters;
  whole.rhythm.counts = knit::CountPlanning::whole;
  apply(session, Tune{whole});
  CHECK(why_none(session).find("--counts rhythm") != std::string::npos);
  knit::Parameters cast_on = parameters;
  cast_on.rows.cast_on = 8;
  apply(session, Tune{cast_on});
  CHECK(why_none(session).find("--cast-on auto") != std::string::npos);
  apply(session, Tune{parameters});
  apply(session, ToLast{});
  apply(session, SeekPlace{{knit::Stage::rows, 12, 0}});
  knit::Parameters wider = parameters;
  wider.rhythm.tolerance = 6.0;
  apply(session, EditFromHere{wider});
  CHECK(why_none(session).find("on the way") != std::string::npos);
  CHECK(why_none(by_hand("y")).find("this one has 3") != std::string::npos);
}

TEST_CASE("the command line asks for the size to be fitted") {
  const auto line =
      parse_command_line({"--example", "egg", "--preset", "hand", "--fit-size", "on"}, KNIT_ASSETS_DIR);
  REQUIRE(std::holds_alternative<CommandLine>(line));
  CHECK(std::get<CommandLine>(line).fit_size);
  const auto other = parse_command_line({"--example", "egg", "--fit-size", "maybe"}, KNIT_ASSETS_DIR);
  REQUIRE(std::holds_alternative<Answer>(other));
  CHECK(std::get<Answer>(other).error.find("give on or off") != std::string::npos);
}
