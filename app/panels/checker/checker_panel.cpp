#include "app/panels/checker/checker_panel.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "app/panels/checker/checker_parts.h"
#include "app/panels/kit/commands.h"
#include "app/session/jobs.h"

namespace app {

bool shows_checker(const Session& session) { return session.view->checking && session.view->checker; }

Colour colour_of(knit::LineVerdict verdict) {
  switch (verdict) {
    case knit::LineVerdict::holds:
      return theme().selected;
    case knit::LineVerdict::does_not_add_up:
      return theme().problem;
    case knit::LineVerdict::not_understood:
      return theme().warning;
    case knit::LineVerdict::not_claimed:
    case knit::LineVerdict::no_instruction:
      break;
  }
  return theme().faint_text;
}

knit::LineVerdict line_verdict_of(CheckVerdict verdict) {
  switch (verdict) {
    case CheckVerdict::holds:
      return knit::LineVerdict::holds;
    case CheckVerdict::does_not_add_up:
      return knit::LineVerdict::does_not_add_up;
    case CheckVerdict::not_understood:
      break;
  }
  return knit::LineVerdict::not_understood;
}

void draw_verdict(ImDrawList& list, knit::LineVerdict verdict, ImVec2 middle, float r) {
  const ImU32 colour = style::packed(opaque(colour_of(verdict)));
  const float thick = std::max(1.5f, 0.4f * r);
  const auto at = [&](float x, float y) { return ImVec2(middle.x + x * r, middle.y + y * r); };
  switch (verdict) {
    case knit::LineVerdict::holds:
      list.AddLine(at(-0.9f, 0.1f), at(-0.25f, 0.8f), colour, thick);
      list.AddLine(at(-0.25f, 0.8f), at(0.9f, -0.7f), colour, thick);
      return;
    case knit::LineVerdict::does_not_add_up:
      list.AddLine(at(-0.8f, -0.8f), at(0.8f, 0.8f), colour, thick);
      list.AddLine(at(-0.8f, 0.8f), at(0.8f, -0.8f), colour, thick);
      return;
    case knit::LineVerdict::not_understood: {
      const ImVec2 size = ImGui::CalcTextSize("?");
      list.AddText(ImVec2(middle.x - 0.5f * size.x, middle.y - 0.5f * size.y), colour, "?");
      return;
    }
    case knit::LineVerdict::not_claimed:
      list.AddLine(at(-0.7f, 0.0f), at(0.7f, 0.0f), colour, thick);
      return;
    case knit::LineVerdict::no_instruction:
      return;
  }
}

namespace {

const Checker& checker_of(const PanelFrame& frame) { return *frame.session.view->checker; }

bool marked_button(PanelFrame& frame, const char* words, const char* mark, const char* help) {
  const bool clicked = ImGui::Button(words);
  frame.mark(mark);
  tooltip(frame, help);
  ImGui::SameLine();
  return clicked;
}

void ask_where(PanelFrame& frame) {
  CheckerDialog& dialog = frame.own<CheckerDialog>();
  const Checker& checker = checker_of(frame);
  dialog.path.set(checker.path.empty() ? "pattern.txt" : checker.path.string());
  dialog.asked = true;
}

void draw_files(PanelFrame& frame) {
  const Checker& checker = checker_of(frame);
  if (marked_button(frame, "Open...", "checker/open",
                    "A pattern: .txt, .md or .html. Or drop it on the window."))
    frame.wish(ShowOpenDialog{true});
  if (marked_button(frame, "Save as...", "checker/save", "The text as it stands here (Ctrl+S)."))
    ask_where(frame);
  const char* const clipboard = ImGui::GetClipboardText();
  if (marked_button(
          frame, "Paste", "checker/paste",
          "The clipboard's text in place of all that stands here, which can be put back. Ctrl+V in the "
          "text pastes at the caret.") &&
      clipboard != nullptr)
    frame.wish(SetCheckedText{clipboard, true});
  if (checker.before && marked_button(frame, "Put back", "checker/restore",
                                      "The text that stood here before; a second click comes back."))
    frame.wish(RestoreCheckedText{});
}

void draw_sizes(PanelFrame& frame) {
  const Checker& checker = checker_of(frame);
  if (!checker.checked || checker.checked->sizes.size() < 2) return;
  ImGui::AlignTextToFramePadding();
  faint_text("Size");
  ImGui::SameLine();
  const auto& sizes = checker.checked->sizes;
  constexpr std::size_t most_buttons = 6;
  if (sizes.size() <= most_buttons) {
    std::vector<std::string_view> names;
    names.reserve(sizes.size());
    for (const knit::CheckedSize& size : sizes) names.push_back(size.name);
    const int chosen = segmented("sizes", names, static_cast<int>(checker.size), 0.0f);
    if (chosen >= 0) frame.wish(ShowCheckedSize{static_cast<std::size_t>(chosen)});
  } else {
    ImGui::SetNextItemWidth(frame.units(90.0f));
    if (begin_list(frame, "##sizes", checker.shown()->name)) {
      for (std::size_t i = 0; i < sizes.size(); ++i)
        if (ImGui::Selectable(sizes[i].name.c_str(), i == checker.size)) frame.wish(ShowCheckedSize{i});
      ImGui::EndCombo();
    }
  }
  frame.mark("checker/sizes");
  ImGui::SameLine();
}

void draw_close(PanelFrame& frame) {
  const float side = ImGui::GetFrameHeight();
  const float left = ImGui::GetWindowContentRegionMax().x - side;
  if (left > ImGui::GetCursorPosX()) ImGui::SetCursorPosX(left);
  if (icon_button("close", Icon::cross, ImVec2(side, side))) frame.wish(ShowChecker{false});
  frame.mark("checker/close");
  tooltip(frame, "Back to the mesh; the text stays (F7).");
}

// What comes of all of it; its parts are in the list below.
void draw_summary(PanelFrame& frame) {
  const Checker& checker = checker_of(frame);
  const bool judged = checker.checked && checker.checked->is_pattern && !checker.text->empty();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float line = ImGui::GetTextLineHeight();
  if (judged) {
    draw_verdict(*ImGui::GetWindowDrawList(), line_verdict_of(checker.checked->verdict),
                 ImVec2(at.x + 0.6f * line, at.y + 0.5f * line), 0.36f * line);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 1.5f * line);
  }
  std::string words = summary_words(checker);
  if (checker.checked && checker.checked_text != checker.text) words += " Reading what changed...";
  const std::string name = checker.path.empty() ? "" : checker.path.filename().string();
  if (checker.unsaved() && !name.empty()) words = name + ", changed. " + words;
  if (!checker.unsaved() && !name.empty()) words = name + ". " + words;
  push_font(frame.fonts.strong);
  wrapped_text(words, judged ? theme().text : theme().faint_text);
  pop_font();
  frame.mark("checker/summary");
}

void draw_saving_inside(PanelFrame& frame, bool begins) {
  CheckerDialog& dialog = frame.own<CheckerDialog>();
  if (begins) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1.0f);
  const bool entered = ImGui::InputText("##path", dialog.path.bytes.data(), dialog.path.bytes.size(),
                                        ImGuiInputTextFlags_EnterReturnsTrue);
  frame.mark("checker/path");
  const std::filesystem::path path = dialog.path.text();
  std::error_code error;
  const bool folder = std::filesystem::is_directory(path, error);
  const bool exists = !folder && std::filesystem::exists(path, error);
  if (folder) wrapped_text("That is a folder; add a name.", theme().warning);
  if (exists) wrapped_text("A file of that name exists; saving replaces it.", theme().warning);
  if (!folder && !exists)
    faint_text("A name without a folder lies in the folder where the program was started.");
  const bool usable = !path.empty() && !folder;
  ImGui::BeginDisabled(!usable);
  const bool clicked = ImGui::Button(exists ? "Replace" : "Save", ImVec2(frame.units(90.0f), 0.0f));
  frame.mark("checker/save-it");
  ImGui::EndDisabled();
  ImGui::SameLine();
  const bool cancelled =
      ImGui::Button("Cancel", ImVec2(frame.units(90.0f), 0.0f)) || key_pressed(Key::Escape);
  if (usable && (clicked || entered)) frame.wish(SaveCheckedText{path});
  if (cancelled || (usable && (clicked || entered))) {
    dialog.shown = false;
    ImGui::CloseCurrentPopup();
  }
}

