#include "app/base/word_search.h"

#include <algorithm>
#include <vector>

namespace app {

namespace {

constexpr int as_a_key = 1000;
constexpr int whole_word = 100;
constexpr int beginning = 80;
constexpr int first_word = 6;  // more when it is the line's first
constexpr int part = 40;
constexpr int letters = 20;     // of the line, in order, each run of them at a word's beginning
constexpr int in_the_rest = 8;  // the beginning of a word in what is found later

std::string small(std::string_view text) {
  std::string out(text);
  for (char& c : out) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return out;
}

bool is_separator(char c) {
  constexpr std::string_view separators = " -:/,.()\"";
  return separators.find(c) != std::string_view::npos;
}

std::vector<std::string> words_in(const std::string& text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    if (!is_separator(c)) {
      words.back() += c;
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

// Whether the letters stand in the words in this order: going on in the same word, or at the next one's beginning.
// So "gtr" is found in "go to row", but not any three letters anywhere.
bool has_letters(const std::vector<std::string>& words, std::string_view wanted, std::size_t from) {
  if (wanted.empty()) return true;
  for (std::size_t i = from; i < words.size(); ++i) {
    const std::string& word = words[i];
    for (std::size_t n = 1; n <= wanted.size() && n <= word.size() && word[n - 1] == wanted[n - 1]; ++n) {
      if (has_letters(words, wanted.substr(n), i + 1)) return true;
    }
  }
  return false;
}

bool begins_some(const std::string& wanted, const std::vector<std::string>& words) {
  return std::any_of(words.begin(), words.end(),
                     [&](const std::string& w) { return w.rfind(wanted, 0) == 0; });
}

std::optional<int> fit_of_word(const std::string& wanted, const std::vector<std::string>& words,
                               const std::vector<std::string>& rest) {
  int best = -1;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::size_t at = words[i].find(wanted);
    if (at == std::string::npos) continue;
    const int here = words[i] == wanted ? whole_word : at == 0 ? beginning : part;
    best = std::max(best, here + (i == 0 ? first_word : 0));
  }
  if (best < 0 && wanted.size() > 1 && has_letters(words, wanted, 0)) best = letters;
  if (best < 0 && begins_some(wanted, rest)) best = in_the_rest;
  return best < 0 ? std::nullopt : std::optional(best);
}

// "Ctrl+Y or Ctrl+Shift+Z" has two.
bool is_a_key_of(std::string_view typed, const std::string& keys) {
  constexpr std::string_view between = " or ";
  for (std::size_t begin = 0; begin < keys.size();) {
    const std::size_t end = std::min(keys.find(between, begin), keys.size());
    if (std::string_view(keys).substr(begin, end - begin) == typed) return true;
    begin = end + between.size();
  }
  return false;
}

}  // namespace

std::optional<int> fit(std::string_view typed, const Searchable& line) {
  const std::string wanted = small(typed);
  const std::vector<std::string> wanted_words = words_in(wanted);
  if (is_a_key_of(wanted, small(line.keys))) return as_a_key;
  const std::vector<std::string> words = words_in(small(line.words));
  const std::vector<std::string> rest = words_in(small(line.more));
  int sum = 0;
  for (const std::string& word : wanted_words) {
    const auto one = fit_of_word(word, words, rest);
    if (!one) return std::nullopt;
    sum += *one;
  }
  if (wanted_words.empty()) return 0;
  // Of two lines that have them, the shorter one says less that was not asked for.
  return 4 * sum / static_cast<int>(wanted_words.size()) - static_cast<int>(words.size());
}

}  // namespace app
