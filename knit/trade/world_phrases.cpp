#include "knit/trade/world_phrases.h"

namespace knit {

namespace {

using Kind = WorldNode::Kind;
using Until = WorldNode::Until;

// The word that a remark without brackets begins with.
bool opens_remark(const Atom& atom) {
  return is_any(atom, {"with",     "using",   "in",         "being",    "taking", "careful", "join",
                       "rejoin",   "break",   "cut",        "change",   "switch", "attach",  "drop",
                       "stuff",    "loosely", "tightly",    "not",      "do",     "don't",   "begin",
                       "starting", "ending",  "twisting",   "remember", "for",    "as",      "adjust",
                       "arrange",  "divide",  "distribute", "keeping",  "note",   "evenly"});
}

bool is_marker(const Atom& atom) {
  return is_any(atom, {"m", "marker", "markers", "mkr", "mkrs", "bor", "eor"});
}

std::optional<WorldNode> marker(PhraseCursor& at) {
  const std::size_t before = at.at();
  WorldNode node;
  if (at.take({"pm"})) {
    node.kind = Kind::place_marker;
  } else if (at.take({"sm", "slm", "sim"})) {
    node.kind = Kind::slip_marker;
  } else if (at.take({"rm"})) {
    node.kind = Kind::remove_marker;
  } else if (at.sees({"place", "slip", "sl", "remove", "pass", "slipping", "removing", "placing"})) {
    const Atom verb = at.peek();
    at.skip();
    while (at.take({"stitch", "first", "second", "third", "next", "beg", "beginning", "of", "round", "rnd",
                    "new", "side", "bor", "another"})) {
    }
    if (!is_marker(at.peek())) {
      at.back_to(before);
      return std::nullopt;
    }
    at.skip();
    node.kind = is_any(verb, {"place", "placing"})     ? Kind::place_marker
                : is_any(verb, {"remove", "removing"}) ? Kind::remove_marker
                                                       : Kind::slip_marker;
  } else {
    return std::nullopt;
  }
  if (at.take({"for"})) {  // "pm for beginning of rnd"
    while (!at.done() && !at.sees({",", ".", ";", ")", "]"})) at.skip();
  }
  return node;
}

// "inc 6 sts evenly around", "decreasing 8 sts evenly", "inc 6 evenly spaced"
std::optional<WorldNode> shaped(PhraseCursor& at) {
  const bool more = at.sees({"inc", "increase", "increasing"});
  const bool fewer = at.sees({"dec", "decrease", "decreasing"});
  if (!more && !fewer) return std::nullopt;
  const std::size_t before = at.at();
  at.skip();
  const bool early = at.take({"evenly"});
  if (!at.peek().is_number()) {
    at.back_to(before);
    return std::nullopt;
  }
  WorldNode node;
  node.kind = Kind::shape;
  node.makes = at.peek().value;
  if (fewer) node.makes = -node.makes;
  at.skip();
  if (is_stitches(at.peek())) at.skip();
  const bool evenly = at.take({"evenly", "even"});
  if (!evenly && !early) {
    at.back_to(before);
    return std::nullopt;
  }
  while (at.take({"spaced", "spread", "around", "across", "over", "in", "on", "this", "round", "rnd", "row",
                  "to", "end", "of", "along", "next", "-"})) {
  }
  return node;
}

bool is_holder(std::span<const Atom> part) {
  if (holds_any(part, {"holder", "holders", "hold", "pin", "lifeline"})) return true;
  for (std::size_t i = 0; i + 1 < part.size(); ++i) {
    if (is_any(part[i], {"waste", "scrap", "spare", "contrasting", "holding"}) &&
        is_any(part[i + 1], {"yarn", "needle", "needles", "dpn", "dpns", "thread", "circular", "double"}))
      return true;
  }
  return false;
}

std::optional<std::int64_t> number_in(std::span<const Atom> part) {
  for (const Atom& atom : part) {
    if (atom.is_number()) return atom.value;
  }
  return std::nullopt;
}

std::span<const Atom> behind(std::span<const Atom> part, AtomWords words) {
  for (std::size_t i = 0; i < part.size(); ++i) {
    if (is_any(part[i], words)) return part.subspan(i + 1);
  }
  return {};
}

// "k across the 8 held arm sts": the name before the first stitches told.
std::string name_before_stitches(std::span<const Atom> part) {
  std::size_t end = 0;
  while (end < part.size() && !is_stitches(part[end])) ++end;
  if (end == part.size()) return "";
  std::size_t begin = end;
  while (
      begin > 0 && part[begin - 1].is_word() &&
      !is_any(part[begin - 1], {"k",     "knit", "p",         "purl",   "work",    "across",  "over", "held",
                                "live",  "next", "remaining", "rem",    "resting", "waiting", "all",  "these",
                                "those", "from", "of",        "holder", "other",   "same"}))
    --begin;
  return world_name(part.subspan(begin, end - begin));
}

std::optional<WorldNode> held(PhraseCursor& at) {
  const std::span<const Atom> part = at.part();
  if (part.empty()) return std::nullopt;
  WorldNode node;
  const bool moves = is_any(part[0], {"place", "slip", "sl", "put", "leave", "transfer", "move", "thread",
                                      "set", "placing", "slipping"});
  if (moves && is_holder(part) && !holds_any(part, {"from", "off", "held", "back"})) {
    node.kind = Kind::hold;
    const auto count = number_in(part);
    node.times = count.value_or(0);
    if (count && *count == 0) return std::nullopt;
    node.name = world_name(behind(part, {"for"}));
  } else if (is_any(part[0], {"k", "knit", "work", "p", "purl"}) &&
             (holds_any(part, {"held", "holder", "resting", "waiting"}) ||
              (holds_any(part, {"across", "over"}) && holds_any(part, {"of", "from"})))) {
    node.kind = Kind::take;
    node.times = number_in(part).value_or(0);
    std::span<const Atom> name = behind(part, {"of", "from"});
    if (holds_any(name, {"of"})) name = behind(name, {"of"});
    node.name = world_name(name);
    if (node.name.empty()) node.name = name_before_stitches(part);
    node.live = !holds_any(part, {"held", "holder", "resting", "waiting"});
  } else {
    return std::nullopt;
  }
  at.skip(part.size());
  return node;
}

// "CO 2 sts over the gap", "pick up and knit 2 sts in the gap", "bind off 4 sts"
std::optional<WorldNode> edge(PhraseCursor& at) {
  const std::size_t before = at.at();
  WorldNode node;
  const bool casts = at.take({"co"}) || (at.sees({"cast", "casting"}) && at.sees({"on"}, 1));
  const bool binds =
      !casts && (at.take({"bo"}) || (at.sees({"bind", "cast", "binding"}) && at.sees({"off"}, 1)));
  const bool picks =
      !casts && !binds && (at.take({"pu", "puk"}) || (at.sees({"pick", "picking"}) && at.sees({"up"}, 1)));
  if (!casts && !binds && !picks) return std::nullopt;
  if (at.sees({"on", "off", "up"}, 1)) at.skip(2);
  while (at.take({"and", "k", "knit", "p", "next", "another", "off", "on", "first"})) {
  }
  const bool all = binds && at.take({"all", "remaining", "rem"});
  if (!at.peek().is_number() && !all) {
    if (binds && (at.done() || at.sees({".", ",", "loosely", "in"}))) {
      node.kind = Kind::bind_off;
      node.times = 0;
      at.skip(at.part().size());
      return node;
    }
    at.back_to(before);
    return std::nullopt;
  }
  node.kind = binds ? Kind::bind_off : Kind::add;
  node.times = at.peek().is_number() ? at.peek().value : 0;
  const std::span<const Atom> part = at.part();
  const bool both = !binds && holds_any(part, {"each", "either", "both"}) &&
                    holds_any(part, {"side", "sides", "end", "ends"});
  if (both) node.times *= 2;
  at.skip(part.size());
  return node;
}

std::optional<WorldNode> turned(PhraseCursor& at) {
  WorldNode node;
  node.kind = Kind::turn;
  if (at.sees({"w"}) && at.sees({"&", "+"}, 1) && at.sees({"t"}, 2)) {
    at.skip(3);
    return node;
  }
  if (at.take({"wt", "turn"})) {
    at.take({"work"});
    return node;
  }
  if (at.sees({"wrap"}) && at.sees({"and", "&"}, 1) && at.sees({"turn"}, 2)) {
    at.skip(3);
    return node;
  }
  return std::nullopt;
}

// "work in pattern", "work even", "knit the knits and purl the purls", "work in k1, p1 rib"
std::optional<WorldNode> as_it_is(PhraseCursor& at) {
  const std::size_t before = at.at();
  WorldNode node;
  node.kind = Kind::rest;
  if (at.sees({"knit", "k"}) && at.sees({"knits"}, 1)) {
    while (
        at.take({"knit", "k", "knits", "and", "purl", "p", "purls", ",", "as", "they", "appear", "work"})) {
    }
    return node;
  }
  const bool work = at.take({"work", "continue", "cont", "patt", "pattern", "knit", "k", "keep", "maintain"});
  if (!work) return std::nullopt;
  bool even = false;
  if (at.take({"even", "evenly", "straight", "plain"})) even = true;
  if (!even && at.take({"in", "as"})) {
    while (at.take({"est",   "established", "patt",   "pattern", "stockinette", "stocking", "st",   "stitch",
                    "rib",   "ribbing",     "garter", "set",     "rev",         "reverse",  "moss", "seed",
                    "est'd", "main",        "color",  "colour",  "mc",          "cc"}))
      even = true;
  }
  if (!even) {
    at.back_to(before);
    return std::nullopt;
  }
  if (const auto words = at.repeat_words()) {
    node.until = words->until == Until::times ? Until::end : words->until;
    node.tail = words->tail;
    node.next = words->next;
    if (node.until == Until::marker) {
      node.kind = Kind::stitch;
      node.takes = node.makes = 1;
    }
  }
  return node;
}

// "with waste yarn k5 for thumb, slip these 5 sts back to left needle and knit them again with main yarn"
std::optional<WorldNode> inserted(PhraseCursor& at) {
  if (!at.sees({"with", "using"}) || !at.sees({"waste", "scrap", "contrasting"}, 1) || !at.sees({"yarn"}, 2))
    return std::nullopt;
  std::span<const Atom> part = at.part();
  const auto count = number_in(part);
  if (!count) return std::nullopt;
  WorldNode node;
  node.kind = Kind::insert;
  node.times = *count;
  node.name = world_name(behind(part, {"for"}));
  at.skip(part.size());
  const std::size_t before = at.at();
  at.take({","});
  part = at.part();
  if (!part.empty() && is_any(part[0], {"slip", "sl", "return", "place"}) && holds_any(part, {"back"})) {
    at.skip(part.size());
    if (holds_any(part, {"again"})) node.takes = node.makes = 1;  // "and knit them again"
  } else {
    at.back_to(before);
  }
  return node;
}

}  // namespace

std::string world_name(std::span<const Atom> atoms) {
  std::string name;
  for (const Atom& atom : atoms) {
    if (!atom.is_word() || is_stitches(atom)) continue;
    if (is_any(atom, {"held", "needle", "needles", "on", "holder", "stitch", "waste", "yarn", "of", "back",
                      "from", "sts", "onto", "later", "next", "remaining", "one", "other"}))
      continue;
    name += (name.empty() ? "" : " ") + atom.text;
  }
  return name;
}

std::optional<WorldNode> phrase_here(PhraseCursor& at) {
  const std::size_t begin = at.peek().at;
  std::optional<WorldNode> node;
  for (auto* const read : {marker, shaped, inserted, held, edge, turned, as_it_is}) {
    node = read(at);
    if (node) break;
  }
  if (!node) return node;
  node->at = begin;
  node->length = at.behind() - begin;
  return node;
}

std::span<const Atom> PhraseCursor::part() const {
  std::size_t end = at_;
  while (end < line_.size() && !is_any(line_[end], {",", ".", ";", "(", ")", "[", "]", "then"})) {
    if (line_[end].is("and") && end + 1 < line_.size() && is_any(line_[end + 1], {"k", "p", "co", "bo"}) &&
        end > at_ + 1)
      break;
    ++end;
  }
  return line_.subspan(at_, end - at_);
}

bool PhraseCursor::of_the_round() {
  std::size_t ahead = sees({"of", "in", "on"}) ? 1 : 0;
  if (sees({"this", "each"}, ahead)) ++ahead;
  if (!is_rounds(peek(ahead)) && !sees({"needle", "needles", "n1", "circle", "piece"}, ahead)) return false;
  skip(ahead + 1);
  return true;
}

std::optional<std::int64_t> PhraseCursor::times_only() {
  const std::size_t before = at_;
  const auto words = numbered_times();
  if (words && !words->more) return words->times;
  at_ = before;
  return std::nullopt;
}

// "6 times", "x 6", "6x", "twice", "5 more times", "5 times more", "a total of 5 times", "5 times in all"
std::optional<RepeatWords> PhraseCursor::numbered_times() {
  const std::size_t before = at_;
  RepeatWords words;
  const bool bracket =
      sees({"(", "["}) && peek(1).is_number() && sees({"times", "x"}, 2) && sees({")", "]"}, 3);
  if (bracket) {
    words.times = peek(1).value;
    skip(4);
    return words;
  }
  take({"for", "worked", "work"});
  if (sees({"total"}) && sees({"of"}, 1)) {
    skip(2);
    words.in_all = true;
  }
  if (sees({"once", "twice", "thrice"})) {
    words.times = sees({"once"}) ? 1 : sees({"twice"}) ? 2 : 3;
    skip();
  } else if ((sees({"x"}) || (sees({"*"}) && at_ > 0 && is_any(line_[at_ - 1], {")", "]"}) &&
                              !sees({"times"}, 2))) &&  // "*k1, (k1, p1)* 3 times": the star's end
             peek(1).is_number()) {
    words.times = peek(1).value;
    skip(2);
    take({"times", "x"});
  } else if (peek().is_number() && (sees({"times", "time", "x", "repeats", "reps"}, 1) ||
                                    (sees({"more"}, 1) && sees({"times", "time"}, 2)))) {
    words.times = peek().value;
    skip();
    words.more = take({"more"});
    skip();
  } else {
    at_ = before;
    return std::nullopt;
  }
  words.more = take({"more", "again"}) || words.more;
  if (sees({"in"}) && sees({"total", "all"}, 1)) {
    skip(2);
    words.in_all = true;
  }
  if (take({"total", "altogether"})) words.in_all = true;
  return words;
}

// "in each st around", "all sts", "in next 3 sts", "of each st"
std::optional<RepeatWords> PhraseCursor::each_words() {
  const std::size_t before = at_;
  RepeatWords words;
  words.each = true;
  words.until = Until::end;
  const bool in = take({"in", "into", "of", "across", "over"});
  if (take({"all", "each", "every"})) {
    take({"of", "single"});
    if (in && sees({"next"}) && peek(1).is_number()) {
      words.until = Until::times;
      words.times = peek(1).value;
      skip(2);
      if (is_stitches(peek())) skip();
      return words;
    }
    take({"remaining", "rem"});
    if (is_stitches(peek()))
      skip();
    else if (!sees({"around"})) {
      at_ = before;
      return std::nullopt;
    }
    if (sees({"around", "across", "to"})) {
      if (const auto end = end_words()) {
        words.tail = end->tail;
        words.until = end->until;
        words.next = end->next;
      }
    } else {
      of_the_round();
    }
    return words;
  }
  if (in && take({"next", "first", "last"})) {
    const bool number = peek().is_number();
    if (number) words.times = peek().value, skip();
    if (is_stitches(peek())) {
      skip();
      words.until = Until::times;
      return words;
    }
  }
  at_ = before;
  return std::nullopt;
}

std::optional<RepeatWords> PhraseCursor::end_words() {
  const std::size_t before = at_;
  RepeatWords words;
  words.until = Until::end;
  take({"all"});
  if (take({"around", "across"})) {
    if (sees({"way"})) skip();
    if (take({"to"})) {
      if (!take({"end"})) --at_;
    }
    if (sees({"all"}) && is_stitches(peek(1))) skip(2);
    of_the_round();
    return words;
  }
  if (sees({"all"})) skip();
  if (sees({"way"}) && sees({"around", "to"}, 1)) skip();
  if (take({"around"})) return words;
  if (!take({"to", "until", "til", "till"})) {
    at_ = before;
    return std::nullopt;
  }
  take({"within"});
  if (take({"end", "beg", "bor"})) {
    of_the_round();
    return words;
  }
  const bool last = take({"last", "final"});
  std::optional<std::int64_t> number;
  if (peek().is_number()) number = peek().value, skip();
  const bool stitches = is_stitches(peek());
  if (stitches) skip();
  take({"of", "is", "are"});
  const bool left = take({"remain", "remains", "rem", "left", "remaining", "before", "from"});
  take({"on", "at"});
  words.next = take({"next", "first", "second", "following", "side"});
  if (is_marker(peek())) {
    skip();
    words.until = Until::marker;
    words.tail = number.value_or(0);
    return words;
  }
  if (left && take({"end", "bor"}))
    of_the_round();
  else if (left && sees({"on"})) {
    skip();
    of_the_round();
  }
  if (stitches && (last || (number && left))) {
    words.tail = number.value_or(1);
    of_the_round();
    return words;
  }
  at_ = before;
  return std::nullopt;
}

std::optional<RepeatWords> PhraseCursor::repeat_words() {
  if (done()) return std::nullopt;
  if (auto words = numbered_times()) return words;
  if (auto words = each_words()) return words;
  return end_words();
}

bool PhraseCursor::star_words() {
  if (take({"between", "instructions"})) {
    take({"between"});
    while (take({"*", "and", "s", "stars", "asterisks", "'s"}) ||
           (sees({"to"}) && sees({"*"}, 1) && take({"to"}))) {
    }
    return true;
  }
  const bool from = take({"from"});
  const bool star = take({"*"});
  if (star && sees({"to"}) && sees({"*"}, 1)) skip(2);
  if (from && !star) take({"star", "asterisk", "beginning", "beg"});
  return from || star;
}

void PhraseCursor::suffix() {
  for (;;) {
    if (take({"tbl", "purlwise", "knitwise", "pwise", "kwise", "wyif", "wyib", "pw", "kw"})) continue;
    if (sees({"through"}) && sees({"back"}, 1) && sees({"loop", "loops"}, 2)) {
      skip(3);
      continue;
    }
    if (sees({"with"}) && sees({"yarn"}, 1) && sees({"in"}, 2) && sees({"front", "back"}, 3)) {
      skip(4);
      continue;
    }
    if (sees({"as"}) && sees({"if"}, 1) && sees({"to"}, 2)) {
      skip(4);
      continue;
    }
    return;
  }
}

bool PhraseCursor::one_stitch() {
  const std::size_t before = at_;
  if (!take({"in", "into", "all"})) return false;
  take({"in", "into"});
  if (take({"next", "same", "1", "following"}) && is_stitches(peek())) {
    skip();
    return true;
  }
  at_ = before;
  // "(k1, p1) in each st": the repeat's words stay, and it is one stitch still
  if (sees({"in", "into"}) && sees({"each", "every", "all"}, 1)) return true;
  return false;
}

bool PhraseCursor::remark() {
  if (done()) return false;
  if (opens_remark(peek())) return remark_words();
  return sees({"(", "["}) && remark_in_brackets();
}

bool PhraseCursor::remark_words() {
  if (take({"loosely", "tightly", "evenly"})) return true;
  const std::size_t length = part().size();
  if (length == 0) return false;
  if (!sees({"join", "being", "taking"}) && works_behind_first()) return colour_words();
  skip(length);
  return true;
}

// Whether the part says work or a number behind its first word.
bool PhraseCursor::works_behind_first() const {
  const std::span<const Atom> words = part();
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (words[i].is_number() || match(i)) return true;
  }
  return false;
}

