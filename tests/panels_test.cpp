// The panels without a display: drawn at every stage, clicked and dragged; each act gives its one wish.
#include "app/panels/dialogs/file_dialogs.h"
#include "app/panels/kit/run_cache.h"
#include "app/panels/parameters/parameters.h"
#include "app/panels/ui.h"
#include "app/session/document.h"
#include "app/session/outbox.h"
#include "app/session/program.h"
#include "app/session/view.h"

#include <imgui.h>

#include <array>

#include "knit/model/stitch_size.h"
#include "tests/support/desk.h"

namespace {

using namespace desk;

bool overlap(const Box& a, const Box& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

bool inside(const Box& a, const Box& b) {
  return a.x >= b.x && a.y >= b.y && a.right() <= b.right() && a.bottom() <= b.bottom();
}

bool inside_but_for_the_foot(const Box& a, const Box& b) {
  return a.x >= b.x && a.y >= b.y && a.right() <= b.right() && a.y < b.bottom();
}

struct Size {
  float width, height, scale;
};
constexpr std::array sizes{Size{1280, 720, 1},  Size{1920, 1080, 1}, Size{3840, 2160, 2},
                           Size{3840, 2160, 1}, Size{640, 400, 1},   Size{1280, 720, 2}};

}  // namespace

TEST_CASE("panels fill the window and never overlap") {
  for (const Size& size : sizes) {
    const Layout layout = layout_of(size.width, size.height, size.scale);
    const std::array boxes{layout.menu, layout.parameters, layout.view, layout.explanation, layout.timeline};
    float area = 0.0f;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      CHECK(inside(boxes[i], layout.window));
      CHECK(boxes[i].width > 0.0f);
      CHECK(boxes[i].height > 0.0f);
      area += boxes[i].width * boxes[i].height;
      for (std::size_t j = 0; j < i; ++j) CHECK_FALSE(overlap(boxes[i], boxes[j]));
    }
    CHECK(area == Approx(size.width * size.height));
    CHECK(layout.view.width >= 0.3f * size.width);
  }
}

TEST_CASE("the view in pixels is counted from the lower left") {
  const Layout layout = layout_of(1280, 720, 1);
  const PixelBox pixels = pixels_of(layout.view, layout.window, 2.0f, 2.0f);
  CHECK(pixels.x == static_cast<int>(2 * layout.parameters.width));
  CHECK(pixels.y == static_cast<int>(2 * layout.timeline.height));
  CHECK(pixels.width == static_cast<int>(2 * layout.view.width));
  CHECK(pixels.height == static_cast<int>(2 * layout.view.height));
}

TEST_CASE("every panel is drawn at every stage, with everything open, and controls keep to their panels") {
  for (const Size& size : sizes) {
    Desk desk(size.width, size.height, size.scale, KNIT_ASSETS_DIR "/fonts");
    CHECK(desk.frame().empty());
    desk.session.program->assets = KNIT_ASSETS_DIR;
    CHECK(desk.frame().empty());
    desk.open();
    for (const RunCache::Stretch& stage : std::vector(desk.ui.own<RunCache>().stages())) {
      for (const std::size_t position : {stage.begin, (stage.begin + stage.end) / 2, stage.end}) {
        desk.session.document->timeline.seek(position);
        CHECK(desk.frame().empty());
      }
    }
    const Layout& layout = desk.layout;
    CHECK(desk.ui.controls.at("view") == layout.view);
    if (size.width < 1280 * size.scale) continue;  // smaller windows scroll and cut
    for (const auto& [name, box] : desk.ui.controls) {
      INFO(name);
      const bool left = name.rfind("knob/", 0) == 0 || name == "mode";
      const bool right = name.rfind("layer/", 0) == 0 || name.rfind("label/", 0) == 0;
      const bool bottom = name == "play" || name == "speed" || name == "position" || name == "track";
      // Parameters scroll, and the panel's foot may cut the last one.
      if (left) CHECK(inside_but_for_the_foot(box, layout.parameters));
      if (right) CHECK(inside(box, layout.explanation));
      if (bottom) CHECK(inside(box, layout.timeline));
    }
  }
}

