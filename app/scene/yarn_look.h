// How the yarn is drawn, and what one control shows of a piece on its way from mesh to yarn.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "app/scene/colour.h"

namespace app {

// What the yarn's colour tells.
enum class YarnColours : std::uint8_t { wool, label, stretch };

// By index: what scripts and session files call them.
inline constexpr std::array<std::string_view, 3> yarn_colours_keys{"wool", "label", "stretch"};

inline constexpr int most_stripe_rounds = 1000;

// In widths of a stitch. Thicker yarn overlaps.
inline constexpr double least_yarn_radius = 0.02, most_yarn_radius = 0.2;

inline constexpr int usual_yarn_easing = 30;  // iterations, where it is asked for

struct YarnLook {
  YarnColours by = YarnColours::wool;
  Colour wool{222, 205, 172}, second{140, 62, 74};
  int stripe_rounds = 0;  // so many rounds of each colour by turns; 0: one colour
  double radius = 0.0;    // in widths of a stitch; 0: an eighth, where neighbouring heads just touch
  int easing = 0;         // iterations that make room where loops overlap [knit/yarn/eased_yarn.h]
  friend bool operator==(const YarnLook&, const YarnLook&) = default;
};

// "auto" is 0; else a number of stitch widths from least to most. None for any other text.
std::optional<double> read_yarn_radius(std::string_view text);

// On the way from what came in to what is knitted.
enum class Looking : std::uint8_t { mesh, stitches, relaxed, yarn };
inline constexpr std::array<std::string_view, 4> looking_keys{"mesh", "stitches", "relaxed", "yarn"};

}  // namespace app
