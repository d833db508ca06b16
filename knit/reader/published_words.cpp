#include "knit/reader/published_words.h"

#include <algorithm>
#include <sstream>
#include <string_view>
#include <utility>

#include "knit/reader/reader_cursor.h"

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
bool begins_with(const Tokens& tokens, WordList words) {
  return !tokens.empty() && is_one_of(tokens.front(), words);
}

bool names_needle(const Tokens& tokens) { return has_word(tokens, {"needle", "needles", "dpn", "dpns"}); }

// "holder", "waste yarn", "spare needle"; not "held".
bool names_holder(const Tokens& tokens) {
  if (has_word(tokens, {"holder", "holders", "hold", "pin"})) return true;
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    if (is_one_of(tokens[i], {"waste", "scrap", "spare", "contrasting"}) &&
        is_one_of(tokens[i + 1],
                  {"yarn", "needle", "needles", "double", "dpn", "dpns", "thread", "circular"}))
      return true;
  }
  return false;
}

// "next 9 sts", "held 7 sts", "7 held sts", "4 underarm sts": the first number before a word for stitches.
std::optional<std::int64_t> stitches_told(const Tokens& tokens) {
  constexpr std::size_t most_words_between = 3;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const auto number = number_of(tokens[i]);
    if (!number) continue;
    std::size_t ahead = i + 1;
    while (ahead < tokens.size() && ahead <= i + most_words_between &&
           tokens[ahead].kind == Token::Kind::word && !is_stitches_word(tokens[ahead]) &&
           !is_one_of(tokens[ahead], {"on", "from", "with", "times"}))
      ++ahead;
    if (ahead < tokens.size() && is_stitches_word(tokens[ahead])) return number;
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

// "14 thumb sts", "first leg sts": the words before the word for stitches.
std::string name_before_stitches(const Tokens& tokens) {
  const auto word =
      std::find_if(tokens.begin(), tokens.end(), [](const Token& token) { return is_stitches_word(token); });
  auto begin = word;
  while (begin != tokens.begin()) {
    const Token& before = *(begin - 1);
    if (before.kind != Token::Kind::word || number_of(before) ||
        is_one_of(before, {"the",    "these",   "those",   "held",  "next", "remaining", "rem",   "live",
                           "all",    "across",  "over",    "of",    "on",   "put",       "place", "slip",
                           "leave",  "waiting", "resting", "new",   "last", "knit",      "k",     "transfer",
                           "thread", "work",    "return",  "other", "both", "extra",     "your",  "stranded",
                           "its",    "leaving", "move",    "worked"}))
      break;
    --begin;
  }
  return word == tokens.end() ? "" : holder_name({begin, word});
}

bool casts_on(const Tokens& tokens) {
  const std::size_t cast = find_word(tokens, {"cast", "casting"});
  return has_word(tokens, {"co"}) || (cast + 1 < tokens.size() && tokens[cast + 1].is("on")) ||
         (has_word(tokens, {"backward", "backwards", "cable"}) && has_word(tokens, {"make", "add"}));
}
bool picks_up(const Tokens& tokens) {
  const std::size_t pick = find_word(tokens, {"pick", "picking"});
  return (pick + 1 < tokens.size() && tokens[pick + 1].is("up")) || has_word(tokens, {"pu", "puk"});
}
bool joins_ends(const Tokens& tokens) {
  const bool three = has_word(tokens, {"three", "3"}) && has_word(tokens, {"needle"}) &&
                     has_word(tokens, {"bind", "bo", "cast"});
  return three || has_word(tokens, {"kitchener", "graft", "3nbo"});
}

std::optional<std::int64_t> added(const Tokens& tokens) {
  auto told = stitches_told(tokens);
  if (!told) told = cast_on_in(tokens);
  if (!told && has_word(tokens, {"pick", "pu", "puk"})) {  // "pick up and k 2"
    for (const Token& token : tokens) {
      if (const auto stitch = stitch_named(token); stitch && stitch->count) told = stitch->count;
      if (!told) told = number_of(token);
    }
  }
  const bool both = has_word(tokens, {"each", "either", "both"}) &&
                    has_word(tokens, {"side", "sides", "end", "ends", "corner", "corners"});
  return told && both ? std::optional(*told * 2) : told;
}

// "held 7 sts", "7 held thumb sts", "the sts held for": not of yarn that is held double.
bool tells_held(const Tokens& tokens) {
  const std::size_t held = find_word(tokens, {"held", "waiting", "resting"});
  if (held >= tokens.size() || has_word(tokens, {"double", "together", "doubled"})) return false;
  if (held > 0 && is_stitches_word(tokens[held - 1])) return true;
  constexpr std::size_t farthest = 4;
  for (std::size_t i = held + 1; i < std::min(tokens.size(), held + 1 + farthest); ++i) {
    if (is_stitches_word(tokens[i])) return true;
  }
  return false;
}

bool is_told_as_a_fact(const Tokens& tokens) {
  return has_word(tokens, {"are", "is", "were", "was", "will", "been", "be"});
}

// "sm", "place a marker": a sign that parts are read for.
bool is_marker(const Tokens& tokens) {
  const bool verb = begins_with(tokens, {"place", "slip", "remove", "pass"});
  return (tokens.size() == 1 && begins_with(tokens, {"pm", "sm", "rm", "slm"})) ||
         (verb && has_word(tokens, {"marker", "markers", "m"}) && !stitches_told(tokens));
}

// A part that is understood and changes no count.
bool is_harmless(const Tokens& tokens) {
  if (is_marker(tokens)) return true;
  if (begins_with(
          tokens,
          {"break",      "cut",      "rejoin",  "join",     "turn",     "being",     "taking",  "careful",
           "stuff",      "do",       "don't",   "change",   "begin",    "beginning", "arrange", "divide",
           "distribute", "leaving",  "leave",   "removing", "slipping", "marking",   "mark",    "adjust",
           "attach",     "continue", "working", "ending",   "end",      "starting",  "start",   "tie",
           "note",       "keeping",  "keep",    "make",     "mind",     "making",    "switch",  "using"}))
    return true;
  return begins_with(tokens, {"with"}) && !std::any_of(tokens.begin(), tokens.end(), [](const Token& token) {
           return stitch_named(token).has_value() || token.is_number();
         });
}

bool is_work_verb(const Token& token) { return is_one_of(token, {"k", "knit", "p", "purl", "work"}); }

Tokens of_word(std::string_view word) { return tokens_of(word); }

// "work the next 7 sts", "knit across 7 sts", "knit the remaining 9 sts" as the grammar has them; "with main yarn" is left out.
Tokens as_work(Tokens tokens) {
  const std::size_t with = find_word(tokens, {"with", "using"});
  if (with == 0 && tokens.size() > 2) {  // "with main yarn k6"
    const auto stitch = std::find_if(tokens.begin(), tokens.end(),
                                     [](const Token& t) { return stitch_named(t).has_value(); });
    if (stitch != tokens.end()) tokens.erase(tokens.begin(), stitch);
  } else if (with < tokens.size()) {
    tokens.resize(with);
  }
  if (!tokens.empty() && tokens.front().is("work")) tokens.front() = of_word("k").front();
  if (tokens.size() < 2 || !is_work_verb(tokens.front())) return tokens;
  const auto drop = [&](WordList words) {
    while (tokens.size() > 2 && is_one_of(tokens[1], words)) tokens.erase(tokens.begin() + 1);
  };
  const std::size_t number =
      static_cast<std::size_t>(std::find_if(tokens.begin() + 1, tokens.end(),
                                            [](const Token& t) { return number_of(t).has_value(); }) -
                               tokens.begin());
  const bool told = number < tokens.size() && number + 1 < tokens.size() && stitches_told(tokens);
  const bool to = has_word(tokens, {"to", "until", "times", "each", "every"});
  if (told && !to) {
    Tokens short_one{tokens.front(), of_word(std::to_string(*stitches_told(tokens))).front()};
    return short_one;
  }
  if (!to && has_word(tokens, {"remaining", "rem", "rest"})) {
    tokens.resize(1);
    for (const Token& token : of_word("to end")) tokens.push_back(token);
  }
  drop({"even", "plain"});
  return tokens;
}

// Where "to marker" begins: a place that is not told in stitches and is no end.
std::size_t floating_at(const Tokens& tokens) {
  for (std::size_t i = 1; i < tokens.size(); ++i) {
    if (!is_one_of(tokens[i], {"to", "until"}) || !is_work_verb(tokens[i - 1])) continue;
    std::size_t at = i + 1;
    while (at < tokens.size() && tokens[at].is("the")) ++at;
    if (at < tokens.size() && is_one_of(tokens[at], {"end", "last"})) return tokens.size();
    const Tokens rest(tokens.begin() + static_cast<std::ptrdiff_t>(at), tokens.end());
    if (has_word(rest, {"remain", "remains", "rem", "left"})) return tokens.size();
    return i;
  }
  return tokens.size();
}

// Nothing where it puts nothing onto a holder.
bool read_hold(PublishedPart& part) {
  const Tokens& tokens = part.tokens;
  const bool moves = has_word(tokens, {"place", "placing", "slip", "sl", "put", "leave", "leaving", "thread",
                                       "transfer", "move", "keep", "set", "slipping", "putting", "hold"});
  if (!moves || !names_holder(tokens) || has_word(tokens, {"from", "off", "held"})) return false;
  part.use = PublishedUse::hold;
  part.count = stitches_told(tokens);
  part.name = holder_name(from_word(tokens, {"for"}));
  if (part.name.empty()) part.name = name_before_stitches(tokens);
  return true;
}

std::string taken_name(const Tokens& tokens) {
  std::string name = holder_name(whose(tokens));
  if (!name.empty()) return name;
  const std::size_t held = find_word(tokens, {"held"});
  if (held + 1 < tokens.size() && tokens[held + 1].is("for"))
    return holder_name({tokens.begin() + static_cast<std::ptrdiff_t>(held) + 2, tokens.end()});
  return name_before_stitches(tokens);
}

bool read_take(PublishedPart& part, bool is_round) {
  const Tokens& tokens = part.tokens;
  const bool told = stitches_told(tokens).has_value();
  const bool sure = tells_held(tokens) || (has_word(tokens, {"from", "off"}) && names_holder(tokens)) ||
                    (is_round && has_word(tokens, {"across", "over"}) && has_word(tokens, {"of"}) && told);
  const bool to_needle =
      has_word(tokens, {"place", "placing", "slip", "put", "return", "transfer", "move", "replace"}) &&
      names_needle(tokens) && !has_word(tokens, {"marker", "markers", "left", "last"});
  const bool across = begins_with(tokens, {"k", "knit", "work"}) && has_word(tokens, {"across", "over"}) &&
                      (has_word(tokens, {"of"}) || !name_before_stitches(tokens).empty());
  if (!sure && !to_needle && !across) return false;
  if (is_told_as_a_fact(tokens) && !is_round) return false;
  part.use = PublishedUse::take;
  part.maybe = !sure;
  part.held = tells_held(tokens) || names_holder(tokens);
  part.count = stitches_told(tokens);
  part.name = taken_name(tokens);
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i)
    part.some = part.some || (is_one_of(tokens[i], {"first", "next", "last"}) && number_of(tokens[i + 1]));
  return true;
}

