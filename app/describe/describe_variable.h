// The variable of the pseudo-code that is pointed at, lit in the view where its quantity lives.
#pragma once

#include "app/scene/scene.h"
#include "app/session/session.h"

namespace app {

// Adds to `scene` what session.learning->pointed_variable stands for at this place; whatever layers are shown, as for
// what is selected. Nothing where it stands for nothing to see. Requires something open.
void describe_variable(const Session& session, Scene& scene);

}  // namespace app
