// What the searches of this folder go through: how the row before ended, and a cost that nothing has. Private to the folder.
#pragma once

#include <cstdint>
#include <limits>

#include "knit/rhythm/segment_search.h"

namespace knit {

inline constexpr double never = std::numeric_limits<double>::infinity();
inline constexpr std::int32_t segment_ends = 4;
inline constexpr auto after_plain = static_cast<std::int32_t>(SegmentEnd::plain);
inline constexpr auto after_change = static_cast<std::int32_t>(SegmentEnd::changed);
inline constexpr auto after_rest = static_cast<std::int32_t>(SegmentEnd::rested);

}  // namespace knit
