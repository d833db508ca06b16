// The knitted thing as one wants to see it: where stitches have settled, where they were placed, or where they come to lie in
// the air (View::positions).
//
// Only positions differ: rows, links, faces and words are the same. Cheap: what is finished is shared.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <string_view>
#include <vector>

#include "app/session/session.h"
#include "app/session/view.h"
#include "knit/run/state.h"

namespace app {

// Whether there are two positions to choose between: settling has begun, or relaxing.
bool has_settled(const Session& session);
bool has_relaxed(const Session& session);

// Which positions are shown: what is wished, where there are such.
Positions positions_shown(const Session& session);
// Where stitches are shown along the path, by pointer: the same as long as they are there. Null: where the fabric has them.
std::shared_ptr<const std::vector<glm::dvec3>> places_shown(const Session& session);

// What the view has to hold: the mesh and, where the piece in the air is wished, the whole of that too, so that no step of its
// making changes it. Requires something open.
knit::Bounds bounds_shown(const Session& session);

// Of the state shown, with its stitches there. Requires something open.
knit::Fabric shown_fabric(const Session& session);
knit::State shown_state(const Session& session);

// " as placed", " as relaxed" where stitches are shown so; else empty.
std::string_view shown_words(const Session& session);

}  // namespace app
