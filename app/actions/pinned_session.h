// The pinned run as a session of its own, at the place of the current one: what stands left of it where both are seen.
#pragma once

#include <memory>
#include <optional>

#include "app/base/worker.h"
#include "app/session/changes.h"
#include "app/session/session.h"
#include "knit/run/timeline.h"

namespace app {

class PinnedSession {
 public:
  // By the same stage, row and item as the current run's, and seen alike; null: one does not look at both. In a window a
  // worker works the run out, and until it is there what both runs have in common is seen; else it is worked out here.
  const Session* refresh(const Session& session);
  // A next frame is due when the worker is done.
  [[nodiscard]] bool pending() const { return work_.running(); }

 private:
  void begin(const Session& session);
  void follow(const Session& session);

  std::shared_ptr<const knit::Input> input_;  // of the run in `pinned_`
  Knobs knobs_;
  std::unique_ptr<Session> pinned_;
  Work<knit::Timeline> work_;
};

}  // namespace app
