// The run that another is compared with: kept whole while the current one is tuned.
#pragma once

#include <memory>
#include <optional>

#include "app/base/worker.h"
#include "app/session/run_figures.h"

namespace app {

struct Session;

struct PinnedEnd {
  knit::State state;
  RunFigures figures;
};

// `input` and `knobs` say it all; the rest is worked out from them when it is missing.
struct Pin {
  std::shared_ptr<const knit::Input> input;
  Knobs knobs;
  knit::State end;  // of the run, finished or stopped
  RunFigures figures;
  bool known = false;  // end and figures are there
  std::optional<Work<PinnedEnd>> work;
};

// The current run as a pin; without its end while that is being worked out. Requires something open.
Pin pin_of(const Session& session);
PinnedEnd end_of(const RunTally& run, const Knobs& knobs);
void take_end(Pin& pin, PinnedEnd end);
// Whether it is the current run that is pinned.
bool is_at_hand(const Session& session, const Pin& pin);
// It lacks its end still, and a frame is due when it comes.
bool pin_is_pending(const Session& session);
// Whether the pinned run is seen beside the current one.
bool shows_both(const Session& session);
// Whether the pinned run is of the current mesh: the same vertices, welded or not.
bool is_of_this_mesh(const Session& session, const Pin& pin);

}  // namespace app
