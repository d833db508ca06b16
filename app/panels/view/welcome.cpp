#include "app/panels/view/overlays.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "app/files/preferences_file.h"
#include "app/panels/kit/commands.h"
#include "app/panels/kit/widgets.h"
#include "app/panels/offers/example_pictures.h"
#include "app/session/jobs.h"
#include "app/session/learning.h"
#include "app/session/program.h"

namespace app {

namespace {

constexpr float card_width = 600.0f;
constexpr std::size_t examples_in_line = 5;
constexpr std::size_t most_shown = 5;  // recent files; the others are in the menu

void accent_button_look() {
  ImGui::PushStyleColor(ImGuiCol_Button, style::vector(theme().accent));
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, style::vector(theme().accent));
  ImGui::PushStyleColor(ImGuiCol_ButtonActive, style::vector(theme().accent));
  ImGui::PushStyleColor(ImGuiCol_Text, style::vector(theme().on_accent));
}

void draw_first_ways(PanelFrame& frame) {
  const CommandInfo& open = info_of(Command::open);
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const ImVec2 size(0.5f * (ImGui::GetContentRegionAvail().x - gap), frame.units(30.0f));
  accent_button_look();
  if (ImGui::Button("Open a mesh...", size)) frame.wish(ShowOpenDialog{true});
  ImGui::PopStyleColor(4);
  frame.mark("welcome/open");
  tooltip(frame, tooltip_of(open));
  ImGui::SameLine();
  if (ImGui::Button("What does it do?", size)) frame.wish(StartLesson{first_lesson});
  frame.mark("welcome/lesson");
  tooltip(frame, "The first lesson: a few pages, with a mesh to try things on.");
  wrapped_text("Or drop a mesh (.obj) or a saved session (.json) anywhere in this window.",
               theme().faint_text);
}

// What each is when it is knitted, so many side by side.
void draw_examples(PanelFrame& frame) {
  const auto examples = list_examples(frame.session.program->assets);
  if (examples.empty()) return;
  heading(frame, "Examples");
  const float gap = frame.units(6.0f);
  const float width =
      std::floor((ImGui::GetContentRegionAvail().x + gap) / static_cast<float>(examples_in_line) - gap);
  const ImVec2 size(width, std::floor(0.52f * width) + ImGui::GetTextLineHeight());
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(gap, gap));
  for (std::size_t i = 0; i < examples.size(); ++i) {
    if (i % examples_in_line > 0) ImGui::SameLine();
    if (example_tile(frame, examples[i], size)) frame.wish(OpenExample{examples[i]});
    frame.mark("welcome/" + examples[i]);
    tooltip(frame, "Open the example " + examples[i] + ".");
  }
  ImGui::PopStyleVar();
}

void draw_recent(PanelFrame& frame) {
  const std::vector<std::string>& recent = frame.session.program->preferences.recent;
  if (recent.empty()) return;
  heading(frame, "Recent");
  for (std::size_t i = 0; i < std::min(recent.size(), most_shown); ++i) {
    const RecentWords words = words_of_recent(recent[i]);
    ImGui::PushID(static_cast<int>(i));
    const float left = ImGui::GetCursorPosX();
    const float width = ImGui::GetContentRegionAvail().x;
    const std::string what = cut_to_width(words.what, 0.6f * width);
    if (ImGui::Selectable("##recent", false, 0, ImVec2(width, 0.0f)))
      frame.wish(opening_of_recent(recent[i]));
    frame.mark("welcome/recent/" + std::to_string(i));
    tooltip(frame, recent[i]);
    ImGui::SameLine(left);
    text(what);
    ImGui::SameLine(0.0f, frame.units(10.0f));
    faint_text(cut_to_width(words.where, left + width - ImGui::GetCursorPosX()));
    ImGui::PopID();
  }
}

}  // namespace

void draw_welcome(PanelFrame& frame) {
  if (frame.timeline() != nullptr || frame.session.learning->lesson || frame.session.jobs->repair_offer)
    return;
  const Box& view = frame.layout.view;
  const float width = std::min(frame.units(card_width), 0.94f * view.width);
  ImGui::SetNextWindowPos(ImVec2(view.x + 0.5f * view.width, view.y + 0.48f * view.height), ImGuiCond_Always,
                          ImVec2(0.5f, 0.5f));
  ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0.0f), ImVec2(width, 0.96f * view.height));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(frame.units(20.0f), frame.units(16.0f)));
  push_raised_look(frame);
  ImGui::Begin("Welcome", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  pop_raised_look();
  ImGui::PopStyleVar();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(frame.units(8.0f), frame.units(8.0f)));
  push_font(frame.fonts.heading);
  text("No mesh is open");
  pop_font();
  wrapped_text("Open one, and see step by step how it becomes a pattern to knit by hand.");
  draw_first_ways(frame);
  draw_examples(frame);
  draw_recent(frame);
  ImGui::PopStyleVar();
  ImGui::End();
}

}  // namespace app
