#include "app/panels/widgets.h"

namespace app {

namespace {

// In units of the icon's size around its centre; y points down.
struct Pen {
  ImDrawList& list;
  ImVec2 centre;
  float size;
  ImU32 colour;

  [[nodiscard]] ImVec2 at(float x, float y) const { return {centre.x + x * size, centre.y + y * size}; }
  void triangle(float from, float to) const {  // points towards `to`
    list.AddTriangleFilled(at(from, -0.5f), at(to, 0.0f), at(from, 0.5f), colour);
  }
  void bar(float left, float right) const {
    list.AddRectFilled(at(left, -0.5f), at(right, 0.5f), colour, 0.06f * size);
  }
  void line(float x0, float y0, float x1, float y1) const {
    list.AddLine(at(x0, y0), at(x1, y1), colour, 0.14f * size);
  }
};

void draw_reset(const Pen& pen) {  // an arrow that turns back
  pen.list.PathArcTo(pen.centre, 0.4f * pen.size, -2.3f, 2.6f, 20);
  pen.list.PathStroke(pen.colour, 0, 0.13f * pen.size);
  pen.list.AddTriangleFilled(pen.at(-0.52f, -0.5f), pen.at(-0.5f, 0.02f), pen.at(-0.02f, -0.18f), pen.colour);
}

}  // namespace

void draw_icon(ImDrawList& list, Icon icon, ImVec2 centre, float size, ImU32 colour) {
  const Pen pen{list, centre, size, colour};
  switch (icon) {
    case Icon::first:
      pen.bar(-0.5f, -0.34f);
      pen.triangle(0.45f, -0.3f);
      return;
    case Icon::back:
      pen.triangle(0.15f, -0.45f);
      pen.bar(0.27f, 0.43f);
      return;
    case Icon::play:
      pen.triangle(-0.35f, 0.5f);
      return;
    case Icon::pause:
      pen.bar(-0.38f, -0.12f);
      pen.bar(0.12f, 0.38f);
      return;
    case Icon::forward:
      pen.bar(-0.43f, -0.27f);
      pen.triangle(-0.15f, 0.45f);
      return;
    case Icon::last:
      pen.triangle(-0.45f, 0.3f);
      pen.bar(0.34f, 0.5f);
      return;
    case Icon::cross:
      pen.line(-0.34f, -0.34f, 0.34f, 0.34f);
      pen.line(-0.34f, 0.34f, 0.34f, -0.34f);
      return;
    case Icon::reset:
      draw_reset(pen);
      return;
  }
}

bool icon_button(const char* id, Icon icon, ImVec2 size, bool lit) {
  ImGui::PushID(id);
  if (lit) ImGui::PushStyleColor(ImGuiCol_Button, style::vector(style::accent));
  if (lit) ImGui::PushStyleColor(ImGuiCol_ButtonHovered, style::vector(style::accent));
  const bool clicked = ImGui::Button("##icon", size);
  if (lit) ImGui::PopStyleColor(2);
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  const ImVec2 centre(0.5f * (low.x + high.x), 0.5f * (low.y + high.y));
  const float side = high.y - low.y < high.x - low.x ? high.y - low.y : high.x - low.x;
  const ImU32 colour = lit ? style::packed(palette::background) : ImGui::GetColorU32(ImGuiCol_Text);
  draw_icon(*ImGui::GetWindowDrawList(), icon, centre, 0.5f * side, colour);
  ImGui::PopID();
  return clicked;
}

}  // namespace app