TEST_CASE("overlays are drawn without a wish of their own") {
  Desk desk;
  desk.open();
  desk.session.view->dialogs.help_open = true;
  desk.session.view->gaze.picking = Picking::end;
  desk.session.outbox->notices = {{Notice::Kind::info, "Saved."},
                                  {Notice::Kind::error, "Something is wrong."}};
  desk.session.view->list = RunList::problems;
  for (int i = 0; i < 3; ++i) CHECK(desk.frame().empty());
  CHECK(desk.ui.controls.count("notice/0") == 1);
  CHECK(only<DismissNotice>(desk.click("notice/1")).index == 1);
  desk.session.view->dialogs.help_open = false;
  desk.settle();
  CHECK(only<SetPicking>(desk.click("picking/cancel")).picking == Picking::nothing);
}

TEST_CASE("a click on a button of the timeline gives its one action") {
  Desk desk;
  desk.open();
  desk.session.document->timeline.seek(20);
  CHECK(only<SetPlaying>(desk.click("play")).playing);
  desk.session.view->playback.playing = true;
  CHECK_FALSE(only<SetPlaying>(desk.click("play")).playing);
  only<ToFirst>(desk.click("first"));
  only<ToLast>(desk.click("last"));
  CHECK(only<StepBy>(desk.click("forward")).unit == Unit::item);
  CHECK(desk.click("unit", 0.9f).empty());
  desk.settle();
  const StepBy back = only<StepBy>(desk.click("back"));
  CHECK(back.unit == Unit::stage);
  CHECK(back.direction == -1);
}

TEST_CASE("dragging the scrubber seeks, and only when it moves") {
  Desk desk;
  desk.open();
  desk.session.document->timeline.seek(0);
  desk.settle();
  const std::size_t known = desk.session.document->timeline.known();
  const Box track = desk.ui.controls.at("track");
  CHECK(desk.frames({desk.over("scrubber")}).empty());
  desk.act(desk.frames({MouseClick{MouseButton::Left, true}}));
  const MouseMove middle{track.x + 0.5f * track.width, track.y + 0.5f * track.height};
  const Actions moved = desk.frames({middle});
  CHECK(only<SeekTo>(moved).position == Approx(known / 2).margin(2));
  desk.act(moved);
  CHECK(desk.frame().empty());
  CHECK(only<SeekTo>(desk.frames({MouseMove{2000, 700}})).position == known);
  desk.session.document->timeline.seek(known);
  CHECK(desk.frames({MouseClick{MouseButton::Left, false}, MouseMove{300, 700}}).empty());
}

TEST_CASE("dragging a knob tunes live, or edits from here") {
  for (const bool from_here : {false, true}) {
    Desk desk(1280, 1400);
    desk.open();
    desk.session.document->timeline.seek(desk.session.document->timeline.known() / 2);
    if (from_here) CHECK(desk.click("mode", 0.9f).empty());
    desk.settle();
    const MouseMove at = desk.over("knob/epsilon");
    CHECK(desk.frames({at, MouseClick{MouseButton::Left, true}}).empty());
    std::size_t wishes = 0;
    for (int i = 1; i <= 10; ++i) {
      const Actions moved = desk.frames({MouseMove{at.x + static_cast<float>(12 * i), at.y}});
      CHECK(count_of<Tune>(moved) == (from_here ? 0 : moved.size()));
      CHECK(count_of<EditFromHere>(moved) == (from_here ? moved.size() : 0));
      wishes += moved.size();
      desk.act(moved);
    }
    CHECK(wishes > 5);
    CHECK(desk.session.document->timeline.parameters().epsilon() > wide_band().epsilon());
    CHECK(desk.session.document->timeline.edits().size() == (from_here ? 1 : 0));
    desk.frames({MouseClick{MouseButton::Left, false}});
    if (from_here) {
      desk.settle();
      CHECK(only<RemoveEdit>(desk.click("edit/0/remove")).index == 0);
    } else {
      CHECK(knit::resolved(only<Tune>(desk.click("reset/epsilon")).parameters,
                           desk.session.document->timeline.input()) ==
            knit::resolved(wide_band(), desk.session.document->timeline.input()));
    }
  }
}