// "with MC k10": the colour's words end where the work begins.
bool PhraseCursor::colour_words() {
  constexpr std::size_t most_words = 4;
  if (!sees({"with", "using", "in"}) || sees({"waste", "scrap", "contrasting"}, 1)) return false;
  const std::span<const Atom> words = part();
  std::size_t ahead = 1;
  while (ahead < words.size() && ahead < most_words && !match(ahead) && !words[ahead].is_number()) ++ahead;
  if (ahead >= words.size() || !match(ahead)) return false;
  skip(ahead);
  return true;
}

// "(dec)", "(RS)", and "(backward loop)": how stitches are cast on.
bool PhraseCursor::remark_in_brackets() {
  const std::size_t end = note_end();
  if (end < 2 || !sees({"rs", "ws", "dec", "inc", "increase", "decrease", "right", "wrong", "optional",
                        "note", "backward", "backwards", "knitted", "cable"},
                       1))
    return false;
  skip(end + 1);
  return true;
}

// How far ahead the bracket that stands here closes; 0: it does not, or holds work.
std::size_t PhraseCursor::note_end() const {
  for (std::size_t ahead = 1; at_ + ahead < line_.size(); ++ahead) {
    if (sees({")", "]"}, ahead)) return ahead;
    if (peek(ahead).is_number() || sees({"(", "["}, ahead)) return 0;
    if (match(ahead) && !sees({"inc", "dec", "increase", "decrease"}, ahead)) return 0;
  }
  return 0;
}

}  // namespace knit
