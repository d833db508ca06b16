// Long work done beside the window: steps that take long, a run that is waited for, how close the finished piece is to the
// mesh, the end of the pinned run.
#pragma once

#include "app/session/session.h"
#include "knit/run/timeline.h"

namespace app {

// Takes what is ready, starts what is due; `seconds` since the last call. Does nothing unless session.jobs->beside.
void work_beside(Session& session, double seconds);

// The run with other parameters. In a window, where that takes longer than a part of a frame, the picture of before stays
// until a worker brings it, with all faces; while a knob is dragged that is the run of a knob a frame ago, and it settles
// once the knob rests.
void tune_run(Session& session, const knit::Parameters& parameters);

// Before a change: cancelling goes back to here, unless it goes back further, as what came before is still worked out.
void note_before_change(Session& session);

// Without a window: the end of the pinned run, at once.
void finish_pin(Session& session);

// How many steps may be worked out in one tick without holding up a frame: fewer where each is dear.
std::size_t steps_of_slice(const knit::Timeline& timeline);

}  // namespace app