bool read_spread(PublishedPart& part) {
  const Tokens& tokens = part.tokens;
  const bool more = has_word(tokens, {"increasing", "increase", "inc"}),
             less = has_word(tokens, {"decreasing", "decrease", "dec"});
  const auto told = stitches_told(tokens);
  if (more == less || !told || !has_word(tokens, {"evenly", "spaced", "across", "around"})) return false;
  part.use = PublishedUse::spread;
  part.count = more ? *told : -*told;
  return true;
}

bool read_join(PublishedPart& part) {
  const Tokens& tokens = part.tokens;
  if (!joins_ends(tokens)) return false;
  part.use = PublishedUse::join_ends;
  part.count = stitches_told(tokens);
  part.all = has_word(tokens, {"both", "underarms", "each"});
  part.own = has_word(tokens, {"remaining", "rem", "top", "toe", "tip", "closed", "last", "live"});
  if (has_word(tokens, {"underarm", "underarms"})) part.name = "underarm";
  if (has_word(tokens, {"to", "with"})) {
    const std::string other = name_before_stitches(from_word(tokens, {"to", "with"}));
    if (part.name.empty()) part.name = other;
  }
  return true;
}

bool read_add(PublishedPart& part) {
  const Tokens& tokens = part.tokens;
  part.picks_up = picks_up(tokens);
  if (!part.picks_up && !casts_on(tokens)) return false;
  part.count = added(tokens);
  part.at_gap = part.picks_up && has_word(tokens, {"gap", "gaps", "opening", "hole", "holes"});
  part.goes_on = has_word(tokens, {"backward", "backwards", "cable", "knitted", "gap", "crotch", "underarm",
                                   "more", "additional", "over", "new", "extra"});
  part.use = part.count ? PublishedUse::add : PublishedUse::none;
  return true;
}

