#pragma once

#include "app/session/preferences.h"

namespace app {

// In ShowPanel: all that can be closed, at once.
inline constexpr Panel every_panel{static_cast<Panel>(panel_keys.size())};

}  // namespace app
