#include "app/panels/dialogs/file_dialogs.h"
#include "app/panels/dialogs/dialogs.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "app/files/session_file.h"
#include "app/lessons/lesson.h"
#include "app/panels/kit/widgets.h"
#include "app/session/document.h"
#include "app/session/learning.h"
#include "app/session/program.h"
#include "app/session/view.h"

namespace app {

namespace {

namespace fs = std::filesystem;

bool is_openable(const fs::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending == ".obj" || ending == ".json" || is_pattern_file(path);
}

void enter_folder(OpenDialog& dialog, const fs::path& wanted) {
  std::error_code error;
  const fs::path folder = fs::canonical(wanted, error);
  std::vector<OpenDialog::Entry> entries;
  fs::directory_iterator it(error ? wanted : folder, fs::directory_options::skip_permission_denied, error);
  for (; !error && it != fs::directory_iterator(); it.increment(error)) {
    std::error_code unknown;
    const std::string name = it->path().filename().string();
    const bool is_folder = it->is_directory(unknown);
    if (name.empty() || name[0] == '.' || (!is_folder && !is_openable(it->path()))) continue;
    entries.push_back({name, is_folder});
  }
  if (error) {
    dialog.trouble = wanted.string() + " cannot be read: " + error.message() + ".";
    return;
  }
  std::sort(entries.begin(), entries.end(),
            [](const auto& a, const auto& b) { return a.folder != b.folder ? a.folder : a.name < b.name; });
  if (folder.has_parent_path() && folder != folder.root_path()) entries.insert(entries.begin(), {"..", true});
  dialog.folder = folder;
  dialog.entries = std::move(entries);
  dialog.trouble.clear();
  dialog.chosen = -1;
  dialog.path.set("");
  ++dialog.field;
  dialog.refocus = true;
}

void begin_dialog(const Session& session, OpenDialog& dialog) {
  dialog.shown = true;
  std::error_code error;
  fs::path folder = dialog.folder;
  if (folder.empty() && session.document && !session.document->source.file.empty())
    folder = fs::absolute(session.document->source.file, error).parent_path();
  if (folder.empty()) folder = fs::current_path(error);
  enter_folder(dialog, folder.empty() ? fs::path("/") : folder);
}

void close_open_dialog(PanelFrame& frame) {
  frame.own<OpenDialog>().shown = false;
  frame.wish(ShowOpenDialog{false});
  ImGui::CloseCurrentPopup();
}

void take(PanelFrame& frame, const fs::path& path) {
  std::error_code error;
  frame.own<OpenDialog>().refocus = true;
  if (fs::is_directory(path, error)) {
    enter_folder(frame.own<OpenDialog>(), path);
  } else if (!fs::exists(path, error)) {
    frame.own<OpenDialog>().trouble = path.string() + " does not exist.";
  } else {
    frame.wish(opening_of(path));
    close_open_dialog(frame);
  }
}

// Nothing: neither typed nor chosen. What is typed is meant from the folder shown.
std::optional<fs::path> chosen_path(const OpenDialog& dialog) {
  if (dialog.chosen >= 0) return dialog.folder / dialog.entries[static_cast<std::size_t>(dialog.chosen)].name;
  const std::string typed = dialog.path.text();
  if (typed.empty()) return std::nullopt;
  const char* const home = std::getenv("HOME");
  if (typed.rfind("~/", 0) == 0 && home != nullptr) return fs::path(home) / typed.substr(2);
  return dialog.folder / typed;
}

// Gives true when an entry was double-clicked.
bool draw_entries(PanelFrame& frame, float height) {
  OpenDialog& dialog = frame.own<OpenDialog>();
  bool opened = false;
  ImGui::BeginChild("entries", ImVec2(0.0f, height), true);
  const auto count = static_cast<int>(dialog.entries.size());
  const int move = (key_pressed(Key::Down, true) ? 1 : 0) - (key_pressed(Key::Up, true) ? 1 : 0);
  if (move != 0 && count > 0) dialog.chosen = std::clamp(dialog.chosen + move, 0, count - 1);
  for (int i = 0; i < count; ++i) {
    const OpenDialog::Entry& entry = dialog.entries[static_cast<std::size_t>(i)];
    ImGui::PushID(i);
    const std::string label = entry.folder ? entry.name + "/" : entry.name;
    if (ImGui::Selectable(label.c_str(), dialog.chosen == i, ImGuiSelectableFlags_AllowDoubleClick)) {
      dialog.chosen = i;
      opened = opened || ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    }
    frame.mark("open/" + entry.name);
    if (move != 0 && dialog.chosen == i) ImGui::SetScrollHereY();
    ImGui::PopID();
  }
  if (count == 0)
    faint_text("No folder, no mesh (.obj), no session (.json) and no pattern (.txt, .md, .html) here.");
  ImGui::EndChild();
  return opened;
}

void draw_open_inside(PanelFrame& frame) {
  OpenDialog& dialog = frame.own<OpenDialog>();
  faint_text(cut_to_width(dialog.folder.string(), ImGui::GetContentRegionAvail().x));
  ImGui::PushID(dialog.field);
  // While something is held, the focus would go back to it.
  if (dialog.refocus && !ImGui::IsAnyMouseDown() && !ImGui::IsAnyItemActive()) {
    ImGui::SetWindowFocus();  // back from the list, where a click went
    ImGui::SetKeyboardFocusHere();
    dialog.refocus = false;
  }
  ImGui::SetNextItemWidth(-1.0f);
  if (ImGui::InputText("##path", dialog.path.bytes.data(), dialog.path.bytes.size())) dialog.chosen = -1;
  frame.mark("open/path");
  ImGui::PopID();
  const bool entered = key_pressed(Key::Enter) || key_pressed(Key::KeypadEnter);
  const float below = 2.0f * ImGui::GetFrameHeightWithSpacing();
  const bool opened = draw_entries(frame, ImGui::GetContentRegionAvail().y - below);
  if (dialog.trouble.empty()) {
    faint_text("Type a path, or choose with the arrow keys or the mouse. Enter opens.");
  } else {
    text(cut_to_width(dialog.trouble, ImGui::GetContentRegionAvail().x));
    tooltip(frame, dialog.trouble);
  }
  const bool clicked = ImGui::Button("Open", ImVec2(frame.units(90.0f), 0.0f));
  frame.mark("open/open");
  ImGui::SameLine();
  const bool cancelled = ImGui::Button("Cancel", ImVec2(frame.units(90.0f), 0.0f));
  if (cancelled || key_pressed(Key::Escape)) {
    close_open_dialog(frame);
  } else if (entered || opened || clicked) {
    if (const auto path = chosen_path(dialog)) take(frame, *path);
  }
}

}  // namespace

void draw_open_dialog(PanelFrame& frame) {
  OpenDialog& dialog = frame.own<OpenDialog>();
  const bool wanted = frame.session.view->dialogs.open_dialog_open;
  if (!wanted && !dialog.shown) return;
  const char* const title = "Open a mesh, a session or a pattern";
  if (wanted && !dialog.shown) {
    begin_dialog(frame.session, dialog);
    ImGui::OpenPopup(title);
  }
  const Box& window = frame.layout.window;
  ImGui::SetNextWindowPos(ImVec2(0.5f * window.width, 0.5f * window.height), ImGuiCond_Always,
                          ImVec2(0.5f, 0.5f));
  ImGui::SetNextWindowSize(ImVec2(std::min(frame.units(600.0f), 0.9f * window.width),
                                  std::min(frame.units(460.0f), 0.9f * window.height)));
  push_raised_look(frame);
  const bool open =
      ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove);
  pop_raised_look();
  if (!open) {
    dialog.shown = false;
    if (wanted) frame.wish(ShowOpenDialog{false});
    return;
  }
  if (!wanted) {  // closed by another hand: a script, or a file dropped on the window
    dialog.shown = false;
    ImGui::CloseCurrentPopup();
  } else {
    draw_open_inside(frame);
  }
  ImGui::EndPopup();
}

