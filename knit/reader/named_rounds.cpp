#include "knit/reader/named_rounds.h"

#include <algorithm>

#include "knit/import/quoting.h"
#include "knit/reader/reader_cursor.h"

namespace knit {

namespace {

// "inc rnd", "dec rnd b": the name, or nothing.
std::string take_name(TokenCursor& at) {
  const std::size_t begin = at.at();
  if (!at.sees({"inc", "dec", "shift", "increase", "decrease"}) || !is_round_word(at.peek(1))) return {};
  std::string name = at.peek().text.substr(0, at.sees({"shift"}) ? 5 : 3) + " rnd";
  at.skip(2);
  const Token& letter = at.peek();
  if (letter.kind == Token::Kind::word && letter.text.size() == 1 && !at.sees({"x", "m"})) {
    name += " " + letter.text;
    at.skip();
  }
  if (name.empty()) at.back_to(begin);
  return name;
}

// "(+8 sts)" at the end: where it begins, and the change.
struct ToldChange {
  std::size_t begin = 0;
  std::int64_t change = 0;
};
std::optional<ToldChange> change_at_end(std::span<const Token> line) {
  for (std::size_t i = line.size(); i-- > 0;) {
    TokenCursor at(line);
    at.skip(i);
    if (!at.take({"("})) continue;
    const bool less = at.sees({"-"});
    if (!at.take({"+", "-"}) || !at.peek().is_number()) return std::nullopt;
    const std::int64_t number = at.peek().value;
    at.skip();
    if (!is_stitches_word(at.peek())) return std::nullopt;
    return ToldChange{i, less ? -number : number};
  }
  return std::nullopt;
}

std::int64_t change_of(const std::vector<WorkNode>& nodes) {
  std::int64_t change = 0;
  for (const WorkNode& node : nodes) {
    const std::int64_t once = node.stitch ? node.makes - node.takes : change_of(node.inside);
    change += std::clamp(node.times * once, -most_number, most_number);
  }
  return change;
}

std::string more_or_fewer(std::int64_t change) {
  const std::int64_t number = change < 0 ? -change : change;
  return std::to_string(number) + (number == 1 ? " stitch " : " stitches ") + (change < 0 ? "fewer" : "more");
}

// "(16, 24, 32 sts)" at the end: the counts, and where they begin.
std::size_t take_counts(std::span<const Token> words, std::vector<std::int64_t>& counts) {
  for (std::size_t i = words.size(); i-- > 0;) {
    TokenCursor at(words);
    at.skip(i);
    if (!at.take({"("})) continue;
    while (at.peek().is_number()) {
      counts.push_back(at.peek().value);
      at.skip();
      if (!at.take({","})) break;
    }
    if (!is_stitches_word(at.peek())) counts.clear();
    return i;
  }
  return words.size();
}

// "knit 2 rnds", "inc rnd"
std::optional<ToldRounds::Part> take_part(TokenCursor& at) {
  if (std::string name = take_name(at); !name.empty()) return ToldRounds::Part{std::move(name), 1};
  if (!at.sees({"knit", "k"}) || !at.peek(1).is_number() || !is_round_word(at.peek(2))) return std::nullopt;
  const std::int64_t rounds = at.peek(1).value;
  at.skip(3);
  return ToldRounds::Part{{}, rounds};
}

}  // namespace

std::optional<PlacedMarkers> markers_placed_in(std::span<const Token> line) {
  TokenCursor at(line);
  for (std::size_t i = 0; i < line.size(); ++i) {
    at.back_to(i);
    if (!at.take({"place"})) continue;
    at.take({"a"});
    if (!at.take({"marker"})) continue;
    if (at.take({"("})) {
      at.take({"m"});
      at.take({")"});
    }
    if (!at.sees({"after"}) || !at.sees({"every", "each"}, 1)) continue;
    at.skip(2);
    PlacedMarkers placed;
    if (at.peek().is_number()) {
      placed.every = at.peek().value;
      at.skip();
    }
    if (!is_stitches_word(at.peek())) continue;
    at.skip();
    if (!at.take({":", ","}) || !at.peek().is_number() || !at.sees({"marker", "markers"}, 1)) continue;
    placed.markers = at.peek().value;
    return placed;
  }
  return std::nullopt;
}

std::optional<NamedMarkers> named_markers_in(std::span<const Token> line) {
  TokenCursor at(line);
  for (std::size_t i = 0; i < line.size(); ++i) {
    at.back_to(i);
    if (!at.take({"place"}) || !at.take({"markers"})) continue;
    if (at.take({"("})) {
      at.take({"m"});
      at.take({")"});
    }
    if (!at.take({"after"})) continue;
    NamedMarkers placed;
    while (at.peek().is_number()) {
      placed.after.push_back(at.peek().value);
      at.skip();
      while (at.take({",", "and"})) {
      }
    }
    if (placed.after.empty() || !is_stitches_word(at.peek())) continue;
    at.skip();
    if (!at.take({":", ","})) continue;
    while (at.sees({"side", "front", "back"}) && placed.names.size() < placed.after.size()) {
      const auto* const name = std::find(marker_names.begin(), marker_names.end(), at.peek().text);
      placed.names.push_back(static_cast<MarkerName>(name - marker_names.begin()));
      at.skip();
      while (at.take({",", "and"})) {
      }
    }
    if (placed.names.size() == placed.after.size()) return placed;
  }
  return std::nullopt;
}

std::optional<NamedWords> named_words_in(std::span<const Token> line) {
  TokenCursor at(line);
  NamedWords named;
  named.name = take_name(at);
  if (named.name.empty() || !at.take({":"})) return std::nullopt;
  const auto told = change_at_end(line);
  if (!told || told->begin <= at.at()) return std::nullopt;
  named.words = round_words(line.subspan(at.at(), told->begin - at.at()), MarkerWords::known);
  if (!named.words.mistake.empty()) return named;
  const std::int64_t change = change_of(named.words.nodes);
  if (change != told->change)
    named.words.mistake =
        " makes " + more_or_fewer(change) + ", the line says " + more_or_fewer(told->change) + ".";
  return named;
}

std::int64_t ToldRounds::rounds() const {
  std::int64_t once = 0;
  for (const Part& part : parts) once = std::min(most_number, once + part.rounds);
  return std::min(most_number, once * times);
}

std::int64_t ToldRounds::named_ones() const {
  const auto once =
      std::count_if(parts.begin(), parts.end(), [](const Part& part) { return !part.name.empty(); });
  return std::min(most_number, once * times);
}

std::optional<ToldRounds> told_rounds_in(std::span<const Token> words) {
  ToldRounds told;
  const std::span<const Token> work = words.first(take_counts(words, told.counts));
  TokenCursor at(work);
  const bool bracket = at.take({"["});
  while (auto part = take_part(at)) {
    told.parts.push_back(std::move(*part));
    if (!at.take({","})) break;
  }
  if (told.named_ones() == 0) return std::nullopt;
  if (bracket) {
    const bool closed = at.take({"]"});
    const bool repeated = closed && at.peek().is_number() && at.sees({"times", "time"}, 1);
    if (repeated) {
      told.times = at.peek().value;
      at.skip(2);
    }
    if (!repeated) told.mistake = ": nothing says how many times its rounds are worked.";
  }
  while (at.take({"."})) {
  }
  if (!at.done() && told.mistake.empty())
    told.mistake = ": " + quoted(at.peek().text) + " stands among rounds that are named.";
  return told;
}

}  // namespace knit