bool read_waste(PublishedPart& part) {
  const Tokens& tokens = part.tokens;
  const bool worked = std::any_of(tokens.begin(), tokens.end(), [](const Token& token) {
    return stitch_named(token) && !token.is("slip") && !token.is("sl");
  });
  if (!names_holder(tokens) || !has_word(tokens, {"with", "using", "in"}) || !worked) return false;
  part.count = stitches_told(tokens);
  for (const Token& token : tokens) {
    if (const auto stitch = stitch_named(token); stitch && stitch->count && !part.count)
      part.count = stitch->count;
  }
  if (!part.count) return false;
  part.use = PublishedUse::insert;
  part.name = holder_name(from_word(tokens, {"for"}));
  return true;
}

bool read_slip_back(PublishedPart& part) {
  const Tokens& tokens = part.tokens;
  if (!has_word(tokens, {"slip", "sl", "return", "transfer", "move", "place"}) ||
      !has_word(tokens, {"back", "left"}) || !names_needle(tokens) || has_word(tokens, {"held"}) ||
      names_holder(tokens) || !has_word(tokens, {"left"}))
    return false;
  part.use = PublishedUse::slip_back;
  part.count = stitches_told(tokens);
  return true;
}

// "Work as for first leg", "make a second leg".
bool read_as_before(PublishedPart& part) {
  const Tokens& tokens = part.tokens;
  const bool makes = begins_with(tokens, {"work", "make", "knit", "repeat"});
  const bool as = has_word(tokens, {"as"}) && has_word(tokens, {"for", "first", "same"});
  part.again = makes && has_word(tokens, {"second", "another", "other"}) &&
               !has_word(tokens, {"with", "on", "using"}) &&
               !std::any_of(tokens.begin(), tokens.end(), [](const Token& token) {
                 return is_round_word(token) || is_stitches_word(token);
               });
  if (!part.again && !((makes || has_word(tokens, {"as"})) && as)) return false;
  part.use = PublishedUse::as_before;
  if (has_word(tokens, {"for", "as"})) part.name = holder_name(from_word(tokens, {"for", "as"}));
  return true;
}

