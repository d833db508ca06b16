// The bottom panel: buttons, speed, position, and the track below them.
#include <array>
#include <string>

#include "app/panels/commands.h"
#include "app/panels/panel_buttons.h"
#include "app/panels/widgets.h"

namespace app {

namespace {

// Plain units.
constexpr float button_height = 26.0f;
constexpr float button_width = 36.0f;
constexpr float button_gap = 3.0f;
constexpr float unit_gap = 16.0f;
constexpr float unit_width = 150.0f;
constexpr float speed_gap = 20.0f;
constexpr float speed_width = 170.0f;
constexpr float ways_gap = 12.0f;
constexpr const char* unit_words = "Step by";
constexpr const char* speed_words = "Speed";
constexpr std::array<std::string_view, 3> unit_names{"item", "row", "stage"};
constexpr std::array forward_commands{Command::forward_item, Command::forward_row, Command::forward_stage};
constexpr std::array back_commands{Command::back_item, Command::back_row, Command::back_stage};

void transport_button(PanelFrame& frame, Command command, Icon icon, std::string_view control,
                      bool lit = false) {
  const CommandInfo& info = info_of(command);
  const std::string id(control);
  if (icon_button(id.c_str(), icon, ImVec2(frame.units(button_width), frame.units(button_height)), lit)) {
    if (auto action = info.make(frame.session)) frame.wish(std::move(*action));
  }
  frame.mark(control);
  tooltip(frame, tooltip_of(info));
  ImGui::SameLine(0.0f, frame.units(button_gap));
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

// What of the row there is room for. The play buttons are always there.
struct Row {
  bool words, speed, whole_position, unit, ways;
};

void draw_unit(PanelFrame& frame, bool words) {
  ImGui::SameLine(0.0f, frame.units(unit_gap));
  if (words) {
    ImGui::AlignTextToFramePadding();
    faint_text(unit_words);
    ImGui::SameLine();
  }
  ImGui::BeginGroup();
  const int clicked = segmented("unit", unit_names, static_cast<int>(frame.ui.unit), frame.units(unit_width));
  ImGui::EndGroup();
  if (clicked >= 0) frame.ui.unit = static_cast<Unit>(clicked);
  frame.mark("unit");
  tooltip(frame,
          "What the back and forward buttons step by. The arrow keys step by item, with Shift by row, with "
          "Ctrl by stage.");
}

void draw_speed(PanelFrame& frame, bool words_before) {
  ImGui::SameLine(0.0f, frame.units(speed_gap));
  if (words_before) {
    ImGui::AlignTextToFramePadding();
    faint_text(speed_words);
    ImGui::SameLine();
  }
  double speed = frame.session.playback.steps_per_second;
  const double low = slowest_steps_per_second;
  const double high = fastest_steps_per_second;
  const char* words = speed >= high  ? "as fast as it goes"
                      : speed < 10.0 ? "%.1f steps a second"
                                     : "%.0f steps a second";
  ImGui::SetNextItemWidth(frame.units(speed_width));
  // Its words must be readable wherever the grab stands.
  ImGui::PushStyleColor(ImGuiCol_SliderGrab, style::vector(with_alpha(theme().accent, 120)));
  ImGui::PushStyleColor(ImGuiCol_SliderGrabActive, style::vector(with_alpha(theme().accent, 160)));
  const bool changed = ImGui::SliderScalar("##speed", ImGuiDataType_Double, &speed, &low, &high, words,
                                           ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
  ImGui::PopStyleColor(2);
  if (changed) frame.wish(SetSpeed{speed});
  frame.mark("speed");
  tooltip(frame, "How fast it plays. Keys: " + keys_of(info_of(Command::slower)) + " slower, " +
                     keys_of(info_of(Command::faster)) + " faster.");
}

void draw_ways_of_playing(PanelFrame& frame) {
  const Travel& travel = frame.session.travel;
  ImGui::SameLine(0.0f, frame.units(ways_gap));
  transport_button(frame, Command::slow_motion, Icon::slow, "slow-motion", travel.slow_motion);
  transport_button(frame, Command::loop, Icon::loop, "loop", travel.loop.has_value());
}

std::string position_text(const knit::Timeline& timeline, bool whole) {
  const std::string here = with_commas(timeline.position());
  const std::string all = with_commas(timeline.known());
  if (!whole) return here + " / " + all + (timeline.complete() ? "" : "...");
  std::string words = "step " + here + " of " + all;
  if (timeline.complete()) return words;
  return words + (timeline.sought() ? "..., going back to its place" : "... so far");
}

// Of the widest that there will be at this length of the run, so that the row does not change while it plays.
float position_width(const PanelFrame& frame, bool whole) {
  const knit::Timeline* timeline = frame.timeline();
  if (timeline == nullptr) return 0.0f;
  const std::string all = with_commas(timeline->known());
  const std::string words = whole ? "step " + all + " of " + all + (timeline->complete() ? "" : "... so far")
                                  : all + " / " + all + "...";
  push_font(frame.fonts.mono);
  const float width = ImGui::CalcTextSize(words.c_str()).x;
  pop_font();
  return width + frame.units(12.0f);
}

float width_of(const PanelFrame& frame, const Row& row) {
  const float button = frame.units(button_width + button_gap);
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  float width = 5.0f * button + position_width(frame, row.whole_position);
  if (row.unit) width += frame.units(unit_gap + unit_width);
  if (row.unit && row.words) width += ImGui::CalcTextSize(unit_words).x + gap;
  if (row.speed) width += frame.units(speed_gap + speed_width);
  if (row.speed && row.words) width += ImGui::CalcTextSize(speed_words).x + gap;
  if (row.ways) width += frame.units(ways_gap) + 2.0f * button;
  return width;
}

// The first that fits: words go first, then the slider, which the keys can do without.
Row row_of(const PanelFrame& frame) {
  constexpr std::array rows{Row{true, true, true, true, true},     Row{false, true, true, true, true},
                            Row{false, false, true, true, true},   Row{false, false, false, true, true},
                            Row{false, false, false, true, false}, Row{false, false, false, false, false}};
  const float room = ImGui::GetContentRegionAvail().x - room_for_cross(frame);
  for (const Row& row : rows) {
    if (width_of(frame, row) <= room) return row;
  }
  return rows.back();
}

float right_end(const PanelFrame& frame) {
  return frame.layout.timeline.right() - ImGui::GetStyle().WindowPadding.x - room_for_cross(frame);
}

void right_aligned(const PanelFrame& frame, const std::string& words, float before) {
  const float right = right_end(frame) - before - ImGui::CalcTextSize(words.c_str()).x;
  ImGui::SameLine();
  if (right > ImGui::GetCursorScreenPos().x)
    ImGui::SetCursorScreenPos(ImVec2(right, ImGui::GetCursorScreenPos().y));
  ImGui::AlignTextToFramePadding();
  text(words);
}

// The position at the right, and before it why another place is shown than the one asked for; where there is
// no room for both, that alone.
void draw_position(PanelFrame& frame, bool whole) {
  const std::string& note = frame.session.place_note;
  const std::string words = position_text(*frame.timeline(), whole);
  push_font(frame.fonts.mono);
  const float width = ImGui::CalcTextSize(words.c_str()).x;
  pop_font();
  const float gap = frame.units(18.0f);
  ImGui::SameLine();
  const float room = right_end(frame) - ImGui::GetCursorScreenPos().x;
  const bool both = ImGui::CalcTextSize(note.c_str()).x + gap + width <= room;
  if (!note.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, style::vector(theme().warning));
    right_aligned(frame, cut_to_width(note, room), both ? width + gap : 0.0f);
    ImGui::PopStyleColor();
    frame.mark("place-note");
    tooltip(frame, note);
    if (!both) return;
  }
  push_font(frame.fonts.mono);
  right_aligned(frame, cut_to_width(words, room), 0.0f);
  pop_font();
  frame.mark("position");
}

}  // namespace

void draw_transport(PanelFrame& frame) {
  const float padding = 0.5f * (frame.units(button_height) - ImGui::GetFontSize());
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(ImGui::GetStyle().FramePadding.x, padding));
  draw_cross(frame, Panel::timeline);
  const Row row = row_of(frame);
  ImGui::BeginDisabled(frame.timeline() == nullptr);
  draw_buttons(frame);
  if (row.unit) draw_unit(frame, row.words);
  if (row.speed) draw_speed(frame, row.words);
  if (row.ways) draw_ways_of_playing(frame);
  ImGui::EndDisabled();
  if (frame.timeline() != nullptr) draw_position(frame, row.whole_position);
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
