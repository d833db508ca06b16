#include "knit/reader/published_words.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

#include "knit/reader/reader_cursor.h"
#include "knit/reader/reader_grammar.h"

namespace knit {

namespace {

bool is_one_of(const Token& token, WordList words) {
  return std::any_of(words.begin(), words.end(), [&](std::string_view w) { return token.is(w); });
}

std::size_t find_word(const Tokens& tokens, WordList words) {
  const auto found =
      std::find_if(tokens.begin(), tokens.end(), [&](const Token& token) { return is_one_of(token, words); });
  return static_cast<std::size_t>(found - tokens.begin());
}
bool has_word(const Tokens& tokens, WordList words) { return find_word(tokens, words) < tokens.size(); }

// "holder", "waste yarn", "spare needle"; not "held".
bool names_holder(const Tokens& tokens) {
  if (has_word(tokens, {"holder", "holders", "hold"})) return true;
  const std::size_t at = find_word(tokens, {"waste", "scrap", "spare"});
  return at + 1 < tokens.size() &&
         is_one_of(tokens[at + 1], {"yarn", "needle", "needles", "double", "dpn", "dpns"});
}

// "next 9 sts", "held 7 sts", "7 held sts", "4 sts": the first number before a word for stitches.
std::optional<std::int64_t> stitches_told(const Tokens& tokens) {
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const auto number = number_of(tokens[i]);
    std::size_t ahead = i + 1;
    while (ahead < tokens.size() &&
           is_one_of(tokens[ahead], {"held", "remaining", "rem", "live", "more", "new", "body", "thumb"}))
      ++ahead;
    if (number && ahead < tokens.size() && is_stitches_word(tokens[ahead])) return number;
  }
  return std::nullopt;
}

Tokens from_word(const Tokens& tokens, WordList words) {
  const std::size_t at = find_word(tokens, words);
  if (at >= tokens.size()) return {};
  return {tokens.begin() + static_cast<std::ptrdiff_t>(at) + 1, tokens.end()};
}

// What stands after the last "of" or "from".
Tokens whose(const Tokens& tokens) {
  std::size_t begin = tokens.size();
  while (begin > 0 && !is_one_of(tokens[begin - 1], {"of", "from", "off"})) --begin;
  if (begin == 0) return {};
  return {tokens.begin() + static_cast<std::ptrdiff_t>(begin), tokens.end()};
}

bool casts_on(const Tokens& tokens) {
  const std::size_t cast = find_word(tokens, {"cast"});
  return has_word(tokens, {"co"}) || (cast + 1 < tokens.size() && tokens[cast + 1].is("on"));
}
bool picks_up(const Tokens& tokens) {
  const std::size_t pick = find_word(tokens, {"pick"});
  return pick + 1 < tokens.size() && tokens[pick + 1].is("up");
}
bool joins_ends(const Tokens& tokens) {
  const bool three =
      has_word(tokens, {"three", "3"}) && has_word(tokens, {"needle"}) && has_word(tokens, {"bind", "bo"});
  return three || has_word(tokens, {"kitchener", "graft", "3nbo"});
}

std::optional<std::int64_t> cast_on_told(const Tokens& tokens) {
  if (const auto told = stitches_told(tokens)) return told;
  return cast_on_in(tokens);
}

PublishedPart part_of(Tokens tokens, bool is_round) {
  while (!tokens.empty() && is_one_of(tokens.front(), {"then", "and", "but"})) tokens.erase(tokens.begin());
  PublishedPart part;
  const bool moves =
      has_word(tokens, {"place", "slip", "put", "leave", "thread", "transfer", "move", "keep"});
  const bool from = has_word(tokens, {"from", "off"}), held = has_word(tokens, {"held"});
  const bool as_for = has_word(tokens, {"work", "make", "knit", "as"}) && has_word(tokens, {"as"}) &&
                      has_word(tokens, {"for", "first"});
  if (joins_ends(tokens)) {
    part.use = PublishedUse::join_ends;
    part.count = stitches_told(tokens);
  } else if (moves && names_holder(tokens) && !from && !held) {
    part.use = PublishedUse::hold;
    part.count = stitches_told(tokens);
    part.name = holder_name(from_word(tokens, {"for"}));
  } else if (held || (from && names_holder(tokens)) ||
             (is_round && has_word(tokens, {"across", "over"}) && has_word(tokens, {"of"}) &&
              stitches_told(tokens))) {
    part.use = PublishedUse::take;
    part.count = stitches_told(tokens);
    part.name = holder_name(whose(tokens));
  } else if (casts_on(tokens) || picks_up(tokens)) {
    part.use = PublishedUse::add;
    part.count = cast_on_told(tokens);
    if (!part.count) part.use = PublishedUse::none;
  } else if (!is_round && as_for) {
    part.use = PublishedUse::as_before;
    part.name = holder_name(from_word(tokens, {"for", "as"}));
  } else if (is_round && !tokens.empty()) {
    part.use = PublishedUse::work;
  }
  part.tokens = std::move(tokens);
  return part;
}

// "(backward loop)": in brackets, and no repeat.
std::size_t end_of_aside(const Tokens& tokens, std::size_t open) {
  std::size_t end = open + 1;
  while (end < tokens.size() && !tokens[end].is(")")) ++end;
  for (std::size_t i = open + 1; i < end; ++i) {
    if (stitch_named(tokens[i]) || tokens[i].is_number()) return open;
  }
  return end < tokens.size() ? end : open;
}

}  // namespace

std::string holder_name(const Tokens& tokens) {
  std::string name;
  for (const Token& token : tokens) {
    if (token.kind != Token::Kind::word) break;
    if (is_stitches_word(token) ||
        is_one_of(token, {"the", "a", "an", "holder", "holders", "waste", "scrap", "spare", "yarn", "needle",
                          "needles", "stitch", "held", "this", "it", "for"}))
      continue;
    if (is_one_of(token, {"onto", "on", "to", "with", "but", "and", "then"})) break;
    name += (name.empty() ? "" : " ") + token.text;
  }
  return name;
}

bool same_name(const std::string& told, const std::string& known) {
  const auto one = [](std::string word) {
    if (word.size() > 3 && word.back() == 's') word.pop_back();
    return word;
  };
  std::istringstream words(told);
  for (std::string word; words >> word;) {
    std::istringstream others(known);
    bool found = false;
    for (std::string other; others >> other;) found = found || one(word) == one(other);
    if (!found) return false;
  }
  return true;
}

std::vector<PublishedPart> parts_of(const Tokens& sentence, bool is_round) {
  std::vector<PublishedPart> parts;
  Tokens now;
  int depth = 0;
  bool stars = false;
  const auto flush = [&] {
    if (!now.empty()) parts.push_back(part_of(std::move(now), is_round));
    now = {};
  };
  for (std::size_t i = 0; i < sentence.size(); ++i) {
    const Token& token = sentence[i];
    if (token.is("(") && depth == 0) {
      const std::size_t end = end_of_aside(sentence, i);
      if (end > i) {
        i = end;
        continue;
      }
    }
    if (is_one_of(token, {"(", "[", "{"})) ++depth;
    if (is_one_of(token, {")", "]", "}"})) --depth;
    stars = stars || token.is("*");
    // A repeat from a star goes on over commas.
    if (depth == 0 && !stars && is_one_of(token, {",", ";", "."})) {
      flush();
    } else {
      now.push_back(token);
    }
  }
  flush();
  return parts;
}

}  // namespace knit
