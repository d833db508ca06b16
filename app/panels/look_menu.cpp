#include "app/panels/look_menu.h"

#include <array>
#include <cmath>
#include <string>

#include "app/core/recent.h"
#include "app/panels/commands.h"
#include "app/panels/panel_buttons.h"
#include "app/panels/widgets.h"

namespace app {

namespace {

constexpr float longest_line = 420.0f;  // plain units of a recent file's name and place

struct NamedScale {
  const char* words;
  double scale;
};
constexpr std::array named_scales{NamedScale{"Smaller", 0.85}, NamedScale{"Normal", 1.0},
                                  NamedScale{"Larger", 1.25}, NamedScale{"Projector", projector_scale}};
constexpr std::array theme_words{"Dark", "Light"};

bool begin_submenu(PanelFrame& frame, const char* label) {
  const bool open = ImGui::BeginMenu(label);
  if (!open) frame.mark("menu/" + std::string(label));  // open, the last item is the menu's own
  return open;
}

bool check_item(PanelFrame& frame, const char* label, const char* keys, bool on) {
  const bool clicked = ImGui::MenuItem(label, keys, on);
  frame.mark("menu/" + std::string(label));
  return clicked;
}

void command_item(PanelFrame& frame, Command command) {
  const CommandInfo& info = info_of(command);
  const auto action = info.make(frame.session);
  const bool clicked =
      ImGui::MenuItem(words_of(info).c_str(), keys_of(info).c_str(), false, action.has_value());
  frame.mark("menu/" + words_of(info));
  if (clicked && action) frame.wish(*action);
}

void draw_panels_menu(PanelFrame& frame) {
  if (!begin_submenu(frame, "Panels")) return;
  for (const Panel panel : {Panel::parameters, Panel::side, Panel::timeline}) {
    const bool open = frame.session.preferences.shows(panel);
    if (check_item(frame, name_of(panel), nullptr, open)) frame.wish(ShowPanel{panel, !open});
  }
  ImGui::Separator();
  command_item(frame, Command::only_view);
  if (check_item(frame, "Reset the layout", nullptr, false)) frame.wish(ResetLayout{});
  tooltip(frame, "All panels, each as wide as there is room.");
  ImGui::EndMenu();
}

void draw_theme_menu(PanelFrame& frame) {
  if (!begin_submenu(frame, "Theme")) return;
  for (std::size_t i = 0; i < theme_words.size(); ++i) {
    const auto kind = static_cast<ThemeKind>(i);
    if (check_item(frame, theme_words[i], nullptr, frame.session.preferences.theme == kind))
      frame.wish(SetTheme{kind});
  }
  ImGui::Separator();
  command_item(frame, Command::theme);
  ImGui::EndMenu();
}

void draw_size_menu(PanelFrame& frame) {
  if (!begin_submenu(frame, "Size")) return;
  const double now = frame.session.preferences.scale;
  for (const NamedScale& named : named_scales) {
    if (check_item(frame, named.words, nullptr, std::abs(now - named.scale) < 1e-6))
      frame.wish(SetScale{named.scale});
  }
  ImGui::Separator();
  for (const Command command : {Command::larger, Command::smaller, Command::plain_size})
    command_item(frame, command);
  ImGui::EndMenu();
}

}  // namespace

void draw_recent_menu(PanelFrame& frame) {
  const std::vector<std::string>& recent = frame.session.preferences.recent;
  if (!begin_submenu(frame, "Open recent")) return;
  for (std::size_t i = 0; i < recent.size(); ++i) {
    const RecentWords words = words_of_recent(recent[i]);
    ImGui::PushID(static_cast<int>(i));
    const std::string what = cut_to_width(words.what, frame.units(0.6f * longest_line));
    const float room = frame.units(longest_line) - ImGui::CalcTextSize(what.c_str()).x;
    // As a shortcut it stands apart, in the faint colour.
    if (ImGui::MenuItem(what.c_str(), cut_to_width(words.where, room).c_str()))
      frame.wish(opening_of_recent(recent[i]));
    frame.mark("recent/" + std::to_string(i));
    tooltip(frame, recent[i]);
    ImGui::PopID();
  }
  if (recent.empty()) ImGui::MenuItem("Nothing yet", nullptr, false, false);
  ImGui::Separator();
  const bool forget = ImGui::MenuItem("Forget these", nullptr, false, !recent.empty());
  frame.mark("recent/forget");
  if (forget) frame.wish(ForgetRecent{});
  tooltip(frame, "Empties this list; the files stay where they are.");
  ImGui::EndMenu();
}

void draw_look_menus(PanelFrame& frame) {
  draw_panels_menu(frame);
  draw_theme_menu(frame);
  draw_size_menu(frame);
  const bool motion = frame.session.preferences.motion;
  if (check_item(frame, "Motion", nullptr, motion)) frame.wish(SetMotion{!motion});
  tooltip(frame, "Short movements in the view that show what changed. Off: everything is there at once.");
}

}  // namespace app
