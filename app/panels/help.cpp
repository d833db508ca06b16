// The overlay of keys: a listing of the one table, and what the mouse does.
#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "app/panels/commands.h"
#include "app/panels/view_help.h"
#include "app/panels/widgets.h"

namespace app {

namespace {

void line(const PanelFrame& frame, std::string_view keys, std::string_view words) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  push_font(frame.fonts.mono);
  text(keys);
  pop_font();
  ImGui::TableNextColumn();
  faint_text(words);
}

bool begin_lines(const PanelFrame& frame, const char* id, const char* title) {
  ImGui::Dummy(ImVec2(0.0f, frame.units(3.0f)));
  heading(frame, title);
  if (!ImGui::BeginTable(id, 2)) return false;
  ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, frame.units(116.0f));
  ImGui::TableSetupColumn("words", ImGuiTableColumnFlags_WidthStretch);
  return true;
}

void draw_group(const PanelFrame& frame, std::string_view group) {
  const std::string title(group);
  if (!begin_lines(frame, title.c_str(), title.c_str())) return;
  for (const CommandInfo& info : command_table()) {
    if (info.group == group) line(frame, keys_of(info), words_of(info));
  }
  ImGui::EndTable();
}

// The table's groups in order, each once.
std::vector<std::string_view> groups() {
  std::vector<std::string_view> names;
  for (const CommandInfo& info : command_table()) {
    if (std::find(names.begin(), names.end(), info.group) == names.end()) names.push_back(info.group);
  }
  return names;
}

void draw_mouse(const PanelFrame& frame) {
  if (!begin_lines(frame, "mouse", "The mouse in the view")) return;
  for (const MouseHelp& help : mouse_help) line(frame, help.what, help.words);
  ImGui::EndTable();
}

}  // namespace

void draw_help(PanelFrame& frame) {
  if (!frame.session.help_open) return;
  const Box& window = frame.layout.window;
  const float width = std::min(frame.units(760.0f), 0.92f * window.width);
  const float height = std::min(frame.units(500.0f), 0.92f * window.height);
  ImGui::SetNextWindowPos(ImVec2(0.5f * (window.width - width), 0.5f * (window.height - height)));
  ImGui::SetNextWindowSize(ImVec2(width, height));
  push_raised_look(frame);
  bool open = true;
  ImGui::Begin("Keys and mouse", &open,
               ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                   ImGuiWindowFlags_NoSavedSettings);
  if (ImGui::BeginTable("halves", 2)) {
    const auto names = groups();
    ImGui::TableNextColumn();
    draw_group(frame, names.front());
    draw_mouse(frame);
    ImGui::TableNextColumn();
    for (std::size_t i = 1; i < names.size(); ++i) draw_group(frame, names[i]);
    ImGui::EndTable();
  }
  ImGui::End();
  pop_raised_look();
  if (!open) frame.wish(ShowHelp{false});
}

}  // namespace app
