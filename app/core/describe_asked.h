// What is asked, in the view: the vertex whose verdict is to be guessed, and what a page of a lesson lights.
#pragma once

#include "app/core/scene.h"
#include "app/core/session.h"

namespace app {

// Adds to `scene`; never gives an answer away. Requires something open.
void describe_asked(const Session& session, Scene& scene);

}  // namespace app