PublishedPart part_of(Tokens tokens, bool is_round) {
  while (begins_with(tokens, {"then", "and", "but", "&", "now"})) tokens.erase(tokens.begin());
  PublishedPart part;
  part.tokens = std::move(tokens);
  if (part.tokens.empty()) return part;
  if (read_join(part) || (is_round && (read_slip_back(part) || read_waste(part)))) return part;
  const auto closing = closing_in(part.tokens);
  const bool draws = closing && !has_word(part.tokens, {"bo", "bind", "cast"});
  if (!draws && (read_hold(part) || read_take(part, is_round))) return part;
  if (closing) {
    part.use = PublishedUse::close;
    part.count = closing->number;
    part.all = draws || has_word(part.tokens, {"all", "remaining", "rem", "loosely"}) || !closing->number;
    return part;
  }
  if (read_spread(part) || read_add(part)) return part;
  if (!is_round && read_as_before(part)) return part;
  const bool works =
      is_round || stitch_named(part.tokens.front()) || begins_with(part.tokens, {"[", "(", "*", "work"});
  if (works && !is_harmless(part.tokens)) part.use = PublishedUse::work;
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

// "k to marker, m1" without the comma: what goes to a place that is not told in stitches is a part of its own.
void push_work(std::vector<PublishedPart>& parts, PublishedPart part) {
  const std::size_t to = floating_at(part.tokens);
  if (to >= part.tokens.size()) {
    part.tokens = as_work(std::move(part.tokens));
    parts.push_back(std::move(part));
    return;
  }
  const auto push = [&](std::size_t begin, std::size_t end) {
    PublishedPart some;
    some.use = PublishedUse::work;
    some.tokens.assign(part.tokens.begin() + static_cast<std::ptrdiff_t>(begin),
                       part.tokens.begin() + static_cast<std::ptrdiff_t>(end));
    if (begin < end) push_work(parts, std::move(some));
  };
  // "[K to 1 st before marker, kfb, sm, kfb] 4 times": however far, the rest of the repeat counts.
  const auto before = part.tokens.begin() + static_cast<std::ptrdiff_t>(to);
  const auto opens = std::count_if(part.tokens.begin(), before, [](const Token& t) {
    return is_one_of(t, {"[", "(", "*"});
  });
  const auto closes = std::count_if(part.tokens.begin(), before, [](const Token& t) {
    return is_one_of(t, {"]", ")"});
  });
  PublishedPart floating;
  floating.use = PublishedUse::work;
  floating.tokens = of_word("k");
  floating.floats = true;
  if (opens > closes) {
    auto end = before;
    while (end != part.tokens.end() && !is_one_of(*end, {",", ";", "]", ")"})) ++end;
    if (end != part.tokens.end() && is_one_of(*end, {",", ";"})) ++end;
    parts.push_back(std::move(floating));
    part.tokens.erase(before - 1, end);
    return push_work(parts, std::move(part));
  }
  push(0, to - 1);
  floating.tokens = {part.tokens[to - 1].is("work") ? of_word("k").front() : part.tokens[to - 1]};
  parts.push_back(std::move(floating));
  std::size_t rest = to + 1;
  while (rest < part.tokens.size() && !is_one_of(part.tokens[rest], {"sm", "pm", "slm"})) ++rest;
  push(rest, part.tokens.size());
}

bool parts_here(const Tokens& sentence, std::size_t i) {
  if (!is_one_of(sentence[i], {"and", "then", "&", "before", "but"}) || i + 1 >= sentence.size())
    return false;
  if (i > 0 && sentence[i - 1].is("up")) return false;
  const Token& next = sentence[i + 1];
  const auto stitch = stitch_named(next);
  return is_one_of(next, {"place",  "slip", "put",  "leave",  "thread", "transfer", "move",  "cast",
                          "co",     "pick", "knit", "k",      "work",   "join",     "break", "cut",
                          "rejoin", "bo",   "bind", "return", "graft",  "purl"}) ||
         (stitch && stitch->count);
}

}  // namespace

