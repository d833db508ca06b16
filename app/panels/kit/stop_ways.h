// The ways on from a stopped run, tried beside the window: for whoever offers them as buttons.
#pragma once

#include <memory>
#include <string>

#include "app/compare/ways_on.h"
#include "app/panels/kit/frame.h"
#include "app/session/run_key.h"

namespace app {

// Begun when a stopped run is first seen, and anew for another run.
class StopWays {
 public:
  void refresh(const knit::Timeline& timeline);
  [[nodiscard]] const WaysOnWork* work() const { return work_.get(); }  // null: the run did not stop
  // Since it was last asked, and twice more after the end: what was found last is still to be drawn, and a window becomes as high
  // as what it holds a frame later.
  bool was_at_it();

 private:
  RunKey key_;
  int frames_due_ = 0;
  std::shared_ptr<WaysOnWork> work_;
};

// Buttons that take one of the ways, as they are found, and over them what cannot be tried but by hand; `mark`: before their
// names. How many ways there are; nothing where the run did not stop.
std::size_t draw_stop_ways(PanelFrame& frame, const std::string& mark);
// The same at once when all are tried: over what must not move time and again.
void draw_tried_ways(PanelFrame& frame, const std::string& mark);

// Some are being tried: a frame is due when they are.
bool ways_are_tried(PanelMemory& memory);

}  // namespace app
