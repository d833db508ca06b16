// Stage 4: where main stitches, increases and decreases go. Each policy has its row in knit/stitches/placement.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace knit {

enum class PlacementPolicy : std::uint8_t { thesis, even, nearest };

// By index: what options, session files and the window call them.
inline constexpr std::array<std::string_view, 3> placement_names{"thesis", "even", "nearest"};

inline constexpr std::string_view placement_help =
    "Where mains and shaping go. thesis: its rules (R0-R4). even: sections as even as can be. "
    "nearest: where the rows' stitches lie closest to each other.";

}  // namespace knit
