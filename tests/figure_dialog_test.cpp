// Saving pictures and animations by keyboard and mouse.
#include <imgui.h>

#include "app/files/figures.h"
#include "app/panels/dialogs/figure_dialog.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "tests/support/desk.h"

using namespace desk;

namespace {

void choose(Desk& desk, const std::string& control, float across) {
  for (const Action& wish : desk.click(control, across)) FAIL("a wish too early: " << wish.index());
  desk.settle();
}

}  // namespace

TEST_CASE("the picture dialog gives the wish by Enter, and Escape closes it") {
  Desk desk;
  desk.open();
  desk.ui.own<FigureDialog>().wanted = FigureDialog::Kind::picture;
  desk.settle();
  CHECK(desk.press({Key::Space, {}, 0}).empty());
  desk.type("/tmp/x.png");
  const SavePicture wish = only<SavePicture>(desk.press({Key::Enter, {}, 0}));
  CHECK(wish.path == "/tmp/x.png");
  CHECK(wish.width == static_cast<int>(std::lround(desk.layout.view.width)));
  CHECK_FALSE(wish.panels);
  CHECK_FALSE(wish.transparent);
  CHECK_FALSE(desk.ui.own<FigureDialog>().wanted);
  desk.settle();
  CHECK_FALSE(ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup));
  desk.ui.own<FigureDialog>().wanted = FigureDialog::Kind::picture;
  desk.settle();
  CHECK(desk.press({Key::Escape, {}, 0}).empty());
  CHECK_FALSE(desk.ui.own<FigureDialog>().wanted);
  desk.settle();
  only<SetPlaying>(desk.press({Key::Space, {}, 0}));
}

TEST_CASE("the picture dialog offers sizes, panels and no ground") {
  Desk desk;
  desk.open();
  desk.ui.own<FigureDialog>().wanted = FigureDialog::Kind::picture;
  desk.settle();
  desk.ui.own<FigureDialog>().size = 2;
  choose(desk, "figure/transparent", 0.1f);
  CHECK(desk.ui.own<FigureDialog>().transparent);
  SavePicture wish = only<SavePicture>(desk.click("figure/save"));
  CHECK(wish.width == 3840);
  CHECK(wish.height == 2160);
  CHECK(wish.transparent);

  desk.ui.own<FigureDialog>().wanted = FigureDialog::Kind::picture;  // with what was chosen the last time
  desk.ui.own<FigureDialog>().panels = true;
  desk.settle();
  choose(desk, "figure/size", 0.5f);  // the last of the sizes: one's own
  CHECK(desk.ui.own<FigureDialog>().own == std::array<int, 2>{3840, 2160});
  desk.ui.own<FigureDialog>().own = {1600, 20};
  desk.settle();
  CHECK(desk.click("figure/save").empty());  // too low
  desk.ui.own<FigureDialog>().own = {1600, 1200};
  desk.settle();
  wish = only<SavePicture>(desk.click("figure/save"));
  CHECK(wish.width == 1600);
  CHECK(wish.panels);
  CHECK_FALSE(wish.transparent);  // panels have a ground
}

TEST_CASE("no label of the picture dialog stands under its control") {
  Desk desk(1280, 720, 1, KNIT_ASSETS_DIR "/fonts");
  desk.open();
  desk.ui.own<FigureDialog>().wanted = FigureDialog::Kind::picture;
  desk.settle();
  const Box& ground = desk.ui.controls.at("figure/transparent");
  for (const char* words : {"Size", "Shows", "Background"})
    CHECK(desk.ui.controls.at("figure/label/" + std::string(words)).right() + 4.0f <= ground.x);
}

TEST_CASE("the animation dialog gives the stretch, the frames and the rate") {
  Desk desk;
  desk.open();
  desk.act({SeekTo{desk.session.document->timeline.known() / 2}});
  desk.ui.own<FigureDialog>().wanted = FigureDialog::Kind::animation;
  desk.settle();
  SaveAnimation wish = only<SaveAnimation>(desk.click("figure/save"));
  CHECK(wish.stretch == Stretch{0, desk.session.document->timeline.known()});
  CHECK(wish.frames == 120);
  CHECK(wish.frames_per_second == 20.0);
  CHECK(wish.path.extension() == ".gif");

  desk.ui.own<FigureDialog>().wanted = FigureDialog::Kind::animation;
  desk.ui.own<FigureDialog>().of = FigureDialog::Of::row;
  desk.settle();
  wish = only<SaveAnimation>(desk.press({Key::Enter, {}, 0}));
  CHECK(wish.stretch.begin < desk.session.document->timeline.position());
  CHECK(wish.stretch.end >= desk.session.document->timeline.position());
  const knit::Place first = desk.session.document->timeline.step(wish.stretch.begin).place;
  const knit::Place last = desk.session.document->timeline.step(wish.stretch.end - 1).place;
  CHECK(first.row == last.row);
  CHECK(first.stage == last.stage);

  desk.act({SetLoop{Stretch{10, 20}}});
  desk.ui.own<FigureDialog>().wanted = FigureDialog::Kind::animation;
  desk.ui.own<FigureDialog>().of = FigureDialog::Of::loop;
  desk.settle();
  CHECK(only<SaveAnimation>(desk.press({Key::Enter, {}, 0})).stretch == Stretch{10, 20});
  desk.act({SetLoop{}});
  desk.ui.own<FigureDialog>().wanted = FigureDialog::Kind::animation;
  desk.ui.own<FigureDialog>().frames = 0;
  desk.settle();
  CHECK(desk.ui.own<FigureDialog>().of == FigureDialog::Of::run);
  CHECK(desk.press({Key::Enter, {}, 0}).empty());  // no frames
  CHECK(desk.ui.own<FigureDialog>().wanted);
}

TEST_CASE("an animation in the making shows how far it has come and can be cancelled") {
  Desk desk;
  desk.open();
  CHECK(desk.ui.controls.count("animation/cancel") == 0);
  AnimationRun run;
  run.wish.path = "a.gif";
  run.frames = 100;
  run.done = 30;
  desk.session.jobs->animation = std::make_shared<const AnimationRun>(run);
  desk.settle();
  only<CancelAnimation>(desk.click("animation/cancel"));
}

TEST_CASE("the file menu leads to both dialogs") {
  Desk desk;
  desk.open();
  desk.click("menu/file");
  desk.settle();
  desk.click("menu/Save an animation...");
  CHECK(desk.ui.own<FigureDialog>().wanted == FigureDialog::Kind::animation);
  desk.settle();
  CHECK(desk.ui.controls.count("figure/rate") == 1);
}
