#include "knit/reader/reader_grammar.h"

#include <algorithm>
#include <utility>

#include "knit/import/quoting.h"
#include "knit/reader/reader_cursor.h"

namespace knit {

namespace {

constexpr int most_depth = 2;

std::int64_t bounded(std::int64_t value) { return std::min(value, most_number); }

class Parser {
 public:
  Parser(std::span<const Token> line, MarkerWords markers) : at_(line), markers_(markers) {}

  RoundWords run() {
    RoundWords words;
    words.nodes = sequence("", 0);
    if (words.nodes.size() == 1 && words.nodes[0].bare) words.nodes[0].open = true;
    if (words.nodes.empty()) fail(": it says nothing to work.");
    words.mistake = std::move(mistake_);
    return words;
  }

 private:
  struct Times {
    bool open = false, more = false;
    std::int64_t number = 1, tail = 0;
  };

  // The first mistake counts; it ends reading.
  void fail(std::string sentence) {
    if (mistake_.empty()) mistake_ = std::move(sentence);
  }
  [[nodiscard]] bool failed() const { return !mistake_.empty(); }

  // Up to the sign `close`, which stays; "" is the end of the line, "*" also ends before "rep from".
  std::vector<WorkNode> sequence(std::string_view close, int depth) {
    std::vector<WorkNode> nodes;
    while (!failed() && !at_.done() && !(at_.peek().is(close) && !close.empty())) {
      if (close == "*" && at_.sees({"rep", "repeat"})) break;
      if (at_.take({",", ";", ".", "and", "then"}) || marker() || join()) continue;
      if (auto node = item(depth)) nodes.push_back(std::move(*node));
    }
    return nodes;
  }

  std::optional<WorkNode> item(int depth) {
    if (at_.sees({"[", "(", "{", "*"})) {
      if (depth >= most_depth) {
        fail(": repeats stand more than " + std::to_string(most_depth) + " deep; write the inner one out.");
        return std::nullopt;
      }
      return at_.sees({"*"}) ? star(depth + 1) : bracket(depth + 1);
    }
    if (const auto named = stitch_named(at_.peek())) return stitch(*named, depth);
    fail(what_is_wrong_here());
    return std::nullopt;
  }

  [[nodiscard]] std::string what_is_wrong_here() const {
    const Token& token = at_.peek();
    if (at_.sees({"]", ")", "}"})) return ": a \"" + token.text + "\" closes a bracket that is not open.";
    if (at_.sees({"rep", "repeat"})) {
      if (is_round_word(at_.peek(1)))
        return ": it repeats other rounds by their numbers; write those rounds out.";
      return ": \"" + token.text + "\" has no * to repeat from.";
    }
    if (at_.sees({"times", "time", "x"})) return ": \"" + token.text + "\" stands without a number.";
    if (token.is_number()) return ": the number " + token.text + " belongs to no word beside it.";
    if (token.kind == Token::Kind::mark) return ": the sign " + quoted(token.text) + " means nothing there.";
    return ": the word " + quoted(token.text) + " is not known.";
  }

  // pm, sm, place marker, slip the marker: no stitch.
  bool marker() {
    if (at_.take({"pm", "sm", "rm"})) return true;
    if (!at_.sees({"place", "slip", "remove"})) return false;
    std::size_t ahead = 1;
    while (at_.sees({"a", "the", "bor", "stitch", "first", "second"}, ahead)) ++ahead;
    if (!at_.sees({"marker", "markers", "m"}, ahead)) return false;
    at_.skip(ahead + 1);
    return true;
  }

  // "Join to work in the round": no stitch.
  bool join() {
    if (!at_.take({"join"})) return false;
    while (!at_.done() && !at_.sees({".", ";", ","})) at_.skip();
    return true;
  }

  static void measure(WorkNode& node) {
    if (node.stitch) {
      node.takes = node.stitch->takes;
      node.makes = node.stitch->makes;
      return;
    }
    for (const WorkNode& inner : node.inside) {
      node.varies = node.varies || inner.varies;
      node.takes = bounded(node.takes + bounded(inner.takes * inner.times));
      node.makes = bounded(node.makes + bounded(inner.makes * inner.times));
    }
  }

  static void set_times(WorkNode& node, const Times& times) {
    node.open = times.open;
    node.times = times.number;
    node.tail = times.tail;
  }

  std::optional<WorkNode> finished(WorkNode node, int depth) {
    measure(node);
    if (node.times < 1) fail(": " + node.words + " is asked for 0 times.");
    if (node.takes == 0 && node.makes == 0) fail(": " + node.words + " holds nothing to work.");
    if (node.open && depth > 0) fail(": a repeat to the end stands within another repeat.");
    return node;
  }

