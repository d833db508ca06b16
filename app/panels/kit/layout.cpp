#include "app/panels/kit/layout.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr float view_share = 1.0f / 3.0f;  // of the window, that the view keeps in each direction

// Of a side: below the first size its controls are cut, beyond the second there is nothing more to see. Plain
// units; `share`: the most of the window's width that it takes unless it is dragged.
struct Side {
  float least, most, share;
};
constexpr Side left_side{264.0f, 640.0f, 0.3f};
constexpr Side right_side{320.0f, 900.0f, 0.34f};
constexpr float least_timeline = 94.0f;
constexpr float most_timeline = 300.0f;

float as_there_is_room(const Side& side, float automatic, float width) {
  return std::floor(std::min(automatic, side.share * width));
}

// `wished` in plain units, or 0.
float side_width(const Side& side, float wished, float automatic, float width, float s) {
  if (wished <= 0.0f) return as_there_is_room(side, automatic, width);
  // In a window too small for its least width it may still have its share.
  const float least = std::min(side.least * s, side.share * width);
  const float most = std::max(least, std::min(side.most * s, (1.0f - view_share) * width));
  return std::floor(std::clamp(wished * s, least, most));
}

float timeline_height(const LayoutWish& wish, float height, float s) {
  const float least = std::min(least_timeline * s, 0.25f * height);
  const float most = std::max(least, std::min(most_timeline * s, 0.4f * height));
  const float wished = wish.bottom > 0.0f ? wish.bottom * s : 104.0f * s;
  return std::floor(wish.bottom > 0.0f ? std::clamp(wished, least, most) : std::min(wished, 0.25f * height));
}

float menu_height(const LayoutWish& wish, float height, float s) {
  return wish.menus ? std::floor(std::min(26.0f * s, 0.1f * height)) : 0.0f;
}

struct Sides {
  float left = 0.0f, right = 0.0f;
};

// Two sides that ask for too much give way alike.
Sides sides_of(const LayoutWish& wish, float width, float s) {
  Sides sides;
  // On a telephone one side alone takes what it can get.
  const bool alone = width < narrow_window * s && wish.parameters != wish.explanation;
  const auto of = [&](Side side) {
    if (alone) side.share = 1.0f - view_share;
    return side;
  };
  if (wish.parameters) {
    const float automatic = std::clamp(0.2f * width, 292.0f * s, 360.0f * s);
    sides.left = side_width(of(left_side), wish.left, automatic, width, s);
  }
  if (wish.explanation) {
    const float automatic = std::clamp(0.24f * width, 344.0f * s, 460.0f * s);
    sides.right = side_width(of(right_side), wish.right, automatic, width, s);
  }
  const float room = std::floor((1.0f - view_share) * width);
  if (sides.left + sides.right <= room) return sides;
  const float factor = room / (sides.left + sides.right);
  return {std::floor(factor * sides.left), std::floor(factor * sides.right)};
}

constexpr float checker_share = 0.6f;          // of the window's width
constexpr float caption_share = 0.3f;          // of the window's height
constexpr float thin_timeline = 18.0f;         // plain units
constexpr float presented_lesson = 264.0f;     // plain units: 20 to 40 characters a line
constexpr float presented_lesson_most = 0.5f;  // of the window's width

// The caption below the view and the thin timeline below both; a lesson at the right of all.
Layout presenting_layout(float width, float height, float scale, const LayoutWish& wish) {
  Layout layout;
  layout.scale = scale;
  layout.window = {0.0f, 0.0f, width, height};
  const float lesson = wish.lesson > 0.0f
                           ? std::floor(std::min(presented_lesson * scale, presented_lesson_most * width))
                           : 0.0f;
  const float thin = std::floor(std::min(thin_timeline * scale, 0.1f * height));
  const float caption = std::floor(caption_share * height);
  const float middle = width - lesson;
  layout.view = {0.0f, 0.0f, middle, height - caption - thin};
  layout.caption = {0.0f, layout.view.bottom(), middle, caption};
  layout.timeline = {0.0f, height - thin, middle, thin};
  if (lesson > 0.0f) layout.lesson = {middle, 0.0f, lesson, height};
  return layout;
}

