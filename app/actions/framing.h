// The camera where it frames all: it goes on doing so when what is to be seen grows, as a piece that comes off the needles.
#pragma once

#include <optional>

#include "app/session/session.h"
#include "knit/mesh/mesh.h"

namespace app {

void frame_all(Session& session);

// A camera that frames all, and what that is.
struct FramedWhole {
  glm::dvec3 target{0.0};
  double distance = 0.0;
  knit::Bounds bounds;
};
// None: a person or a session put it elsewhere, or nothing is open.
std::optional<FramedWhole> framed_whole(const Session& session);
// After a change that left the camera alone: all is framed again, where there is more or less of it now.
void frame_again(Session& session, const FramedWhole& before);

// A person who has the piece relaxed wants to see it so, and as before once it is not.
void show_as_relaxed(Session& session, bool before, bool now);

}  // namespace app
