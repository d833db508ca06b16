// A knob that teaches: its sweep on demand, the mark where problems end, and no control that moves.
#include "app/panels/parameters/knob_curve.h"

#include "app/compare/sweep_work.h"
#include "tests/support/desk.h"

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
  const auto quiet = quiet_stretch(work, cache);
  REQUIRE(quiet);
  const auto& values = work.first_values();
  const auto problems_at = [&](double value) {
    const auto i = static_cast<std::size_t>(std::find(values.begin(), values.end(), value) - values.begin());
    return work.run(i)->figures.problems;
  };
  std::size_t longest = 0;
  std::size_t length = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const SweepRun& run = *work.run(i);
    length = run.refused.empty() && run.figures.finished && run.figures.problems == 0 ? length + 1 : 0;
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
  CHECK(words_of(QuietStretch{0.01940001, 0.09, false, true}) == "No problem from 0.0194 on.");
  CHECK(words_of(QuietStretch{0.01, 0.05, true, false}) == "No problem up to 0.05.");
  CHECK(words_of(QuietStretch{0.02, 0.05, false, false}) == "No problem from 0.02 to 0.05.");
}
