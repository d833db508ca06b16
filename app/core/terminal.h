// Whether somebody reads along.
#pragma once

namespace app {

bool error_is_terminal();

}  // namespace app
