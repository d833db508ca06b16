// Moving through a run by item, row or stage, to a place by its name, and through a lesson by its pages.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "app/session/action.h"
#include "app/session/at.h"
#include "app/session/run_key.h"

namespace app {

// Moves there. A sentence if the run has no such place; it then shows the nearest before it.
std::optional<std::string> go_to(Session& session, const At& at);
// The page's number from 1, as the command line has it; the error is one sentence.
std::optional<std::string> go_to_lesson_page(Session& session, std::int32_t number);

// The position that a step of one unit leads to, working the run out as far as needed.
// Forward: past the rest of the current row (stage). Back: to its beginning, or that of the one before.
std::size_t position_after(knit::Timeline& timeline, Unit unit, int direction);

// The position just after the last step at or before `place`, working the run out until then.
std::size_t position_at(knit::Timeline& timeline, const knit::Place& place);

// Where a step of this unit forwards leads, when that can be said before it is worked out.
std::optional<knit::Place> place_ahead(const knit::Timeline& timeline, Unit unit);

// Steps over, into and out, as in a debugger whose calls are stage, row and item: by which unit a step goes,
// the same forwards and backwards. Over: by the whole stage or row that begins (backwards: ends) here. Out: by
// the rest of the current row, at its end of the stage. None: by all that is left, at a stage's end.
std::optional<Unit> unit_of_depth(const knit::Timeline& timeline, Depth depth);

// From before the first of the places to after the last one; none where a run has none of these steps.
std::optional<Stretch> stretch_of(const knit::Timeline& timeline, const PlaceStretch& places);

// The current row in the current stage, as far as it is known; none at the start.
std::optional<Stretch> stretch_of_row(const Session& session);

// Tuning keeps one's place: where one was before an action, and what to say when the new run has no such
// place.

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