  std::optional<WorkNode> stitch(const NamedStitch& named, int depth) {
    WorkNode node;
    node.stitch = named.kind;
    node.words = at_.peek().text;
    at_.skip();
    std::optional<std::int64_t> count = named.count;
    if (named.kind.counts && !count) count = count_behind();
    at_.take({"tbl"});
    if (count && is_stitches_word(at_.peek())) at_.skip();
    node.bare = named.kind.word.starts_with("k") && named.kind.counts && !count;
    if (count && *count != 1) {  // k4 is a repeat of k
      WorkNode one = std::move(node);
      measure(one);
      node = WorkNode{};
      node.words = one.words;
      if (named.count == std::nullopt) node.words += " " + std::to_string(*count);
      one.times = *count;
      if (*count < 1) fail(": " + node.words + " is no stitch at all.");
      node.inside.push_back(std::move(one));
    }
    if (const auto target = to_marker(node)) {
      node.tail = target->tail;
      node.marker = target->name;
      node.to_marker = node.varies = true;
      node.bare = false;
    } else if (const auto times = times_here()) {
      set_times(node, *times);
      node.bare = false;
    }
    return finished(std::move(node), depth);
  }

  // "k to next m", "k to 2 sts before front m": the stitches that are kept, and which marker.
  struct MarkerAhead {
    std::int64_t tail = 0;
    MarkerName name = MarkerName::next;
  };
  std::optional<MarkerAhead> to_marker(const WorkNode& node) {
    const std::size_t begin = at_.at();
    if (markers_ != MarkerWords::known || !node.bare || !at_.take({"to"})) return std::nullopt;
    MarkerAhead target;
    if (at_.peek().is_number() && is_stitches_word(at_.peek(1)) && at_.sees({"before"}, 2)) {
      target.tail = at_.peek().value;
      at_.skip(3);
    }
    at_.take({"the"});
    const auto* const name = std::find(marker_names.begin(), marker_names.end(), at_.peek().text);
    if (name != marker_names.end()) {
      target.name = static_cast<MarkerName>(name - marker_names.begin());
      at_.skip();
      if (at_.take({"m", "marker"})) return target;
    }
    at_.back_to(begin);
    return std::nullopt;
  }

  // "knit 4", "k the next 4": not "k 4 times".
  std::optional<std::int64_t> count_behind() {
    std::size_t ahead = 0;
    while (at_.sees({"the", "next"}, ahead)) ++ahead;
    const auto count = number_of(at_.peek(ahead));
    if (!count || at_.sees({"times", "time", "x", "more"}, ahead + 1)) return std::nullopt;
    at_.skip(ahead + 1);
    return count;
  }

  std::optional<WorkNode> bracket(int depth) {
    const std::string open = at_.peek().text;
    const std::string_view close = open == "[" ? "]" : open == "(" ? ")" : "}";
    at_.skip();
    WorkNode node;
    node.words = "the repeat";
    node.inside = sequence(close, depth);
    if (failed()) return std::nullopt;
    if (!at_.take({close})) {
      fail(": the bracket \"" + open + "\" is not closed.");
      return std::nullopt;
    }
    while (at_.sees({","}) && (at_.sees({"rep", "repeat"}, 1) && !at_.sees({"from"}, 2))) at_.skip();
    if (at_.sees({"rep", "repeat"}) && !at_.sees({"from", "*"}, 1)) at_.skip();
    const auto times = times_here();
    if (!times && at_.peek().is_number())
      fail(": the number " + at_.peek().text + " after the bracket has no \"times\".");
    if (!times && at_.sees({"times", "time", "x"})) fail(what_is_wrong_here());
    if (!times) fail(": a bracket closes and nothing says how many times it is worked.");
    if (failed()) return std::nullopt;
    set_times(node, *times);
    return finished(std::move(node), depth - 1);
  }

  std::optional<WorkNode> star(int depth) {
    at_.skip();
    WorkNode node;
    node.words = "the repeat";
    node.inside = sequence("*", depth);
    if (failed()) return std::nullopt;
    const bool closed = at_.take({"*"});
    while (closed && at_.sees({",", ";"})) at_.skip();
    const bool again = at_.take({"rep", "repeat"});
    const bool from = again && at_.take({"from"});
    if (again) at_.take({"*"});
    if (at_.sees({",", ";"}) && at_.sees({"to", "until", "around"}, 1)) at_.skip();
    auto times = times_here();
    if (!times && from && at_.sees({"times", "time", "x"})) fail(what_is_wrong_here());
    if (!times && from) times = Times{true};
    if (!times) fail(": the * is never repeated; \"rep from *\" and how often is missing.");
    if (failed()) return std::nullopt;
    // "rep from * 5 times" comes on top of the one just worked, as "5 more times" does.
    if (!times->open && (from || times->more)) ++times->number;
    set_times(node, *times);
    return finished(std::move(node), depth - 1);
  }

