// What has been begun and is not done. In a window long work is done beside it; without one it is waited for.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "app/base/worker.h"
#include "app/scene/flight.h"
#include "app/session/document.h"
#include "knit/import/repair.h"
#include "knit/quality/closeness.h"
#include "knit/run/timeline.h"

namespace knit {
struct CheckedPattern;
}  // namespace knit

namespace app {

// What a worker does for the session, so that a window stays responsive.
struct LongStep {
  knit::Timeline::Job job;
  Work<knit::Timeline::Outcome> work;
  double seconds = 0.0;  // since it began
};
// The run that is waited for: what the timeline wished when it began (BasicTimeline::tune_beside).
struct AwaitedRun {
  Work<knit::Timeline> work;
  double seconds = 0.0;  // since it began
};
struct Measuring {
  std::uint64_t run = 0;  // hash of the state measured
  Work<std::optional<knit::Closeness>> work;
};
// For the open run: given up with it.
struct RunWork {
  std::optional<LongStep> long_step;
  std::optional<AwaitedRun> awaited;
  std::optional<Measuring> measuring;
};

// A mesh that could not be opened, and what would make it fit. It is not open: what was open still is.
struct RepairOffer {
  Source source;
  std::string finding;  // the sentence: what is wrong with it
  std::shared_ptr<const knit::RepairPlan> plan;
};

// A large file on its way to be open, and what was made ready for an action (opening.h).
struct Opening;
struct MadeMesh;
struct AnimationRun;  // figures.h: replaced whole when it changes

// A large text, read anew; `text`: what it is of.
struct PatternCheck {
  std::shared_ptr<const std::string> text;
  Work<std::shared_ptr<const knit::CheckedPattern>> work;
};

struct Jobs {
  bool beside = false;                        // this is a window
  std::shared_ptr<Opening> opening;           // null: none under way
  std::shared_ptr<const MadeMesh> made_mesh;  // while the action is done that it was made ready for
  std::optional<RepairOffer> repair_offer;    // of the mesh that could not be opened last
  RunWork run;
  std::optional<CameraFlight> flight;             // none: the view is where it is to be
  std::shared_ptr<const AnimationRun> animation;  // in the making; null: none
  std::optional<PatternCheck> pattern_check;
};

}  // namespace app