TEST_CASE("choices, the axis and welding are one click") {
  Desk desk(1280, 1280);
  desk.open();
  CHECK(only<Tune>(desk.click("knob/last-anchor", 0.9f)).parameters.rows.last_anchor ==
        knit::LastAnchor::drop);
  CHECK(only<Tune>(desk.click("knob/axis", 0.05f)).parameters.timing.axis.kind == knit::AxisKind::x);
  desk.ui.own<ChangeMode>().from_here = true;
  CHECK(only<Tune>(desk.click("knob/weld", 0.9f)).parameters.mesh.weld == knit::Weld::on);
  CHECK(only<EditFromHere>(desk.click("knob/on-stall", 0.9f)).parameters.rows.on_stall ==
        knit::OnStall::stop);
  CHECK(only<SetPicking>(desk.click("pick/start")).picking == Picking::start);
}

TEST_CASE("drags, wheel and clicks in the view") {
  Desk desk;
  desk.open();
  const MouseMove centre = desk.over("view");
  const auto drag = [&](MouseButton button, const Mods& mods) {
    Actions all = desk.frames({centre, KeyPress{Key::LeftShift, mods.shift, mods}, MouseClick{button, true}});
    for (const float by : {20.0f, 40.0f}) {
      for (Action& wish : desk.frames({MouseMove{centre.x + by, centre.y + by}}))
        all.push_back(std::move(wish));
    }
    desk.frames({MouseClick{button, false}, KeyPress{Key::LeftShift, false, {}}});
    return all;
  };
  const Actions turned = drag(MouseButton::Left, {});
  REQUIRE(count_of<Orbit>(turned) == 2);
  CHECK(turned[0].get<Orbit>().yaw < 0.0);
  CHECK(turned[0].get<Orbit>().pitch > 0.0);
  CHECK(count_of<Pan>(drag(MouseButton::Right, {})) == 2);
  CHECK(count_of<Pan>(drag(MouseButton::Middle, {})) == 2);
  const Actions panned = drag(MouseButton::Left, {.shift = true});
  REQUIRE(count_of<Pan>(panned) == 2);
  CHECK(panned[0].get<Pan>().move.x == Approx(2.0 * 20.0 / static_cast<double>(desk.layout.view.width)));
  CHECK(panned[0].get<Pan>().move.y < 0.0);
  const Zoom zoomed = only<Zoom>(desk.frames({centre, Wheel{0, 1}}));
  CHECK(zoomed.factor < 1.0);
  CHECK(zoomed.cursor.x == Approx(0.0).margin(1e-6));
  for (int i = 0; i < 40; ++i) desk.frame();
  const MouseClick down{MouseButton::Left, true};
  const MouseClick up{MouseButton::Left, false};
  only<FrameAll>(desk.frames({down, up, down, up}));
}

TEST_CASE("a click picks a vertex when one is asked for, and a drag still turns") {
  Desk desk;
  desk.open();
  desk.session.view->gaze.picking = Picking::start;
  const auto& mesh = desk.session.document->timeline.input().mesh;
  CHECK(only<PickVertex>(desk.click("view")).vertex < mesh.positions.size());
  const MouseMove centre = desk.over("view");
  const Actions dragged =
      desk.frames({centre, MouseClick{MouseButton::Left, true}, MouseMove{centre.x + 50, centre.y},
                   MouseClick{MouseButton::Left, false}});
  only<Orbit>(dragged);
  CHECK(count_of<PickVertex>(
            desk.frames({MouseMove{desk.layout.view.x + 3, desk.layout.view.y + 3},
                         MouseClick{MouseButton::Left, true}, MouseClick{MouseButton::Left, false}})) == 0);
}

