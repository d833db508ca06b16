// The sides Compare and Sweep of the right column, without a window.
#include "app/panels/compare/compare_cache.h"
#include "tests/support/desk.h"

#include "app/panels/compare/sweep_plot.h"
#include "app/panels/kit/widgets.h"
#include "app/session/document.h"
#include "app/session/outbox.h"
#include "app/session/view.h"
#include "knit/model/settings_table.h"
#include "knit/model/stitch_size.h"

using namespace desk;

namespace {

void tune_epsilon(Desk& desk, double epsilon) {
  knit::Parameters parameters = desk.session.document->timeline.parameters();
  knit::give_epsilon(parameters, epsilon);
  apply(desk.session, Tune{parameters});
  desk.session.document->timeline.extend_to_end();
}

bool shows(const Desk& desk, const std::string& control) { return desk.ui.controls.count(control) == 1; }

}  // namespace

TEST_CASE("compare side: pin, see what differs, swap, unpin", "[panels]") {
  Desk desk(1280, 720);
  desk.session.view->side = SidePanel::compare;
  desk.settle();
  desk.open();
  desk.act({only<PinRun>(desk.click("compare/pin"))});
  tune_epsilon(desk, 0.1);
  desk.settle();
  CHECK(shows(desk, "compare/setting/epsilon"));
  CHECK(shows(desk, "compare/figure/course-cv"));
  CHECK(shows(desk, "compare/stitches"));
  CHECK(count_of<SeekPlace>(desk.click("compare/first-row")) == 1);
  CHECK(count_of<SeekPlace>(desk.click("compare/stitches")) == 1);
  const std::size_t times = desk.ui.own<CompareCache>().times_compared();
  desk.settle();
  CHECK(desk.ui.own<CompareCache>().times_compared() == times);
  desk.act({only<SwapPinned>(desk.click("compare/swap"))});
  CHECK(desk.session.document->timeline.parameters().epsilon() == wide_band().epsilon());
  desk.session.document->timeline.extend_to_end();
  desk.settle();
  CHECK(desk.ui.own<CompareCache>().times_compared() == times + 1);
  desk.act({only<Unpin>(desk.click("compare/unpin"))});
  desk.settle();
  CHECK(shows(desk, "compare/pin"));
  CHECK_FALSE(shows(desk, "compare/swap"));
}

TEST_CASE("compare side: where the run stops now, the ways on stand there, and the pinned run stays",
          "[panels]") {
  Desk desk(1280, 720);
  desk.open();
  apply(desk.session, PinRun{});
  knit::Parameters parameters = desk.session.document->timeline.parameters();
  knit::give_epsilon(parameters, 0.01);
  parameters.rows.on_stall = knit::OnStall::stop;
  apply(desk.session, Tune{parameters});
  desk.session.document->timeline.extend_to_end();
  REQUIRE(desk.session.document->timeline.stop() != nullptr);
  apply(desk.session, ToFirst{});  // where no card of the stop is in sight
  desk.session.view->side = SidePanel::compare;
  desk.settle();
  REQUIRE(shows(desk, "compare/words"));
  std::string way;
  for (const auto& [name, box] : desk.ui.controls)
    if (name.rfind("compare/", 0) == 0 && box.width > 0.0f && way.empty() && name == "compare/contours")
      way = name;
  REQUIRE_FALSE(way.empty());
  desk.act({only<Tune>(desk.click(way))});
  CHECK(desk.session.document->pinned);
  CHECK(desk.session.document->timeline.parameters().rows.source == knit::RowSource::contours);
}

TEST_CASE("sweep side: start, point, take", "[panels]") {
  Desk desk(1280, 720);
  desk.session.view->side = SidePanel::sweep;
  desk.settle();
  desk.open();
  CHECK(desk.ui.own<SweepForm>().axis.key == "epsilon");
  CHECK_FALSE(shows(desk, "sweep/problems"));
  desk.ui.own<SweepForm>().axis = {"epsilon", 0.05, 0.25, 5};
  desk.act({only<StartSweep>(desk.click("sweep/start"))});
  REQUIRE(desk.session.document->sweep);
  desk.settle();
  for (const char* plot : {"sweep/problems", "sweep/stitches", "sweep/course-cv"}) {
    CAPTURE(plot);
    CHECK(shows(desk, plot));
  }
  const auto taken = only<TakeSweepValue>(desk.click("sweep/stitches", 0.97f));
  CHECK(taken.run == 4);
  desk.act({taken});
  CHECK(desk.session.document->timeline.parameters().epsilon() == 0.25);
}

