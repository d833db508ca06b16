// Distance to the anchor along a row's ring, with the band: a saw whose teeth end in the band, and a stall
// where one climbs out of it.
#pragma once

#include <imgui.h>

#include "app/panels/panels.h"

namespace app {

struct CandidatePlot {
  const knit::CandidateTable& table;
  std::optional<std::int32_t> current;   // the candidate at hand, by its place in the ring
  std::optional<std::int32_t> selected;  // likewise
  std::size_t position = 0;              // what was measured from here on is drawn faintly
};

// The place in the ring that was clicked.
std::optional<std::int32_t> draw_candidate_plot(PanelFrame& frame, const CandidatePlot& plot, ImVec2 size);

}  // namespace app
