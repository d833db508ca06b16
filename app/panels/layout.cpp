#include "app/panels/layout.h"

#include <algorithm>
#include <cmath>

namespace app {

double Layout::view_aspect() const {
  return static_cast<double>(view.width) / static_cast<double>(view.height);
}

Layout layout_of(float width, float height, float scale) {
  width = std::max(width, 8.0f);
  height = std::max(height, 8.0f);
  Layout layout;
  layout.scale = std::max(scale, 0.25f);
  const float s = layout.scale;
  const float menu = std::floor(std::min(26.0f * s, 0.1f * height));
  const float bottom = std::floor(std::min(104.0f * s, 0.25f * height));
  const float left = std::floor(std::min(std::clamp(0.2f * width, 292.0f * s, 360.0f * s), 0.3f * width));
  const float right = std::floor(std::min(std::clamp(0.24f * width, 344.0f * s, 460.0f * s), 0.34f * width));
  const float middle = height - menu - bottom;
  layout.window = {0.0f, 0.0f, width, height};
  layout.menu = {0.0f, 0.0f, width, menu};
  layout.parameters = {0.0f, menu, left, middle};
  layout.view = {left, menu, width - left - right, middle};
  layout.explanation = {width - right, menu, right, middle};
  layout.timeline = {0.0f, height - bottom, width, bottom};
  return layout;
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
