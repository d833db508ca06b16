// Finding a line by what a person types: words in any order, each by its beginning, a part of it or its letters in
// order.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace app {

struct Searchable {
  std::string_view words;  // "Set epsilon to..."
  std::string_view more;   // found by it too, but later: its group, its help
  std::string_view keys;   // "Ctrl+Y or Ctrl+Shift+Z"
};

// How well it fits, the higher the better; none: some word of what is typed is not in it. Nothing typed fits all
// alike. A key typed exactly, in any case, fits best.
std::optional<int> fit(std::string_view typed, const Searchable& line);

}  // namespace app
