// The menu bar: what the program does by name, how it looks, and what was opened lately.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "app/explain/destination.h"
#include "app/files/export.h"
#include "app/files/preferences_file.h"
#include "app/panels/dialogs/dialogs.h"
#include "app/panels/dialogs/menu_parts.h"
#include "app/panels/kit/commands.h"
#include "app/panels/kit/frame.h"
#include "app/panels/kit/panel_buttons.h"
#include "app/panels/kit/run_cache.h"
#include "app/panels/kit/widgets.h"
#include "app/panels/offers/example_pictures.h"
#include "app/script/command_line.h"
#include "app/session/document.h"
#include "app/session/presets.h"
#include "app/session/program.h"
#include "app/session/view.h"

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

void command_item(PanelFrame& frame, const CommandInfo& info, const char* label, bool enabled = true) {
  const bool chosen = ImGui::MenuItem(label, keys_of(info).c_str(), false, enabled);
  frame.mark("menu/" + std::string(label));
  if (!chosen) return;
  if (auto action = info.make(frame.session)) frame.wish(std::move(*action));
}

// Also while nothing is open: enabled where there is an action to do.
void look_item(PanelFrame& frame, Command command) {
  const CommandInfo& info = info_of(command);
  command_item(frame, info, words_of(info).c_str(), info.make(frame.session).has_value());
}

void draw_panels_menu(PanelFrame& frame) {
  if (!begin_submenu(frame, "Panels")) return;
  for (const Panel panel : {Panel::parameters, Panel::side, Panel::timeline}) {
    const bool open = frame.session.program->preferences.shows(panel);
    if (check_item(frame, name_of(panel), nullptr, open)) frame.wish(ShowPanel{panel, !open});
  }
  ImGui::Separator();
  look_item(frame, Command::only_view);
  if (check_item(frame, "Reset the layout", nullptr, false)) frame.wish(ResetLayout{});
  tooltip(frame, "All panels, each as wide as there is room.");
  ImGui::EndMenu();
}

void draw_theme_menu(PanelFrame& frame) {
  if (!begin_submenu(frame, "Theme")) return;
  for (std::size_t i = 0; i < theme_words.size(); ++i) {
    const auto kind = static_cast<ThemeKind>(i);
    if (check_item(frame, theme_words[i], nullptr, frame.session.program->preferences.theme == kind))
      frame.wish(SetTheme{kind});
  }
  ImGui::Separator();
  look_item(frame, Command::theme);
  ImGui::EndMenu();
}

void draw_size_menu(PanelFrame& frame) {
  if (!begin_submenu(frame, "Size")) return;
  const double now = frame.session.program->preferences.scale;
  for (const NamedScale& named : named_scales) {
    if (check_item(frame, named.words, nullptr, std::abs(now - named.scale) < 1e-6))
      frame.wish(SetScale{named.scale});
  }
  ImGui::Separator();
  for (const Command command : {Command::larger, Command::smaller, Command::plain_size})
    look_item(frame, command);
  ImGui::EndMenu();
}

void draw_recent_menu(PanelFrame& frame) {
  const std::vector<std::string>& recent = frame.session.program->preferences.recent;
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
  const bool following = frame.session.view->following;
  if (check_item(frame, "Turn to what happens", nullptr, following)) frame.wish(SetFollowing{!following});
  tooltip(frame, "The view turns by itself when the step is behind the surface, never while you drag it.");
  const bool motion = frame.session.program->preferences.motion;
  if (check_item(frame, "Motion", nullptr, motion)) frame.wish(SetMotion{!motion});
  tooltip(frame, "Short movements in the view that show what changed. Off: everything is there at once.");
}

bool begin_menu(PanelFrame& frame, const char* label, const char* control) {
  const bool open = ImGui::BeginMenu(label);
  if (!open) {
    frame.mark(control);  // open, the last item is the menu's own
  } else if (key_pressed(Key::Escape)) {
    ImGui::CloseCurrentPopup();
  }
  return open;
}

void command_item(PanelFrame& frame, Command command) {
  const CommandInfo& info = info_of(command);
  command_item(frame, info, words_of(info).c_str(), frame.timeline() != nullptr);
}

