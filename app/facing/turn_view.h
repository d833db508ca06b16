// Turning the view to something: as little as shows it from the front. What is on the screen and faces the viewer stays.
#pragma once

#include "app/scene/camera.h"
#include "app/session/session.h"
#include "knit/insight/sized.h"

namespace app {

// The view's camera, turned to a thing at the place of the run that is shown; else to where it is going to be. Requires
// something open.
Camera turned_to(const Session& session, const knit::Element& thing);
// To the one of them that the view needs to turn least for.
Camera turned_to(const Session& session, const knit::SizeRange& range);

}  // namespace app
