// A line of the world's patterns in its smallest pieces: "K2tog-tbl" is k, 2, tog, -, tbl. So "k 2 tog", "K2-tog" and
// "k2tog" are the same words. Numbers as words are numbers; fillers ("the", "a") are left out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace knit {

struct Atom {
  enum class Kind : std::uint8_t { word, number, mark };
  Kind kind = Kind::mark;
  std::string text;  // words in lower case; dashes are "-", a times sign is the word "x"
  std::int64_t value = 0;
  std::size_t at = 0, length = 0;  // bytes of the line
  bool glued = false;              // nothing stands between it and the piece before
  [[nodiscard]] bool is(std::string_view wanted) const { return text == wanted; }
  [[nodiscard]] bool is_number() const { return kind == Kind::number; }
  [[nodiscard]] bool is_word() const { return kind == Kind::word; }
};
using Atoms = std::vector<Atom>;

// From `at` on; none beyond the end.
inline std::span<const Atom> rest_of(const Atoms& line, std::size_t at) {
  return std::span(line).subspan(at < line.size() ? at : line.size());
}

inline constexpr std::int64_t most_value = 1'000'000'000;

// Any bytes; linear.
Atoms atoms_of(std::string_view line);

using AtomWords = std::initializer_list<std::string_view>;
bool is_any(const Atom& atom, AtomWords words);
bool holds_any(std::span<const Atom> atoms, AtomWords words);
bool is_stitches(const Atom& atom);
bool is_rounds(const Atom& atom);

}  // namespace knit
