// Words in large letters, broken into lines that can be read from the back of a room.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

struct ImFont;

namespace app {

inline constexpr std::size_t longest_large_line = 40, shortest_large_line = 20;  // letters

// At most so many letters a line, in as few lines as that allows, all about equally long. A word that is longer has a
// line of its own.
std::vector<std::string> even_lines(std::string_view words, std::size_t most_letters);

struct LargeWords {
  std::vector<std::string> lines;
  float size = 0.0f;  // of the font
};
// As large as the room allows, at most `wanted`; lines of 20 to 40 letters where there are that many. Never cut: what is
// long gets smaller.
LargeWords large_words(ImFont* font, std::string_view words, float wanted, float width, float height);

inline constexpr float large_line_height = 1.25f;  // times the font's size

}  // namespace app
