// Tuning keeps one's place: where one was before an action, and what to say when the new run has no such
// place.
#pragma once

#include <optional>
#include <string>

#include "app/core/action.h"

namespace app {

struct Whereabouts {
  std::optional<RunKey> run;         // none: nothing open
  std::optional<knit::Place> place;  // none: the start
  bool moved = false;                // the action is itself a move
};

// Around every action. A move forgets what is said here and is never corrected.
Whereabouts before_action(Session& session, const Action& action);
void after_action(Session& session, const Whereabouts& before);

// A person or the playing moves on: nothing is to come back to, nothing is said.
void forget_place(Session& session);

// Why `shown` is shown and not `wanted`; empty when it is the place wanted. `next`: the place after `shown`.
std::string place_note(const knit::Place& wanted, const knit::Place& shown, const knit::Place& next);

}  // namespace app
