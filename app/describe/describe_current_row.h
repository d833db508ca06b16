// The row that the place shown is about, lit where it is finished and a stage goes through its stitches.
#pragma once

#include "app/scene/scene.h"
#include "app/session/session.h"

namespace app {

// While a row is made its stitches are the bright ones; stitches that settle move all at once; of a finished run no row
// is the current one. Requires something open.
void describe_current_row(const Session& session, Scene& scene);

}  // namespace app
