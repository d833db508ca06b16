#include "app/panels/kit/widgets.h"

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

// A clock.
void draw_slow(const Pen& pen) {
  pen.list.AddCircle(pen.centre, 0.45f * pen.size, pen.colour, 20, 0.12f * pen.size);
  pen.line(0.0f, -0.28f, 0.0f, 0.04f);
  pen.line(0.0f, 0.04f, 0.2f, 0.14f);
}

// An arrow that goes round.
void draw_loop(const Pen& pen) {
  pen.list.PathArcTo(pen.centre, 0.38f * pen.size, -0.5f, 4.9f, 24);
  pen.list.PathStroke(pen.colour, 0, 0.13f * pen.size);
  pen.list.AddTriangleFilled(pen.at(0.02f, -0.62f), pen.at(0.02f, -0.12f), pen.at(0.44f, -0.38f), pen.colour);
}

// Half a turn with a head at its near end; side -1: to the left, 1: to the right.
void draw_turn(const Pen& pen, float side) {
  constexpr float pi = 3.14159265f;
  const ImVec2 middle = pen.at(0.0f, 0.08f);
  pen.list.PathArcTo(middle, 0.36f * pen.size, side < 0.0f ? -0.9f * pi : -0.1f * pi,
                     side < 0.0f ? 0.5f * pi : -1.5f * pi, 20);
  pen.list.PathStroke(pen.colour, 0, 0.13f * pen.size);
  const ImVec2 tip = pen.at(side * 0.42f, 0.24f);
  const ImVec2 outer = pen.at(side * 0.62f, -0.14f);
  const ImVec2 inner = pen.at(side * 0.1f, -0.12f);
  if (side < 0.0f) {
    pen.list.AddTriangleFilled(outer, inner, tip, pen.colour);
  } else {
    pen.list.AddTriangleFilled(inner, outer, tip, pen.colour);
  }
}

void draw_sheet(const Pen& pen, ImVec2 low, ImVec2 high) {
  pen.list.AddRect(low, high, pen.colour, 0.08f * pen.size, 0, 0.11f * pen.size);
}

void draw_copy(const Pen& pen) {  // a sheet, and the corner of one behind it
  draw_sheet(pen, pen.at(-0.12f, -0.2f), pen.at(0.42f, 0.5f));
  pen.line(-0.38f, 0.24f, -0.38f, -0.46f);
  pen.line(-0.42f, -0.46f, 0.16f, -0.46f);
}

void draw_paste(const Pen& pen) {  // a board with a clip and two lines
  draw_sheet(pen, pen.at(-0.38f, -0.38f), pen.at(0.38f, 0.5f));
  pen.list.AddRectFilled(pen.at(-0.18f, -0.52f), pen.at(0.18f, -0.26f), pen.colour, 0.06f * pen.size);
  pen.line(-0.18f, 0.02f, 0.18f, 0.02f);
  pen.line(-0.18f, 0.26f, 0.18f, 0.26f);
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
    case Icon::slow:
      draw_slow(pen);
      return;
    case Icon::loop:
      draw_loop(pen);
      return;
    case Icon::undo:
      draw_turn(pen, -1.0f);
      return;
    case Icon::redo:
      draw_turn(pen, 1.0f);
      return;
    case Icon::copy:
      draw_copy(pen);
      return;
    case Icon::paste:
      draw_paste(pen);
      return;
  }
}

bool icon_button(const char* id, Icon icon, ImVec2 size, bool lit) {
  ImGui::PushID(id);
  if (lit) ImGui::PushStyleColor(ImGuiCol_Button, style::vector(theme().accent));
  if (lit) ImGui::PushStyleColor(ImGuiCol_ButtonHovered, style::vector(theme().accent));
  const bool clicked = ImGui::Button("##icon", size);
  if (lit) ImGui::PopStyleColor(2);
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  const ImVec2 centre(0.5f * (low.x + high.x), 0.5f * (low.y + high.y));
  const float side = high.y - low.y < high.x - low.x ? high.y - low.y : high.x - low.x;
  const ImU32 colour = lit ? style::packed(theme().on_accent) : ImGui::GetColorU32(ImGuiCol_Text);
  draw_icon(*ImGui::GetWindowDrawList(), icon, centre, 0.5f * side, colour);
  ImGui::PopID();
  return clicked;
}

}  // namespace app
