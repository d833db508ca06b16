// One turn of the window's loop: collect what hands did, let time pass, draw, and do what was wished.
#pragma once

#include <chrono>
#include <string>

#include "app/window/frame.h"
#include "app/window/window.h"

namespace app {

// Popups and notices find their size in a few frames; after these nothing changes until something happens.
inline constexpr int frames_after_event = 3;

struct Pace {
  std::chrono::steady_clock::time_point last = std::chrono::steady_clock::now();
  double frame_seconds = 1.0 / 60.0;  // what a frame costs, smoothed
  int frames_due = frames_after_event;
  bool panels_waited = false;  // for work beside, when looked at last
  std::string shader_problem;  // as told

  double tick();  // seconds since the one before
  // Before a frame: do panels wait for work beside. What the last of it brings changes sizes, as an event does.
  void look_at(bool panels_wait);
};

FrameShape shape_of(const Window& window, double seconds, int samples);

// Gives the seconds since the one before. Sleeps while there is nothing to do.
double turn(Session& session, Window& window, FrameDrawer& drawer, Pace& pace);

}  // namespace app
