// The centre, empty but for what lies over the scene.
#pragma once

#include <optional>

#include "app/panels/kit/frame.h"

namespace app {

void draw_view(PanelFrame& frame);
void draw_other_view(PanelFrame& frame);      // the half with the pinned run
void draw_captions(PanelFrame& frame);        // inside the view's window
void draw_other_captions(PanelFrame& frame);  // of the pinned run, inside its half
void draw_view_overlays(PanelFrame& frame);   // notices, the picking banner, the empty state
void draw_prediction(PanelFrame& frame);      // over the view: what comes next?

// A click in the view counts once it can no longer become a double click.
struct PendingClick {
  bool waits = false;
  std::optional<knit::Element> thing;  // none: beside everything
  double due = 0.0;
};

// Where the card at a stop stood in the last frame; none: there was none.
struct StopCardPlace {
  std::optional<Box> box;
};

}  // namespace app
