// What is selected, in words, with ways on from there: few lines, because the lists below need the room.
#include <string>

#include "app/core/why_words.h"
#include "app/panels/commands.h"
#include "app/panels/widgets.h"

namespace app {

namespace {

// The buttons stand at the right end of the line.
void draw_buttons(PanelFrame& frame, const knit::Thing& thing, float left) {
  const float side = ImGui::GetFrameHeight();
  const ImVec2 size(side, side);
  const float gap = frame.units(3.0f);
  ImGui::SameLine(left);
  if (ImGui::Button("Why##selected", ImVec2(0.0f, side))) frame.wish(ShowWhy{thing});
  frame.mark("selected/why");
  tooltip(frame, "To the step that made it, or decided on it");
  ImGui::SameLine(0.0f, gap);
  if (icon_button("selected back", Icon::back, size)) frame.wish(ToTouch{-1});
  frame.mark("selected/back");
  tooltip(frame, tooltip_of(info_of(Command::last_touch)));
  ImGui::SameLine(0.0f, gap);
  if (icon_button("selected forward", Icon::forward, size)) frame.wish(ToTouch{1});
  frame.mark("selected/forward");
  tooltip(frame, tooltip_of(info_of(Command::next_touch)));
  ImGui::SameLine(0.0f, gap);
  if (icon_button("selected close", Icon::cross, size)) frame.wish(Select{});
  frame.mark("selected/close");
  tooltip(frame, "Select nothing");
}

float width_of_buttons(const PanelFrame& frame) {
  const float word = ImGui::CalcTextSize("Why").x + 2.0f * ImGui::GetStyle().FramePadding.x;
  return word + 3.0f * (ImGui::GetFrameHeight() + frame.units(3.0f));
}

}  // namespace

void draw_selected(PanelFrame& frame) {
  const auto& selected = frame.session.travel.selected;
  if (!selected || frame.timeline() == nullptr) return;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(frame.units(5.0f), frame.units(2.0f)));
  const float left = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - width_of_buttons(frame);
  ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, style::vector(theme().selected));
  text(cut_to_width(capitalised(words_of(*selected)), left - ImGui::GetCursorPosX() - frame.units(6.0f)));
  ImGui::PopStyleColor();
  frame.mark("selected");
  draw_buttons(frame, *selected, left);
  ImGui::PopStyleVar();
  push_font(frame.fonts.small);
  const std::string words = why_words(*frame.timeline(), *selected);
  wrapped_text(words, theme().faint_text);
  pop_font();
  frame.mark("selected/words");
  tooltip(frame, words);
}

}  // namespace app
