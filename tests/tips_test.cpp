// Tips: beside what they are about, never on it, and inside the window.
#include <string>
#include <vector>

#include "app/panels/kit/widgets.h"
#include "app/session/document.h"
#include "app/session/view.h"
#include "tests/support/desk.h"

using namespace desk;

namespace {

bool share_room(const Box& a, const Box& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

bool holds_whole(const Box& outer, const Box& inner) {
  return inner.x >= outer.x && inner.y >= outer.y && inner.right() <= outer.right() &&
         inner.bottom() <= outer.bottom();
}

std::vector<std::string> names_of_controls(const Desk& desk) {
  std::vector<std::string> names;
  for (const auto& [name, box] : desk.ui.controls) names.push_back(name);
  return names;
}

}  // namespace

TEST_CASE("a tip stands below, else above, else beside, always in the window") {
  const Box window{0, 0, 400, 300};
  const ImVec2 size(100, 40);
  CHECK(tip_box({10, 10, 50, 20}, window, size, 4) == Box{10, 34, 100, 40});
  CHECK(tip_box({380, 10, 20, 20}, window, size, 4) == Box{300, 34, 100, 40});
  CHECK(tip_box({10, 270, 50, 20}, window, size, 4) == Box{10, 226, 100, 40});
  CHECK(tip_box({10, 20, 50, 260}, window, size, 4) == Box{64, 20, 100, 40});
  CHECK(tip_box({330, 20, 50, 260}, window, size, 4) == Box{226, 20, 100, 40});
}

TEST_CASE("no control's tip covers it, in a small window and in a large one") {
  for (const float scale : {1.0f, 2.0f}) {
    Desk desk(1280, 720, scale);
    desk.open();
    std::size_t tips = 0;
    for (const std::string& name : names_of_controls(desk)) {
      desk.frame({desk.over(name)});
      desk.frame();
      const auto tip = desk.ui.controls.find("tip");
      const auto control = desk.ui.controls.find(name);
      if (tip == desk.ui.controls.end() || control == desk.ui.controls.end()) continue;
      if (control->second.height > 120.0f * scale) continue;  // a plot: beside what is pointed at
      INFO(name);
      CHECK_FALSE(share_room(tip->second, control->second));
      CHECK(holds_whole(desk.layout.window, tip->second));
      ++tips;
    }
    CHECK(tips > 20);
  }
}

TEST_CASE("the tip of a name that stands over its field leaves the field free") {
  Desk desk(1280, 960, 2);
  desk.open();
  std::size_t seen = 0;
  for (const std::string& name : names_of_controls(desk)) {
    if (name.rfind("knob-label/", 0) != 0) continue;
    desk.frame({desk.over(name)});
    desk.frame();
    const std::string knob = "knob/" + name.substr(11);
    if (desk.ui.controls.count("tip") == 0 || desk.ui.controls.count(knob) == 0) continue;
    INFO(name);
    CHECK_FALSE(share_room(desk.ui.controls.at("tip"), desk.ui.controls.at(knob)));
    ++seen;
  }
  CHECK(seen > 3);
}

TEST_CASE("the tip of a side's tab leaves the side free") {
  for (const float height : {720.0f, 1080.0f}) {
    Desk desk(1280, height, 1, KNIT_ASSETS_DIR "/fonts");
    desk.open();
    desk.frames({desk.over("side/report"), desk.over("side/report", 0.6f)});
    desk.settle();
    const Box tip = desk.ui.controls.at("tip");
    CHECK(tip.width > 10.0f);
    CHECK(tip.right() <= desk.layout.explanation.x);
    CHECK(tip.x >= 0.0f);
  }
}
