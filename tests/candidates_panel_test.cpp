// The candidates of a row and the ways to "why" in the panels: view, chart, lists, the line of what is selected.
#include "app/panels/step/candidate_list.h"
#include "app/session/document.h"
#include "app/session/view.h"
#include "tests/support/desk.h"

using namespace desk;

namespace {

// In the middle of a row that is picked from the mesh's vertices.
void go_into_row(Desk& desk, std::int32_t row) {
  desk.act({SeekPlace{{knit::Stage::rows, row, 8}}});
  desk.session.view->list = RunList::candidates;
  desk.settle();
}

// Long enough for a click to be no double click.
Actions wait_for_click(Desk& desk) {
  Actions all;
  for (int i = 0; i < 30; ++i) {
    for (Action& wish : desk.frame()) all.push_back(std::move(wish));
  }
  return all;
}

}  // namespace

TEST_CASE("candidates: a line each, and a click goes to the step that decided") {
  Desk desk(1280, 1200);
  desk.open();
  go_into_row(desk, 4);
  const auto& table = desk.ui.own<CandidateList>().table();
  REQUIRE(table.none == knit::NoCandidates::has_some);
  CHECK(table.row == 4);
  REQUIRE(desk.ui.own<CandidateList>().size() == table.candidates.size());
  const knit::Candidate& fifth = table.candidates[5];
  CHECK(only<ShowWhy>(desk.click("candidate/5")).thing == knit::Element(knit::VertexElement{fifth.vertex}));
  desk.act({ShowWhy{knit::VertexElement{fifth.vertex}}});
  CHECK(desk.session.document->timeline.position() == fifth.step + 1);
  desk.settle();
  CHECK(desk.ui.own<CandidateList>().order_of(desk.session.document->timeline,
                                              *desk.session.document->travel.selected) == 5);
  CHECK(count_of<ShowWhy>(desk.click("plot/candidates", 0.7f)) == 1);
}

TEST_CASE("candidates: those that were kept have their stitch's number, from 1") {
  Desk desk(1280, 1200);
  desk.open();
  go_into_row(desk, 4);
  const CandidateList& list = desk.ui.own<CandidateList>();
  std::int32_t kept = 0;
  for (const knit::Candidate& candidate : list.table().candidates) {
    const bool is_kept = candidate.verdict <= knit::CandidateVerdict::taken;
    CHECK(list.stitch_of(candidate.order) == (is_kept ? ++kept : 0));
    if (is_kept)
      CHECK(list.order_of(desk.session.document->timeline, knit::StitchElement{4, kept - 1}) ==
            candidate.order);
  }
  CHECK(kept > 3);
}

TEST_CASE("candidates: sorted by what is clicked, both ways") {
  Desk desk;
  desk.open();
  go_into_row(desk, 4);
  const CandidateList& list = desk.ui.own<CandidateList>();
  const auto rises = [&](auto value) {
    for (std::size_t i = 1; i < list.size(); ++i) {
      if (value(list.at(i)) < value(list.at(i - 1))) return false;
    }
    return true;
  };
  const auto distance = [](const knit::Candidate& c) { return c.distance; };
  CHECK(rises([](const knit::Candidate& c) { return c.order; }));
  CHECK_FALSE(rises(distance));
  CHECK(desk.click("candidates/sort/2", 0.3f).empty());
  desk.settle();
  CHECK(rises(distance));
  CHECK(desk.click("candidates/sort/2", 0.3f).empty());
  desk.settle();
  CHECK(rises([](const knit::Candidate& c) { return -c.distance; }));
  CHECK(desk.click("candidates/sort/3", 0.3f).empty());
  desk.settle();
  CHECK(rises([](const knit::Candidate& c) { return c.verdict; }));
}

TEST_CASE("candidates: where there are none it says so, and nothing breaks") {
  Desk desk;
  desk.session.view->list = RunList::candidates;
  desk.settle();
  desk.open();
  desk.act({ToFirst{}});
  desk.settle();
  CHECK(desk.ui.own<CandidateList>().table().none == knit::NoCandidates::no_row);
  desk.act({SeekPlace{{knit::Stage::cast_on, 1, 2}}});
  desk.settle();
  CHECK(desk.ui.own<CandidateList>().table().none == knit::NoCandidates::cast_on);
  knit::Parameters parameters = wide_band();
  parameters.rows.source = knit::RowSource::contours;
  desk.open(parameters);
  desk.act({SeekPlace{{knit::Stage::rows, 3, 4}}});
  desk.settle();
  CHECK(desk.ui.own<CandidateList>().table().none == knit::NoCandidates::cut);
}

