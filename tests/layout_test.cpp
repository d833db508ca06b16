// Where panels stand: they never overlap, and the view keeps its share, whatever is closed and dragged.
#include "app/panels/kit/layout.h"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "tests/support/catch.h"

namespace {

using namespace app;

bool overlap(const Box& a, const Box& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

bool inside(const Box& a, const Box& b) {
  return a.x >= b.x && a.y >= b.y && a.right() <= b.right() && a.bottom() <= b.bottom();
}

struct Window {
  float width, height, scale;
};

std::vector<Window> windows() {
  std::vector<Window> all;
  for (const auto& [width, height] : {std::pair{640.0f, 400.0f},
                                      {1280.0f, 720.0f},
                                      {1366.0f, 768.0f},
                                      {1920.0f, 1080.0f},
                                      {3840.0f, 2160.0f},
                                      {800.0f, 1400.0f},
                                      {97.0f, 61.0f}}) {
    for (const float scale : {0.75f, 1.0f, 1.5f, 2.0f, 5.0f}) all.push_back({width, height, scale});
  }
  return all;
}

std::vector<LayoutWish> wishes() {
  std::vector<LayoutWish> all;
  for (int shown = 0; shown < 8; ++shown) {
    for (const float size : {0.0f, 1.0f, 333.0f, 9000.0f}) {
      for (const float lesson : {0.0f, 150.0f}) {
        all.push_back({(shown & 1) != 0, (shown & 2) != 0, (shown & 4) != 0, size, size, size, lesson});
        all.push_back(
            {(shown & 1) != 0, (shown & 2) != 0, (shown & 4) != 0, size, 0.0f, 0.0f, lesson, 116.0f});
      }
    }
  }
  return all;
}

constexpr float third = 1.0f / 3.0f;

}  // namespace

TEST_CASE("the checker and its view take all below the menu, for every size and scale") {
  LayoutWish wish;
  wish.checking = true;
  for (const Window& window : windows()) {
    const Layout layout = layout_of(window.width, window.height, window.scale, wish);
    CHECK(layout.checker.y == layout.menu.bottom());
    CHECK(layout.checker.right() == layout.view.x);
    CHECK(layout.view.right() == layout.window.right());
    CHECK(layout.view.bottom() == layout.window.bottom());
    CHECK(layout.view.width >= third * layout.window.width);
    CHECK(layout.timeline.width + layout.parameters.width + layout.explanation.width == 0.0f);
  }
}

TEST_CASE("no panels overlap and all of the window is used, for every size, scale, closed panel and drag") {
  for (const Window& window : windows()) {
    for (const LayoutWish& wish : wishes()) {
      INFO(window.width << " x " << window.height << " by " << window.scale << ", shown " << wish.parameters
                        << wish.explanation << wish.timeline << ", dragged to " << wish.left << ' '
                        << wish.right << ", lesson " << wish.lesson);
      const Layout layout = layout_of(window.width, window.height, window.scale, wish);
      const std::array boxes{layout.menu,     layout.parameters, layout.view, layout.explanation,
                             layout.timeline, layout.lesson,     layout.guess};
      float area = 0.0f;
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        REQUIRE(inside(boxes[i], layout.window));
        area += boxes[i].width * boxes[i].height;
        for (std::size_t j = 0; j < i; ++j) REQUIRE_FALSE(overlap(boxes[i], boxes[j]));
      }
      REQUIRE(area == Approx(window.width * window.height));
      REQUIRE(layout.view.width >= third * window.width - 1.0f);
      REQUIRE(layout.view.height >= third * window.height - 1.0f);
      REQUIRE((layout.parameters.width > 0.0f) == wish.parameters);
      REQUIRE((layout.explanation.width > 0.0f) == wish.explanation);
      REQUIRE((layout.timeline.height > 0.0f) == wish.timeline);
    }
  }
}

TEST_CASE("closed panels give their room to the view") {
  LayoutWish wish;
  wish.parameters = wish.explanation = wish.timeline = false;
  const Layout layout = layout_of(1280, 720, 1, wish);
  CHECK(layout.view.width == 1280.0f);
  CHECK(layout.view.height == 720.0f - layout.menu.height);
  CHECK(layout.view_aspect() == Approx(1280.0 / (720.0 - 26.0)));
}

TEST_CASE("a panel is as wide as it is dragged, at every scale, and stays so in another window") {
  for (const float scale : {1.0f, 1.5f, 2.0f}) {
    const LayoutWish wish{true, true, true, 300.0f, 400.0f, 150.0f, 0.0f};
    for (const float wider : {1.0f, 1.5f}) {
      const Layout layout = layout_of(wider * 1280 * scale, wider * 720 * scale, scale, wish);
      CHECK(layout.parameters.width == 300.0f * scale);
      CHECK(layout.explanation.width == 400.0f * scale);
      CHECK(layout.timeline.height == 150.0f * scale);
    }
  }
}

TEST_CASE("a drag to the end of its range gives exactly that, and moves no other panel") {
  const Layout before = layout_of(1280, 720, 1);
  for (const float left : {range_of_left(before).low, range_of_left(before).high}) {
    const Layout after = layout_of(1280, 720, 1, {true, true, true, left, 0.0f, 0.0f, 0.0f});
    CHECK(after.parameters.width == std::floor(left));
    CHECK(after.explanation == before.explanation);
  }
  for (const float right : {range_of_right(before).low, range_of_right(before).high}) {
    const Layout after = layout_of(1280, 720, 1, {true, true, true, 0.0f, right, 0.0f, 0.0f});
    CHECK(after.explanation.width == std::floor(right));
    CHECK(after.parameters == before.parameters);
  }
  for (const float bottom : {range_of_bottom(before).low, range_of_bottom(before).high}) {
    const Layout after = layout_of(1280, 720, 1, {true, true, true, 0.0f, 0.0f, bottom, 0.0f});
    CHECK(after.timeline.height == std::floor(bottom));
  }
}

TEST_CASE("in a narrow window one side alone takes all but the view's share") {
  const float width = 390.0f;
  REQUIRE(width < narrow_window);
  const Layout parameters = layout_of(width, 844, 1, {true, false, true});
  CHECK(parameters.parameters.width == Approx(260.0f).margin(1.0));
  CHECK(parameters.view.width >= width / 3.0f - 1.0f);
  const Layout both = layout_of(width, 844, 1, {true, true, true});
  CHECK(both.parameters.width < 0.31f * width);
}

TEST_CASE("without menus the view begins at the top") {
  LayoutWish wish;
  const float before = layout_of(1280, 720, 1, wish).view.height;
  wish.menus = false;
  const Layout layout = layout_of(1280, 720, 1, wish);
  CHECK(layout.menu.height == 0.0f);
  CHECK(layout.view.y == 0.0f);
  CHECK(layout.view.height > before);
}
