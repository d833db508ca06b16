#include "app/render/animation_file.h"

#include <algorithm>
#include <cstring>

namespace app {

namespace {

const std::uint8_t* pixel(const Image& image, int x, int y) {
  const auto at =
      static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
  return image.rgba.data() + 4 * at;
}

bool same_row(const Image& a, const Image& b, int y) {
  return std::memcmp(pixel(a, 0, y), pixel(b, 0, y), 4 * static_cast<std::size_t>(a.width)) == 0;
}

}  // namespace

OpenedAnimation open_animation(const std::filesystem::path& path, const AnimationShape& shape) {
  switch (animation_kind_of(path).value_or(AnimationKind::folder)) {
    case AnimationKind::gif:
      return open_gif(path, shape);
    case AnimationKind::apng:
      return open_apng(path, shape);
    case AnimationKind::folder:
      break;
  }
  return open_frame_folder(path, shape);
}

PixelPatch changed_patch(const Image& before, const Image& now) {
  int top = 0, bottom = now.height;
  while (top < bottom && same_row(before, now, top)) ++top;
  while (bottom > top && same_row(before, now, bottom - 1)) --bottom;
  if (top == bottom) return {};
  int left = now.width, right = 0;
  for (int y = top; y < bottom; ++y) {
    const auto differs = [&](int x) { return std::memcmp(pixel(before, x, y), pixel(now, x, y), 4) != 0; };
    for (int x = 0; x < left; ++x) {
      if (differs(x)) left = x;
    }
    for (int x = now.width; x > right; --x) {
      if (differs(x - 1)) right = x;
    }
  }
  return {left, top, right - left, bottom - top};
}

Image cut_out(const Image& image, const PixelPatch& patch) {
  Image part{.width = patch.width, .height = patch.height, .rgba = {}};
  const std::size_t row = 4 * static_cast<std::size_t>(patch.width);
  part.rgba.reserve(row * static_cast<std::size_t>(patch.height));
  for (int y = patch.y; y < patch.y + patch.height; ++y) {
    const std::uint8_t* from = pixel(image, patch.x, y);
    part.rgba.insert(part.rgba.end(), from, from + row);
  }
  return part;
}

}  // namespace app
