// What is selected: lit in the view, with the step that made it.
#pragma once

#include "app/core/scene.h"
#include "app/core/session.h"

namespace app {

void describe_selected(const Session& session, Scene& scene);

}  // namespace app
