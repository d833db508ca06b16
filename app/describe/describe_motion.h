// A short movement where the last step did something: a ring that closes in on the stitch. It says where to look,
// nothing else; any next step takes its place.
#pragma once

#include <optional>

#include "app/scene/scene.h"
#include "app/session/session.h"

namespace app {

inline constexpr double motion_s = 0.22;

// Of what a step has made or decided; none: nothing that stands at one place.
std::optional<glm::vec3> place_of_step(const Session& session, const knit::Step& step);

// `appeared`: from 0, the step was just taken, to 1, the movement is over.
void describe_motion(const Session& session, double appeared, Scene& scene);

}  // namespace app
