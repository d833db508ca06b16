// The list of pieces in the window: names typed, orders dragged, refused with the reason; lines of pieces that light their
// rows and are lit; knitting along limb by limb.
#include "app/panels/pattern/piece_list.h"

#include "app/panels/pattern/pattern_parts.h"
#include "app/session/document.h"
#include "app/session/outbox.h"
#include "app/session/view.h"
#include "tests/support/desk.h"
#include "tests/support/session.h"

using namespace desk;

namespace {

// Two legs, A and B, that join in body C: rows 1 to 15, 16 to 30, 31 on.
void show_trousers(Desk& desk) {
  desk.session.document = test_support::example_session("trousers").document;
  desk.session.document->timeline.extend_to_end();
  desk.act({ShowSide{SidePanel::pattern}});
  desk.settle();
}

void type_name(Desk& desk, const std::string& letter, const std::string& words) {
  const std::string field = "piece/" + letter + "/name";
  desk.act(desk.frames(
      {desk.over(field), MouseClick{MouseButton::Left, true}, MouseClick{MouseButton::Left, false}}));
  for (const char c : words) desk.act(desk.frames({Text{static_cast<char32_t>(c)}}));
  desk.act(desk.press({Key::Enter, {}, 0}));
  desk.settle();
}

const std::string& trouble(Desk& desk) { return desk.ui.own<PieceList>().trouble; }

}  // namespace

TEST_CASE("a name is typed in place, of twins that are called alike both, and is refused with a sentence") {
  Desk desk(1440, 1000);
  show_trousers(desk);
  type_name(desk, "A", "leg");
  CHECK(desk.session.document->pieces.names ==
        std::map<std::string, std::string>{{"A", "Leg"}, {"B", "Leg"}});
  CHECK(desk.ui.own<ChartCache>().pattern().pieces.front().name == "Legs A and B");
  type_name(desk, "C", "my trunk");
  CHECK(trouble(desk) == "A piece cannot be called \"my trunk\"; give one word of letters: Tail.");
  CHECK(desk.session.document->pieces.names.size() == 2);
  desk.act({Undo{}});
  desk.settle();
  CHECK(desk.ui.own<PieceList>().names.front().text() == "Limb");
}

TEST_CASE("a piece goes up or down where that can be worked, and back to the cheapest order") {
  Desk desk(1440, 1000);
  show_trousers(desk);
  CHECK(desk.ui.controls.count("pieces/cheapest") == 0);
  desk.act(desk.click("piece/B/up"));
  desk.settle();
  CHECK(desk.session.document->pieces.order == std::vector<std::string>{"B", "A", "C"});
  CHECK(desk.ui.own<ChartCache>().pieces().chosen);
  // Lettered anew: what was B is A now.
  CHECK(count_of<SetPieceOrder>(desk.click("piece/C/up")) == 0);
  CHECK(trouble(desk) == "Body C is worked on the stitches of Limb B, so that one must come first.");
  desk.act(desk.click("pieces/cheapest"));
  desk.settle();
  CHECK(desk.session.document->pieces.order.empty());
}

TEST_CASE("a piece is dragged by its letter to another place") {
  Desk desk(1440, 1000);
  show_trousers(desk);
  const auto drag = [&](const std::string& from, const std::string& to, float below) {
    const MouseMove start = desk.over(from);
    const Box box = desk.ui.controls.at(to);
    const MouseMove end{start.x, box.y + below * box.height};
    Actions all = desk.frames({start, MouseClick{MouseButton::Left, true}, MouseMove{start.x, start.y + 6.0f},
                               end, end, MouseClick{MouseButton::Left, false}, MouseLeave{}});
    desk.act(all);
    desk.settle();
    return count_of<SetPieceOrder>(all);
  };
  CHECK(drag("piece/A/handle", "piece/B/handle", 0.9f) == 1);
  CHECK(desk.session.document->pieces.order == std::vector<std::string>{"B", "A", "C"});
  CHECK(drag("piece/C/handle", "piece/A/handle", 0.1f) == 0);
  CHECK(trouble(desk).find("must come first.") != std::string::npos);
  CHECK(drag("piece/A/handle", "piece/A/handle", 0.4f) == 0);  // to where it was
}

