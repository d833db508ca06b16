// The left panel: every knob of the pipeline in its order, and the edits made on the way.
#include <array>
#include <string>

#include "app/panels/commands.h"
#include "app/panels/knob.h"
#include "app/panels/panel_buttons.h"
#include "app/panels/widgets.h"
#include "knit/gauge.h"

namespace app {

namespace {

struct Tool {
  Command command;
  Icon icon;
  const char* id;
  bool usable;
};

constexpr std::size_t tool_count = 4;

// With the gap before them, and the cross after them.
float width_of_tools(const PanelFrame& frame) {
  return static_cast<float>(tool_count) * (ImGui::GetFrameHeight() + frame.units(3.0f)) + frame.units(4.0f) +
         room_for_cross(frame);
}

// Undo, redo, copy and paste at the right end of a line.
void draw_tools(PanelFrame& frame) {
  const Changes& changes = frame.session.changes;
  const std::array<Tool, tool_count> tools{Tool{Command::undo, Icon::undo, "undo", !changes.undo.empty()},
                                           Tool{Command::redo, Icon::redo, "redo", !changes.redo.empty()},
                                           Tool{Command::copy, Icon::copy, "copy", true},
                                           Tool{Command::paste, Icon::paste, "paste", true}};
  const float side = ImGui::GetFrameHeight();
  const float gap = frame.units(3.0f);
  const auto count = static_cast<float>(tools.size());
  ImGui::SameLine();
  const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
  float x = right - count * side - (count - 1.0f) * gap - room_for_cross(frame);
  for (const Tool& tool : tools) {
    const CommandInfo& info = info_of(tool.command);
    ImGui::SameLine(x);
    ImGui::BeginDisabled(!tool.usable);
    const bool clicked = icon_button(tool.id, tool.icon, ImVec2(side, side));
    ImGui::EndDisabled();
    frame.mark(tool.id);
    tooltip(frame, tooltip_of(info));
    if (clicked) {
      if (auto wish = info.make(frame.session)) frame.wish(std::move(*wish));
    }
    x += side + gap;
  }
}

void draw_mode(PanelFrame& frame) {
  constexpr std::array<std::string_view, 2> names{"from the start", "from here"};
  const char* const words = "A change counts";
  ImGui::AlignTextToFramePadding();
  if (ImGui::CalcTextSize(words).x + width_of_tools(frame) <= ImGui::GetContentRegionAvail().x) {
    faint_text(words);
  } else {
    ImGui::Dummy(ImVec2(0.0f, ImGui::GetFrameHeight()));  // in a narrow panel the buttons below say enough
  }
  draw_tools(frame);
  ImGui::BeginGroup();
  const int clicked = segmented("mode", names, frame.ui.from_here ? 1 : 0, ImGui::GetContentRegionAvail().x);
  ImGui::EndGroup();
  if (clicked >= 0) frame.ui.from_here = clicked == 1;
  frame.mark("mode");
  tooltip(frame,
          "From the start: the run becomes what it would have been with this value, and shows the same place "
          "in it.\n\n"
          "From here: what is past stays as it is; the rest is run anew.");
}

// What a change asks for: welding makes another mesh, so it can only count from the start.
void wish_change(PanelFrame& frame, const knit::ParameterInfo& info, const knit::Parameters& changed) {
  const bool held = ImGui::IsAnyItemActive();  // a drag goes on; a click is over
  if (frame.ui.from_here && info.first_reader != knit::Stage::import) {
    frame.wish(EditFromHere{changed, held});
  } else {
    frame.wish(Tune{changed, held});
  }
}

std::string changes_text(const knit::Parameters& from, const knit::Parameters& to) {
  std::string words;
  for (const knit::ParameterInfo& info : knit::parameter_table()) {
    const std::string before = knit::value_text(info, from);
    const std::string after = knit::value_text(info, to);
    if (before == after) continue;
    if (!words.empty()) words += "\n";
    words.append(info.label).append(" ").append(before).append(" \xE2\x86\x92 ").append(after);
  }
  return words.empty() ? "nothing changes" : words;
}

void draw_edit(PanelFrame& frame, const knit::Timeline& timeline, std::size_t i) {
  const knit::Edit& edit = timeline.edits()[i];
  const knit::Parameters& before = i > 0 ? timeline.edits()[i - 1].parameters : timeline.base_parameters();
  const float side = ImGui::GetFrameHeight();
  ImGui::PushID(static_cast<int>(i));
  const float left = ImGui::GetCursorPosX();
  const float width = ImGui::GetContentRegionAvail().x - side - frame.units(6.0f);
  const std::string place = "From " + words_of(edit.at);
  if (ImGui::Selectable(cut_to_width(place, width).c_str(), false, 0, ImVec2(width, 0.0f))) {
    const auto& positions = frame.ui.run.edits();
    if (i < positions.size()) frame.wish(SeekTo{positions[i]});
  }
  frame.mark("edit/" + std::to_string(i));
  tooltip(frame, place + ". Click: go there.");
  ImGui::SameLine(left + width + frame.units(6.0f));
  if (icon_button("remove", Icon::cross, ImVec2(side, side))) frame.wish(RemoveEdit{i});
  frame.mark("edit/" + std::to_string(i) + "/remove");
  tooltip(frame, "Take this change back.");
  wrapped_text(changes_text(before, edit.parameters), theme().faint_text);
  ImGui::PopID();
}

void draw_knobs(PanelFrame& frame, const knit::Timeline& timeline) {
  std::string_view group;
  for (const knit::ParameterInfo& info : knit::parameter_table()) {
    // What nothing reads now would only be in the way.
    if (!knit::is_read(info, timeline.parameters())) continue;
    if (info.group != group) {
      group = info.group;
      heading(frame, std::string(group).c_str());
    }
    // Each knob starts from what is in force, so that one frame wishes at most what one hand did.
    knit::Parameters parameters = timeline.parameters();
    draw_knob(frame, info, parameters);
    if (parameters == timeline.parameters()) continue;
    knit::give_size_by(info.key, parameters);
    wish_change(frame, info, parameters);
  }
}

}  // namespace

void draw_edits(PanelFrame& frame) {
  const knit::Timeline& timeline = *frame.timeline();
  if (timeline.edits().empty()) return;
  heading(frame, "Changes on the way");
  for (std::size_t i = 0; i < timeline.edits().size(); ++i) draw_edit(frame, timeline, i);
}

void draw_parameters(PanelFrame& frame) {
  begin_panel("Parameters", frame.layout.parameters);
  draw_cross(frame, Panel::parameters);
  if (const knit::Timeline* timeline = frame.timeline()) {
    draw_mode(frame);
    draw_knobs(frame, *timeline);
    draw_edits(frame);
  } else {
    push_font(frame.fonts.strong);
    faint_text("Parameters");
    pop_font();
    wrapped_text("They appear here once a mesh is open.", theme().faint_text);
  }
  ImGui::End();
}

}  // namespace app
