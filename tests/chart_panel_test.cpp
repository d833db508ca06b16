// The chart in the centre and the round at hand over it: keys, pointer, and what they wish.
#include "app/panels/pattern/chart_bands.h"
#include "app/panels/pattern/chart_cache.h"
#include "app/panels/pattern/pattern_parts.h"
#include "app/session/document.h"
#include "app/session/view.h"
#include "tests/support/desk.h"

using namespace desk;

namespace {

// A desk with a finished run and the chart in its centre.
void show_chart(Desk& desk) {
  desk.open();
  desk.act({ShowCentre{CentrePanel::chart}});
  desk.settle();
}

}  // namespace

TEST_CASE("T shows the chart and the view again, K the round at hand") {
  Desk desk;
  desk.open();
  CHECK(only<ShowCentre>(desk.press({Key::T, {}, 0})).centre == CentrePanel::chart);
  desk.act({ShowCentre{CentrePanel::chart}});
  CHECK(only<ShowCentre>(desk.press({Key::T, {}, 0})).centre == CentrePanel::view);
  CHECK(only<KnitAlong>(desk.press({Key::K, {}, 0})).round == 1);
  desk.act({KnitAlong{7}});
  CHECK_FALSE(only<KnitAlong>(desk.press({Key::K, {}, 0})).round);
  desk.act({KnitAlong{std::nullopt}});
  CHECK(only<KnitAlong>(desk.press({Key::K, {}, 0})).round == 7);  // remembered
}

TEST_CASE("a wide chart is broken into bands where its squares would be too small to read") {
  const ChartRoom room{700.0f, 400.0f, 20.0f, 9.0f, 28.0f};
  const ChartBands whole = bands_for(60, 30, room);  // 11.7 across, 13.3 up
  CHECK(whole.count == 1);
  CHECK(whole.gap == 0.0f);
  CHECK(whole.side == 700.0f / 60.0f);
  CHECK(bands_for(60, 100, room).count == 1);  // its height makes it small, breaking would not help
  CHECK(bands_for(3, 3, room).side == 28.0f);

  // All in sight: as large as two bands let it be. In one it would have squares of 5.5.
  const ChartBands two = bands_for(127, 15, room);
  CHECK(two.count == 2);
  CHECK(two.each == 70);
  CHECK(two.columns_in(1) == 57);
  CHECK(two.side == 10.0f);
  CHECK(two.height() <= room.height);

  // Not all in sight, but legible; and never wider than the room.
  const ChartBands high = bands_for(127, 29, room);
  CHECK(high.count == 2);
  CHECK(high.side == 9.0f);
  CHECK(high.height() > room.height);
  CHECK(high.width() <= room.width);
  CHECK(bands_for(127, 29, {120.0f, 400.0f, 20.0f, 9.0f, 28.0f}).width() <= 120.0f);

  // Column 0 is the right edge of the first band, row 0 the lowest; the second begins at the right again.
  CHECK(two.at(0, 0).x == 690.0f);
  CHECK(two.at(14, 0).y == 20.0f);
  CHECK(two.at(0, 69).x == 0.0f);
  CHECK(two.at(0, 70).x == 690.0f);
  CHECK(two.at(14, 70).y == 20.0f + 150.0f + 20.0f);
  CHECK(two.scaled(2.0f).at(14, 70).y == 380.0f);
}

TEST_CASE("the chart stands in the view's place, before there is anything to chart too") {
  Desk desk;
  desk.act({ShowCentre{CentrePanel::chart}});
  desk.settle();
  CHECK(desk.ui.controls.count("chart") == 0);
  show_chart(desk);
  CHECK(desk.ui.controls.count("view") == 0);
  CHECK(desk.ui.controls.at("chart").width == desk.layout.view.width);
  CHECK(desk.ui.own<ChartCache>().last_row() ==
        static_cast<int>(desk.session.document->timeline.furthest().fabric.rows().size()));
}

