// The short form of a pattern: rounds that are named once and then worked by name, and markers between sections.
//
//   "Place a marker (m) after every 2 sts: 4 markers."
//   "Place markers (m) after 2, 6 and 10 sts: side, front and side"
//   "Inc rnd: [K1, m1l, k to next m, m1r] 4 times. (+8 sts)"
//   "[Knit 1 rnd, inc rnd] 6 times. (16, 24, 32, 40, 48, 56 sts)"
// Nothing is worked here: `pattern_reader` does that.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "knit/reader/reader_grammar.h"

namespace knit {

struct PlacedMarkers {
  std::int64_t every = 1, markers = 0;
};
std::optional<PlacedMarkers> markers_placed_in(std::span<const Token> line);

// "Place markers (m) after 2, 6 and 10 sts: side, front and side": as many places as names; the round's beginning is not among
// them.
struct NamedMarkers {
  std::vector<std::int64_t> after;
  std::vector<MarkerName> names;
};
std::optional<NamedMarkers> named_markers_in(std::span<const Token> line);

struct NamedWords {
  std::string name;  // "inc rnd", "dec rnd b"
  RoundWords words;  // its mistake says too where its own change is not as told
};
// Only a line that tells a change with its sign: another "Inc rnd:" is prose.
std::optional<NamedWords> named_words_in(std::span<const Token> line);

struct ToldRounds {
  struct Part {
    std::string name;         // empty: knit rounds
    std::int64_t rounds = 1;  // of a named one always 1
  };
  std::vector<Part> parts;
  std::int64_t times = 1;
  std::vector<std::int64_t> counts;  // after each round that is named
  std::string mistake;
  [[nodiscard]] std::int64_t rounds() const;      // all times together
  [[nodiscard]] std::int64_t named_ones() const;  // of them
};
// Nothing where no round is named among the words.
std::optional<ToldRounds> told_rounds_in(std::span<const Token> words);

}  // namespace knit
