// A written pattern that is checked as one types: the text with a verdict and the stitches beside each line, what is
// wrong with it, and its shape.
#pragma once

#include "app/panels/kit/frame.h"

namespace app {

// It takes the place of all panels about the mesh.
bool shows_checker(const Session& session);
// In layout.checker and layout.view.
void draw_checker(PanelFrame& frame);

}  // namespace app
