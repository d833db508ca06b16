// On the track: where break conditions hold, and the stretch that playing goes round in.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "app/panels/kit/ways.h"
#include "app/panels/kit/widgets.h"
#include "app/panels/timeline/track.h"
#include "app/session/document.h"
#include "app/session/view.h"

namespace app {

namespace {

// A drag with the right button on the track, which lays the loop.
struct LoopDrag {
  std::size_t from = 0;  // the position where it began
  float x = 0.0f;        // and on the screen
  bool moved = false;    // far enough to be no click
};

bool over_track(const PanelFrame& frame, const Track& track) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const float margin = frame.units(12.0f);
  return ImGui::IsWindowHovered() && mouse.x >= track.left && mouse.x <= track.right &&
         mouse.y >= track.top - margin && mouse.y <= track.bottom + margin;
}

// A drag with the right button lays the loop; a click with it takes the loop away.
void lay_loop(PanelFrame& frame, const Track& track) {
  std::optional<LoopDrag>& drag = frame.own<std::optional<LoopDrag>>();
  const float x = ImGui::GetIO().MousePos.x;
  if (!drag && ImGui::IsMouseClicked(ImGuiMouseButton_Right) && over_track(frame, track))
    drag = LoopDrag{track.position_at(x), x, false};
  if (!drag) return;
  const std::optional<Stretch>& now = frame.session.document->travel.loop;
  drag->moved = drag->moved || std::abs(x - drag->x) > frame.units(4.0f);
  const std::size_t to = track.position_at(x);
  const Stretch wanted{std::min(drag->from, to), std::max(drag->from, to)};
  if (drag->moved && wanted.begin < wanted.end && now != wanted) frame.wish(SetLoop{wanted});
  if (ImGui::IsMouseDown(ImGuiMouseButton_Right)) return;
  if (!drag->moved && now) frame.wish(SetLoop{});
  drag.reset();
}

void draw_loop(const PanelFrame& frame, const Track& track, ImDrawList& list) {
  const std::optional<Stretch>& loop = frame.session.document->travel.loop;
  if (!loop) return;
  const float left = track.x_of(loop->begin);
  const float right = std::max(track.x_of(loop->end), left + frame.units(2.0f));
  const float over = frame.units(3.0f);
  const float foot = frame.units(4.0f);
  const float wide = frame.units(2.0f);
  const ImU32 colour = style::packed(theme().text, 220);
  list.AddRectFilled(ImVec2(left, track.top), ImVec2(right, track.bottom), style::packed(theme().text, 56));
  const auto handle = [&](float x, float inwards) {
    list.AddLine(ImVec2(x, track.top - over), ImVec2(x, track.bottom + over), colour, wide);
    for (const float y : {track.top - over, track.bottom + over})
      list.AddLine(ImVec2(x, y), ImVec2(x + inwards, y), colour, wide);
  };
  handle(left, foot);
  handle(right, -foot);
}

// As many as pixels at most, however many hits there are.
void draw_hits(const PanelFrame& frame, const Track& track, ImDrawList& list) {
  const BreakHits& hits = frame.session.document->travel.hits;
  const float half = frame.units(3.0f);
  const float y = track.top - frame.units(3.0f);
  for (auto position = hits.from(0); position && *position <= track.steps;) {
    const float x = track.x_of(*position);
    list.AddTriangleFilled(ImVec2(x - half, y - 1.8f * half), ImVec2(x + half, y - 1.8f * half), ImVec2(x, y),
                           style::packed(theme().break_hit));
    position = hits.from(std::max(*position, track.position_at(x + half)) + 1);
  }
}

}  // namespace

void draw_travel_marks(PanelFrame& frame, const Track& track) {
  lay_loop(frame, track);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_loop(frame, track, list);
  draw_hits(frame, track, list);
}

// The round under the pointer on the timeline: the stretch that each stage spends on it, and the other way round.

namespace {

void draw_pattern_mark(const PanelFrame& frame, const Track& track, const knit::Timeline& timeline,
                       const RoundSpan& meant) {
  using knit::Stage;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const Stage stage : {Stage::cast_on, Stage::rows, Stage::stitches, Stage::faces, Stage::pattern}) {
    constexpr std::int32_t low = std::numeric_limits<std::int32_t>::min();
    constexpr std::int32_t high = std::numeric_limits<std::int32_t>::max();
    const std::size_t begin = timeline.position_of({stage, meant.first, low});
    const std::size_t end = timeline.position_of({stage, meant.last, high});
    if (begin == end) continue;
    const float x0 = track.x_of(begin);
    const float x1 = std::max(track.x_of(end), x0 + frame.units(2.0f));
    list.AddRectFilled(ImVec2(x0, track.top), ImVec2(x1, track.bottom), style::packed(theme().accepted, 80));
    list.AddRectFilled(ImVec2(x0, track.bottom), ImVec2(x1, track.bottom + frame.units(3.0f)),
                       style::packed(theme().accepted));
  }
}

}  // namespace

void draw_pattern_marks(PanelFrame& frame, const Track& track) {
  const knit::Timeline* timeline = frame.timeline();
  if (timeline == nullptr) return;
  for (const RoundSpan& meant : all_rounds_meant(frame.session))
    draw_pattern_mark(frame, track, *timeline, meant);
}

void mean_round_under(PanelFrame& frame, const Track& track) {
  const std::size_t position = track.position_at(ImGui::GetIO().MousePos.x);
  if (position == 0) return;
  const std::int32_t row = frame.timeline()->step(position - 1).place.row;
  if (row > 0) frame.rounds_under = RoundSpan{row, row};
}

}  // namespace app
