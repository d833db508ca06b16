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

constexpr int column_count = 3;

void line(const PanelFrame& frame, std::string_view keys, std::string_view words) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  push_font(frame.fonts.mono);
  wrapped_text(keys);
  pop_font();
  ImGui::TableNextColumn();
  wrapped_text(words, palette::faint_text);
}

bool begin_lines(const PanelFrame& frame, const char* id, const char* title) {
  ImGui::Dummy(ImVec2(0.0f, frame.units(3.0f)));
  heading(frame, title);
  if (!ImGui::BeginTable(id, 2)) return false;
  ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, frame.units(124.0f));
  ImGui::TableSetupColumn("words", ImGuiTableColumnFlags_WidthStretch);
  return true;
}

void draw_group(PanelFrame& frame, std::string_view group) {
  const std::string title(group);
  if (!begin_lines(frame, title.c_str(), title.c_str())) return;
  for (const CommandInfo& info : command_table()) {
    if (info.group != group) continue;
    line(frame, keys_of(info), words_of(info));
    frame.mark("help/" + words_of(info));
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

std::size_t lines_of(std::string_view group) {
  const auto table = command_table();
  return 2 + static_cast<std::size_t>(std::count_if(
                 table.begin(), table.end(), [&](const CommandInfo& info) { return info.group == group; }));
}

// The groups from `first` that go into a column: about a third of all lines. The mouse's are in the first.
std::size_t end_of_column(const std::vector<std::string_view>& names, std::size_t first, int column) {
  if (column + 1 == column_count) return names.size();
  const std::size_t mouse = 2 + mouse_help.size();
  std::size_t all = mouse;
  for (const std::string_view name : names) all += lines_of(name);
  std::size_t lines = column == 0 ? mouse : 0;
  std::size_t end = first;
  for (; end < names.size() && lines + lines_of(names[end]) / 2 < all / column_count; ++end)
    lines += lines_of(names[end]);
  return end;
}

}  // namespace

void draw_help(PanelFrame& frame) {
  if (!frame.session.help_open) return;
  const Box& window = frame.layout.window;
  const float width = std::min(frame.units(1200.0f), 0.96f * window.width);
  const float height = std::min(frame.units(540.0f), 0.96f * window.height);
  ImGui::SetNextWindowPos(ImVec2(0.5f * (window.width - width), 0.5f * (window.height - height)));
  ImGui::SetNextWindowSize(ImVec2(width, height));
  push_raised_look(frame);
  bool open = true;
  ImGui::Begin("Keys and mouse", &open,
               ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                   ImGuiWindowFlags_NoSavedSettings);
  frame.ui.controls.insert_or_assign(
      "help", Box{0.5f * (window.width - width), 0.5f * (window.height - height), width, height});
  if (ImGui::BeginTable("columns", column_count)) {
    const auto names = groups();
    std::size_t next = 0;
    for (int column = 0; column < column_count; ++column) {
      ImGui::TableNextColumn();
      const std::size_t end = end_of_column(names, next, column);
      for (; next < end; ++next) draw_group(frame, names[next]);
      if (column == 0) draw_mouse(frame);
    }
    ImGui::EndTable();
  }
  ImGui::End();
  pop_raised_look();
  if (!open) frame.wish(ShowHelp{false});
}

}  // namespace app