TEST_CASE("layers, rows and problems are clicked") {
  Desk desk;
  desk.open();
  desk.session.document->timeline.seek(desk.session.document->timeline.known());
  desk.settle();
  const SetLayer hidden = only<SetLayer>(desk.click("layer/faces", 0.1f));
  CHECK(hidden.layer == Layer::faces);
  CHECK_FALSE(hidden.on);
  const std::string last =
      "row/" + std::to_string(desk.session.document->timeline.state().fabric.rows().size());
  CHECK(only<SeekPlace>(desk.click(last, 0.1f)).place.row ==
        static_cast<int>(desk.session.document->timeline.state().fabric.rows().size()));

  knit::Parameters narrow = wide_band();
  knit::give_epsilon(narrow, 0.001);
  desk.open(narrow);
  desk.session.view->list = RunList::problems;
  desk.settle();
  REQUIRE_FALSE(desk.ui.own<RunCache>().problems().empty());
  const std::size_t worst = desk.ui.own<RunCache>().ranked()[0].step;
  const Actions wishes = desk.click("problem/0");
  REQUIRE(wishes.size() == 2);
  CHECK(wishes[0].get<SeekTo>().position == worst + 1);
  CHECK(wishes[1].get<LookAt>().thing == knit::thing_of_problem(desk.session.document->timeline.step(worst)));
}

TEST_CASE("a problem's mark on the timeline leads to its step and to what it is about") {
  Desk desk;
  knit::Parameters narrow = wide_band();
  knit::give_epsilon(narrow, 0.001);
  desk.open(narrow);
  const auto problems = desk.ui.own<RunCache>().problems();
  REQUIRE(problems.size() > 3);
  const std::size_t step = problems[problems.size() / 2];
  const Box track = desk.ui.controls.at("track");
  const knit::Timeline& timeline = desk.session.document->timeline;
  const float margin = desk.layout.scale * 6.0f;
  const float share = static_cast<float>(step + 1) / static_cast<float>(timeline.known());
  const float x = track.x + margin + share * (track.width - 2.0f * margin) + 1.0f;
  const float low = track.bottom() - 4.0f;
  const Actions wishes = desk.frames({MouseMove{x, low}, MouseClick{MouseButton::Left, true},
                                      MouseClick{MouseButton::Left, false}, MouseLeave{}});
  REQUIRE(count_of<LookAt>(wishes) == 1);
  desk.act(wishes);
  const std::size_t at = timeline.position();
  REQUIRE(std::binary_search(problems.begin(), problems.end(), at - 1));
  CHECK(desk.session.document->travel.selected == knit::thing_of_problem(timeline.step(at - 1)));
  // Higher up a press goes where it is, as ever.
  const Actions plain =
      desk.frames({MouseMove{x + 40.0f, track.y + 0.5f * track.height}, MouseClick{MouseButton::Left, true},
                   MouseClick{MouseButton::Left, false}, MouseLeave{}});
  CHECK(count_of<LookAt>(plain) == 0);
}

TEST_CASE("menus open, choose, and close by Escape, meanwhile keys do nothing else") {
  Desk desk;
  desk.session.program->assets = KNIT_ASSETS_DIR;
  desk.open();
  for (const char* menu : {"menu/file", "menu/go", "menu/view", "menu/help"}) {
    INFO(menu);
    CHECK(desk.click(menu).empty());
    desk.settle();
    CHECK(ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup));
    CHECK(desk.press({Key::Space, {}, 0}).empty());
    CHECK(desk.press({Key::Escape, {}, 0}).empty());
    desk.settle();
    CHECK_FALSE(ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup));
  }
  CHECK(desk.click("menu/go").empty());
  desk.settle();
  only<ToLast>(desk.click("menu/To the end"));
  CHECK(desk.click("menu/file").empty());
  desk.settle();
  CHECK(desk.click("menu/Save the report...").empty());
  CHECK(desk.ui.own<SaveDialog>().wanted == find_export("report"));
}
