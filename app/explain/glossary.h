// The words that the program uses and not everybody knows: what each means, and where it occurs in a text.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace app {

struct Term {
  std::string_view word;     // "main stitch"
  std::string_view forms;    // what else it is called, with commas: "main, mains"; plain plurals need none
  std::string_view meaning;  // one to three sentences
  std::string_view see;      // words of other terms, with commas
  std::string_view where;    // a section of docs/algorithm.md or of the thesis; may be empty
};

std::span<const Term> glossary();  // by the alphabet
// By its word or any of its forms, in any case, also in the plural; null: there is none.
const Term* find_term(std::string_view word);
// Those that it names in `see`.
std::vector<const Term*> seen_from(const Term& term);
// What a search finds: words that begin so first, then words and meanings that contain it. Nothing typed: all.
std::vector<const Term*> search_glossary(std::string_view typed);

// Where a term stands in a text: bytes, from `begin` to before `end`.
struct TermAt {
  std::size_t begin = 0, end = 0;
  const Term* term = nullptr;
};
// Whole words only, the longest first where several begin alike, each term where it first stands.
std::vector<TermAt> terms_in(std::string_view text);

}  // namespace app
