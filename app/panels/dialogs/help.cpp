// The overlay of keys: a listing of the one table, and what the mouse does. However long the table grows, it is set
// so that all of it can be seen at once: in columns as equal as can be, and smaller where that is not enough.
#include <algorithm>
#include <string>
#include <vector>

#include "app/panels/dialogs/action_palette.h"
#include "app/panels/dialogs/dialogs.h"
#include "app/panels/kit/commands.h"
#include "app/panels/kit/view_help.h"
#include "app/panels/kit/widgets.h"
#include "app/session/view.h"

namespace app {

namespace {

constexpr std::size_t column_count = 3;

struct HelpLine {
  std::string keys, words, mark;
};
struct HelpGroup {
  std::string title;
  std::vector<HelpLine> lines;
};

// The table's groups in its order, and the mouse.
std::vector<HelpGroup> help_groups() {
  std::vector<HelpGroup> groups;
  for (const CommandInfo& info : command_table()) {
    auto group =
        std::find_if(groups.begin(), groups.end(), [&](const HelpGroup& g) { return g.title == info.group; });
    if (group == groups.end()) group = groups.insert(groups.end(), {std::string(info.group), {}});
    group->lines.push_back({keys_of(info), words_of(info), "help/" + words_of(info)});
  }
  HelpGroup mouse{"The mouse", {}};
  for (const MouseHelp& help : mouse_help)
    mouse.lines.push_back({std::string(help.what), std::string(help.words), ""});
  mouse.lines.push_back({"Click a word", "Where it is underlined: what it means", ""});
  groups.push_back(std::move(mouse));
  return groups;
}

// In which size and how wide it is set.
struct HelpSetting {
  ImFont* keys_font;
  ImFont* words_font;
  float width;       // of a column
  float keys_width;  // within it
  float gap;         // between lines
  float between;     // groups
  float ways;        // what leads on, below the last column
};

float height_of(const std::string& words, float width) {
  return ImGui::CalcTextSize(words.c_str(), nullptr, false, width).y;
}

float height_of(const HelpSetting& setting, const HelpLine& line) {
  push_font(setting.keys_font);
  const float keys = height_of(line.keys, setting.keys_width - ImGui::GetFontSize());
  pop_font();
  push_font(setting.words_font);
  const float words = height_of(line.words, setting.width - setting.keys_width);
  pop_font();
  return std::max(keys, words) + setting.gap;
}

float height_of(const HelpSetting& setting, const HelpGroup& group) {
  float height = ImGui::GetTextLineHeightWithSpacing() + setting.between;
  for (const HelpLine& line : group.lines) height += height_of(setting, line);
  return height;
}

// How many groups stand in each column.
struct HelpColumns {
  std::vector<std::size_t> ends;
  float height = 0.0f;  // of the tallest
};

// Groups stay whole and in order; of all ways to break them the one whose tallest column is shortest.
HelpColumns columns_of(const HelpSetting& setting, const std::vector<HelpGroup>& groups) {
  std::vector<float> below(groups.size() + 1, 0.0f);  // heights summed
  for (std::size_t i = 0; i < groups.size(); ++i) below[i + 1] = below[i] + height_of(setting, groups[i]);
  HelpColumns best{{groups.size(), groups.size(), groups.size()}, below.back() + setting.ways};
  static_assert(column_count == 3);
  for (std::size_t first = 0; first <= groups.size(); ++first) {
    for (std::size_t second = first; second <= groups.size(); ++second) {
      const float height =
          std::max({below[first], below[second] - below[first], below.back() - below[second] + setting.ways});
      if (height < best.height) best = {{first, second, groups.size()}, height};
    }
  }
  return best;
}

void draw_group(PanelFrame& frame, const HelpSetting& setting, const HelpGroup& group, float left) {
  ImGui::SetCursorPosX(left);
  const float top = ImGui::GetCursorPosY();
  // The heading's line ends with the column.
  ImGui::BeginChild(group.title.c_str(), ImVec2(setting.width, ImGui::GetTextLineHeight()), false,
                    ImGuiWindowFlags_NoScrollbar);
  heading(frame, group.title.c_str());
  ImGui::EndChild();
  float y = top + ImGui::GetTextLineHeightWithSpacing();
  for (const HelpLine& line : group.lines) {
    ImGui::SetCursorPos(ImVec2(left, y));
    ImGui::BeginGroup();
    push_font(setting.keys_font);
    ImGui::PushTextWrapPos(left + setting.keys_width - ImGui::GetFontSize());
    text(line.keys);
    ImGui::PopTextWrapPos();
    pop_font();
    ImGui::SetCursorPos(ImVec2(left + setting.keys_width, y));
    push_font(setting.words_font);
    ImGui::PushTextWrapPos(left + setting.width);
    faint_text(line.words);
    ImGui::PopTextWrapPos();
    pop_font();
    ImGui::EndGroup();
    if (!line.mark.empty()) frame.mark(line.mark);
    y += height_of(setting, line);
  }
  ImGui::SetCursorPosY(y + setting.between);
}

// What explains more than keys.
void draw_ways_on(PanelFrame& frame) {
  const auto way = [&](const char* words, const char* mark, const char* help) {
    const bool clicked = ImGui::Button(words);
    frame.mark(mark);
    tooltip(frame, help);
    ImGui::SameLine();
    if (clicked) frame.wish(ShowHelp{false});
    return clicked;
  };
  if (way("All actions", "help-to/actions", "Everything that can be done, found by name."))
    frame.wish(ShowActionPalette{true});
  if (way("Glossary", "help-to/glossary", "What the words mean.")) frame.wish(ShowGlossary{true, {}});
  if (way("Lessons", "help-to/lessons", "Guided steps through the algorithm.")) {
    frame.own<ActionPaletteState>().begin_with = "lesson ";
    frame.wish(ShowActionPalette{true});
  }
  ImGui::NewLine();
}

void draw_columns(PanelFrame& frame, const HelpSetting& setting, const std::vector<HelpGroup>& groups,
                  const HelpColumns& columns, float gap) {
  const ImVec2 origin = ImGui::GetCursorPos();
  std::size_t next = 0;
  for (std::size_t column = 0; column < column_count; ++column) {
    const float left = origin.x + static_cast<float>(column) * (setting.width + gap);
    ImGui::SetCursorPosY(origin.y);
    for (; next < columns.ends[column]; ++next) draw_group(frame, setting, groups[next], left);
    ImGui::SetCursorPosX(left);
  }
  draw_ways_on(frame);
  ImGui::SetCursorPos(ImVec2(origin.x, origin.y + columns.height));
}

}  // namespace

void draw_help(PanelFrame& frame) {
  if (!frame.session.view->dialogs.help_open) return;
  const Box& window = frame.layout.window;
  const ImGuiStyle& look = ImGui::GetStyle();
  const float width = std::min(frame.units(1200.0f), 0.98f * window.width);
  const float gap = frame.units(22.0f);
  const float column = (width - 2.0f * look.WindowPadding.x - 2.0f * gap) / static_cast<float>(column_count);
  const auto groups = help_groups();
  HelpSetting setting{frame.fonts.mono,
                      frame.fonts.text,
                      column,
                      std::min(frame.units(132.0f), 0.4f * column),
                      frame.units(2.0f),
                      frame.units(8.0f),
                      ImGui::GetFrameHeightWithSpacing()};
  HelpColumns columns = columns_of(setting, groups);
  // The title and the window's edges.
  const float around = ImGui::GetFrameHeightWithSpacing() + 2.0f * look.WindowPadding.y;
  const float below = frame.layout.menu.bottom();  // the menu bar stays in sight
  const float room = 0.99f * (window.height - below);
  if (columns.height + around > room) {
    setting.words_font = frame.fonts.small;
    setting.gap = 0.0f;
    columns = columns_of(setting, groups);
  }
  if (columns.height + around > room) {
    setting.keys_font = frame.fonts.small;
    setting.between = frame.units(1.0f);
    columns = columns_of(setting, groups);
  }
  const float height = std::min(columns.height + around, room);
  const Box box{0.5f * (window.width - width), below + 0.5f * (window.height - below - height), width,
                height};
  ImGui::SetNextWindowPos(ImVec2(box.x, box.y));
  ImGui::SetNextWindowSize(ImVec2(width, height));
  push_raised_look(frame);
  bool open = true;
  ImGui::Begin("Keys and mouse", &open,
               ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                   ImGuiWindowFlags_NoSavedSettings);
  frame.memory.controls.insert_or_assign("help", box);
  draw_columns(frame, setting, groups, columns, gap);
  ImGui::End();
  pop_raised_look();
  if (!open) frame.wish(ShowHelp{false});
}

}  // namespace app
