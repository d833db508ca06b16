// Long work done beside the window: steps that take long, and how close the finished piece is to the mesh,
// the end of the pinned run.
#pragma once

#include "app/session/session.h"
#include "knit/run/timeline.h"

namespace app {

// Takes what is ready, starts what is due; `seconds` since the last call. Does nothing unless session.jobs->beside.
void work_beside(Session& session, double seconds);

// Without a window: the end of the pinned run, at once.
void finish_pin(Session& session);

// How many steps may be worked out in one tick without holding up a frame: fewer where each is dear.
std::size_t steps_of_slice(const knit::Timeline& timeline);

}  // namespace app
