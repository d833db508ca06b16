// A place in a line of tokens, for the grammar's files alone. Beyond the end stands an empty token.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string_view>

#include "knit/reader/reader_words.h"

namespace knit {

using WordList = std::initializer_list<std::string_view>;

class TokenCursor {
 public:
  explicit TokenCursor(std::span<const Token> line) : line_(line) {}
  [[nodiscard]] const Token& peek(std::size_t ahead = 0) const {
    return at_ + ahead < line_.size() ? line_[at_ + ahead] : nothing_;
  }
  [[nodiscard]] bool done() const { return at_ >= line_.size(); }
  [[nodiscard]] bool sees(WordList words, std::size_t ahead = 0) const {
    return std::any_of(words.begin(), words.end(), [&](std::string_view w) { return peek(ahead).is(w); });
  }
  bool take(WordList words) {
    if (!sees(words)) return false;
    ++at_;
    return true;
  }
  void skip(std::size_t count = 1) { at_ = std::min(line_.size(), at_ + count); }
  [[nodiscard]] std::size_t at() const { return at_; }
  void back_to(std::size_t at) { at_ = at; }

 private:
  std::span<const Token> line_;
  std::size_t at_ = 0;
  Token nothing_{};
};

// A number in figures or as a word.
inline std::optional<std::int64_t> number_of(const Token& token) {
  if (token.is_number()) return token.value;
  constexpr std::array<std::string_view, 12> words{"one",   "two",   "three", "four", "five",   "six",
                                                   "seven", "eight", "nine",  "ten",  "eleven", "twelve"};
  const auto* const found = std::find(words.begin(), words.end(), token.text);
  if (found == words.end()) return std::nullopt;
  return found - words.begin() + 1;
}

}  // namespace knit
