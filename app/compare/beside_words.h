// What tells the pinned run from the current one, in a few words each: what stands over the two halves of the view.
#pragma once

#include <string>

#include "app/session/session.h"

namespace app {

struct BesideWords {
  std::string pinned, here;  // "Stitch width 0.1" and "Stitch width 0.12"
};
// Requires a pinned run.
BesideWords beside_words(const Session& session);

}  // namespace app
