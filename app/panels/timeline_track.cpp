// The track: stages as coloured stretches, rows as ticks, marks for edits and problems, the scrubber.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "app/panels/track.h"
#include "app/panels/widgets.h"
#include "knit/narrate.h"

namespace app {

namespace {

void draw_stages(const PanelFrame& frame, const Track& track, ImDrawList& list) {
  const float now = track.x_of(frame.timeline()->position());
  for (const RunCache::Stretch& stretch : frame.ui.run.stages()) {
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
    const ImVec2 at(0.5f * (x0 + x1 - size.x), 0.5f * (track.top + track.bottom - size.y));
    list.AddText(at, style::packed(theme().text), name.c_str());
  }
}

// Those that would stand closer than a few units are left out.
void draw_row_ticks(const PanelFrame& frame, const Track& track, ImDrawList& list) {
  float last = -1e9f;
  const float length = frame.units(4.0f);
  for (const std::size_t start : frame.ui.run.row_starts()) {
    const float x = track.x_of(start);
    if (x - last < frame.units(3.0f)) continue;
    last = x;
    list.AddLine(ImVec2(x, track.bottom), ImVec2(x, track.bottom + length),
                 style::packed(theme().faint_text, 150));
  }
}

// As many as pixels at most, however many problems there are.
void draw_problem_marks(const PanelFrame& frame, const Track& track, ImDrawList& list) {
  const auto& problems = frame.ui.run.problems();
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
  for (const std::size_t at : frame.ui.run.edits()) {
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
  frame.ui.controls.insert_or_assign("scrubber", Box{x - over, track.top - 2.0f * over, 2.0f * over,
                                                     track.bottom - track.top + 3.0f * over});
}

// The nearest of rising positions within a few units of the pointer.
std::optional<std::size_t> near_pointer(const PanelFrame& frame, const Track& track,
                                        const std::vector<std::size_t>& positions, std::size_t offset) {
  const float x = ImGui::GetIO().MousePos.x;
  const float reach = frame.units(4.0f);
  const std::size_t from = track.position_at(x - reach);
  const auto it = std::lower_bound(positions.begin(), positions.end(), from > offset ? from - offset : 0);
  if (it == positions.end() || std::abs(track.x_of(*it + offset) - x) > reach) return std::nullopt;
  return static_cast<std::size_t>(it - positions.begin());
}

void draw_track_tooltip(const PanelFrame& frame, const Track& track) {
  const knit::Timeline& timeline = *frame.timeline();
  const std::size_t position = track.position_at(ImGui::GetIO().MousePos.x);
  std::string words = "Step " + with_commas(position);
  if (position > 0) words += ": " + words_of(timeline.step(position - 1).place);
  if (const auto edit = near_pointer(frame, track, frame.ui.run.edits(), 0)) {
    words += "\n\nParameters were changed before " + words_of(timeline.edits()[*edit].at) + ".";
  }
  if (const auto problem = near_pointer(frame, track, frame.ui.run.problems(), 1)) {
    const std::size_t step = frame.ui.run.problems()[*problem];
    words += "\n\n" + knit::narrate(timeline.step(step), timeline.parameters_of_step(step));
  }
  // A mark covers a few units: the hit nearest below its right edge.
  const BreakHits& hits = frame.session.travel.hits;
  const auto hit = hits.before(track.position_at(ImGui::GetIO().MousePos.x + frame.units(4.0f)) + 1);
  if (hit && std::abs(track.x_of(*hit) - ImGui::GetIO().MousePos.x) <= frame.units(4.0f))
    words += "\n\nBreak: " + knit::words_of(*hits.condition_at(*hit)) + ".";
  words += "\n\nDrag: go there. Right drag: a loop that playing goes round in; right click: no loop.";
  tooltip(frame, words);
}

}  // namespace

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
  const Track track{at.x + margin, at.x + room.x - margin, top, bottom, timeline->known()};
  ImGui::InvisibleButton("track", room);
  frame.mark("track");
  if (ImGui::IsItemActive()) {
    const std::size_t wanted = track.position_at(ImGui::GetIO().MousePos.x);
    if (wanted != timeline->position()) frame.wish(SeekTo{wanted});
  } else if (ImGui::IsItemHovered()) {
    mean_round_under(frame, track);
    if (wants_tooltip()) draw_track_tooltip(frame, track);
  }
  draw_stages(frame, track, list);
  draw_row_ticks(frame, track, list);
  draw_problem_marks(frame, track, list);
  draw_edit_marks(frame, track, list);
  draw_travel_marks(frame, track);
  draw_pattern_marks(frame, track);
  draw_scrubber(frame, track, list);
}

}  // namespace app