void draw_saving(PanelFrame& frame) {
  CheckerDialog& dialog = frame.own<CheckerDialog>();
  if (is_pressed_in_checker(Command::save_checked) && checker_of(frame).path.empty()) ask_where(frame);
  const bool begins = dialog.asked;
  if (begins) ImGui::OpenPopup("Save the pattern");
  dialog.shown = dialog.shown || begins;
  dialog.asked = false;
  if (!dialog.shown) return;
  const Box& window = frame.layout.window;
  ImGui::SetNextWindowPos(ImVec2(0.5f * window.width, 0.4f * window.height), ImGuiCond_Always,
                          ImVec2(0.5f, 0.5f));
  ImGui::SetNextWindowSize(ImVec2(std::min(frame.units(520.0f), 0.9f * window.width), 0.0f));
  push_raised_look(frame);
  const bool open = ImGui::BeginPopupModal("Save the pattern", nullptr,
                                           ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove);
  pop_raised_look();
  dialog.shown = open;
  if (!open) return;
  draw_saving_inside(frame, begins);
  ImGui::EndPopup();
}

}  // namespace

void draw_checker(PanelFrame& frame) {
  const Box& box = frame.layout.checker;
  if (box.width <= 0.0f) return;  // the layout follows in the next frame
  begin_panel("Checker", box, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  draw_files(frame);
  draw_sizes(frame);
  draw_close(frame);
  draw_summary(frame);
  const float room = ImGui::GetContentRegionAvail().y;
  const float list = std::floor(std::clamp(0.26f * room, frame.units(110.0f), frame.units(240.0f)));
  const float editor = std::max(frame.units(60.0f), room - list - ImGui::GetStyle().ItemSpacing.y);
  draw_checker_editor(frame, ImVec2(ImGui::GetContentRegionAvail().x, editor));
  draw_checker_list(frame, std::max(1.0f, ImGui::GetContentRegionAvail().y));
  draw_saving(frame);
  ImGui::End();
  draw_checker_view(frame);
}

}  // namespace app
