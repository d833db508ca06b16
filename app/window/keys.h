// GLFW's names of keys and buttons in ours.
#pragma once

#include "app/actions/input_queue.h"

namespace app {

// `scancode` finds the letter that is printed on the key, whatever the keyboard's layout. Key::None: unknown
// to us.
Key key_from_glfw(int key, int scancode);
MouseButton button_from_glfw(int button);  // MouseButton::Count: unknown to us
Mods mods_from_glfw(int mods);
// Systems differ in whether a modifier's own event counts itself; this makes it so.
Mods mods_after(Mods mods, Key key, bool down);

}  // namespace app
