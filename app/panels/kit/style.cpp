#include "app/panels/kit/style.h"

namespace app {

const Theme& theme() {
  const void* kept = ImGui::GetIO().UserData;
  return kept != nullptr ? *static_cast<const Theme*>(kept) : dark_theme;
}

namespace style {

namespace {

void set_sizes(ImGuiStyle& style) {
  style.WindowPadding = ImVec2(10.0f, 8.0f);
  style.FramePadding = ImVec2(7.0f, 3.0f);
  style.ItemSpacing = ImVec2(7.0f, 5.0f);
  style.ItemInnerSpacing = ImVec2(6.0f, 4.0f);
  style.CellPadding = ImVec2(5.0f, 1.0f);
  style.ScrollbarSize = 11.0f;
  style.GrabMinSize = 11.0f;
  style.DisabledAlpha = disabled_alpha;
  style.WindowRounding = 0.0f;
  style.ChildRounding = 4.0f;
  style.FrameRounding = 4.0f;
  style.PopupRounding = 6.0f;
  style.ScrollbarRounding = 6.0f;
  style.GrabRounding = 4.0f;
  style.WindowBorderSize = 0.0f;
  style.ChildBorderSize = 1.0f;
  style.PopupBorderSize = 1.0f;
  style.FrameBorderSize = 0.0f;
  style.WindowTitleAlign = ImVec2(0.5f, 0.5f);
  style.WindowMenuButtonPosition = ImGuiDir_None;
}

void set_surfaces(ImGuiStyle& style, const Theme& theme) {
  ImVec4* const colours = style.Colors;
  colours[ImGuiCol_Text] = vector(theme.text);
  colours[ImGuiCol_TextDisabled] = vector(theme.faint_text);
  colours[ImGuiCol_WindowBg] = vector(theme.panel);
  colours[ImGuiCol_ChildBg] = ImVec4(0.0f, 0.0f, 0.0f, 0.0f);
  colours[ImGuiCol_PopupBg] = vector(theme.panel);
  colours[ImGuiCol_Border] = vector(theme.outline);
  colours[ImGuiCol_MenuBarBg] = vector(theme.background);
  colours[ImGuiCol_TitleBg] = vector(theme.raised);
  colours[ImGuiCol_TitleBgActive] = vector(theme.raised);
  colours[ImGuiCol_Separator] = vector(theme.outline);
  colours[ImGuiCol_TableHeaderBg] = vector(theme.panel);
  colours[ImGuiCol_TableBorderStrong] = vector(theme.outline);
  colours[ImGuiCol_TableBorderLight] = vector(theme.outline);
  colours[ImGuiCol_ScrollbarBg] = ImVec4(0.0f, 0.0f, 0.0f, 0.0f);
  colours[ImGuiCol_ModalWindowDimBg] = ImVec4(0.0f, 0.0f, 0.0f, 0.55f);
}

void set_controls(ImGuiStyle& style, const Theme& theme) {
  ImVec4* const colours = style.Colors;
  colours[ImGuiCol_FrameBg] = vector(theme.raised);
  colours[ImGuiCol_FrameBgHovered] = vector(theme.hovered);
  colours[ImGuiCol_FrameBgActive] = vector(theme.pressed);
  colours[ImGuiCol_Button] = vector(theme.raised);
  colours[ImGuiCol_ButtonHovered] = vector(theme.hovered);
  colours[ImGuiCol_ButtonActive] = vector(theme.pressed);
  colours[ImGuiCol_Header] = vector(theme.hovered);
  colours[ImGuiCol_HeaderHovered] = vector(theme.hovered);
  colours[ImGuiCol_HeaderActive] = vector(theme.pressed);
  colours[ImGuiCol_ScrollbarGrab] = vector(theme.hovered);
  colours[ImGuiCol_ScrollbarGrabHovered] = vector(theme.pressed);
  colours[ImGuiCol_ScrollbarGrabActive] = vector(theme.accent);
  colours[ImGuiCol_CheckMark] = vector(theme.accent);
  colours[ImGuiCol_SliderGrab] = vector(theme.accent);
  colours[ImGuiCol_SliderGrabActive] = vector(theme.text);
  colours[ImGuiCol_TextSelectedBg] = vector({theme.accent.r, theme.accent.g, theme.accent.b, 100});
}

}  // namespace

ImVec4 vector(Colour c) {
  const auto part = [](std::uint8_t byte) { return static_cast<float>(byte) / 255.0f; };
  return {part(c.r), part(c.g), part(c.b), part(c.a)};
}

void apply(float scale, const Theme& theme) {
  ImGuiStyle style;
  set_sizes(style);
  set_surfaces(style, theme);
  set_controls(style, theme);
  style.ScaleAllSizes(scale);
  ImGui::GetStyle() = style;
  // Panels ask for it by theme(); ImGui only carries it.
  ImGui::GetIO().UserData = const_cast<Theme*>(&theme);
}

}  // namespace style

}  // namespace app
