// What the program says, as it is said in the window: sentences name settings as the command line takes them
// ("--rows contours"), since scripts read them; a person who looks at panels finds "Rows from: contours" there.
#pragma once

#include <string>
#include <string_view>

namespace app {

// Options of settings become their labels, with a value in quotes; a preset and what can be saved go by their words in the
// menus. A part of a sentence that is about the command line alone falls away. Other text stays as it is.
std::string in_window_words(std::string_view text);

}  // namespace app
