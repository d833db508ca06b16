// A place in a sentence of a pattern with limbs, for the files beside it alone: what is taken is as it is wanted, or nothing is.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "knit/reader/reader_words.h"
#include "knit/trade/characters.h"

namespace knit {

// "Limb B"; as a heading of several says it, the word is in the plural.
struct LimbName {
  std::string word, letters;
  std::int32_t holder = 1;  // of several holders that go by one piece
  [[nodiscard]] std::string text() const {
    return word + " " + letters + (holder > 1 ? " (holder " + std::to_string(holder) + ")" : "");
  }
};

class LimbScan {
 public:
  explicit LimbScan(std::string_view text) : rest_(text) {}
  [[nodiscard]] bool done() const { return rest_.empty(); }
  [[nodiscard]] std::string_view rest() const { return rest_; }
  [[nodiscard]] bool sees(std::string_view words) const { return rest_.starts_with(words); }
  bool take(std::string_view words) {
    if (!sees(words)) return false;
    rest_.remove_prefix(words.size());
    return true;
  }
  std::optional<std::int32_t> number() {
    std::int64_t value = 0;
    std::size_t digits = 0;
    for (; digits < rest_.size() && is_digit(rest_[digits]); ++digits)
      value = value > most_number ? value : value * 10 + (rest_[digits] - '0');
    if (digits == 0 || value > most_number) return std::nullopt;
    rest_.remove_prefix(digits);
    return static_cast<std::int32_t>(value);
  }
  // "5 sts", "1 st"
  std::optional<std::int32_t> stitches() {
    const LimbScan begin = *this;
    const auto count = number();
    if (count && take(*count == 1 ? " st" : " sts") && (done() || !is_letter(rest_.front()))) return count;
    *this = begin;
    return std::nullopt;
  }
  std::optional<std::string> capitals() {
    std::size_t end = 0;
    while (end < rest_.size() && rest_[end] >= 'A' && rest_[end] <= 'Z') ++end;
    if (end == 0 || end > 2) return std::nullopt;
    std::string letters(rest_.substr(0, end));
    rest_.remove_prefix(end);
    return letters;
  }
  // "Limb"
  std::optional<std::string> word() {
    std::size_t end = 1;
    if (rest_.empty() || rest_.front() < 'A' || rest_.front() > 'Z') return std::nullopt;
    while (end < rest_.size() && rest_[end] >= 'a' && rest_[end] <= 'z') ++end;
    if (end < 2) return std::nullopt;
    std::string text(rest_.substr(0, end));
    rest_.remove_prefix(end);
    return text;
  }
  std::optional<LimbName> name() {
    const LimbScan begin = *this;
    const auto first = word();
    if (first && take(" ")) {
      const auto letters = capitals();
      if (letters && (done() || !is_letter(rest_.front()))) return LimbName{*first, *letters, 1};
    }
    *this = begin;
    return std::nullopt;
  }
  // "Limb B", "Limb B (holder 2)"
  std::optional<LimbName> holder() {
    auto name = this->name();
    const LimbScan begin = *this;
    if (!name || !take(" (holder ")) return name;
    const auto number = this->number();
    if (number && *number > 1 && *number < 100 && take(")"))
      name->holder = *number;
    else
      *this = begin;
    return name;
  }
  // " (12 sts)" at the end
  std::optional<std::int32_t> count_at_end() {
    const LimbScan begin = *this;
    if (take(" (")) {
      const auto count = stitches();
      if (count && take(")") && done()) return count;
    }
    *this = begin;
    return std::nullopt;
  }

 private:
  std::string_view rest_;
};

}  // namespace knit