namespace {

// "lesson-3-picking-a-row.html": the number as the lessons' list counts, none for one that is not of the list. Its own, whatever
// mesh the page shows, so that no lesson's sheet lies in wait for another's.
std::string worksheet_name(const PanelFrame& frame, const Lesson& lesson) {
  const std::vector<LessonEntry> listed = list_lessons(frame.session.program->assets);
  const auto found = std::find_if(listed.begin(), listed.end(),
                                  [&](const LessonEntry& entry) { return entry.key == lesson.key; });
  std::string name = "lesson-";
  if (found != listed.end()) name += std::to_string(found - listed.begin() + 1) + "-";
  for (const char c : lesson.key) {
    name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '-';  // no folder, no hidden sign
  }
  return name + ".html";
}

std::string suggestion(const PanelFrame& frame, const ExportInfo& kind) {
  const auto& run = frame.session.learning->lesson;
  if (kind.key == "worksheet" && run) return worksheet_name(frame, *run->lesson);
  const std::string name = frame.timeline() != nullptr ? frame.timeline()->input().mesh.name : "";
  return (name.empty() ? "mesh" : name) + std::string(kind.ending);
}

void close_save_dialog(PanelFrame& frame) {
  frame.own<SaveDialog>().wanted = nullptr;
  frame.own<SaveDialog>().shown = false;
  ImGui::CloseCurrentPopup();
}

void draw_save_buttons(PanelFrame& frame, bool entered) {
  const std::filesystem::path path = frame.own<SaveDialog>().path.text();
  std::error_code error;
  const bool exists = std::filesystem::exists(path, error);
  const bool folder = std::filesystem::is_directory(path, error);
  if (folder) {
    wrapped_text("That is a folder; add a name.", theme().warning);
  } else if (exists) {
    wrapped_text("A file of that name exists; saving replaces it.", theme().warning);
  } else {
    faint_text("A name without a folder lies in the folder where the program was started.");
  }
  const bool usable = !path.empty() && !folder;
  ImGui::BeginDisabled(!usable);
  const bool clicked = ImGui::Button(exists ? "Replace" : "Save", ImVec2(frame.units(90.0f), 0.0f));
  frame.mark("save/save");
  ImGui::EndDisabled();
  if (usable && (clicked || entered)) {
    frame.wish(Export{std::string(frame.own<SaveDialog>().wanted->key), path});
    close_save_dialog(frame);
    return;
  }
  ImGui::SameLine();
  const bool cancelled = ImGui::Button("Cancel", ImVec2(frame.units(90.0f), 0.0f));
  if (cancelled || key_pressed(Key::Escape)) close_save_dialog(frame);
}

}  // namespace

