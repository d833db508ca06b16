// The look of the panels: one calm dark theme around palette::background.
#pragma once

#include <imgui.h>

#include "app/core/palette.h"

namespace app::style {

inline constexpr float text_size = 16.0f;  // for ImGuiGlue::load_fonts, times the scale

inline constexpr Colour panel{31, 35, 42};
inline constexpr Colour raised{43, 48, 57};
inline constexpr Colour hovered{57, 64, 76};
inline constexpr Colour pressed{70, 80, 95};
inline constexpr Colour outline{52, 58, 68};
inline constexpr Colour accent{96, 160, 224};
inline constexpr Colour warning{230, 170, 60};

inline constexpr ImU32 packed(Colour c) { return IM_COL32(c.r, c.g, c.b, c.a); }
inline constexpr ImU32 packed(Colour c, std::uint8_t alpha) { return IM_COL32(c.r, c.g, c.b, alpha); }
ImVec4 vector(Colour colour);

// Once after fonts are loaded, and again when the scale changes. Between frames.
void apply(float scale);

}  // namespace app::style
