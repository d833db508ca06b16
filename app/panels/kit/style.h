// The look of the panels: calm, in the colours of a theme.
#pragma once

#include <imgui.h>

#include "app/scene/palette.h"

namespace app {

// As the last style::apply laid it down for the ImGui context that is current.
const Theme& theme();

namespace style {

inline constexpr float text_size = 16.0f;  // for ImGuiGlue::load_fonts, times the scale

inline constexpr ImU32 packed(Colour c) { return IM_COL32(c.r, c.g, c.b, c.a); }
inline constexpr ImU32 packed(Colour c, std::uint8_t alpha) { return IM_COL32(c.r, c.g, c.b, alpha); }
// Of what cannot be used now: fainter, and to be read all the same.
inline constexpr float disabled_alpha = 0.7f;
ImVec4 vector(Colour colour);

// Once after fonts are loaded, and again when the scale changes. Between frames.
void apply(float scale, const Theme& theme = dark_theme);

}  // namespace style

}  // namespace app
