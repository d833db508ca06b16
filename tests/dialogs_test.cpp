// The open and save dialogs, by keyboard and mouse.
#include <imgui.h>

#include <filesystem>
#include <fstream>

#include "app/panels/dialogs/file_dialogs.h"
#include "app/session/view.h"
#include "tests/support/desk.h"

using namespace desk;

TEST_CASE("the open dialog works by keyboard and mouse") {
  const auto folder = std::filesystem::temp_directory_path() / "knit panels test";
  std::filesystem::create_directories(folder / "inner");
  std::ofstream(folder / "ball.OBJ") << "v 0 0 0\n";
  std::ofstream(folder / "notes.doc") << "no mesh\n";
  Desk desk;
  desk.open();
  desk.ui.own<OpenDialog>().folder = folder;
  desk.session.view->dialogs.open_dialog_open = true;
  desk.settle();
  CHECK(desk.ui.controls.count("open/ball.OBJ") == 1);
  CHECK(desk.ui.controls.count("open/inner") == 1);
  CHECK(desk.ui.controls.count("open/notes.doc") == 0);
  CHECK(desk.press({Key::Space, {}, 0}).empty());
  CHECK(desk.press({Key::O, {.ctrl = true}, 0}).empty());

  SECTION("a typed path") {
    desk.type("nothing.obj");
    CHECK(desk.press({Key::Enter, {}, 0}).empty());
    CHECK(desk.ui.own<OpenDialog>().trouble.find("nothing.obj") != std::string::npos);
  }
  SECTION("a typed path that exists, from the folder shown") {
    desk.type("ball.OBJ");
    const Actions wishes = desk.press({Key::Enter, {}, 0});
    CHECK(count_of<OpenFile>(wishes) == 1);
    CHECK(count_of<ShowOpenDialog>(wishes) == 1);
    CHECK(std::filesystem::equivalent(wishes[0].get<OpenFile>().path, folder / "ball.OBJ"));
  }
  SECTION("arrow keys: past .. and inner to the file") {
    for (int i = 0; i < 3; ++i) CHECK(desk.press({Key::Down, {}, 0}).empty());
    CHECK(count_of<OpenFile>(desk.press({Key::Enter, {}, 0})) == 1);
  }
  SECTION("a folder by double click, then typing again") {
    const MouseClick down{MouseButton::Left, true};
    const MouseClick up{MouseButton::Left, false};
    CHECK(desk.frames({desk.over("open/inner", 0.1f), down, up, down, up}).empty());
    CHECK(std::filesystem::equivalent(desk.ui.own<OpenDialog>().folder, folder / "inner"));
    desk.settle();
    desk.type("../ball.OBJ");
    CHECK(count_of<OpenFile>(desk.press({Key::Enter, {}, 0})) == 1);
  }
  SECTION("Escape closes") {
    CHECK_FALSE(only<ShowOpenDialog>(desk.press({Key::Escape, {}, 0})).open);
    desk.session.view->dialogs.open_dialog_open = false;
    desk.settle();
    only<SetPlaying>(desk.press({Key::Space, {}, 0}));
  }
  SECTION("closed by another hand") {
    desk.session.view->dialogs.open_dialog_open = false;
    desk.settle();
    CHECK_FALSE(ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup));
  }
  std::filesystem::remove_all(folder);
}

TEST_CASE("the save dialog gives an export, and says that a file would be replaced") {
  Desk desk;
  desk.open();
  desk.ui.own<SaveDialog>().wanted = find_export("map");
  desk.settle();
  const auto path = std::filesystem::temp_directory_path() / "knit-panels-test-map.txt";
  CHECK(desk.ui.own<SaveDialog>().path.text().find("-map.txt") != std::string::npos);
  desk.type(path.string());
  const Export saved = only<Export>(desk.press({Key::Enter, {}, 0}));
  CHECK(saved.what == "map");
  CHECK(saved.path == path);
  CHECK_FALSE(desk.ui.own<SaveDialog>().wanted);
  desk.settle();
  only<SetPlaying>(desk.press({Key::Space, {}, 0}));
  desk.ui.own<SaveDialog>().wanted = find_export("screenshot");
  desk.settle();
  CHECK(desk.press({Key::Escape, {}, 0}).empty());
  CHECK_FALSE(desk.ui.own<SaveDialog>().wanted);
}
