// A knob that teaches: its sweep on demand, the mark where problems end, and no control that moves.
#include "app/panels/parameters/knob_curve.h"

#include "app/compare/sweep_work.h"
#include "app/panels/kit/number_field.h"
#include "tests/support/desk.h"
#include "tests/support/session.h"

using namespace desk;

TEST_CASE("the button of a knob sweeps it, and a click on the mark takes the first value without a problem") {
  Desk desk(1280, 1400);
  desk.open();
  const auto before = desk.ui.controls;
  CHECK(before.count("curve-mark/epsilon") == 0);
  const Actions asked = desk.click("curve/epsilon");
  CHECK(only<StartSweep>(asked).plan.axis.key == "epsilon");
  desk.act(asked);
  desk.settle();
  const SweepWork& work = *desk.session.document->sweep->work;
  REQUIRE(work.done() == work.total());

  SweepCache cache;
  cache.refresh(desk.session.document->sweep->work);
  const auto quiet = quiet_stretch(work, cache, SweepFigure::problems);
  REQUIRE(quiet);
  const auto& values = work.first_values();
  std::vector<bool> answers;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const SweepRun& run = *work.run(i);
    answers.push_back(run.refused.empty() && run.figures.finished && run.figures.problems.total() == 0);
  }
  const auto coarse = longest_quiet(values, answers);
  REQUIRE(coarse);
  CHECK(quiet->from <= coarse->from);
  CHECK(quiet->to >= coarse->to);
  CHECK(quiet->to_last == coarse->to_last);

  REQUIRE_FALSE((quiet->from_first && quiet->to_last));
  const double marked = quiet->from_first ? quiet->to : quiet->from;
  CHECK(shown_number(marked) == knit::number_text(marked));
  CHECK(only<Tune>(desk.click("curve-mark/epsilon")).parameters.epsilon() == marked);
  for (const auto& [name, box] : before) {
    if (!name.starts_with("knob/") && !name.starts_with("curve/")) continue;
    CAPTURE(name);
    CHECK(desk.ui.controls.at(name) == box);
  }
}

TEST_CASE("what is said of the values without a problem") {
  CHECK(words_of(QuietStretch{0.01940001, 0.09, false, true}, SweepFigure::problems) ==
        "No problem from 0.0194 on.");
  CHECK(words_of(QuietStretch{0.01, 0.05, true, false}, SweepFigure::problems) == "No problem up to 0.05.");
  CHECK(words_of(QuietStretch{0.02, 0.05, false, false}, SweepFigure::problems) ==
        "No problem from 0.02 to 0.05.");
  CHECK(words_of(QuietStretch{0.02, 0.05, false, true, 0.01}, SweepFigure::stalls) ==
        "No stall from 0.02 on, at 0.01 not yet.");
}

TEST_CASE("where stalls end has a mark and a sentence of its own, if that is elsewhere") {
  Desk desk(1280, 1400);
  desk.session.document = test_support::example_session("thesis-sphere").document;
  apply(desk.session, StartSweep{{{"epsilon", 0.015, 0.05, 8}, std::nullopt}});
  desk.settle();
  SweepCache cache;
  cache.refresh(desk.session.document->sweep->work);
  const SweepWork& work = *desk.session.document->sweep->work;
  const auto stalls = quiet_stretch(work, cache, SweepFigure::stalls);
  const auto problems = quiet_stretch(work, cache, SweepFigure::problems);
  REQUIRE((stalls && problems));
  CHECK(words_of(*stalls, SweepFigure::stalls) == "No stall from 0.019237 on, at 0.019236 not yet.");
  CHECK(words_of(*problems, SweepFigure::problems) == "No problem from 0.031675 on, at 0.031674 not yet.");
  CHECK(only<Tune>(desk.click("curve-mark/epsilon")).parameters.epsilon() == problems->from);
  CHECK(only<Tune>(desk.click("curve-mark/epsilon/stalls")).parameters.epsilon() == stalls->from);
}

TEST_CASE("stitch width and height have their curves too with values of their own") {
  for (const char* key : {"epsilon", "stitch-width", "stitch-height"}) {
    INFO(key);
    Desk desk(1280, 1400);
    desk.open();
    const Actions asked = desk.click("curve/" + std::string(key));
    const SweepPlan& plan = only<StartSweep>(asked).plan;
    CHECK(plan.axis.key == key);
    CHECK(plan.axis.count == 96);
    CHECK_FALSE(plan.second);
    apply(desk.session, StartSweep{{{key, plan.axis.from, plan.axis.to, 4}, std::nullopt}});
    desk.settle();
    SweepCache cache;
    cache.refresh(desk.session.document->sweep->work);
    for (const SweepFigure figure : {SweepFigure::problems, SweepFigure::stitches, SweepFigure::course_cv})
      CHECK(cache.of(figure).size() == 4);
    desk.frames({desk.over("knob/" + std::string(key)), desk.over("knob/" + std::string(key))});
    CHECK(desk.ui.controls.count("tip") == 1);
  }
}
