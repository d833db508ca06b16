// The state whose stitches are drawn, picked and named: that of the place shown, with its stitches where one wants to see
// them (app/session/shown.h). Copied only where that differs. Refers to the session. Requires something open.
#pragma once

#include <optional>

#include "app/session/document.h"
#include "app/session/shown.h"
#include "app/session/view.h"

namespace app {

class StateShown {
 public:
  explicit StateShown(const Session& session) : state_(&session.document->timeline.state()) {
    if (!places_shown(session)) return;
    placed_ = shown_state(session);
    state_ = &*placed_;
  }
  StateShown(const StateShown&) = delete;
  StateShown& operator=(const StateShown&) = delete;

  const knit::State& operator*() const { return *state_; }
  const knit::State* operator->() const { return state_; }

 private:
  const knit::State* state_;
  std::optional<knit::State> placed_;
};

}  // namespace app