TEST_CASE("moving a piece leaves the others in their order") {
  PlannedPieces pieces;
  pieces.letters = {"A", "B", "C", "D"};
  using Letters = std::vector<std::string>;
  CHECK(moved_piece(pieces, 0, 2) == Letters{"B", "A", "C", "D"});
  CHECK(moved_piece(pieces, 0, 4) == Letters{"B", "C", "D", "A"});
  CHECK(moved_piece(pieces, 3, 0) == Letters{"D", "A", "B", "C"});
  CHECK(moved_piece(pieces, 2, 2) == pieces.letters);
  CHECK(moved_piece(pieces, 2, 3) == pieces.letters);
}

TEST_CASE("lines of pieces light their rows and are lit by them") {
  Desk desk(1440, 5000);
  show_trousers(desk);
  const auto meant = [&](const std::string& mark) {
    desk.act(desk.frames({desk.over(mark, 0.9f)}));
    return desk.session.view->gaze.hovered_rounds;
  };
  CHECK(meant("pattern/piece/31") ==
        RoundSpan{31, desk.session.document->timeline.furthest().fabric.row_count()});
  CHECK(meant("pattern/deal/31/1") == RoundSpan{31, 31});
  CHECK(meant("piece/B/handle") == RoundSpan{16, 30});
  desk.act(desk.frames({MouseLeave{}}));
  // Both legs are made by one line.
  const PatternLayout& layout = desk.ui.own<PatternView>().layout;
  CHECK(layout.line_of(1) == layout.line_of(16));
  CHECK(layout.line_of(15) == layout.line_of(30));
  for (std::int32_t row = 1; row <= desk.session.document->timeline.furthest().fabric.row_count(); ++row) {
    CAPTURE(row);
    const auto line = layout.line_of(row);
    REQUIRE(line);
    CHECK(layout.lines()[*line].line.says(row));
  }
  REQUIRE(layout.line_of(31, 1));
  CHECK(layout.lines()[*layout.line_of(31, 1)].line.words.find("Join") == 0);
}

TEST_CASE("knitting along goes through rounds and deals, and from piece to piece") {
  Desk desk(1440, 1400);
  show_trousers(desk);
  desk.act({KnitAlong{30}});
  desk.settle();
  for (const char* control : {"line", "needle", "holders", "next", "end"})
    CHECK(desk.ui.controls.count("knit-along/" + std::string(control)) == 1);
  desk.act(desk.click("knit-along/forward"));
  CHECK(desk.session.view->gaze.knit_along == 31);
  CHECK(desk.session.view->gaze.knit_along_deal == 1);
  desk.settle();
  CHECK(desk.ui.controls.count("knit-along/end") == 0);
  desk.act(desk.click("knit-along/forward"));
  CHECK(desk.session.view->gaze.knit_along == 31);
  CHECK(desk.session.view->gaze.knit_along_deal == 0);
  desk.settle();
  desk.act(desk.click("knit-along/first"));
  CHECK(desk.session.view->gaze.knit_along_deal == 1);
  desk.settle();
  desk.act(desk.click("knit-along/first"));
  CHECK(desk.session.view->gaze.knit_along == 16);
  desk.settle();
  desk.act(desk.click("knit-along/next-piece"));
  CHECK(desk.session.view->gaze.knit_along == 31);
  // A line of the text, too.
  desk.settle();
  const Actions clicked = desk.click("pattern/deal/31/1", 0.9f);
  REQUIRE(count_of<KnitAlong>(clicked) == 1);
  desk.act(clicked);
  CHECK(desk.session.view->gaze.knit_along_deal == 1);
}
