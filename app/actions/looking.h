// One control for layers and positions together: the mesh, the stitches on it, the piece as it lies in the air, and its yarn.
// What else is shown stays as it is.
#pragma once

#include "app/session/session.h"
#include "app/session/view.h"

namespace app {

// What is shown now: yarn before all else, then by positions and layers.
Looking looking_of(const Session& session);

void show_as(Session& session, Looking looking);

// Stripes from 0 to most_stripe_rounds, colours opaque.
YarnLook within_limits(const YarnLook& look);

}  // namespace app