TEST_CASE("sweep side: the form shows the plan of a sweep that a script began", "[panels]") {
  Desk desk(1280, 720);
  desk.session.view->side = SidePanel::sweep;
  desk.open();
  desk.act({StartSweep{{{"epsilon", 0.06, 0.2, 4}, SweepAxis{"stitch-width", 0.4, 0.6, 3}}}});
  desk.settle();
  CHECK(desk.ui.own<SweepForm>().axis == SweepAxis{"epsilon", 0.06, 0.2, 4});
  CHECK(desk.ui.own<SweepForm>().grid);
  CHECK(desk.ui.own<SweepForm>().second == SweepAxis{"stitch-width", 0.4, 0.6, 3});
  desk.ui.own<SweepForm>().axis.to = 0.1;  // a hand may change it afterwards
  desk.settle();
  CHECK(desk.ui.own<SweepForm>().axis.to == 0.1);
}

TEST_CASE("sweep side: two parameters make a map", "[panels]") {
  Desk desk(1280, 720);
  desk.session.view->side = SidePanel::sweep;
  desk.open();
  desk.click("sweep/grid");
  desk.settle();
  REQUIRE(desk.ui.own<SweepForm>().grid);
  CHECK(desk.ui.own<SweepForm>().second.key == "stitch-width");
  desk.ui.own<SweepForm>().axis = {"epsilon", 0.05, 0.25, 4};
  desk.ui.own<SweepForm>().second = {"stitch-width", 0.3, 0.5, 3};
  desk.act({only<StartSweep>(desk.click("sweep/start"))});
  desk.settle();
  REQUIRE(shows(desk, "sweep/map"));
  const auto taken = only<TakeSweepValue>(desk.click("sweep/map", 0.97f));
  CHECK(taken.run == 10);  // the last column, the middle row
  desk.act({taken});
  CHECK(desk.session.document->timeline.parameters().epsilon() == 0.25);
  CHECK(desk.session.document->timeline.parameters().stitch.width == 0.4);
}

TEST_CASE("sweep side: the usual range of every parameter can be swept, one that cannot is told",
          "[panels]") {
  for (const knit::ParameterInfo& info : knit::parameter_table()) {
    if (!can_be_swept(info)) continue;
    CAPTURE(info.key);
    const SweepAxis axis = usual_axis(info, wide_band(), 200);
    CHECK_FALSE(fault_of(SweepPlan{axis, std::nullopt}));
    const auto value = present_value(info, wide_band());
    CHECK((value || info.key == "rhythm-simplicity"));  // what auto stands for there only a run says
    if (!value) continue;
    CHECK(axis.from <= *value);
    CHECK(axis.to >= *value);
  }
  Desk desk(1280, 720);
  desk.session.view->side = SidePanel::sweep;
  desk.open();
  desk.ui.own<SweepForm>().axis.from = 9.0;
  CHECK(desk.click("sweep/start").empty());
}

TEST_CASE("sweep side: a parameter that nothing reads now is not kept in the form", "[panels]") {
  Desk desk(1280, 720);
  desk.session.view->side = SidePanel::sweep;
  desk.open();
  CHECK(desk.ui.own<SweepForm>().axis.key == "epsilon");
  knit::Parameters parameters = desk.session.document->timeline.parameters();
  parameters.rows.source = knit::RowSource::contours;
  apply(desk.session, Tune{parameters});
  desk.settle();
  CHECK(desk.ui.own<SweepForm>().axis.key == "stitch-width");
  CHECK_FALSE(fault_of(SweepPlan{desk.ui.own<SweepForm>().axis, std::nullopt}));
}

