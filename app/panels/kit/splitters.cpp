// The lines between the panels: dragged they give a panel more room or less, a double click gives it back what it
// had by itself. They are seen only under the pointer.
#include <algorithm>
#include <cmath>
#include <string>

#include "app/panels/kit/splitters.h"
#include "app/panels/kit/widgets.h"
#include "app/session/program.h"

namespace app {

namespace {

constexpr float reach = 6.0f;  // plain units across

struct Splitter {
  Split split;
  Box line;      // in the middle of what can be gripped, without any width
  bool upright;  // moves sideways
  float size;    // of its panel now, window units
  float grows;   // 1: with the pointer's coordinate; -1: against it
  DragRange range;
};

const char* help_of(Split split) {
  return split == Split::bottom ? "Drag: a higher or lower timeline. Double click: as there is room."
                                : "Drag: a wider or narrower panel. Double click: as there is room.";
}

// Whether the pointer has been there for a while: who only crosses the line needs no help.
bool rests(bool hovered) {
  constexpr float seconds = 0.7f;
  ImGuiStorage& storage = *ImGui::GetStateStorage();
  float& for_long = *storage.GetFloatRef(ImGui::GetID("for long"));
  for_long = hovered ? for_long + ImGui::GetIO().DeltaTime : 0.0f;
  return for_long > seconds;
}

// What a drag asks for, in whole plain units; it begins at the size that the panel has.
float dragged_to(const PanelFrame& frame, const Splitter& splitter) {
  ImGuiStorage& storage = *ImGui::GetStateStorage();
  const ImGuiID began = ImGui::GetID("began");
  if (ImGui::IsItemActivated()) storage.SetFloat(began, splitter.size);
  const ImVec2 by = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, 0.0f);
  const float moved = splitter.grows * (splitter.upright ? by.x : by.y);
  const float wanted = (storage.GetFloat(began) + moved) / frame.layout.scale;
  // Rounding must not take it beyond the end, where the other panels would have to give way.
  const float inside = std::clamp(wanted, splitter.range.low, splitter.range.high);
  return std::min(std::round(inside), std::floor(splitter.range.high));
}

void handle(PanelFrame& frame, const Splitter& splitter) {
  const double chosen = frame.session.program->preferences.splits[static_cast<std::size_t>(splitter.split)];
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    if (chosen > 0.0) frame.wish(SetSplit{splitter.split, 0.0});
    return;
  }
  if (!ImGui::IsItemActive()) return;
  const float wanted = dragged_to(frame, splitter);
  const ImVec2 by = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, 0.0f);
  const bool moved = std::abs(splitter.upright ? by.x : by.y) >= 1.0f;
  const bool differs = std::abs(wanted - splitter.size / frame.layout.scale) >= 1.0f;
  if (moved && differs && wanted > 0.0f) frame.wish(SetSplit{splitter.split, static_cast<double>(wanted)});
}

void draw_line(const PanelFrame& frame, const Splitter& splitter, bool lit) {
  const Box& line = splitter.line;
  const float thick = lit ? frame.units(2.0f) : std::max(1.0f, std::floor(frame.units(1.0f)));
  const Colour colour = lit ? theme().accent : theme().outline;
  const ImVec2 low(std::floor(line.x - (splitter.upright ? 0.5f * thick : 0.0f)),
                   std::floor(line.y - (splitter.upright ? 0.0f : 0.5f * thick)));
  const ImVec2 high(splitter.upright ? low.x + thick : line.right(),
                    splitter.upright ? line.bottom() : low.y + thick);
  ImGui::GetWindowDrawList()->AddRectFilled(low, high, style::packed(colour));
}

void draw_splitter(PanelFrame& frame, const Splitter& splitter) {
  const std::string name = "split/" + std::string(split_keys[static_cast<std::size_t>(splitter.split)]);
  const float wide = frame.units(reach);
  const Box& line = splitter.line;
  const Box grip = splitter.upright ? Box{line.x - 0.5f * wide, line.y, wide, line.height}
                                    : Box{line.x, line.y - 0.5f * wide, line.width, wide};
  if (grip.width < 1.0f || grip.height < 1.0f) return;
  begin_panel(name.c_str(), grip,
              ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar |
                  ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::InvisibleButton("grip", ImVec2(grip.width, grip.height));
  frame.mark(name);
  const bool lit = ImGui::IsItemHovered() || ImGui::IsItemActive();
  if (lit) ImGui::SetMouseCursor(splitter.upright ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
  draw_line(frame, splitter, lit);
  handle(frame, splitter);
  if (rests(ImGui::IsItemHovered())) tooltip(frame, help_of(splitter.split));
  ImGui::End();
}

}  // namespace

// Before the panels: the first window of several that stay where they are is on top.
void draw_splitters(PanelFrame& frame) {
  const Layout& layout = frame.layout;
  const Preferences& chosen = frame.session.program->preferences;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0f, 1.0f));
  if (chosen.shows(Panel::parameters)) {
    const Box& box = layout.parameters;
    draw_splitter(
        frame,
        {Split::left, {box.right(), box.y, 0.0f, box.height}, true, box.width, 1.0f, range_of_left(layout)});
  }
  if (chosen.shows(Panel::side)) {
    const Box& box = layout.explanation;
    draw_splitter(
        frame,
        {Split::right, {box.x, box.y, 0.0f, box.height}, true, box.width, -1.0f, range_of_right(layout)});
  }
  if (chosen.shows(Panel::timeline)) {
    const Box& box = layout.timeline;
    draw_splitter(
        frame,
        {Split::bottom, {box.x, box.y, box.width, 0.0f}, false, box.height, -1.0f, range_of_bottom(layout)});
  }
  ImGui::PopStyleVar(2);
}

}  // namespace app
