// The tubes of a drawing as a list below it, in working order: letter, rounds, stitches, and which are alike.
#pragma once

#include <optional>

#include "app/panels/tubes/tubes_drawing.h"

namespace app {

// What a hand does to its lines.
struct TubeListUse {
  std::optional<knit::TubeId> pointed, clicked;
};
// At most so many lines high; it scrolls beyond that.
TubeListUse draw_tube_list(PanelFrame& frame, const TubesDrawing& drawing);
float height_of_tube_list(const PanelFrame& frame, std::size_t tubes);

}  // namespace app
