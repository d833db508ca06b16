// Where an example is chosen, there is a picture of what it is when it is knitted.
#include "app/panels/offers/example_pictures.h"

#include <algorithm>

#include "app/session/program.h"
#include "app/window/frame.h"
#include "tests/support/desk.h"
#include "tests/support/session.h"

using namespace desk;

namespace {

// Pixels in the box of a window of 1280 x 720 that have another colour than most there.
std::size_t drawn_in(const Box& box, const std::filesystem::path& assets) {
  Session session;
  session.program->assets = assets;
  const auto picture = picture_of(session, 1280, 720);
  REQUIRE(std::holds_alternative<Image>(picture));
  const Image& image = std::get<Image>(picture);
  std::map<std::array<int, 3>, std::size_t> colours;
  std::size_t all = 0, most = 0;
  for (int y = static_cast<int>(box.y); y < static_cast<int>(box.bottom()); ++y) {
    for (int x = static_cast<int>(box.x); x < static_cast<int>(box.right()); ++x) {
      const auto at = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                           static_cast<std::size_t>(x));
      most = std::max(most, ++colours[{image.rgba[at], image.rgba[at + 1], image.rgba[at + 2]}]);
      ++all;
    }
  }
  return all - most;
}

}  // namespace

TEST_CASE("examples stand with their pictures where nothing is open, and a click on one opens it") {
  Desk desk(1280, 720, 1, KNIT_ASSETS_DIR "/fonts");
  desk.session.program->assets = KNIT_ASSETS_DIR;
  desk.settle();
  CHECK(desk.ui.own<ExamplePictures>().wanted);
  for (const std::string& name : list_examples(KNIT_ASSETS_DIR)) {
    CAPTURE(name);
    const auto tile = desk.ui.controls.find("welcome/" + name);
    REQUIRE(tile != desk.ui.controls.end());
    CHECK(tile->second.height >= 60.0f);  // a picture has room over the name
  }
  CHECK(only<OpenExample>(desk.click("welcome/octopus")).name == "octopus");

  // In the picture of the window: without a file there is only the name.
  const Box tile = desk.ui.controls.at("welcome/octopus");
  const test_support::Folder bare;
  for (const std::string& name : list_examples(KNIT_ASSETS_DIR)) {
    std::filesystem::create_directory(bare.path() / name);
    for (const char* file : {"mesh.obj", "parameters.json"})
      test_support::write_text(bare.path() / name / file, "");
  }
  std::filesystem::create_directory_symlink(KNIT_ASSETS_DIR "/fonts", bare.path() / "fonts");
  const std::size_t with = drawn_in(tile, KNIT_ASSETS_DIR), without = drawn_in(tile, bare.path());
  CHECK(without > 50);
  CHECK(with > without + 500);
}

TEST_CASE("the menu of examples has them too, as high as a small window allows") {
  for (const float height : {720.0f, 420.0f}) {
    Desk desk(1280, height, 1, KNIT_ASSETS_DIR "/fonts");
    desk.session.program->assets = KNIT_ASSETS_DIR;
    desk.open();
    CHECK(desk.click("menu/file").empty());
    desk.settle();
    CHECK(desk.click("menu/Examples").empty());
    desk.settle();
    CHECK(desk.ui.own<ExamplePictures>().wanted);
    for (const std::string& name : list_examples(KNIT_ASSETS_DIR)) {
      CAPTURE(name, height);
      const auto line = desk.ui.controls.find("menu/example/" + name);
      REQUIRE(line != desk.ui.controls.end());
      CHECK(line->second.y >= 0.0f);
      CHECK(line->second.bottom() <= height);
    }
    CHECK(only<OpenExample>(desk.click("menu/example/vase")).name == "vase");
  }
}