std::string holder_name(const Tokens& tokens) {
  std::string name;
  for (const Token& token : tokens) {
    if (token.kind != Token::Kind::word) break;
    if (is_stitches_word(token) ||
        is_one_of(token, {"the",   "a",           "an",     "holder",  "holders",   "waste",   "scrap",
                          "spare", "yarn",        "needle", "needles", "stitch",    "held",    "this",
                          "it",    "for",         "later",  "now",     "use",       "working", "each",
                          "one",   "contrasting", "dpn",    "dpns",    "remaining", "rem"}))
      continue;
    if (is_one_of(token, {"onto", "on", "to", "with", "but", "and", "then", "while", "until", "using",
                          "without", "at", "except", "over", "again", "in"}))
      break;
    name += (name.empty() ? "" : " ") + token.text;
  }
  return name;
}

bool same_name(const std::string& told, const std::string& known) {
  const auto one = [](std::string word) {
    if (word.size() > 3 && word.back() == 's') word.pop_back();
    if (word == "gusset") return std::string("thumb");
    return word == "sleeve" ? std::string("arm") : word;
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
  bool stars = false;  // a repeat from a star goes on over commas, until it says from where to repeat
  const auto flush = [&] {
    if (now.empty()) return;
    PublishedPart part = part_of(std::exchange(now, {}), is_round);
    if (part.use == PublishedUse::work)
      push_work(parts, std::move(part));
    else
      parts.push_back(std::move(part));
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
    if (token.is("*")) stars = !(i > 0 && sentence[i - 1].is("from"));
    const bool to_come =
        i + 1 < sentence.size() && is_one_of(sentence[i + 1], {"to", "until", "around", "rep", "repeat"});
    const bool stop = is_one_of(token, {",", ";", "."}) && !(to_come && !now.empty());
    if (depth == 0 && !stars && (stop || parts_here(sentence, i))) {
      flush();
    } else {
      now.push_back(token);
    }
  }
  flush();
  return parts;
}

std::optional<RoundLabel> published_label(const Tokens& line) {
  if (auto label = label_of(line)) return label;
  constexpr std::size_t most_words = 4;
  std::size_t at = 0;
  while (at < line.size() && at < most_words && !is_round_word(line[at]) &&
         (line[at].kind == Token::Kind::word || line[at].is("-")) && !(stitch_named(line[at]) && at > 0))
    ++at;
  if (at == 0 || at >= line.size() || !is_round_word(line[at]) || is_one_of(line[0], {"rep", "repeat"}))
    return std::nullopt;
  ++at;
  if (at < line.size() && line[at].is("(")) {
    while (at < line.size() && !line[at].is(")")) ++at;
    ++at;
  }
  if (at >= line.size() || !line[at].is(":")) return std::nullopt;
  RoundLabel label;
  label.tokens = at + 1;
  return label;
}

std::optional<SectionTitle> title_in(const Tokens& tokens) {
  constexpr std::size_t most_words = 5;
  SectionTitle title;
  Tokens words;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const Token& token = tokens[i];
    if (token.is(":") && i + 1 == tokens.size()) break;
    if (token.is("(") && i + 4 == tokens.size() && is_one_of(tokens[i + 1], {"make", "work", "knit"})) {
      const auto made = number_of(tokens[i + 2]);
      if (!made || *made < 1 || *made > 20 || !tokens[i + 3].is(")")) return std::nullopt;
      title.made = *made;
      break;
    }
    if (token.kind != Token::Kind::word || stitch_named(token)) return std::nullopt;
    words.push_back(token);
  }
  if (words.empty() || words.size() > most_words) return std::nullopt;
  if (begins_with(words,
                  {"using",  "with",   "join",   "break",  "cut",    "stuff",    "weave",  "sew",  "work",
                   "place",  "slip",   "turn",   "fasten", "rejoin", "begin",    "do",     "bind", "continue",
                   "leave",  "change", "divide", "repeat", "rep",    "graft",    "cast",   "pick", "remove",
                   "return", "put",    "co",     "bo",     "make",   "transfer", "thread", "draw", "pull"}))
    return std::nullopt;
  title.tells =
      begins_with(words, {"materials", "notes", "note", "gauge", "abbreviations", "tension", "size", "sizes",
                          "yarn", "needles", "notions", "techniques", "measurements", "about", "level"});
  title.name = holder_name(words);
  return title.name.empty() ? std::nullopt : std::optional(title);
}

