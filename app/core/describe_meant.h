// What the pointer or the person who knits along means, lit in the view: a stitch, whole rounds.
#pragma once

#include "app/core/scene.h"
#include "app/core/session.h"

namespace app {

// Adds to `scene`. A round that is not made yet at this place of the run stands where it is going to be.
// Requires something open.
void describe_meant(const Session& session, Scene& scene);

}  // namespace app
