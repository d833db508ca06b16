// The knitted thing as one wants to see it: where stitches have settled, or where they were placed (View::positions).
//
// Only positions differ: rows, links, faces and words are the same. Cheap: what is finished is shared.
#pragma once

#include <string_view>

#include "app/session/session.h"
#include "knit/run/state.h"

namespace app {

// Whether there are two positions to choose between: settling has begun.
bool has_settled(const Session& session);

// Of the state shown, with its stitches there. Requires something open.
knit::Fabric shown_fabric(const Session& session);
knit::State shown_state(const Session& session);

// " as placed" where stitches are shown so and have settled; else empty.
std::string_view shown_words(const Session& session);

}  // namespace app
