// A knob that teaches: its sweep on demand, the mark where problems end, and no control that moves.
#include "app/panels/parameters/knob_curve.h"

#include "app/compare/sweep_work.h"
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
  const auto problems_at = [&](double value) {
    const auto i = static_cast<std::size_t>(std::find(values.begin(), values.end(), value) - values.begin());
    return work.run(i)->figures.problems.total();
  };
  std::size_t longest = 0;
  std::size_t length = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const SweepRun& run = *work.run(i);
    length =
        run.refused.empty() && run.figures.finished && run.figures.problems.total() == 0 ? length + 1 : 0;
    longest = std::max(longest, length);
  }
  const auto first = std::find(values.begin(), values.end(), quiet->from);
  const auto last = std::find(values.begin(), values.end(), quiet->to);
  CHECK(static_cast<std::size_t>(last - first) + 1 == longest);
  CHECK(problems_at(quiet->from) == 0);
  CHECK(problems_at(quiet->to) == 0);

  REQUIRE_FALSE((quiet->from_first && quiet->to_last));
  const double marked = quiet->from_first ? quiet->to : quiet->from;
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
  CHECK(words_of(*stalls, SweepFigure::stalls) == "No stall from 0.02 on, at 0.015 not yet.");
  CHECK(words_of(*problems, SweepFigure::problems) == "No problem from 0.035 on, at 0.03 not yet.");
  CHECK(only<Tune>(desk.click("curve-mark/epsilon")).parameters.epsilon() == problems->from);
  CHECK(only<Tune>(desk.click("curve-mark/epsilon/stalls")).parameters.epsilon() == stalls->from);
}
