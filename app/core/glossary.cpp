#include "app/core/glossary.h"

#include <algorithm>
#include <string>

namespace app {

namespace {

constexpr std::size_t most_words = 4;  // of one form

bool is_word_byte(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= 0x80U || (byte >= '0' && byte <= '9') || (byte >= 'a' && byte <= 'z');
}

// In small letters, hyphens as blanks; byte for byte, so that places in it are places in the text.
std::string plain(std::string_view text) {
  std::string out(text);
  for (char& c : out) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (c == '-') c = ' ';
  }
  return out;
}

// The next of the names in a list with commas; what is left stays in `list`.
std::string_view take_name(std::string_view& list) {
  const std::size_t comma = list.find(',');
  std::string_view name = list.substr(0, comma);
  list.remove_prefix(comma == std::string_view::npos ? list.size() : comma + 1);
  while (!name.empty() && name.front() == ' ') name.remove_prefix(1);
  return name;
}

bool is_form(std::string_view form, std::string_view words) {
  return form.size() == words.size() && plain(form) == words;
}

// `words` is plain.
const Term* term_called(std::string_view words) {
  for (const Term& term : glossary()) {
    if (is_form(term.word, words)) return &term;
    for (std::string_view forms = term.forms; !forms.empty();) {
      if (is_form(take_name(forms), words)) return &term;
    }
  }
  return nullptr;
}

bool ends_with(std::string_view words, std::string_view end) {
  return words.size() > end.size() && words.substr(words.size() - end.size()) == end;
}

// As it is, or in the plural: "rows", "stitches", "geometries".
const Term* term_of(const std::string& words) {
  if (const Term* term = term_called(words)) return term;
  if (!ends_with(words, "s")) return nullptr;
  if (const Term* term = term_called(words.substr(0, words.size() - 1))) return term;
  if (ends_with(words, "es")) return term_called(words.substr(0, words.size() - 2));
  return nullptr;
}

// Where the first words of a text end, from one that begins at `begin`; only blanks may stand between them.
std::vector<std::size_t> word_ends(const std::string& text, std::size_t begin) {
  std::vector<std::size_t> ends;
  while (ends.size() < most_words) {
    while (begin < text.size() && is_word_byte(text[begin])) ++begin;
    ends.push_back(begin);
    if (begin + 1 >= text.size() || text[begin] != ' ' || !is_word_byte(text[begin + 1])) break;
    ++begin;
  }
  return ends;
}

// The longest that begins there; without a term: to the end of the first word.
TermAt term_from(const std::string& text, std::size_t begin) {
  const std::vector<std::size_t> ends = word_ends(text, begin);
  for (std::size_t words = ends.size(); words > 0; --words) {
    const std::size_t end = ends[words - 1];
    if (const Term* term = term_of(text.substr(begin, end - begin))) return {begin, end, term};
  }
  return {begin, ends.front(), nullptr};
}

}  // namespace

const Term* find_term(std::string_view word) { return term_of(plain(word)); }

std::vector<const Term*> seen_from(const Term& term) {
  std::vector<const Term*> terms;
  for (std::string_view names = term.see; !names.empty();) {
    if (const Term* other = find_term(take_name(names))) terms.push_back(other);
  }
  return terms;
}

std::vector<const Term*> search_glossary(std::string_view typed) {
  const std::string wanted = plain(typed);
  const auto rank = [&](const Term& term) {
    if (plain(term.word).rfind(wanted, 0) == 0) return 0;
    if (plain(term.word).find(wanted) != std::string::npos) return 1;
    if (plain(term.forms).find(wanted) != std::string::npos) return 2;
    return plain(term.meaning).find(wanted) != std::string::npos ? 3 : 4;
  };
  std::vector<const Term*> found;
  for (int wished = 0; wished < 4; ++wished) {
    for (const Term& term : glossary()) {
      if (rank(term) == wished) found.push_back(&term);
    }
  }
  return found;
}

std::vector<TermAt> terms_in(std::string_view text) {
  const std::string words = plain(text);
  std::vector<TermAt> found;
  for (std::size_t at = 0; at < words.size();) {
    if (!is_word_byte(words[at])) {
      ++at;
      continue;
    }
    const TermAt here = term_from(words, at);
    const bool known =
        std::any_of(found.begin(), found.end(), [&](const TermAt& t) { return t.term == here.term; });
    if (here.term != nullptr && !known) found.push_back(here);
    at = here.end;
  }
  return found;
}

}  // namespace app
