// The scene's captions over a picture of the scene alone.
#pragma once

#include "app/panels/ui.h"

namespace app {

// Needs a frame of ImGui's; the layout's view is the whole picture.
void draw_captions_alone(const Session& session, UiState& ui, const Scene& scene, const Layout& layout,
                         const Fonts& fonts);

}  // namespace app
