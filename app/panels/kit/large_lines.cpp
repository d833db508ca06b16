#include "app/panels/kit/large_lines.h"

#include <imgui.h>

#include <algorithm>
#include <cfloat>

#include "app/explain/window_words.h"

namespace app {

namespace {

std::size_t letters_of(std::string_view words) {
  // Bytes that go on with a letter do not count.
  return static_cast<std::size_t>(std::count_if(
      words.begin(), words.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::vector<std::string> filled_lines(std::string_view words, std::size_t most_letters) {
  std::vector<std::string> lines;
  std::size_t in_line = 0;
  for (std::size_t at = 0; at < words.size();) {
    const std::size_t begin = words.find_first_not_of(" \n", at);
    if (begin == std::string_view::npos) break;
    const std::size_t end = std::min(words.find_first_of(" \n", begin), words.size());
    const std::string_view word = words.substr(begin, end - begin);
    const std::size_t letters = letters_of(word);
    if (lines.empty() || in_line + 1 + letters > most_letters) {
      lines.emplace_back(word);
      in_line = letters;
    } else {
      lines.back().append(" ").append(word);
      in_line += 1 + letters;
    }
    at = end;
  }
  return lines;
}

float widest(ImFont* font, float size, const std::vector<std::string>& lines) {
  float width = 0.0f;
  for (const std::string& line : lines)
    width = std::max(width, font->CalcTextSizeA(size, FLT_MAX, 0.0f, line.c_str()).x);
  return width;
}

}  // namespace

std::vector<std::string> even_lines(std::string_view words, std::size_t most_letters) {
  std::vector<std::string> lines = filled_lines(words, most_letters);
  for (std::size_t fewer = most_letters; fewer > 1; --fewer) {
    std::vector<std::string> narrower = filled_lines(words, fewer - 1);
    if (narrower.size() > lines.size()) break;
    lines = std::move(narrower);
  }
  return lines;
}

LargeWords large_words(ImFont* font, std::string_view words, float wanted, float width, float height) {
  const std::string shown = in_window_words(words);
  constexpr std::size_t fewer = 5;
  constexpr float smaller = 0.94f;
  constexpr float least_share = 0.2f;  // of what is wanted; there are no sentences as long as that
  for (float size = wanted; size > least_share * wanted; size *= smaller) {
    for (std::size_t letters = longest_large_line; letters >= shortest_large_line; letters -= fewer) {
      std::vector<std::string> lines = even_lines(shown, letters);
      const bool fits = static_cast<float>(lines.size()) * large_line_height * size <= height &&
                        widest(font, size, lines) <= width;
      if (fits) return {std::move(lines), size};
    }
  }
  return {even_lines(shown, longest_large_line), least_share * wanted};
}

}  // namespace app
