// The tabs of the right column, in order: the one list of them. A row is a side's key, which scripts, links and
// session files call it by, and the word on its tab. All else follows: the tabs, the key that goes round them, the
// option --side, the entries of all actions, and draw_side<SidePanel::KEY>, which its panel's file defines.
//
// A macro, because enumerators and keys can be made from one row in no other way.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

// clang-format off
#define KNIT_SIDE_PANELS(SIDE) \
  SIDE(step, "Step")           \
  SIDE(tubes, "Tubes")         \
  SIDE(report, "Report")       \
  SIDE(pattern, "Pattern")     \
  SIDE(compare, "Compare")     \
  SIDE(sweep, "Sweep")
// clang-format on

namespace app {

#define KNIT_SIDE(key, words) key,
enum class SidePanel : std::uint8_t { KNIT_SIDE_PANELS(KNIT_SIDE) };
#undef KNIT_SIDE

// By index: what scripts and session files call them.
#define KNIT_SIDE(key, words) std::string_view(#key),
inline constexpr std::array side_keys{KNIT_SIDE_PANELS(KNIT_SIDE)};
#undef KNIT_SIDE

// And on their tabs.
#define KNIT_SIDE(key, words) std::string_view(words),
inline constexpr std::array side_words{KNIT_SIDE_PANELS(KNIT_SIDE)};
#undef KNIT_SIDE

}  // namespace app
