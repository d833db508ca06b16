// Where the step shown happens on the surface, and how the camera turns to it when that is behind.
#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "app/scene/camera.h"
#include "app/session/session.h"

namespace app {

struct StepPlace {
  glm::dvec3 at{0.0};
  glm::dvec3 outward{0.0};  // the surface's normal there, of unit length
};

// Of a vertex measured, a stitch, a label or a face made; none: nothing is open, or the step is about no one place.
std::optional<StepPlace> step_place(const Session& session);

// The camera after turning for so long, about its own target: the same where the place is in sight. It turns the faster
// the more there is to turn, and no further than until the surface there is seen at a slant.
Camera turned_to(const Camera& camera, const StepPlace& place, double seconds);

}  // namespace app