void ask_to_save(PanelFrame& frame, std::string_view key) {
  frame.own<SaveDialog>().wanted = find_export(key);
}

void draw_save_dialog(PanelFrame& frame) {
  SaveDialog& dialog = frame.own<SaveDialog>();
  if (dialog.wanted == nullptr) return;
  const ExportInfo& kind = *dialog.wanted;
  const std::string title = "Save the " + std::string(kind.words) + "###save";
  const bool begins = !dialog.shown;
  if (begins) {
    dialog.shown = true;
    dialog.path.set(suggestion(frame, kind));
    ImGui::OpenPopup(title.c_str());
  }
  const Box& window = frame.layout.window;
  ImGui::SetNextWindowPos(ImVec2(0.5f * window.width, 0.4f * window.height), ImGuiCond_Always,
                          ImVec2(0.5f, 0.5f));
  ImGui::SetNextWindowSize(ImVec2(std::min(frame.units(520.0f), 0.9f * window.width), 0.0f));
  push_raised_look(frame);
  const bool open =
      ImGui::BeginPopupModal(title.c_str(), nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove);
  pop_raised_look();
  if (!open) {
    dialog.wanted = nullptr;
    dialog.shown = false;
    return;
  }
  if (begins) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1.0f);
  const bool entered = ImGui::InputText("##path", dialog.path.bytes.data(), dialog.path.bytes.size(),
                                        ImGuiInputTextFlags_EnterReturnsTrue);
  frame.mark("save/path");
  draw_save_buttons(frame, entered);
  ImGui::EndPopup();
}

}  // namespace app
