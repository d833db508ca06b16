#include "app/panels/style.h"

namespace app::style {

namespace {

void set_sizes(ImGuiStyle& style) {
  style.WindowPadding = ImVec2(10.0f, 8.0f);
  style.FramePadding = ImVec2(7.0f, 3.0f);
  style.ItemSpacing = ImVec2(7.0f, 5.0f);
  style.ItemInnerSpacing = ImVec2(6.0f, 4.0f);
  style.CellPadding = ImVec2(5.0f, 1.0f);
  style.ScrollbarSize = 11.0f;
  style.GrabMinSize = 11.0f;
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

void set_surfaces(ImGuiStyle& style) {
  ImVec4* const colours = style.Colors;
  colours[ImGuiCol_Text] = vector(palette::text);
  colours[ImGuiCol_TextDisabled] = vector(palette::faint_text);
  colours[ImGuiCol_WindowBg] = vector(panel);
  colours[ImGuiCol_ChildBg] = ImVec4(0.0f, 0.0f, 0.0f, 0.0f);
  colours[ImGuiCol_PopupBg] = vector(panel);
  colours[ImGuiCol_Border] = vector(outline);
  colours[ImGuiCol_MenuBarBg] = vector(palette::background);
  colours[ImGuiCol_TitleBg] = vector(raised);
  colours[ImGuiCol_TitleBgActive] = vector(raised);
  colours[ImGuiCol_Separator] = vector(outline);
  colours[ImGuiCol_TableHeaderBg] = vector(panel);
  colours[ImGuiCol_TableBorderStrong] = vector(outline);
  colours[ImGuiCol_TableBorderLight] = vector(outline);
  colours[ImGuiCol_ScrollbarBg] = ImVec4(0.0f, 0.0f, 0.0f, 0.0f);
  colours[ImGuiCol_ModalWindowDimBg] = ImVec4(0.0f, 0.0f, 0.0f, 0.55f);
}

void set_controls(ImGuiStyle& style) {
  ImVec4* const colours = style.Colors;
  colours[ImGuiCol_FrameBg] = vector(raised);
  colours[ImGuiCol_FrameBgHovered] = vector(hovered);
  colours[ImGuiCol_FrameBgActive] = vector(pressed);
  colours[ImGuiCol_Button] = vector(raised);
  colours[ImGuiCol_ButtonHovered] = vector(hovered);
  colours[ImGuiCol_ButtonActive] = vector(pressed);
  colours[ImGuiCol_Header] = vector(hovered);
  colours[ImGuiCol_HeaderHovered] = vector(hovered);
  colours[ImGuiCol_HeaderActive] = vector(pressed);
  colours[ImGuiCol_ScrollbarGrab] = vector(hovered);
  colours[ImGuiCol_ScrollbarGrabHovered] = vector(pressed);
  colours[ImGuiCol_ScrollbarGrabActive] = vector(accent);
  colours[ImGuiCol_CheckMark] = vector(accent);
  colours[ImGuiCol_SliderGrab] = vector(accent);
  colours[ImGuiCol_SliderGrabActive] = vector(palette::text);
  colours[ImGuiCol_TextSelectedBg] = vector({accent.r, accent.g, accent.b, 100});
}

}  // namespace

ImVec4 vector(Colour c) {
  const auto part = [](std::uint8_t byte) { return static_cast<float>(byte) / 255.0f; };
  return {part(c.r), part(c.g), part(c.b), part(c.a)};
}

void apply(float scale) {
  ImGuiStyle style;
  set_sizes(style);
  set_surfaces(style);
  set_controls(style);
  style.ScaleAllSizes(scale);
  ImGui::GetStyle() = style;
}

}  // namespace app::style
