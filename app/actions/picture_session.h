// Copies of a session that pictures are made from: what is open and how one looks at it, and nothing else.
#pragma once

#include "app/session/session.h"

namespace app {

// With nothing open over it, nothing under the pointer and nothing under way.
Session figure_session(const Session& session);
// The finished piece alone, in a square. Requires something open.
Session finished_piece(const Session& session);
// So that all that is seen in a view of the session's aspect is seen in one of this, which it gets.
void fit_view(Session& session, double aspect);

}  // namespace app
