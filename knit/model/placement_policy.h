// Stage 4: where main stitches, increases and decreases go. Each policy has its row in knit/stitches/placement.cpp.
// by_itself is none of them, and chooses one by what rows are made from: thesis for rings, nearest for contours.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace knit {

enum class PlacementPolicy : std::uint8_t { thesis, even, nearest, by_itself };

// By index: what options, session files and the window call them.
inline constexpr std::array<std::string_view, 4> placement_names{"thesis", "even", "nearest", "auto"};

inline constexpr std::string_view placement_help =
    "Where mains and shaping go. thesis: its rules (R0-R4). even: sections as even as can be. "
    "nearest: where the rows' stitches lie closest to each other. auto: nearest with contours, thesis with "
    "rings.";

}  // namespace knit
