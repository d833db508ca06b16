// From a file's bytes to the lines a knitter sees: HTML and Markdown dress taken off, wrapped lines joined, several
// rounds in one line parted.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace knit {

// More in one line are refused.
inline constexpr std::int64_t most_rounds_in_line = 10'000;

struct TextLine {
  std::size_t number = 0;  // of the file, from 1: where it begins
  std::string text;
};

// Any bytes; time linear in their number.
std::vector<TextLine> pattern_lines(std::string_view text);

// HTML to lines, one a block element, without scripts, styles and drawings.
bool looks_like_html(std::string_view text);
std::vector<TextLine> lines_of_html(std::string_view html);

// "Rnd 7:", "Rnds 8-12:" at this place.
bool label_at(std::string_view text, std::size_t at);

}  // namespace knit