TEST_CASE("P lets a pinned run go and says so, one of another mesh gives way to the run that is shown",
          "[panels]") {
  Desk desk;
  desk.open();
  const Chord pin{Key::P, {}, 0};
  desk.act({only<PinRun>(desk.press(pin))});
  CHECK(desk.session.outbox->notices.empty());
  desk.act({only<Unpin>(desk.press(pin))});
  CHECK_FALSE(desk.session.document->pinned);
  REQUIRE(desk.session.outbox->notices.size() == 1);
  CHECK(desk.session.outbox->notices[0].text.starts_with("The pinned run is let go."));
  desk.act({PinRun{}});
  knit::Timeline other(knit::make_input(knit::sphere(12, 7, false)), wide_band());
  other.extend_to_end();
  desk.session.document->timeline = other;
  desk.settle();
  desk.act({only<PinRun>(desk.press(pin))});
  REQUIRE(desk.session.document->pinned);
  CHECK(desk.session.document->pinned->input == other.input_pointer());
  CHECK(
      desk.session.outbox->notices.back().text.starts_with("This run is pinned now, instead of the one of "));
}

TEST_CASE("a list that hangs open is closed by Esc alone, and by Ctrl+Z, which is heard", "[panels]") {
  Desk desk(1280, 720);
  desk.session.view->side = SidePanel::sweep;
  desk.open();
  const auto hangs = [&] {
    desk.settle();
    return desk.ui.own<HangingList>().open;
  };
  desk.session.outbox->notices = {{Notice::Kind::info, "Saved."}};
  for (const Chord& key : {Chord{Key::Escape, {}, 0}, Chord{Key::Z, {.ctrl = true}, 0}}) {
    CHECK_FALSE(hangs());
    desk.click("sweep/parameter");
    REQUIRE(hangs());
    CHECK(count_of<Undo>(desk.press(key)) == (key.key == Key::Z ? 1 : 0));
    CHECK_FALSE(hangs());
    desk.press({Key::LeftCtrl, {}, 0});
  }
  CHECK(desk.session.outbox->notices.size() == 1);
}

TEST_CASE("sweep side: the first plot counts all problems or one kind, and says where there is none",
          "[panels]") {
  Desk desk(1280, 960);
  desk.session.view->side = SidePanel::sweep;
  desk.settle();
  desk.open();
  desk.act({StartSweep{{{"epsilon", 0.01, 0.25, 25}, std::nullopt}}});
  desk.settle();
  CHECK(shows(desk, "sweep/problems"));
  desk.click("sweep/problem-figure");
  desk.settle();
  CHECK_FALSE(shows(desk, "sweep/problem-figure/Rows"));
  desk.click("sweep/problem-figure/Stalls");
  desk.settle();
  CHECK(shows(desk, "sweep/stalls"));
  CHECK_FALSE(shows(desk, "sweep/problems"));
  const SweepWork& work = *desk.session.document->sweep->work;
  const auto stalls = [&](std::size_t i) {
    return work.run(i)->figures.problems.of(knit::ProblemKind::band_missed);
  };
  std::size_t first = work.total();
  while (first > 0 && stalls(first - 1) == 0) --first;
  REQUIRE(first > 0);
  REQUIRE(first < work.total());
  const auto quiet = quiet_stretch(work, desk.ui.own<SweepCache>(), SweepFigure::stalls);
  REQUIRE(quiet);
  // Narrowed down beyond the values that were asked for.
  CHECK(quiet->from <= work.first_values()[first]);
  CHECK(quiet->from > work.first_values()[first - 1]);
  CHECK(quiet->to_last);
  CHECK(words_of(*quiet, SweepFigure::stalls).starts_with("No stall from "));
}

TEST_CASE("compare side: every figure has a tip that says what it is", "[panels]") {
  Desk desk(1280, 1080);
  desk.open();
  desk.act({PinRun{}});
  tune_epsilon(desk, 0.01);  // with stalls
  desk.session.view->side = SidePanel::compare;
  desk.settle();
  const auto marks = desk.ui.controls;
  std::size_t figures = 0;
  for (const auto& [name, box] : marks) {
    if (name.rfind("compare/figure/", 0) != 0) continue;
    INFO(name);
    desk.frames({desk.over(name), desk.over(name)});
    CHECK(desk.ui.controls.count("tip") == 1);
    ++figures;
  }
  CHECK(figures >= 9);
  CHECK(marks.count("compare/figure/stalls") == 1);
}
