// The report card as plain text: the same figures as in the panel, and each row beside the stitches that its
// length holds.
#pragma once

#include <string>

#include "app/core/session.h"

namespace app {

// Requires something open. Measures what has not been measured yet.
std::string card_text(const Session& session);

}  // namespace app
