// A written pattern that is being checked: its text, what the checker says of it, and how one looks at both. Any text
// at all; no mesh is needed.
//
// Replaced whole when something changes, so that whoever holds one sees it stay as it is. Texts are shared: the same
// pointer is the same text.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/scene/camera.h"
#include "knit/reader/checked_pattern.h"

namespace app {

using CheckVerdict = decltype(knit::CheckedPattern::verdict);
using SharedText = std::shared_ptr<const std::string>;

// Where one is in the text: a line from 1, a byte of it from 0, and so many bytes marked from there.
struct TextCaret {
  std::size_t line = 1, at = 0, length = 0;
  friend bool operator==(const TextCaret&, const TextCaret&) = default;
};

// Stitches and rows on 10 cm: what the preview is as large as.
struct CheckedGauge {
  double stitches = 22.0, rows = 32.0;
  friend bool operator==(const CheckedGauge&, const CheckedGauge&) = default;
};
inline constexpr double least_gauge = 1.0, most_gauge = 200.0;

// "22x32"; none: it is no gauge, or out of range.
std::optional<CheckedGauge> checked_gauge(std::string_view text);

// Pieces stand on their cast on, which one looks down at.
inline constexpr double look_down = 0.32;

struct Checker {
  std::filesystem::path path;  // of the file it came from or went to; empty: none
  SharedText text = std::make_shared<const std::string>();
  SharedText saved = text;  // what the file has; with no file the empty text
  SharedText before;        // what stood there before it was replaced; null: nothing
  std::shared_ptr<const knit::CheckedPattern> checked;  // of `checked_text`; null: not checked yet
  SharedText checked_text;
  std::size_t size = 0;  // of the pattern's sizes, the one shown
  TextCaret caret;
  CheckedGauge gauge;
  Camera camera{glm::dvec3(0.0), 4.0, 0.15, look_down};  // of the preview
  bool moved = false;  // the view, by hand: it stays as it is while one types, else all of the shape is in it

  [[nodiscard]] bool up_to_date() const { return checked != nullptr && checked_text == text; }
  [[nodiscard]] bool unsaved() const { return *saved != *text; }
  // Null until it is checked.
  [[nodiscard]] const knit::CheckedSize* shown() const;
};

// What is said of a line, by its number; null: nothing. O(log lines).
const knit::CheckedLine* line_numbered(const knit::CheckedSize& size, std::size_t number);
// A line that one has to look at, with its sentence: what the list of mistakes shows.
bool is_mistake(const knit::CheckedLine& line);
// In the order of the text.
std::vector<const knit::CheckedLine*> mistakes_of(const knit::CheckedSize& size);
// The next of them after a line, or the one before; round at the end. Null: there is none.
const knit::CheckedLine* mistake_from(const knit::CheckedSize& size, std::size_t line, int direction);

// What of a line its sentence is about: a word, or all of it.
TextCaret mark_of(const Checker& checker, const knit::CheckedLine& line);

// Where each line begins in the text; there is always one. O(bytes).
std::vector<std::size_t> line_starts(std::string_view text);
// The caret at a byte of the text, and back; what lies beyond an end is brought to it.
TextCaret caret_at(const std::vector<std::size_t>& starts, std::size_t byte);
std::size_t byte_of(const std::vector<std::size_t>& starts, std::size_t bytes, const TextCaret& caret);

// "Does not add up" and what follows from it, in one sentence, of all sizes. Never empty.
std::string verdict_words(CheckVerdict verdict);
std::string summary_words(const Checker& checker);
// Of one line, where the checker says nothing of its own.
std::string_view verdict_words(knit::LineVerdict verdict);

}  // namespace app