std::optional<RepeatedRounds> repeated_rounds(const Tokens& tokens) {
  const bool refers =
      begins_with(tokens, {"work"}) && has_word(tokens, {"last", "these", "those", "previous"});
  if (!begins_with(tokens, {"rep", "repeat"}) && !refers) return std::nullopt;
  TokenCursor at(tokens);
  RepeatedRounds repeated;
  bool rounds = false;
  for (std::size_t i = 1; i < tokens.size(); ++i) {
    at.back_to(i);
    if (is_round_word(tokens[i]) && !rounds) {
      rounds = true;
      if (at.peek(1).is_number()) {
        repeated.first = repeated.last = at.peek(1).value;
        if (at.sees({"-", "to", "and", "through", "&"}, 2) && at.peek(3).is_number())
          repeated.last = at.peek(3).value;
      } else if (const auto count = number_of(tokens[i - 1])) {
        repeated.count = *count;
      }
      repeated.understood = repeated.last >= repeated.first.value_or(0);
    }
    const std::size_t more = at.sees({"more"}, 1) ? 2 : 1;
    if (number_of(tokens[i]) && at.sees({"times", "time"}, more)) repeated.times = *number_of(tokens[i]);
    if (at.sees({"twice"})) repeated.times = 2;
    if (at.sees({"until"})) {
      repeated.until = stitches_told({tokens.begin() + static_cast<std::ptrdiff_t>(i), tokens.end()});
      repeated.understood =
          repeated.understood && repeated.until && !has_word(tokens, {"between", "marker", "markers"});
    }
  }
  if (!rounds) return std::nullopt;
  return repeated;
}

}  // namespace knit
