#include "app/scene/contrast.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr int mixing_parts = 32;

double linear_light(std::uint8_t byte) {
  const double c = byte / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

double luminance_of(const Colour& c) {
  return 0.2126 * linear_light(c.r) + 0.7152 * linear_light(c.g) + 0.0722 * linear_light(c.b);
}

Colour mixed_with(const Colour& colour, std::uint8_t extreme, int parts) {
  const auto channel = [&](std::uint8_t byte) {
    return static_cast<std::uint8_t>((byte * (mixing_parts - parts) + extreme * parts) / mixing_parts);
  };
  return {channel(colour.r), channel(colour.g), channel(colour.b)};
}

}  // namespace

double contrast(const Colour& a, const Colour& b) {
  const double x = luminance_of(a), y = luminance_of(b);
  return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

Colour readable_on(const Colour& words, const Colour& ground) {
  constexpr Colour white{255, 255, 255}, black{0, 0, 0};
  const std::uint8_t extreme = contrast(white, ground) >= contrast(black, ground) ? 255 : 0;
  Colour result = opaque(words);
  for (int parts = 1; parts <= mixing_parts && contrast(result, ground) < readable_contrast; ++parts)
    result = mixed_with(words, extreme, parts);
  return result;
}

}  // namespace app
