// The words that stand at places in the view: clear of the legend, and in both halves where two runs are seen.
#include "app/actions/pinned_session.h"
#include "app/panels/view/view.h"
#include "tests/support/desk.h"
#include "tests/support/session.h"

using namespace desk;

namespace {

bool overlap(const Box& a, const Box& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

std::vector<Box> boxes_named(const Desk& desk, const std::string& beginning) {
  std::vector<Box> boxes;
  for (const auto& [name, box] : desk.ui.controls)
    if (name.rfind(beginning, 0) == 0) boxes.push_back(box);
  return boxes;
}

}  // namespace

TEST_CASE("words in the view never stand under the legend, wherever the view is turned") {
  Desk desk(1280, 720, 1, KNIT_ASSETS_DIR "/fonts");
  desk.open();
  knit::Timeline& timeline = desk.session.document->timeline;
  timeline.seek(timeline.position_of({knit::Stage::stitches, 4, 2}));
  desk.settle();
  const Box legend = desk.ui.controls.at("legend-box");
  const auto tags = boxes_named(desk, "tag/");
  REQUIRE_FALSE(tags.empty());
  // The tag is carried over the whole of the legend.
  const glm::dvec2 units(2.0 / desk.layout.view.width, -2.0 / desk.layout.view.height);
  const Camera start = desk.session.view->gaze.camera;
  std::size_t near = 0;
  for (float x = legend.x - 40.0f; x < legend.right(); x += 12.0f) {
    for (float y = legend.y - 20.0f; y < legend.bottom(); y += 12.0f) {
      desk.session.view->gaze.camera = start;
      apply(desk.session, Pan{units * glm::dvec2(x - tags[0].x, y - tags[0].y)});
      desk.frame();
      for (const Box& tag : boxes_named(desk, "tag/")) {
        CHECK_FALSE(overlap(tag, legend));
        near += tag.right() > legend.x - 60.0f && tag.bottom() > legend.y - 60.0f ? 1 : 0;
      }
    }
  }
  CHECK(near > 20);
}

TEST_CASE("words in the view never stand under the card at a stop, and the start tells of the stop") {
  Desk desk(1280, 720, 1, KNIT_ASSETS_DIR "/fonts");
  desk.session.document = test_support::torus_from_rings().document;
  knit::Timeline& timeline = desk.session.document->timeline;
  timeline.extend_to_end();
  REQUIRE(timeline.stop() != nullptr);
  timeline.seek(0);
  CHECK(sentence(desk.session).find("stops after step " + std::to_string(timeline.known())) !=
        std::string::npos);
  apply(desk.session, ToLast{});
  desk.settle();
  desk.frame();
  REQUIRE(desk.ui.own<StopCardPlace>().box);
  const Box card = *desk.ui.own<StopCardPlace>().box;
  const auto tags = boxes_named(desk, "tag/");
  REQUIRE_FALSE(tags.empty());
  for (const Box& tag : tags) CHECK_FALSE(overlap(tag, card));
  desk.click("stop/away");
  desk.settle();
  CHECK_FALSE(desk.ui.own<StopCardPlace>().box);
}

TEST_CASE("each half of two runs has its own words: its values, its row and what is told at its places") {
  Desk desk(1280, 720, 1, KNIT_ASSETS_DIR "/fonts");
  desk.open();
  apply(desk.session, PinRun{});
  knit::Parameters other = wide_band();
  knit::give_width(other, 0.4);
  apply(desk.session, Tune{other});
  knit::Timeline& timeline = desk.session.document->timeline;
  timeline.extend_to_end();
  timeline.seek(timeline.position_of({knit::Stage::stitches, 3, 2}));
  apply(desk.session, ShowBoth{});
  LayoutWish wish;
  wish.both = true;
  desk.layout = layout_of(1280, 720, 1, wish);
  PinnedSession pinned;
  const Session* there = pinned.refresh(desk.session);
  REQUIRE(there != nullptr);
  desk.other = Describer().describe(*there);
  REQUIRE_FALSE(desk.other->captions.empty());
  desk.settle();
  const auto here = boxes_named(desk, "tag/"), beside = boxes_named(desk, "other-tag/");
  REQUIRE_FALSE(here.empty());
  REQUIRE_FALSE(beside.empty());
  for (const Box& tag : beside) CHECK(tag.right() <= desk.layout.other_view.right());
  for (const Box& tag : here) CHECK(tag.x >= desk.layout.view.x);
  for (const auto& [name, box] : desk.ui.controls)
    if (name.rfind("half", 0) == 0) UNSCOPED_INFO(name);
  REQUIRE(desk.ui.controls.count("half/now/row") == 1);
  REQUIRE(desk.ui.controls.count("half/pinned/row") == 1);
  const Box over_here = desk.ui.controls.at("half/now/row"),
            over_there = desk.ui.controls.at("half/pinned/row");
  CHECK(over_there.right() <= desk.layout.other_view.right());
  CHECK(over_here.x >= desk.layout.view.x);
}
