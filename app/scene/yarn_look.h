// How the yarn is drawn, and what one control shows of a piece on its way from mesh to yarn.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "app/scene/colour.h"

namespace app {

// What the yarn's colour tells.
enum class YarnColours : std::uint8_t { wool, label, stretch };

// By index: what scripts and session files call them.
inline constexpr std::array<std::string_view, 3> yarn_colours_keys{"wool", "label", "stretch"};

inline constexpr int most_stripe_rounds = 1000;

struct YarnLook {
  YarnColours by = YarnColours::wool;
  Colour wool{222, 205, 172}, second{140, 62, 74};
  int stripe_rounds = 0;  // so many rounds of each colour by turns; 0: one colour
  friend bool operator==(const YarnLook&, const YarnLook&) = default;
};

// On the way from what came in to what is knitted.
enum class Looking : std::uint8_t { mesh, stitches, relaxed, yarn };
inline constexpr std::array<std::string_view, 4> looking_keys{"mesh", "stitches", "relaxed", "yarn"};

}  // namespace app
