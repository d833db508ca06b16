// What a line is: a round, a cast on, an end.
#include <algorithm>

#include "knit/import/quoting.h"
#include "knit/reader/reader_cursor.h"
#include "knit/reader/reader_grammar.h"

namespace knit {

namespace {

// "3", "8-12", "8 to 12", "3 and 4", "3, 4 and 5". The mistake is kept in the label.
void read_numbers(TokenCursor& at, RoundLabel& label) {
  label.first = at.peek().value;
  label.last = at.peek().value;
  at.skip();
  while (at.peek(1).is_number() && at.sees({"-", "to", "through", "and", "&", ","})) {
    const bool range = at.sees({"-", "to", "through"});
    const std::int64_t next = at.peek(1).value;
    if (range && next < label.last)
      label.mistake = ": the round numbers run backwards.";
    else if (!range && next != label.last + 1)
      label.mistake = ": the rounds do not follow each other; write them in working order.";
    label.last = std::max(label.last, next);
    at.skip(2);
  }
}

// "(RS)", "(5 rnds)" before the colon.
void read_remark(TokenCursor& at, RoundLabel& label) {
  const std::size_t begin = at.at();
  if (!at.take({"("})) return;
  const Token number = at.peek();
  const bool tells_rounds = number.is_number() && is_round_word(at.peek(1));
  while (!at.done() && !at.sees({")"})) at.skip();
  at.take({")"});
  if (!at.sees({":"})) return at.back_to(begin);
  if (tells_rounds && number.value != label.last - *label.first + 1 && label.mistake.empty())
    label.mistake = ": the label says " + number.text +
                    (number.value == 1 ? " round and names " : " rounds and names ") +
                    std::to_string(label.last - *label.first + 1) + ".";
}

// "Rdn": a round word with one letter wrong, lost, doubled or swapped.
bool almost_round_word(const Token& token) {
  if (token.kind != Token::Kind::word || token.text.size() < 2 || token.text[0] != 'r') return false;
  for (const std::string_view right : {"rnd", "rnds", "round", "rounds", "row", "rows"}) {
    std::string have = token.text, want(right);
    std::sort(have.begin(), have.end());
    std::sort(want.begin(), want.end());
    if (have == want) return true;
    std::size_t same = 0;
    while (same < std::min(right.size(), token.text.size()) && right[same] == token.text[same]) ++same;
    const std::string_view rest = std::string_view(token.text).substr(same), other = right.substr(same);
    const bool wrong = !rest.empty() && !other.empty() && rest.substr(1) == other.substr(1);
    const bool lost = !other.empty() && rest == other.substr(1);
    const bool added = !rest.empty() && rest.substr(1) == other;
    if (wrong || lost || added) return true;
  }
  return false;
}

// Where words that close may begin: "break yarn, thread through ..."
std::size_t first_closing_word(std::span<const Token> line, std::size_t sentence, std::size_t found) {
  TokenCursor at(line);
  for (std::size_t i = sentence; i < found; ++i) {
    at.back_to(i);
    if (at.sees({"break", "cut", "leaving", "using", "thread", "draw", "pull", "run"})) return i;
  }
  return found;
}

// "thread ... through remaining 6 sts", "draw yarn through."
bool draws_through(std::span<const Token> line, std::size_t verb) {
  constexpr std::size_t farthest = 24;
  TokenCursor at(line);
  std::size_t end = verb;
  while (end < std::min(line.size(), verb + farthest) && !line[end].is(".")) ++end;
  bool through = false;
  for (std::size_t i = verb + 1; i < end; ++i) {
    at.back_to(i);
    if (through && (is_stitches_word(line[i]) || at.sees({"remaining", "rem", "all", "live", "them"})))
      return true;
    if (at.sees({"through", "thru"})) through = true;
    if (through && i + 1 == end) return true;
  }
  return false;
}

std::optional<std::int64_t> closing_number(std::span<const Token> line, std::size_t from, std::size_t end) {
  TokenCursor at(line);
  for (std::size_t i = from; i < end; ++i) {
    at.back_to(i);
    const auto number = number_of(line[i]);
    if (!number) continue;
    std::size_t ahead = 1;
    while (at.sees({"remaining", "rem", "live", "last", "open"}, ahead)) ++ahead;
    if (is_stitches_word(at.peek(ahead))) return number;
    if (i > from && (line[i - 1].is("bo") || line[i - 1].is("off"))) return number;
  }
  return std::nullopt;
}

}  // namespace

std::optional<RoundLabel> label_of(std::span<const Token> line) {
  TokenCursor at(line);
  RoundLabel label;
  const bool next = at.sees({"next"}) && is_round_word(at.peek(1)) && at.sees({":"}, 2);
  if (next) {
    label.tokens = 3;
    return label;
  }
  const bool known = is_round_word(at.peek());
  if (!known && !almost_round_word(at.peek())) return std::nullopt;
  const std::string word = at.peek().text;
  at.skip();
  at.take({"."});
  if (!at.peek().is_number()) {
    if (!known || !at.sees({":"})) return std::nullopt;
    label.mistake = " has no number.";
    label.tokens = at.at() + 1;
    return label;
  }
  read_numbers(at, label);
  read_remark(at, label);
  const bool colon =
      at.take({":"}) || (at.sees({".", "-", "="}) && begins_work(at.peek(1)) && at.take({".", "-", "="}));
  // "Round 7 is the widest." is no round.
  if ((!colon || !known) && !begins_work(at.peek()) && !at.sees({"co", "cast"})) return std::nullopt;
  if (!colon && (at.sees({"to", "from", "more"}) || at.peek().is_number())) return std::nullopt;
  if (!colon && label.mistake.empty()) label.mistake = ": the colon after the round's number is missing.";
  if (!known) label.mistake = ": the word " + quoted(word) + " is not known; it may stand for \"Rnd\".";
  label.tokens = at.at();
  return label;
}

std::optional<std::int64_t> cast_on_in(std::span<const Token> line) {
  constexpr std::size_t most_words_between = 4;  // "cast on loosely a total of 6 sts"
  TokenCursor at(line);
  for (std::size_t i = 0; i < line.size(); ++i) {
    at.back_to(i);
    const bool told = at.take({"co"}) || (at.sees({"cast"}) && at.sees({"on"}, 1));
    if (!told) continue;
    if (at.take({"cast"})) at.skip();
    for (std::size_t w = 0;
         w < most_words_between && at.peek().kind == Token::Kind::word && !number_of(at.peek()); ++w)
      at.skip();
    const auto number = number_of(at.peek());
    if (!number) continue;
    at.skip();
    const bool ended =
        at.done() || at.sees({",", ";", "(", "and"}) || (at.sees({"."}) && !at.peek(1).is_number());
    if (ended || is_stitches_word(at.peek())) return number;
  }
  return std::nullopt;
}

std::optional<ClosingWords> closing_in(std::span<const Token> line) {
  TokenCursor at(line);
  std::size_t sentence = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    at.back_to(i);
    if (at.sees({".", ")", "]"})) sentence = i + 1;
    const bool off = at.sees({"bo"}) || (at.sees({"bind", "cast"}) && at.sees({"off"}, 1));
    const bool drawn = at.sees({"thread", "draw", "pull", "run", "pass"}) && draws_through(line, i);
    if (!off && !drawn) continue;
    return ClosingWords{first_closing_word(line, sentence, i), closing_number(line, i, line.size())};
  }
  return std::nullopt;
}

}  // namespace knit
