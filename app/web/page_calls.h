// What the page's script (page.js) does for the program, and under which names it answers. Strings are UTF-8; a window is
// told apart by a pointer that the script hands back as it got it.
#pragma once

#include "app/actions/input_queue.h"

namespace app {

// KeyboardEvent.code and .key; Key::None: unknown to us.
Key key_of_page(const char* code, const char* key);
// As page.js packs them: 1 shift, 2 ctrl, 4 alt, 8 super, as they are after the event.
Mods mods_of_page(int packed);

// WebGL 2 on the page's canvas, made current: a context of emscripten's; 0 or less: there is none.
int open_canvas();
inline constexpr const char* no_webgl =
    "This browser draws no WebGL 2. Switch on hardware acceleration in its settings, or take a newer "
    "browser.";

}  // namespace app
