// Pictures without a ground: what lies between the mesh and nothing is not dark.
#include "app/session/program.h"
#include "app/session/view.h"
#include "app/window/animation.h"
#include "tests/support/catch.h"
#include "tests/support/pictures.h"
#include "tests/support/session.h"

using namespace app;
using test_support::Folder;

namespace {

constexpr int width = 240, height = 180;

Session bare_session(ThemeKind theme) {
  Session session = test_support::finished_small_session();
  session.program->preferences.theme = theme;
  session.view->layers.fill(false);
  session.view->layers[static_cast<std::size_t>(Layer::faces)] = true;
  session.view->layers[static_cast<std::size_t>(Layer::surface)] = true;
  return session;
}

Image picture_of(const Session& session, bool transparent) {
  const Folder folder;
  const auto path = folder.path() / "figure.png";
  REQUIRE(save_figure_headless(session, {path, width, height, false, transparent}) == std::nullopt);
  Image image = test_support::read_png(test_support::read_text(path));
  REQUIRE(image.width == width);
  REQUIRE(image.height == height);
  return image;
}

}  // namespace

TEST_CASE("a transparent picture has nothing where the ground was, and the mesh whole") {
  const Session session = bare_session(ThemeKind::dark);
  const Image clear = picture_of(session, true);
  const Image full = picture_of(session, false);
  const Colour ground = theme_of(ThemeKind::dark).background;
  std::size_t empty = 0, whole = 0, between = 0;
  for (std::size_t i = 0; i < clear.rgba.size(); i += 4) {
    const int alpha = clear.rgba[i + 3];
    CHECK(full.rgba[i + 3] == 255);
    const bool is_ground =
        full.rgba[i] == ground.r && full.rgba[i + 1] == ground.g && full.rgba[i + 2] == ground.b;
    if (alpha == 0) {
      ++empty;
      if (!is_ground) FAIL_CHECK("a pixel of the mesh is missing: " << i / 4);
    } else if (alpha == 255) {
      ++whole;
      for (std::size_t c = i; c < i + 3; ++c) {
        if (clear.rgba[c] != full.rgba[c]) FAIL_CHECK("another colour at " << i / 4);
      }
    } else {
      ++between;
    }
  }
  CHECK(clear.rgba[3] == 0);
  CHECK(empty > 10000);
  CHECK(whole > 8000);
  CHECK(between > 100);  // soft edges
}

TEST_CASE("laid over a ground of one's own, a transparent picture equals one drawn on that ground") {
  Session session = bare_session(ThemeKind::light);
  session.view->layers[static_cast<std::size_t>(Layer::faces)] = false;  // they bear dark symbols
  const Image clear = picture_of(session, true);
  const Image full = picture_of(session, false);
  const Colour ground = theme_of(ThemeKind::light).background;
  const std::array<int, 3> under{ground.r, ground.g, ground.b};
  int farthest = 0, darkest = 255;
  for (std::size_t i = 0; i < clear.rgba.size(); i += 4) {
    const double alpha = clear.rgba[i + 3] / 255.0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double laid = alpha * clear.rgba[i + c] + (1.0 - alpha) * under[c];
      farthest = std::max(farthest, static_cast<int>(std::abs(laid - full.rgba[i + c]) + 0.5));
    }
    // A dark fringe would be colours still multiplied by what they cover.
    if (clear.rgba[i + 3] > 40)
      darkest =
          std::min(darkest, std::max({int{clear.rgba[i]}, int{clear.rgba[i + 1]}, int{clear.rgba[i + 2]}}));
  }
  CHECK(farthest <= 3);
  CHECK(darkest > 50);
}
