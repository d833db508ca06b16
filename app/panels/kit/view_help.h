// What the mouse does in the view: one table for the help and for the hint in the view's corner.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace app {

struct MouseHelp {
  std::string_view what;
  std::string_view words;
  std::string_view hint;  // short, for the corner; empty: not there
};

inline constexpr std::array mouse_help{
    MouseHelp{"Click", "Say why: to the step that made it", "click says why"},
    MouseHelp{"Ctrl+click", "The same for the mesh's vertex there", ""},
    MouseHelp{"Left drag", "Turn", "left drag turns"},
    MouseHelp{"Right drag", "Move", "right drag moves"},
    MouseHelp{"Middle drag", "Move", ""},
    MouseHelp{"Shift+left drag", "Move", ""},
    MouseHelp{"Wheel", "Zoom to the pointer", "wheel zooms"},
    MouseHelp{"Double click", "Frame the mesh", ""},
    MouseHelp{"Drop a file", "Open it", ""},
};

// In a line of this width as many hints as there is room for, each whole; that which leads to all of them always. Needs a frame of
// ImGui's.
std::string hint_words(float width);

}  // namespace app