TEST_CASE("a click in the view shows why, once it can be no double click") {
  Desk desk;
  desk.open();
  CHECK(desk.click("view").empty());
  const Actions wishes = wait_for_click(desk);
  REQUIRE(count_of<ShowWhy>(wishes) == 1);
  desk.act(wishes);
  REQUIRE(desk.session.document->travel.selected);
  CHECK(desk.session.document->timeline.position() < desk.session.document->timeline.known());
  // Beside everything: nothing is selected any more.
  const Box& view = desk.layout.view;
  desk.frames({MouseMove{view.x + 3, view.y + 3}, MouseClick{MouseButton::Left, true},
               MouseClick{MouseButton::Left, false}});
  const Actions none = wait_for_click(desk);
  REQUIRE(count_of<Select>(none) == 1);
  desk.act(none);
  CHECK_FALSE(desk.session.document->travel.selected);
  // A drag is no click, and a double click frames.
  const MouseMove centre = desk.over("view");
  desk.frames({centre, MouseClick{MouseButton::Left, true}, MouseMove{centre.x + 50, centre.y},
               MouseClick{MouseButton::Left, false}});
  CHECK(count_of<ShowWhy>(wait_for_click(desk)) == 0);
  const MouseClick down{MouseButton::Left, true};
  const MouseClick up{MouseButton::Left, false};
  CHECK(count_of<FrameAll>(desk.frames({centre, down, up, down, up})) == 1);
  CHECK(count_of<ShowWhy>(wait_for_click(desk)) == 0);
}

TEST_CASE("the line of what is selected leads on from there") {
  Desk desk;
  desk.open();
  CHECK(desk.ui.controls.count("selected") == 0);
  desk.act({Select{knit::StitchElement{4, 2}}});
  desk.settle();
  CHECK(only<ShowWhy>(desk.click("selected/why")).thing == knit::Element(knit::StitchElement{4, 2}));
  CHECK(only<ToTouch>(desk.click("selected/back")).direction == -1);
  CHECK(only<ToTouch>(desk.click("selected/forward")).direction == 1);
  CHECK_FALSE(only<Select>(desk.click("selected/close")).thing);
}

TEST_CASE("a double click on a row's cell leads to what begins, counts or changes it") {
  Desk desk(1280, 960);
  desk.open();
  desk.act({SeekPlace{{knit::Stage::rows, 4, 3}}});
  desk.settle();
  const MouseClick down{MouseButton::Left, true};
  const MouseClick up{MouseButton::Left, false};
  const auto twice = [&](float across) {
    for (int i = 0; i < 40; ++i) desk.frame();
    return desk.frames({desk.over("row/3", across), down, up, down, up});
  };
  const Actions begins = twice(0.1f);
  REQUIRE(count_of<SeekPlace>(begins) == 2);
  CHECK(begins.back().get<SeekPlace>().place == knit::Place{knit::Stage::rows, 3, 0});
  const Actions counts = twice(0.5f);
  const auto decided = knit::count_decided_by(desk.session.document->timeline, 3);
  REQUIRE(decided);
  CHECK(counts.back().get<SeekPlace>().place == desk.session.document->timeline.step(*decided).place);
  CHECK(twice(0.9f).back().get<SeekPlace>().place == knit::Place{knit::Stage::stitches, 3, 0});
}

TEST_CASE("a click on a square of the chart selects its label or stitch and goes there") {
  Desk desk;
  desk.open();
  desk.act({ShowCentre{CentrePanel::chart}});
  desk.settle();
  desk.act(desk.frames({desk.over("chart")}));
  REQUIRE(desk.session.view->gaze.hovered_stitch);
  desk.settle();
  desk.act(desk.frames({MouseClick{MouseButton::Left, true}, MouseClick{MouseButton::Left, false}}));
  REQUIRE(desk.session.document->travel.selected);
  const auto made = knit::made_by(desk.session.document->timeline, *desk.session.document->travel.selected);
  REQUIRE(made);
  CHECK(desk.session.document->timeline.position() == *made + 1);
}
