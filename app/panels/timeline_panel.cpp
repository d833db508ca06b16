// The bottom panel: buttons, speed, position, and the track below them.
#include <array>
#include <string>

#include "app/panels/commands.h"
#include "app/panels/widgets.h"

namespace app {

namespace {

constexpr float button_height = 26.0f;
constexpr std::array<std::string_view, 3> unit_names{"item", "row", "stage"};
constexpr std::array forward_commands{Command::forward_item, Command::forward_row, Command::forward_stage};
constexpr std::array back_commands{Command::back_item, Command::back_row, Command::back_stage};

void transport_button(PanelFrame& frame, Command command, Icon icon, std::string_view control,
                      bool lit = false) {
  const CommandInfo& info = info_of(command);
  const std::string id(control);
  if (icon_button(id.c_str(), icon, ImVec2(frame.units(36.0f), frame.units(button_height)), lit)) {
    if (auto action = info.make(frame.session)) frame.wish(std::move(*action));
  }
  frame.mark(control);
  tooltip(frame, tooltip_of(info));
  ImGui::SameLine(0.0f, frame.units(3.0f));
}

void draw_buttons(PanelFrame& frame) {
  const auto unit = static_cast<std::size_t>(frame.ui.unit);
  const Playback& playback = frame.session.playback;
  const bool forward = playback.playing && playback.direction > 0;
  transport_button(frame, Command::first, Icon::first, "first");
  transport_button(frame, back_commands[unit], Icon::back, "back");
  transport_button(frame, Command::play, forward ? Icon::pause : Icon::play, "play", playback.playing);
  transport_button(frame, forward_commands[unit], Icon::forward, "forward");
  transport_button(frame, Command::last, Icon::last, "last");
}

void draw_unit(PanelFrame& frame) {
  ImGui::SameLine(0.0f, frame.units(16.0f));
  ImGui::AlignTextToFramePadding();
  faint_text("Step by");
  ImGui::SameLine();
  ImGui::BeginGroup();
  const int clicked = segmented("unit", unit_names, static_cast<int>(frame.ui.unit), frame.units(150.0f));
  ImGui::EndGroup();
  if (clicked >= 0) frame.ui.unit = static_cast<Unit>(clicked);
  frame.mark("unit");
  tooltip(frame,
          "What the back and forward buttons step by. The arrow keys step by item, with Shift by row, with "
          "Ctrl by stage.");
}

void draw_speed(PanelFrame& frame) {
  ImGui::SameLine(0.0f, frame.units(20.0f));
  faint_text("Speed");
  ImGui::SameLine();
  double speed = frame.session.playback.steps_per_second;
  const double low = slowest_steps_per_second;
  const double high = fastest_steps_per_second;
  const char* words = speed >= high  ? "as fast as it goes"
                      : speed < 10.0 ? "%.1f steps a second"
                                     : "%.0f steps a second";
  ImGui::SetNextItemWidth(frame.units(170.0f));
  const bool changed = ImGui::SliderScalar("##speed", ImGuiDataType_Double, &speed, &low, &high, words,
                                           ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
  if (changed) frame.wish(SetSpeed{speed});
  frame.mark("speed");
  tooltip(frame, "How fast it plays. Keys: " + keys_of(info_of(Command::slower)) + " slower, " +
                     keys_of(info_of(Command::faster)) + " faster.");
}

void draw_ways_of_playing(PanelFrame& frame) {
  const Travel& travel = frame.session.travel;
  ImGui::SameLine(0.0f, frame.units(12.0f));
  transport_button(frame, Command::slow_motion, Icon::slow, "slow-motion", travel.slow_motion);
  transport_button(frame, Command::loop, Icon::loop, "loop", travel.loop.has_value());
}

std::string position_text(const knit::Timeline& timeline) {
  std::string words = "step " + with_commas(timeline.position()) + " of " + with_commas(timeline.known());
  if (!timeline.complete()) words += timeline.sought() ? "..., going back to its place" : "... so far";
  return words;
}

void right_aligned(const PanelFrame& frame, const std::string& words, float before) {
  const float right = frame.layout.timeline.right() - ImGui::GetStyle().WindowPadding.x - before -
                      ImGui::CalcTextSize(words.c_str()).x;
  ImGui::SameLine();
  if (right > ImGui::GetCursorScreenPos().x)
    ImGui::SetCursorScreenPos(ImVec2(right, ImGui::GetCursorScreenPos().y));
  ImGui::AlignTextToFramePadding();
  text(words);
}

// The position at the right, and before it why another place is shown than the one asked for; where there is
// no room for both, that alone.
void draw_position(PanelFrame& frame) {
  const std::string& note = frame.session.place_note;
  const std::string words = position_text(*frame.timeline());
  push_font(frame.fonts.mono);
  const float width = ImGui::CalcTextSize(words.c_str()).x;
  pop_font();
  const float gap = frame.units(18.0f);
  ImGui::SameLine();
  const float room =
      frame.layout.timeline.right() - ImGui::GetStyle().WindowPadding.x - ImGui::GetCursorScreenPos().x;
  const bool both = ImGui::CalcTextSize(note.c_str()).x + gap + width <= room;
  if (!note.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, style::vector(style::warning));
    right_aligned(frame, cut_to_width(note, room), both ? width + gap : 0.0f);
    ImGui::PopStyleColor();
    frame.mark("place-note");
    tooltip(frame, note);
    if (!both) return;
  }
  push_font(frame.fonts.mono);
  right_aligned(frame, words, 0.0f);
  pop_font();
  frame.mark("position");
}

}  // namespace

void draw_transport(PanelFrame& frame) {
  const float padding = 0.5f * (frame.units(button_height) - ImGui::GetFontSize());
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(ImGui::GetStyle().FramePadding.x, padding));
  ImGui::BeginDisabled(frame.timeline() == nullptr);
  draw_buttons(frame);
  draw_unit(frame);
  draw_speed(frame);
  draw_ways_of_playing(frame);
  ImGui::EndDisabled();
  if (frame.timeline() != nullptr) draw_position(frame);
  ImGui::PopStyleVar();
  if (frame.timeline() == nullptr) ImGui::NewLine();
}

void draw_timeline(PanelFrame& frame) {
  begin_panel("Timeline", frame.layout.timeline,
              ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  draw_transport(frame);
  draw_track(frame);
  ImGui::End();
}

}  // namespace app
