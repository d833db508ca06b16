// The count at a line's end: "(30 sts)", "[30]", "- 30 sts", "30 sts.", "(5 sts inc'd, 30 sts)", "(+8 sts)".
#include <algorithm>

#include "knit/trade/world_grammar.h"

namespace knit {

namespace {

bool is_filler(const Atom& atom) {
  return is_any(atom, {"total", "in",        "all",  "on",  "needle", "needles", "now",   "remain", "remains",
                       "rem",   "remaining", "left", "you", "have",   "should",  "there", "are",    "will",
                       "be",    "is",        "dpns", "of",  "for",    "left",    "live",  "=",      "-",
                       ".",     ":",         "and",  ";",   "stitch", "count",   "work",  "worked", "at",
                       "end",   "round",     "rnd",  "row", "this",   "these"});
}
bool tells_more(const Atom& atom) {
  return is_any(atom,
                {"inc", "inc'd", "increased", "incs", "increases", "added", "more", "incd", "increase"});
}
bool tells_fewer(const Atom& atom) {
  return is_any(atom,
                {"dec", "dec'd", "decreased", "decs", "decreases", "fewer", "less", "decd", "decrease"});
}
// "10 sts each needle": no total.
bool tells_part(const Atom& atom) {
  return is_any(atom, {"each", "per", "between", "side", "sides", "before", "after", "body", "sleeve",
                       "front", "back", "thumb", "markers", "marker", "every"});
}

// Counts in `part`, or nothing where it says something else. `loose`: a bare number is a count too.
std::optional<WorldCount> count_in(std::span<const Atom> part, bool loose) {
  WorldCount count;
  bool stitches = false, partial = false, any = false, signed_one = false;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const Atom& atom = part[i];
    if (atom.is_number()) {
      any = true;
      const bool sign = i > 0 && is_any(part[i - 1], {"+", "-"}) && (i == 1 || part[i - 1].is("+"));
      std::size_t ahead = i + 1;
      while (ahead < part.size() && (is_stitches(part[ahead]) || part[ahead].is("were"))) ++ahead;
      const bool more = ahead < part.size() && tells_more(part[ahead]);
      const bool fewer = ahead < part.size() && tells_fewer(part[ahead]);
      if (sign || more || fewer) {
        const std::int64_t change = fewer || (sign && part[i - 1].is("-")) ? -atom.value : atom.value;
        count.change = count.change.value_or(0) + change;
        signed_one = signed_one || sign;
      } else {
        count.all.push_back(atom.value);
      }
      continue;
    }
    if (is_stitches(atom) || atom.is("total")) {
      stitches = true;
    } else if (tells_part(atom)) {
      partial = true;
    } else if (!is_any(atom, {",", "+", "by", "st", "/"}) && !tells_more(atom) && !tells_fewer(atom) &&
               !is_filler(atom)) {
      return std::nullopt;
    }
  }
  if (!any || (!stitches && !loose && !count.change)) return std::nullopt;
  if (partial) count.all.clear(), count.change.reset();
  if (!count.all.empty()) count.total = count.all.back();
  return count;
}

std::size_t opening_of(const Atoms& line, std::size_t close) {
  const std::string_view open = line[close].is(")") ? "(" : "[";
  for (std::size_t i = close; i-- > 0;) {
    if (line[i].is(open)) return i;
    if (is_any(line[i], {"(", ")", "[", "]"})) break;
  }
  return close;
}

void drop_points(Atoms& line) {
  while (!line.empty() && is_any(line.back(), {".", "!", ",", ";", "-", "=", ":"})) line.pop_back();
}

// "... . 30 sts", "- 30 sts", "= 30", "; 30 sts remain"
std::optional<WorldCount> loose_end(Atoms& line, const Lexicon& lexicon) {
  std::size_t begin = line.size();
  while (begin > 0 && !is_any(line[begin - 1], {".", "-", "=", ";", ")", "]", ","})) --begin;
  if (begin == 0 || begin == line.size()) return std::nullopt;
  const bool sign = is_any(line[begin - 1], {"-", "="});
  const auto part = std::span<const Atom>(line).subspan(begin);
  if (line[begin - 1].is("-") && line[begin - 1].glued && part[0].glued && begin > 1 &&
      line[begin - 2].is_number())
    return std::nullopt;  // "rnds 1-2"
  if (lexicon.match(part, 0) && !part[0].is_number() && !tells_fewer(part[0]) && !tells_more(part[0]))
    return std::nullopt;
  auto count = count_in(part, sign);
  // "..., 30 sts" needs a word for stitches beside the number; "k4, 2 sts" is no count either.
  if (!count) return std::nullopt;
  if (line[begin - 1].is(",") &&
      !holds_any(part, {"remain", "rem", "total", "now", "have", "left", "remaining"}))
    return std::nullopt;
  std::size_t end = begin;
  if (!is_any(line[begin - 1], {")", "]"})) end = begin - 1;
  line.resize(end);
  return count;
}

}  // namespace

WorldCount take_count(Atoms& line, const Lexicon& lexicon) {
  WorldCount found;
  const auto add = [&](const WorldCount& more) {
    if (!found.total) found.total = more.total, found.all = more.all;
    if (!found.change) found.change = more.change;
  };
  for (;;) {
    drop_points(line);
    if (line.empty()) return found;
    if (is_any(line.back(), {")", "]"})) {
      const std::size_t open = opening_of(line, line.size() - 1);
      if (open + 1 >= line.size()) return found;
      const auto part = std::span<const Atom>(line).subspan(open + 1, line.size() - open - 2);
      const auto count = count_in(part, true);
      const bool words = open > 0;
      if (!count || !words) return found;
      add(*count);
      line.resize(open);
      continue;
    }
    const auto count = loose_end(line, lexicon);
    if (!count) return found;
    add(*count);
  }
}

}  // namespace knit
