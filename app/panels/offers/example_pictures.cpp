#include "app/panels/offers/example_pictures.h"

#include <algorithm>
#include <cmath>

#include "app/panels/kit/widgets.h"

namespace app {

namespace {

// Dear ImGui has a pointer for it, later a whole number.
ImTextureID texture_id(std::uint32_t texture) {
  return (ImTextureID)(std::intptr_t)texture;  // NOLINT(performance-no-int-to-ptr,google-readability-casting)
}

constexpr float picture_shape =
    static_cast<float>(example_picture_width_px) / static_cast<float>(example_picture_height_px);

// As large as the box allows, in its middle.
void draw_example_picture(PanelFrame& frame, const std::string& name, ImVec2 from, ImVec2 to) {
  auto& pictures = frame.own<ExamplePictures>();
  pictures.wanted = true;
  const auto found = pictures.textures.find(name);
  if (found == pictures.textures.end()) return;
  const float width = std::min(to.x - from.x, (to.y - from.y) * picture_shape);
  const ImVec2 half(0.5f * width, 0.5f * width / picture_shape);
  const ImVec2 middle(0.5f * (from.x + to.x), 0.5f * (from.y + to.y));
  ImGui::GetWindowDrawList()->AddImage(texture_id(found->second), {middle.x - half.x, middle.y - half.y},
                                       {middle.x + half.x, middle.y + half.y});
}

ImU32 colour_of_text() { return ImGui::GetColorU32(ImGuiCol_Text); }

}  // namespace

bool example_tile(PanelFrame& frame, const std::string& name, ImVec2 size) {
  const bool clicked = ImGui::Button(("##" + name).c_str(), size);
  const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
  const float edge = frame.units(3.0f);
  push_font(frame.fonts.small);  // the longest name fits
  const float line = ImGui::GetTextLineHeight();
  draw_example_picture(frame, name, {from.x + edge, from.y + edge}, {to.x - edge, to.y - line - 2.0f * edge});
  const std::string words = cut_to_width(name, size.x - 2.0f * edge);
  const float x = 0.5f * (from.x + to.x - ImGui::CalcTextSize(words.c_str()).x);
  ImGui::GetWindowDrawList()->AddText({std::floor(x), to.y - line - edge}, colour_of_text(), words.c_str());
  pop_font();
  return clicked;
}

bool example_line(PanelFrame& frame, const std::string& name, bool open, ImVec2 size) {
  const bool clicked = ImGui::Selectable(("##" + name).c_str(), open, 0, size);
  const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
  const float wide = (to.y - from.y) * picture_shape;
  draw_example_picture(frame, name, from, {from.x + wide, to.y});
  const float y = 0.5f * (from.y + to.y - ImGui::GetTextLineHeight());
  ImGui::GetWindowDrawList()->AddText({from.x + wide + frame.units(8.0f), std::floor(y)}, colour_of_text(),
                                      name.c_str());
  return clicked;
}

}  // namespace app
