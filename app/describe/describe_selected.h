// What is selected: lit in the view, with the step that made it.
#pragma once

#include "app/scene/scene.h"
#include "app/session/session.h"

namespace app {

void describe_selected(const Session& session, Scene& scene);
// All edges or corners of a size, lit likewise. Requires something open.
void describe_sized(const Session& session, Scene& scene);

// What is asked, in the view: the vertex whose verdict is to be guessed, and what a page of a lesson lights.

// Adds to `scene`; never gives an answer away. Requires something open.
void describe_asked(const Session& session, Scene& scene);

// What the pointer or the person who knits along means, lit in the view: a stitch, whole rounds.

// Adds to `scene`. A round that is not made yet at this place of the run stands where it is going to be.
// Requires something open.
void describe_meant(const Session& session, Scene& scene);

}  // namespace app
