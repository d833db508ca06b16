// Work beside the loop that draws. A program of the system's gives it a thread of its own; a page, which has none, does it
// at once, or piece by piece between two turns.
#pragma once

#include <functional>

namespace app {

// Begins the work and does not wait for it. Where there are no threads it is done when this returns.
void start_beside(std::function<void()> work);

// Calls `piece` again and again while it returns true. A piece should take no longer than a frame or two.
void start_in_pieces(std::function<bool()> piece);

// How many pieces may run at the same time, at least 1.
unsigned hands_beside();

}  // namespace app
