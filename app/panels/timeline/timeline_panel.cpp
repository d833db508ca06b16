// The bottom panel: buttons, speed, position, and the track below them.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "app/actions/playing.h"
#include "app/base/text.h"
#include "app/panels/kit/commands.h"
#include "app/panels/kit/number_field.h"
#include "app/panels/kit/panel_buttons.h"
#include "app/panels/kit/run_cache.h"
#include "app/panels/kit/tube_marks.h"
#include "app/panels/kit/widgets.h"
#include "app/panels/timeline/timeline.h"
#include "app/panels/timeline/track.h"
#include "app/panels/timeline/tube_band.h"
#include "app/session/document.h"
#include "app/session/view.h"
#include "knit/insight/narrate.h"
#include "knit/model/settings_table.h"
#include "knit/model/words.h"

namespace app {

namespace {

struct StepButtons {
  Unit unit = Unit::item;
};

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
  const auto unit = static_cast<std::size_t>(frame.own<StepButtons>().unit);
  const Playback& playback = frame.session.view->playback;
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
  const int clicked =
      segmented("unit", unit_names, static_cast<int>(frame.own<StepButtons>().unit), frame.units(unit_width));
  ImGui::EndGroup();
  if (clicked >= 0) frame.own<StepButtons>().unit = static_cast<Unit>(clicked);
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
  double speed = frame.session.view->playback.steps_per_second;
  const double low = slowest_steps_per_second;
  const double high = fastest_steps_per_second;
  const std::string full = knit::number_text(speed);
  const std::string shown =
      speed >= high ? "as fast as it goes" : fixed_text(speed, speed < 10.0 ? 1 : 0) + " steps a second";
  const NumberShape shape{shown, full, speed, low, high, DragPace::ratio};
  if (edit_number(frame, "##speed", speed, shape, frame.units(speed_width))) frame.wish(SetSpeed{speed});
  frame.mark("speed");
  tooltip(frame, "How fast it plays: drag, or click and type. Keys: " + keys_of(info_of(Command::slower)) +
                     " slower, " + keys_of(info_of(Command::faster)) + " faster.");
}

void draw_ways_of_playing(PanelFrame& frame) {
  ImGui::SameLine(0.0f, frame.units(ways_gap));
  transport_button(frame, Command::slow_motion, Icon::slow, "slow-motion", frame.session.view->slow_motion);
  transport_button(frame, Command::loop, Icon::loop, "loop",
                   frame.session.document && frame.session.document->travel.loop);
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

void right_aligned(const PanelFrame& frame, const std::string& words) {
  const float right = right_end(frame) - ImGui::CalcTextSize(words.c_str()).x;
  ImGui::SameLine();
  if (right > ImGui::GetCursorScreenPos().x)
    ImGui::SetCursorScreenPos(ImVec2(right, ImGui::GetCursorScreenPos().y));
  ImGui::AlignTextToFramePadding();
  text(words);
}

// At the right.
void draw_position(PanelFrame& frame, bool whole) {
  const std::string words = position_text(*frame.timeline(), whole);
  ImGui::SameLine();
  const float room = right_end(frame) - ImGui::GetCursorScreenPos().x;
  push_font(frame.fonts.mono);
  right_aligned(frame, cut_to_width(words, room));
  pop_font();
  frame.mark("position");
}

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

// --- the track: stages as coloured stretches, rows as ticks, marks for edits and problems, the scrubber

void draw_stages(const PanelFrame& frame, const Track& track, ImDrawList& list) {
  const float now = track.x_of(frame.timeline()->position());
  const float foot = place_of_band(frame, track).letters;
  for (const RunCache::Stretch& stretch : frame.own<RunCache>().stages()) {
    const float x0 = track.x_of(stretch.begin);
    const float x1 = std::max(track.x_of(stretch.end), x0 + 1.0f);
    const Colour colour = theme().of(stretch.stage);
    list.AddRectFilled(ImVec2(x0, track.top), ImVec2(x1, track.bottom),
                       style::packed(colour, theme().stage_ahead));
    if (now > x0) {
      list.AddRectFilled(ImVec2(x0, track.top), ImVec2(std::min(now, x1), track.bottom),
                         style::packed(colour, theme().stage_done));
    }
    if (x0 > track.left) {
      list.AddLine(ImVec2(x0, track.top), ImVec2(x0, track.bottom), style::packed(theme().panel),
                   frame.units(1.5f));
    }
    const std::string name = capitalised(knit::name_of(stretch.stage));
    const ImVec2 size = ImGui::CalcTextSize(name.c_str());
    if (x1 - x0 < size.x + frame.units(8.0f)) continue;
    const ImVec2 at(0.5f * (x0 + x1 - size.x), std::max(track.top, 0.5f * (track.top + foot - size.y)));
    list.AddText(at, style::packed(theme().text), name.c_str());
  }
}

// Those that would stand closer than a few units are left out.
void draw_row_ticks(const PanelFrame& frame, const Track& track, ImDrawList& list) {
  float last = -1e9f;
  const float length = frame.units(4.0f);
  for (const std::size_t start : frame.own<RunCache>().row_starts()) {
    const float x = track.x_of(start);
    if (x - last < frame.units(3.0f)) continue;
    last = x;
    list.AddLine(ImVec2(x, track.bottom), ImVec2(x, track.bottom + length),
                 style::packed(theme().faint_text, 150));
  }
}

// As many as pixels at most, however many problems there are.
void draw_problem_marks(const PanelFrame& frame, const Track& track, ImDrawList& list) {
  const auto& problems = frame.own<RunCache>().problems();
  const float half = frame.units(3.0f);
  const float y = track.bottom + frame.units(5.0f);
  const auto mark = [&](float x) {
    list.AddTriangleFilled(ImVec2(x, y), ImVec2(x + half, y + 1.8f * half), ImVec2(x - half, y + 1.8f * half),
                           style::packed(theme().problem));
  };
  for (auto it = problems.begin(); it != problems.end();) {
    const float x = track.x_of(*it + 1);
    mark(x);
    const std::size_t beyond = track.position_at(x + half);
    it = std::upper_bound(it + 1, problems.end(), beyond);
  }
  if (frame.timeline()->stop() != nullptr) mark(track.right);
}

void draw_edit_marks(const PanelFrame& frame, const Track& track, ImDrawList& list) {
  const float half = frame.units(4.5f);
  const float y = track.top - half;
  for (const std::size_t at : frame.own<RunCache>().edits()) {
    const float x = track.x_of(at);
    list.AddQuadFilled(ImVec2(x, y - half), ImVec2(x + half, y), ImVec2(x, y + half), ImVec2(x - half, y),
                       style::packed(theme().warning));
  }
}

void draw_scrubber(const PanelFrame& frame, const Track& track, ImDrawList& list) {
  const float x = track.x_of(frame.timeline()->position());
  const float wide = frame.units(1.2f);
  const float over = frame.units(5.0f);
  list.AddRectFilled(ImVec2(x - wide, track.top - over), ImVec2(x + wide, track.bottom + over),
                     style::packed(theme().text));
  list.AddCircleFilled(ImVec2(x, track.top - over), frame.units(5.0f), style::packed(theme().text));
  frame.memory.controls.insert_or_assign("scrubber", Box{x - over, track.top - 2.0f * over, 2.0f * over,
                                                         track.bottom - track.top + 3.0f * over});
}

// The nearest of rising positions within a few units of the pointer; of equals the first.
std::optional<std::size_t> near_pointer(const PanelFrame& frame, const Track& track,
                                        const std::vector<std::size_t>& positions, std::size_t offset) {
  const float x = ImGui::GetIO().MousePos.x;
  const std::size_t at = track.position_at(x);
  auto it = std::lower_bound(positions.begin(), positions.end(), at > offset ? at - offset : 0);
  const auto away = [&](std::vector<std::size_t>::const_iterator of) {
    return std::abs(track.x_of(*of + offset) - x);
  };
  if (it != positions.begin() && (it == positions.end() || away(it - 1) <= away(it))) --it;
  if (it == positions.end() || away(it) > frame.units(4.0f)) return std::nullopt;
  return static_cast<std::size_t>(it - positions.begin());
}

// Where marks of problems hang, below the track.
bool among_problem_marks(const Track& track) { return ImGui::GetIO().MousePos.y > track.bottom; }

// The position that shows the problem whose mark is under the pointer.
std::optional<std::size_t> problem_under(const PanelFrame& frame, const Track& track) {
  if (!among_problem_marks(track)) return std::nullopt;
  const bool stopped = frame.timeline()->stop() != nullptr;
  if (stopped && std::abs(track.right - ImGui::GetIO().MousePos.x) <= frame.units(4.0f)) return track.steps;
  const auto& problems = frame.own<RunCache>().problems();
  const auto problem = near_pointer(frame, track, problems, 1);
  return problem ? std::optional(problems[*problem] + 1) : std::nullopt;
}

void draw_track_tooltip(const PanelFrame& frame, const Track& track) {
  const knit::Timeline& timeline = *frame.timeline();
  const std::size_t position = track.position_at(ImGui::GetIO().MousePos.x);
  std::string words = "Step " + with_commas(position);
  if (position > 0) words += ": " + words_of(timeline.step(position - 1).place);
  if (const std::string tube = tube_words_at(frame, position); !tube.empty()) words += "\n" + tube;
  if (const auto mark = mark_under(frame, track))
    words +=
        "\n\n" + event_words(*timeline.furthest().tubes, mark->event) + "\nClick: to the step that deals it.";
  if (const auto edit = near_pointer(frame, track, frame.own<RunCache>().edits(), 0)) {
    words += "\n\nParameters were changed before " + words_of(timeline.edits()[*edit].at) + ".";
  }
  if (const auto problem = near_pointer(frame, track, frame.own<RunCache>().problems(), 1)) {
    const std::size_t step = frame.own<RunCache>().problems()[*problem];
    words += "\n\n" + knit::narrate(timeline.step(step), timeline.parameters_of_step(step));
    if (among_problem_marks(track)) words += "\nClick: to this step, with what it is about.";
  }
  // A mark covers a few units: the hit nearest below its right edge.
  const BreakHits& hits = frame.session.document->travel.hits;
  const auto hit = hits.before(track.position_at(ImGui::GetIO().MousePos.x + frame.units(4.0f)) + 1);
  if (hit && std::abs(track.x_of(*hit) - ImGui::GetIO().MousePos.x) <= frame.units(4.0f))
    words += "\n\nBreak: " + knit::words_of(*hits.condition_at(*hit)) + ".";
  words += "\n\nDrag: go there. Right drag: a loop that playing goes round in; right click: no loop.";
  tooltip(frame, words);
}

// A press on a mark goes to its step and stays there until the pointer is drawn away.
struct MarkPressed {
  std::optional<std::size_t> at;
};

std::optional<std::size_t> pressed_at(const PanelFrame& frame, const Track& track) {
  if (const auto mark = mark_under(frame, track)) return mark->at;
  return problem_under(frame, track);
}

// What a problem's step is about is selected, so that it is seen in the view.
void select_problem(PanelFrame& frame, std::size_t position) {
  const knit::Timeline& timeline = *frame.timeline();
  const auto& problems = frame.own<RunCache>().problems();
  if (position == 0 || !std::binary_search(problems.begin(), problems.end(), position - 1)) return;
  if (const auto thing = knit::thing_of_problem(timeline.step(position - 1))) frame.wish(LookAt{*thing});
}

void follow_pointer(PanelFrame& frame, const Track& track) {
  std::optional<std::size_t>& pressed = frame.own<MarkPressed>().at;
  const bool begins = ImGui::IsItemActivated();
  if (begins) pressed = pressed_at(frame, track);
  if (ImGui::IsMouseDragging(ImGuiMouseButton_Left, frame.units(4.0f))) pressed.reset();
  const std::size_t wanted = pressed.value_or(track.position_at(ImGui::GetIO().MousePos.x));
  if (wanted != frame.timeline()->position()) frame.wish(SeekTo{wanted});
  if (begins && pressed && problem_under(frame, track) == pressed) select_problem(frame, *pressed);
}

void draw_track(PanelFrame& frame) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  if (room.x < 2.0f || room.y < 2.0f) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float margin = frame.units(6.0f);
  const float top = at.y + frame.units(12.0f);
  const float bottom = std::max(top + 2.0f, at.y + room.y - frame.units(12.0f));
  const knit::Timeline* timeline = frame.timeline();
  if (timeline == nullptr) {
    list.AddRectFilled(ImVec2(at.x + margin, top), ImVec2(at.x + room.x - margin, bottom),
                       style::packed(theme().raised), frame.units(3.0f));
    return;
  }
  const Prelude prelude = prelude_of(*timeline);
  const Track track{at.x + margin, at.x + room.x - margin,          top, bottom, timeline->known(),
                    prelude.steps, prelude.share(timeline->known())};
  ImGui::InvisibleButton("track", room);
  frame.mark("track");
  if (ImGui::IsItemActive()) {
    follow_pointer(frame, track);
  } else if (ImGui::IsItemHovered()) {
    mean_round_under(frame, track);
    if (wants_tooltip()) draw_track_tooltip(frame, track);
  }
  draw_stages(frame, track, list);
  draw_tube_band(frame, track);
  draw_row_ticks(frame, track, list);
  draw_problem_marks(frame, track, list);
  draw_edit_marks(frame, track, list);
  draw_travel_marks(frame, track);
  draw_pattern_marks(frame, track);
  draw_scrubber(frame, track, list);
}

}  // namespace

void draw_timeline(PanelFrame& frame) {
  begin_panel("Timeline", frame.layout.timeline,
              ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  draw_transport(frame);
  draw_track(frame);
  ImGui::End();
}

}  // namespace app