TEST_CASE("a square under the pointer is shown everywhere, and a click goes to its round") {
  Desk desk;
  show_chart(desk);
  const MouseMove middle = desk.over("chart");
  const Actions hovered = desk.frames({middle});
  REQUIRE(count_of<HoverStitch>(hovered) == 1);
  desk.act(hovered);
  REQUIRE(desk.session.view->gaze.hovered_stitch);
  const auto row = desk.session.view->gaze.hovered_stitch->row;
  CHECK(row > 1);
  desk.settle();
  const Actions clicked =
      desk.frames({MouseClick{MouseButton::Left, true}, MouseClick{MouseButton::Left, false}});
  REQUIRE(count_of<SeekPlace>(clicked) == 1);
  for (const Action& wish : clicked) {
    if (const auto* seek = wish.get_if<SeekPlace>()) CHECK(seek->place.row == row);
  }
  desk.act(desk.frames({MouseLeave{}}));
  CHECK_FALSE(desk.session.view->gaze.hovered_stitch);
}

TEST_CASE("a drag moves the chart and goes nowhere, the wheel brings it nearer") {
  Desk desk;
  show_chart(desk);
  const MouseMove middle = desk.over("chart");
  desk.act(desk.frames({middle, MouseClick{MouseButton::Left, true}}));
  const Actions dragged =
      desk.frames({MouseMove{middle.x + 60, middle.y + 10}, MouseClick{MouseButton::Left, false}});
  CHECK(count_of<SeekPlace>(dragged) == 0);
  CHECK(desk.ui.own<ChartView>().move.x > 50.0f);
}

TEST_CASE("knitting along: forward, back, first, and away") {
  Desk desk;
  desk.open();
  desk.act({KnitAlong{3}});
  desk.settle();
  CHECK(only<KnitAlong>(desk.click("knit-along/forward")).round == 4);
  CHECK(only<KnitAlong>(desk.click("knit-along/back")).round == 2);
  CHECK(only<KnitAlong>(desk.click("knit-along/first")).round == 1);
  CHECK_FALSE(only<KnitAlong>(desk.click("knit-along/close")).round);
  desk.act({KnitAlong{100000}});
  desk.settle();
  CHECK(only<KnitAlong>(desk.click("knit-along/forward")).round == desk.ui.own<ChartCache>().last_row());
  CHECK(desk.ui.own<ChartCache>().line_of(1).find("CO") != std::string::npos);
  for (int round = 2; round <= desk.ui.own<ChartCache>().last_row(); ++round)
    CHECK(desk.ui.own<ChartCache>().line_of(round).rfind("Rnd", 0) == 0);
}

TEST_CASE("the arrows turn the rounds while one knits along, and the steps again afterwards") {
  Desk desk;
  desk.open();
  const Chord right{Key::Right, {}, 0}, left{Key::Left, {}, 0};
  desk.act({KnitAlong{3}});
  desk.settle();
  CHECK(only<KnitAlong>(desk.press(right)).round == 4);
  CHECK(only<KnitAlong>(desk.press(left)).round == 2);
  CHECK(only<StepBy>(desk.press({Key::Right, {.shift = true}, 0})).unit == Unit::row);
  desk.act({KnitAlong{std::nullopt}});
  desk.settle();
  CHECK(only<StepBy>(desk.press(right)).direction == 1);
}

TEST_CASE("the round at hand is lit in the view") {
  Desk desk;
  desk.open();
  desk.act({ToLast{}});
  Describer describer;
  const std::size_t before = describer.describe(desk.session).lines.size();
  desk.act({KnitAlong{4}});
  const std::size_t stitches = desk.session.document->timeline.state().fabric.rows()[3]->stitches.size();
  CHECK(describer.describe(desk.session).lines.size() == before + stitches);
  desk.act({HoverStitch{StitchAt{2, 1}}});
  const Scene scene = describer.describe(desk.session);
  REQUIRE(!scene.captions.empty());
  CHECK(scene.captions.back().text == "row 2, stitch 2");
}