// As high as the window allows.
void draw_examples_menu(PanelFrame& frame) {
  if (!begin_submenu(frame, "Examples")) return;
  const auto examples = list_examples(frame.session.program->assets);
  const float spacing = ImGui::GetStyle().ItemSpacing.y;
  const auto count = static_cast<float>(std::max<std::size_t>(1, examples.size()));
  const float room = (frame.layout.window.height - frame.units(30.0f)) / count - spacing;
  const float height = std::floor(std::clamp(room, ImGui::GetTextLineHeight(), frame.units(30.0f)));
  for (const std::string& name : examples) {
    const bool open = frame.session.document && frame.session.document->source.example == name;
    if (example_line(frame, name, open, ImVec2(frame.units(170.0f), height))) frame.wish(OpenExample{name});
    frame.mark("menu/example/" + name);
  }
  if (examples.empty()) ImGui::MenuItem("No examples were found", nullptr, false, false);
  ImGui::EndMenu();
}

void draw_file_menu(PanelFrame& frame) {
  if (!begin_menu(frame, "File", "menu/file")) return;
  command_item(frame, info_of(Command::open), "Open...");
  draw_examples_menu(frame);
  draw_recent_menu(frame);
  command_item(frame, info_of(Command::checker), "Check a written pattern");
  command_item(frame, info_of(Command::close_mesh), "Close", frame.timeline() != nullptr);
  ImGui::Separator();
  for (const ExportInfo* kind : exports_of_menu()) {
    const std::string label = "Save the " + std::string(kind->words) + "...";
    if (ImGui::MenuItem(label.c_str(), nullptr, false, frame.timeline() != nullptr)) {
      ask_to_save(frame, kind->key);
    }
    frame.mark("menu/" + label);
  }
  draw_figure_menu(frame);
  ImGui::Separator();
  command_item(frame, info_of(Command::quit), "Quit");
  ImGui::EndMenu();
}

void draw_edit_menu(PanelFrame& frame) {
  if (!begin_menu(frame, "Edit", "menu/edit")) return;
  for (const Command command : {Command::undo, Command::redo}) command_item(frame, command);
  ImGui::Separator();
  for (const Command command : {Command::copy, Command::paste, Command::copy_link})
    command_item(frame, command);
  ImGui::Separator();
  for (const Command command : {Command::pin, Command::swap}) command_item(frame, command);
  ImGui::EndMenu();
}

// Each about what is shown or selected; where nothing is, the answer says what to click.
void draw_questions(PanelFrame& frame) {
  for (const WhyQuestion& question : why_questions()) {
    const std::string words(question.words);
    const bool asked = ImGui::MenuItem(words.c_str(), nullptr, false, frame.timeline() != nullptr);
    frame.mark("menu/" + words);
    tooltip(frame, question.help);
    if (asked) frame.wish(GoTo{std::string(question.where)});
  }
}

void draw_why_menu(PanelFrame& frame) {
  if (!begin_menu(frame, "Why", "menu/why")) return;
  draw_questions(frame);
  ImGui::Separator();
  for (const Command command :
       {Command::go_back, Command::go_forward, Command::next_touch, Command::last_touch})
    command_item(frame, command);
  ImGui::Separator();
  for (const Command command : {Command::next_break, Command::last_break}) command_item(frame, command);
  ImGui::Separator();
  for (const Command command : {Command::step_over, Command::step_into, Command::step_out, Command::over_back,
                                Command::into_back, Command::out_back})
    command_item(frame, command);
  ImGui::EndMenu();
}

void draw_preset_menu(PanelFrame& frame) {
  if (!begin_menu(frame, "Presets", "menu/presets")) return;
  for (const Preset& preset : presets()) {
    const std::string title(preset.title);
    if (ImGui::MenuItem(title.c_str(), nullptr, false, frame.timeline() != nullptr))
      frame.wish(ApplyPreset{std::string(preset.key)});
    frame.mark("menu/" + title);
    tooltip(frame, preset.about);
  }
  ImGui::EndMenu();
}

void draw_go_menu(PanelFrame& frame) {
  if (!begin_menu(frame, "Go", "menu/go")) return;
  command_item(frame, info_of(Command::go_to), "Go to...", frame.timeline() != nullptr);
  ImGui::Separator();
  for (const Command command : {Command::first, Command::last}) command_item(frame, command);
  ImGui::Separator();
  for (const Command command : {Command::back_item, Command::forward_item, Command::back_row,
                                Command::forward_row, Command::back_stage, Command::forward_stage}) {
    command_item(frame, command);
  }
  ImGui::Separator();
  for (const Command command : {Command::play, Command::play_back, Command::faster, Command::slower,
                                Command::slow_motion, Command::loop}) {
    command_item(frame, command);
  }
  if (frame.timeline() != nullptr && !frame.own<RunCache>().stages().empty()) {
    ImGui::Separator();
    for (const RunCache::Stretch& stretch : frame.own<RunCache>().stages()) {
      const std::string label = "To the end of " + capitalised(knit::name_of(stretch.stage));
      if (ImGui::MenuItem(label.c_str())) frame.wish(SeekTo{stretch.end});
    }
  }
  ImGui::EndMenu();
}

