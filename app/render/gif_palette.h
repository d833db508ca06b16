// At most 255 colours for a picture that has more: the program's flat colours exactly, its shades as near as
// can be.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "app/render/image.h"

namespace app {

struct PaletteColour {
  std::uint8_t r = 0, g = 0, b = 0;
  friend bool operator==(const PaletteColour&, const PaletteColour&) = default;
};

struct PalettedImage {
  std::vector<PaletteColour> colours;  // 1 to 255
  std::vector<std::uint8_t> pixels;    // an index a pixel; `unchanged_index` for those left out
};
inline constexpr std::uint8_t unchanged_index = 255;

// Of pictures one after the other: a colour that the first one had is shown the same in all, so that what
// comes back does not stand out from what never went.
class GifPalette {
 public:
  // `before` of the same size: pixels that are as they were there are left out. Null: none is.
  PalettedImage next(const Image& image, const Image* before);

 private:
  std::unordered_map<std::uint32_t, std::uint32_t> shown_as_;  // of the first picture, 0xrrggbb
};

}  // namespace app
