// The list of break conditions, their marks, the loop on the track, and what the timeline says.
#include "app/panels/step/step_parts.h"
#include "app/session/document.h"
#include "app/session/view.h"
#include "tests/support/desk.h"

using namespace desk;

namespace {

void open_breaks(Desk& desk, const std::vector<std::string>& texts) {
  desk.open();
  desk.session.view->list = RunList::breaks;
  std::vector<knit::BreakCondition> conditions;
  for (const std::string& text : texts)
    conditions.push_back(std::get<knit::BreakCondition>(knit::parse_break(text)));
  apply(desk.session, SetBreaks{conditions});
  desk.settle();
}

}  // namespace

TEST_CASE("break conditions are added by one click, by words, and removed", "[breaks]") {
  Desk desk;
  open_breaks(desk, {});
  desk.act(desk.click("break/usual/stall"));
  REQUIRE(desk.session.view->breaks.size() == 1);
  CHECK(knit::text_of(desk.session.view->breaks[0]) == "stall");
  desk.settle();
  CHECK(desk.ui.controls.count("break/usual/stall") == 0);  // it is there already

  desk.click("break/field");
  desk.type("row=3");
  desk.act(desk.click("break/add"));
  REQUIRE(desk.session.view->breaks.size() == 2);
  CHECK(knit::text_of(desk.session.view->breaks[1]) == "row=3");

  desk.settle();
  desk.act(desk.click("break/remove/0"));
  REQUIRE(desk.session.view->breaks.size() == 1);
  CHECK(knit::text_of(desk.session.view->breaks[0]) == "row=3");
}

TEST_CASE("what is no condition gets its sentence below the field and adds nothing", "[breaks]") {
  Desk desk;
  open_breaks(desk, {});
  desk.click("break/field");
  desk.type("row=x");
  CHECK(desk.click("break/add").empty());
  CHECK_FALSE(desk.ui.own<BreakField>().trouble.empty());
  CHECK(desk.ui.own<BreakField>().text.text() == "row=x");
}

TEST_CASE("the buttons of the list run to the hits", "[breaks]") {
  Desk desk;
  open_breaks(desk, {"row=3"});
  CHECK(only<RunToBreak>(desk.click("break/next")).direction == 1);
  CHECK(only<RunToBreak>(desk.click("break/last")).direction == -1);
}

TEST_CASE("a right drag on the track lays the loop, a right click takes it away", "[breaks]") {
  Desk desk;
  desk.open();
  const Box track = desk.ui.controls.at("track");
  const auto at = [&](float across) {
    return MouseMove{track.x + across * track.width, track.y + 0.5f * track.height};
  };
  const std::size_t position = desk.session.document->timeline.position();
  desk.act(desk.frames({at(0.25f), MouseClick{MouseButton::Right, true}}));
  CHECK_FALSE(desk.session.document->travel.loop);
  desk.act(desk.frames({at(0.4f)}));
  desk.act(desk.frames({at(0.5f)}));
  desk.act(desk.frames({MouseClick{MouseButton::Right, false}, MouseLeave{}}));
  REQUIRE(desk.session.document->travel.loop.has_value());
  const auto known = static_cast<double>(desk.session.document->timeline.known());
  CHECK(static_cast<double>(desk.session.document->travel.loop->begin) ==
        Approx(0.25 * known).margin(0.01 * known));
  CHECK(static_cast<double>(desk.session.document->travel.loop->end) ==
        Approx(0.5 * known).margin(0.01 * known));
  CHECK(desk.session.document->timeline.position() == position);
  const Actions wishes = desk.frames(
      {at(0.6f), MouseClick{MouseButton::Right, true}, MouseClick{MouseButton::Right, false}, MouseLeave{}});
  CHECK(count_of<SetLoop>(wishes) == 1);
  desk.act(wishes);
  CHECK_FALSE(desk.session.document->travel.loop);
}

TEST_CASE("loop and slow motion are buttons of the timeline", "[breaks]") {
  Desk desk;
  desk.open();
  desk.session.document->timeline.seek(50);
  desk.settle();
  CHECK(only<SetSlowMotion>(desk.click("slow-motion")).on);
  const SetLoop loop = only<SetLoop>(desk.click("loop"));
  REQUIRE(loop.stretch.has_value());
  CHECK(loop.stretch->begin <= 50);
  CHECK(loop.stretch->end >= 50);
  desk.act({loop});
  CHECK_FALSE(only<SetLoop>(desk.click("loop")).stretch);
}

TEST_CASE("the place note stands whole over the view, with a cross of its own", "[breaks]") {
  for (const float width : {1280.0f, 1920.0f}) {
    Desk desk(width, 800);
    desk.open();
    CHECK(desk.ui.controls.count("place-note") == 0);
    const Box position = desk.ui.controls.at("position");
    desk.session.document->place_note =
        "The 3rd of 28 k2tog after row 29: k2tog 3 of 4 in row 54, made by step 17343. Row 54, cell 15: "
        "k2tog "
        "on stitches 33 and 34 of row 53, so that the next stitch is worked above the one that lies nearest.";
    desk.settle();
    REQUIRE(desk.ui.controls.count("place-note") == 1);
    const Box note = desk.ui.controls.at("place-note");
    const Box cross = desk.ui.controls.at("note/away");
    const float lines = note.height / ImGui::GetTextLineHeight();
    CHECK(note.x >= desk.layout.view.x);
    CHECK(note.right() <= cross.x);
    CHECK(lines > (width < 1900.0f ? 1.5f : 0.9f));
    CHECK(desk.ui.controls.at("position") == position);
    CHECK(desk.frame().empty());
    desk.act({only<PutNoteAway>(desk.click("note/away"))});
    CHECK(desk.session.document->place_note.empty());
    desk.session.document->place_note = "Row 3 has 8 stitches.";
    desk.settle();
    desk.act({only<PutNoteAway>(desk.press({Key::Escape, {}, 0}))});
    CHECK(desk.session.document->place_note.empty());
  }
}

TEST_CASE("many hits are drawn without a wish", "[breaks]") {
  Desk desk;
  open_breaks(desk, {"label=main", "label=m1l", "row=2", "narrower<5"});
  REQUIRE(desk.session.document->travel.hits.hits().size() > 30);
  CHECK(desk.frame().empty());
}