void draw_view_menu(PanelFrame& frame) {
  if (!begin_menu(frame, "View", "menu/view")) return;
  for (std::size_t i = 0; i < layer_count; ++i) {
    const auto layer = static_cast<Layer>(i);
    const bool on = frame.session.view->shows(layer);
    if (ImGui::MenuItem(std::string(name_of(layer)).c_str(), keys_of(info_of(layer)).c_str(), on)) {
      frame.wish(SetLayer{layer, !on});
    }
  }
  ImGui::Separator();
  const bool placed = frame.session.view->positions == Positions::placed;
  if (check_item(frame, "Stitches as placed", nullptr, placed))
    frame.wish(SetPositions{placed ? Positions::settled : Positions::placed});
  tooltip(frame, "Stitches that have settled are shown, measured and saved where they were placed.");
  const bool relaxed = frame.session.view->positions == Positions::relaxed;
  if (check_item(frame, "Stitches in the air", nullptr, relaxed))
    frame.wish(SetPositions{relaxed ? Positions::settled : Positions::relaxed});
  tooltip(frame, "A piece that has been relaxed is shown, measured and saved as it comes off the needles.");
  ImGui::Separator();
  command_item(frame, Command::frame_all);
  command_item(frame, Command::side);
  for (const Command command : {Command::chart, Command::knit_along, Command::both})
    command_item(frame, command);
  ImGui::Separator();
  look_item(frame, Command::present);
  tooltip(
      frame,
      "The view, what the step says in large words, row and count, a thin timeline. F5 or Esc comes back.");
  if (check_item(frame, "Ring round the pointer", nullptr, frame.session.view->ring))
    frame.wish(SetRing{!frame.session.view->ring});
  tooltip(frame, "While presenting, so that everybody sees where you point.");
  ImGui::Separator();
  draw_look_menus(frame);
  ImGui::EndMenu();
}

void draw_help_menu(PanelFrame& frame) {
  if (!begin_menu(frame, "Help", "menu/help")) return;
  command_item(frame, info_of(Command::help), "Keys and mouse");
  command_item(frame, info_of(Command::action_palette), "All actions");
  command_item(frame, info_of(Command::glossary), "Glossary");
  ImGui::Separator();
  const std::string version = "knit-mesh " + std::string(program_version());
  ImGui::MenuItem(version.c_str(), nullptr, false, false);
  ImGui::EndMenu();
}

// What is open, at the right end of the bar.
void draw_title(const PanelFrame& frame) {
  const knit::Timeline* timeline = frame.timeline();
  if (timeline == nullptr) return;
  const knit::Mesh& mesh = timeline->input().mesh;
  const std::string counts =
      with_commas(mesh.positions.size()) + " vertices, " + with_commas(mesh.triangles.size()) + " triangles";
  const std::string title = mesh.name + "   " + counts;
  const float width = ImGui::CalcTextSize(title.c_str()).x;
  const float left = frame.layout.menu.right() - width - room_for_toggles(frame);
  if (left < ImGui::GetCursorPosX() + frame.units(16.0f)) return;
  ImGui::SetCursorPosX(left);
  text(mesh.name);
  ImGui::SameLine();
  ImGui::SetCursorPosX(left + width - ImGui::CalcTextSize(counts.c_str()).x);
  faint_text(counts);
}

}  // namespace

void draw_menu(PanelFrame& frame) {
  const float spare = frame.layout.menu.height - ImGui::GetFontSize();
  const ImVec2 padding(ImGui::GetStyle().FramePadding.x, spare > 0.0f ? 0.5f * spare : 0.0f);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, padding);
  const bool open = ImGui::BeginMainMenuBar();
  ImGui::PopStyleVar();
  if (!open) return;
  draw_file_menu(frame);
  draw_edit_menu(frame);
  draw_preset_menu(frame);
  draw_go_menu(frame);
  draw_why_menu(frame);
  draw_view_menu(frame);
  draw_lesson_menu(frame);
  draw_help_menu(frame);
  draw_title(frame);
  draw_toggles(frame);
  ImGui::EndMainMenuBar();
}

}  // namespace app
