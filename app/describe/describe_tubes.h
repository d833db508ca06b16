// What there is to see of tubes: the critical vertices that the sweep has come to, the curves that are planned, a deal in
// progress, bridges, and the loops that wait on holders.
#pragma once

#include "app/scene/scene.h"
#include "app/session/session.h"

namespace app {

void describe_tubes(const Session& session, Scene& scene);

}  // namespace app
