// What an example looks like when it is knitted, where one is chosen: a small picture, made by tools/pictures.sh
// --examples, which lies beside the example as picture.png.
//
// Panels cannot read pictures: they say that they want them, and whoever draws the frame fills in the textures before the
// next one. Without a picture only the name is there.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "app/panels/kit/frame.h"

namespace app {

// Pixels of a file; on the screen they are smaller.
inline constexpr int example_picture_width_px = 160, example_picture_height_px = 120;

struct ExamplePictures {
  bool wanted = false;                                         // by a panel, in this frame or before
  bool filled = false;                                         // as far as there are any
  std::map<std::string, std::uint32_t, std::less<>> textures;  // OpenGL's names, by the example's
};

// A button: the picture over the name. True when it is clicked.
bool example_tile(PanelFrame& frame, const std::string& name, ImVec2 size);
// A line of a menu: the picture before the name.
bool example_line(PanelFrame& frame, const std::string& name, bool open, ImVec2 size);

}  // namespace app
