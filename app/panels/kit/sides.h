// What each side of the right column is drawn by; its own file defines it.
#pragma once

#include <array>

#include "app/panels/kit/frame.h"
#include "app/session/side_panels.h"

namespace app {

// Inside the side panel, below the tabs.
template <SidePanel side>
void draw_side(PanelFrame& frame);

#define KNIT_SIDE(key, words) \
  template <>                 \
  void draw_side<SidePanel::key>(PanelFrame & frame);
KNIT_SIDE_PANELS(KNIT_SIDE)
#undef KNIT_SIDE

using DrawSide = void (*)(PanelFrame&);
#define KNIT_SIDE(key, words) draw_side<SidePanel::key>,
inline constexpr std::array<DrawSide, side_keys.size()> side_drawings{KNIT_SIDE_PANELS(KNIT_SIDE)};
#undef KNIT_SIDE

}  // namespace app
