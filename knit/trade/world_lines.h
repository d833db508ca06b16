// What a line of the world's patterns begins with: "Rnd 7:", "2nd rnd:", "7.", "Dec rnd:", "Rnds 2, 4 and 6:",
// "All even rounds:", "Next 3 rnds:".
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "knit/trade/world_words.h"

namespace knit {

struct WorldLabel {
  std::vector<std::pair<std::int64_t, std::int64_t>>
      numbers;                             // "3, 5-8": first and last each; none: it has a name, or nothing
  std::string name;                        // "dec rnd", "next rnd": small letters
  std::int64_t rounds = 1;                 // "Next 3 rnds"
  std::optional<std::int64_t> every_from;  // "Rnd 2 and every alternate rnd": from 2 on
  std::int64_t every_step = 2;
  bool rows = false, sided = false;  // "Row", "(RS)"
  bool bare_number = false;          // "7."
  std::size_t atoms = 0;             // that it takes up
  std::string trouble;               // what is wrong with its numbers
};
std::optional<WorldLabel> world_label(std::span<const Atom> line, const Lexicon& lexicon);

// "THUMB", "First leg:", "Legs (make 2)": few words, no number but that, and nothing to work.
struct WorldTitle {
  std::string name;
  std::int64_t made = 1;
  bool tells = false;  // MATERIALS, NOTES: nothing is worked there
};
std::optional<WorldTitle> world_title(std::span<const Atom> line, const Lexicon& lexicon);

// Whether it looks like work, read or not: stitch words, counts, words for rounds with a verb.
bool looks_like_work(std::span<const Atom> line, const Lexicon& lexicon);
// "k2tog: knit two together", "CO = cast on".
bool is_word_list(std::span<const Atom> line, const Lexicon& lexicon);
// Crochet: "sc", "dc", "ch 3", in lines of work. How many of its words stand there.
std::size_t crochet_words(std::span<const Atom> line);

}  // namespace knit
