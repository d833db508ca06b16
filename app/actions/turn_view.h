// Turning the view to something: as little as shows it from the front. What is on the screen and faces the viewer stays.
#pragma once

#include "app/session/session.h"
#include "knit/insight/sized.h"

namespace app {

// At the place of the run that is shown; else where the thing is going to be. Requires something open.
void turn_to(Session& session, const knit::Element& thing);
// To the one of them that the view needs to turn least for.
void turn_to(Session& session, const knit::SizeRange& range);

}  // namespace app
