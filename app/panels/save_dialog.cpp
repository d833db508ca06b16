#include "app/panels/save_dialog.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "app/panels/widgets.h"

namespace app {

namespace {

constexpr std::array kinds{
    SaveKind{ExportKind::mesh, "knit mesh", "-knit.obj"},
    SaveKind{ExportKind::gltf, "knit mesh as glTF", "-knit.glb"},
    SaveKind{ExportKind::map, "stitch map", "-map.txt"},
    SaveKind{ExportKind::report, "report", "-report.json"},
    SaveKind{ExportKind::card, "report card", "-card.txt"},
    SaveKind{ExportKind::pattern, "pattern", "-pattern.html"},
    SaveKind{ExportKind::chart, "chart", "-chart.svg"},
    SaveKind{ExportKind::steps, "log of steps", "-steps.jsonl"},
    SaveKind{ExportKind::plots, "plots", "-plots.svg"},
    SaveKind{ExportKind::session, "session", "-session.json"},
    SaveKind{ExportKind::picture, "picture", ".png"},
};

const SaveKind& info_of(ExportKind kind) {
  return *std::find_if(kinds.begin(), kinds.end(), [&](const SaveKind& k) { return k.kind == kind; });
}

std::string suggestion(const PanelFrame& frame, const SaveKind& kind) {
  const std::string name = frame.timeline() != nullptr ? frame.timeline()->input().mesh.name : "";
  return (name.empty() ? "mesh" : name) + std::string(kind.ending);
}

void finish(PanelFrame& frame) {
  frame.ui.save.wanted.reset();
  frame.ui.save.shown = false;
  ImGui::CloseCurrentPopup();
}

void draw_buttons(PanelFrame& frame, bool entered) {
  const std::filesystem::path path = frame.ui.save.path.text();
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
    frame.wish(Export{*frame.ui.save.wanted, path});
    finish(frame);
    return;
  }
  ImGui::SameLine();
  const bool cancelled = ImGui::Button("Cancel", ImVec2(frame.units(90.0f), 0.0f));
  if (cancelled || key_pressed(Key::Escape)) finish(frame);
}

}  // namespace

// A picture has a dialog of its own: figure_dialog.h.
std::span<const SaveKind> save_kinds() { return std::span(kinds).first(kinds.size() - 1); }

void draw_save_dialog(PanelFrame& frame) {
  SaveDialog& dialog = frame.ui.save;
  if (!dialog.wanted) return;
  const SaveKind& kind = info_of(*dialog.wanted);
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
    dialog.wanted.reset();
    dialog.shown = false;
    return;
  }
  if (begins) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1.0f);
  const bool entered = ImGui::InputText("##path", dialog.path.bytes.data(), dialog.path.bytes.size(),
                                        ImGuiInputTextFlags_EnterReturnsTrue);
  frame.mark("save/path");
  draw_buttons(frame, entered);
  ImGui::EndPopup();
}

}  // namespace app