  // "6 times", "x 6", "6x", "twice", "to end", "around", "in each st", "to last 3 sts".
  std::optional<Times> times_here() {
    if (auto open = to_the_end()) return open;
    if (at_.sees({"once", "twice", "thrice"})) {
      Times times;
      times.number = at_.sees({"once"}) ? 1 : at_.sees({"twice"}) ? 2 : 3;
      at_.skip();
      times.more = at_.take({"more"});
      return times;
    }
    const Token& here = at_.peek();
    if (here.is("x") && at_.peek(1).is_number()) {
      const std::int64_t number = at_.peek(1).value;
      at_.skip(2);
      at_.take({"times"});
      return Times{false, false, number, 0};
    }
    if (here.kind == Token::Kind::word && here.text.size() > 1 && here.text[0] == 'x') {
      const Tokens number = tokens_of(std::string_view(here.text).substr(1));
      if (number.size() != 1 || !number[0].is_number()) return std::nullopt;
      at_.skip();
      return Times{false, false, number[0].value, 0};
    }
    const auto number = number_of(here);
    const bool more = at_.sees({"more"}, 1);
    if (!number || !at_.sees({"times", "time", "x"}, more ? 2 : 1)) return std::nullopt;
    at_.skip(more ? 3 : 2);
    const bool more_behind = at_.take({"more"});
    return Times{false, more || more_behind, *number, 0};
  }

  // "of the rnd", "of rnd"
  void of_the_round() {
    std::size_t ahead = at_.sees({"of"}) ? 1 : 0;
    while (at_.sees({"the", "this"}, ahead)) ++ahead;
    if (is_round_word(at_.peek(ahead))) at_.skip(ahead + 1);
  }

  std::optional<Times> to_the_end() {
    const std::size_t begin = at_.at();
    if (at_.take({"around", "across"})) {
      of_the_round();
      return Times{true};
    }
    const bool in = at_.take({"in"});
    if (at_.take({"all", "each", "every"})) {
      if (is_stitches_word(at_.peek())) at_.skip();
      if (at_.sees({"around", "across"}) || (at_.sees({"to"}) && at_.sees({"end", "the"}, 1))) to_the_end();
      return Times{true};
    }
    if (!in && at_.take({"to", "until"})) {
      at_.take({"the"});
      if (at_.take({"end"})) {
        of_the_round();
        return Times{true};
      }
      const bool last = at_.take({"last"});
      const auto number = number_of(at_.peek());
      if (number) at_.skip();
      const bool stitches = is_stitches_word(at_.peek());
      if (stitches) at_.skip();
      const bool left = !last && (at_.take({"remain", "remains", "rem", "left", "before"}) || is_left());
      if (left) at_.take({"end"});
      if (stitches && (last || (number && left))) return Times{true, false, 1, number.value_or(1)};
    }
    at_.back_to(begin);
    return std::nullopt;
  }

  bool is_left() {
    if (!at_.sees({"are", "is"}) || !at_.sees({"left"}, 1)) return false;
    at_.skip(2);
    return true;
  }

  TokenCursor at_;
  MarkerWords markers_;
  std::string mistake_;
};

// "(30 sts)", "[30 sts]", "(30)", "- 30 sts", "= 30": where it begins and its number.
struct Stated {
  std::size_t begin = 0, end = 0;
  std::int64_t number = 0;
};

std::optional<Stated> bracketed_count(std::span<const Token> line, std::size_t open) {
  TokenCursor at(line);
  at.skip(open);
  const std::string_view close = at.sees({"("}) ? ")" : "]";
  if (!at.take({"(", "["}) || !at.peek().is_number()) return std::nullopt;
  const std::int64_t number = at.peek().value;
  at.skip();
  const bool stitches = is_stitches_word(at.peek());
  if (stitches) at.skip();
  while (at.sees({"total", "in", "all", "on", "needle", "needles", "now", "remain", "rem", "remaining"}))
    at.skip();
  at.take({"."});
  if (!at.take({close})) return std::nullopt;
  const std::size_t end = at.at();
  // Without the word "sts" only the line's last brackets are a count.
  while (at.take({"."})) {
  }
  if (!stitches && (!at.done() || open == 0)) return std::nullopt;
  return Stated{open, end, number};
}

std::optional<Stated> find_stated(std::span<const Token> line) {
  for (std::size_t i = line.size(); i-- > 0;) {
    if (const auto stated = bracketed_count(line, i)) return stated;
  }
  TokenCursor at(line);
  std::size_t end = line.size();
  while (end > 0 && line[end - 1].is(".")) --end;
  const std::size_t last = end > 0 && is_stitches_word(line[end - 1]) ? end - 1 : end;
  if (last < 2 || !line[last - 1].is_number() || !(line[last - 2].is("-") || line[last - 2].is("=")))
    return std::nullopt;
  return Stated{last - 2, line.size(), line[last - 1].value};
}

}  // namespace

RoundWords round_words(std::span<const Token> line, MarkerWords markers) {
  const auto stated = find_stated(line);
  RoundWords words = Parser(stated ? line.first(stated->begin) : line, markers).run();
  if (!stated) return words;
  words.stated = stated->number;
  // Behind the count only a remark may stand.
  for (const Token& token : line.subspan(stated->end)) {
    if (((stitch_named(token) && !token.is("slip")) || token.is_number() || token.is("*")) &&
        words.mistake.empty())
      words.mistake = ": " + quoted(token.text) + " stands behind the count; the count comes last.";
  }
  return words;
}

std::optional<std::int64_t> stated_in(std::span<const Token> line) {
  const auto stated = find_stated(line);
  return stated ? std::optional(stated->number) : std::nullopt;
}

}  // namespace knit
