#pragma once

#include <cstdint>

namespace app {

// Linear-free sRGB bytes as seen on the screen.
struct Colour {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
  friend bool operator==(const Colour&, const Colour&) = default;
};

inline constexpr Colour opaque(Colour c) { return {c.r, c.g, c.b}; }
inline constexpr Colour with_alpha(Colour c, std::uint8_t alpha) { return {c.r, c.g, c.b, alpha}; }

}  // namespace app