Layout working_layout(float width, float height, float scale, const LayoutWish& wish) {
  Layout layout;
  layout.scale = scale;
  const float s = layout.scale;
  const float menu = menu_height(wish, height, s);
  const float bottom = wish.timeline ? timeline_height(wish, height, s) : 0.0f;
  const Sides sides = sides_of(wish, width, s);
  const float middle = height - menu - bottom;
  layout.window = {0.0f, 0.0f, width, height};
  layout.menu = {0.0f, 0.0f, width, menu};
  layout.parameters = {0.0f, menu, sides.left, middle};
  layout.view = {sides.left, menu, width - sides.left - sides.right, middle};
  layout.explanation = {width - sides.right, menu, sides.right, middle};
  const float spare = std::max(0.0f, middle - std::ceil(view_share * height));
  // Two strips that ask for too much give way alike.
  const float asked = std::max(1.0f, (wish.lesson + wish.guess) * s);
  const float share = std::min(1.0f, spare / asked);
  const float strip = std::floor(share * wish.lesson * s);
  const float guess = std::floor(share * wish.guess * s);
  layout.view.height -= strip + guess;
  layout.guess = {layout.view.x, layout.view.bottom(), layout.view.width, guess};
  layout.lesson = {layout.view.x, layout.guess.bottom(), layout.view.width, strip};
  layout.timeline = {0.0f, height - bottom, width, bottom};
  return layout;
}

// The text takes more than the half: its lines are long.
Layout checking_layout(float width, float height, float scale, const LayoutWish& wish) {
  Layout layout;
  layout.scale = scale;
  const float menu = menu_height(wish, height, scale);
  const float left = std::floor(checker_share * width);
  layout.window = {0.0f, 0.0f, width, height};
  layout.menu = {0.0f, 0.0f, width, menu};
  layout.checker = {0.0f, menu, left, height - menu};
  layout.view = {left, menu, width - left, height - menu};
  return layout;
}

// The same width for both, and a line between them.
void halve_view(Layout& layout) {
  const float gap = std::max(1.0f, std::floor(2.0f * layout.scale));
  const Box whole = layout.view;
  const float half = std::max(1.0f, std::floor(0.5f * (whole.width - gap)));
  layout.other_view = {whole.x, whole.y, half, whole.height};
  layout.view = {whole.right() - half, whole.y, half, whole.height};
}

}  // namespace

double Layout::view_aspect() const {
  return static_cast<double>(view.width) / static_cast<double>(view.height);
}

Layout layout_of(float width, float height, float scale, const LayoutWish& wish) {
  width = std::max(width, 8.0f);
  height = std::max(height, 8.0f);
  scale = std::max(scale, 0.25f);
  if (wish.checking) return checking_layout(width, height, scale, wish);
  Layout layout = wish.presenting ? presenting_layout(width, height, scale, wish)
                                  : working_layout(width, height, scale, wish);
  if (wish.both) halve_view(layout);
  return layout;
}

float presenting_scale(float width, float height, float scale) {
  const float automatic = std::min({height / 360.0f, width / 460.0f, largest_presenting_scale});
  // In quarters, so that fonts are not made anew at every size that a window is dragged through.
  return std::max({scale, std::floor(4.0f * automatic) / 4.0f, 0.5f});
}

DragRange range_of_left(const Layout& layout) {
  const float most = (1.0f - view_share) * layout.window.width - layout.explanation.width;
  const float high = std::min(left_side.most, most / layout.scale);
  return {std::min(left_side.least, high), high};
}

DragRange range_of_right(const Layout& layout) {
  const float most = (1.0f - view_share) * layout.window.width - layout.parameters.width;
  const float high = std::min(right_side.most, most / layout.scale);
  return {std::min(right_side.least, high), high};
}

DragRange range_of_bottom(const Layout& layout) {
  const float high = std::min(most_timeline, 0.4f * layout.window.height / layout.scale);
  return {std::min(least_timeline, high), high};
}

PixelBox pixels_of(const Box& box, const Box& window, float pixels_per_x, float pixels_per_y) {
  const auto pixel = [](float units, float factor) { return static_cast<int>(std::lround(units * factor)); };
  const int left = pixel(box.x, pixels_per_x);
  const int right = pixel(box.right(), pixels_per_x);
  const int low = pixel(window.height - box.bottom(), pixels_per_y);
  const int high = pixel(window.height - box.y, pixels_per_y);
  return {left, low, right - left, high - low};
}

}  // namespace app
