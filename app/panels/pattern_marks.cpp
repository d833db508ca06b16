// The round under the pointer on the timeline: the stretch that each stage spends on it, and the other way round.
#include <cstdint>
#include <limits>

#include "app/panels/track.h"
#include "app/panels/widgets.h"

namespace app {

void draw_pattern_marks(PanelFrame& frame, const Track& track) {
  using knit::Stage;
  const auto meant = rounds_meant(frame.session);
  const knit::Timeline* timeline = frame.timeline();
  if (!meant || timeline == nullptr) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const Stage stage : {Stage::cast_on, Stage::rows, Stage::stitches, Stage::faces, Stage::pattern}) {
    constexpr std::int32_t low = std::numeric_limits<std::int32_t>::min();
    constexpr std::int32_t high = std::numeric_limits<std::int32_t>::max();
    const std::size_t begin = timeline->position_of({stage, meant->first, low});
    const std::size_t end = timeline->position_of({stage, meant->last, high});
    if (begin == end) continue;
    const float x0 = track.x_of(begin);
    const float x1 = std::max(track.x_of(end), x0 + frame.units(2.0f));
    list.AddRectFilled(ImVec2(x0, track.top), ImVec2(x1, track.bottom), style::packed(theme().accepted, 80));
    list.AddRectFilled(ImVec2(x0, track.bottom), ImVec2(x1, track.bottom + frame.units(3.0f)),
                       style::packed(theme().accepted));
  }
}

void mean_round_under(PanelFrame& frame, const Track& track) {
  const std::size_t position = track.position_at(ImGui::GetIO().MousePos.x);
  if (position == 0) return;
  const std::int32_t row = frame.timeline()->step(position - 1).place.row;
  if (row > 0) frame.rounds_under = RoundSpan{row, row};
}

}  // namespace app
