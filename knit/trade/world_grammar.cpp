#include "knit/trade/world_grammar.h"

#include <algorithm>
#include <utility>

#include "knit/import/quoting.h"
#include "knit/trade/world_phrases.h"

namespace knit {

namespace {

using Kind = WorldNode::Kind;
using Until = WorldNode::Until;
using Nodes = std::vector<WorldNode>;
constexpr int most_depth = 6;

class RoundParser {
 public:
  RoundParser(std::span<const Atom> line, const Lexicon& lexicon, bool other)
      : at_(line, lexicon), other_(other) {}

  WorldRound run() {
    WorldRound round;
    round.nodes = sequence("", 0);
    if (round_.trouble.empty() && round.nodes.empty()) fail("it says nothing to work.");
    if (round.nodes.size() == 1 && round.nodes[0].plain) to_the_end(round.nodes[0]);
    round.trouble = std::move(round_.trouble);
    round.at = round_.at;
    round.length = round_.length;
    round.choice = choice_;
    return round;
  }

 private:
  void fail(std::string sentence) {
    if (!round_.trouble.empty()) return;
    round_.trouble = std::move(sentence);
    round_.at = at_.peek().at;
    round_.length = at_.peek().length;
  }
  [[nodiscard]] bool failed() const { return !round_.trouble.empty(); }
  void fail_here() {
    if (at_.done()) return fail("it breaks off.");
    const Atom& atom = at_.peek();
    if (atom.is_word()) return fail("the word " + quoted(atom.text) + " is not known.");
    if (atom.is_number()) return fail("the number " + atom.text + " belongs to no word beside it.");
    fail("the sign " + quoted(atom.text) + " means nothing there.");
  }

  static void to_the_end(WorldNode& node) {
    node.until = Until::end;
    node.plain = false;
  }
  static WorldNode group(Nodes nodes) {
    WorldNode node;
    node.kind = Kind::repeat;
    node.at = nodes.empty() ? 0 : nodes.front().at;
    if (!nodes.empty()) node.length = nodes.back().at + nodes.back().length - node.at;
    node.inside = std::move(nodes);
    return node;
  }
  static bool shapes(const WorldNode& node) { return node.kind == Kind::stitch || node.kind == Kind::repeat; }
  static bool is_open(const WorldNode& node) { return node.until != Until::times; }

  Nodes sequence(std::string_view close, int depth) {
    Nodes nodes;
    std::optional<std::size_t> star;  // the node that "*" stands before
    while (!failed() && !at_.done() && (close.empty() || !at_.sees({close}))) {
      if (at_.take({",", ";", ".", "and", "then", "-", ":", "&", "/"})) continue;
      if (at_.sees({"*"})) {
        if (!star)
          star = nodes.size(), at_.skip();
        else if (!end_of_star(nodes, *star))
          fail_here();
        else
          star.reset();
        continue;
      }
      if (at_.sees({"rep", "repeat", "repeating"})) {
        if (!again(nodes, star, close)) fail_here();
        star.reset();
        continue;
      }
      if (!nodes.empty() && whole_repeat(nodes, star.value_or(0))) {
        star.reset();
        continue;
      }
      if (at_.remark()) continue;
      const std::size_t before = at_.at();
      auto node = item(depth);
      if (!node) {
        if (!failed()) fail_here();
        break;
      }
      nodes.push_back(std::move(*node));
      if (at_.at() == before) fail_here();
    }
    if (!failed() && star && *star < nodes.size()) fail("the * is never repeated.");
    settle_plain(nodes, depth);
    return nodes;
  }

  // "k" without a number is one stitch, or all that is left where it stands last.
  void settle_plain(Nodes& nodes, int depth) {
    if (nodes.size() < 2 && depth == 0) return;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (!nodes[i].plain) continue;
      nodes[i].plain = false;
      const bool alone_shaping =
          i > 0 && std::all_of(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(i),
                               [](const WorldNode& n) { return !shapes(n); });
      bool last = true;
      for (std::size_t j = i + 1; j < nodes.size(); ++j) last = last && !shapes(nodes[j]);
      if (depth > 0 || !last) continue;
      const bool shaped_after =
          std::any_of(nodes.begin(), nodes.end(), [](const WorldNode& n) { return n.kind == Kind::shape; });
      if (shaped_after) continue;
      choice_ = true;
      if (alone_shaping || i == 0 || other_) to_the_end(nodes[i]);
    }
    const auto shape =
        std::find_if(nodes.begin(), nodes.end(), [](const WorldNode& n) { return n.kind == Kind::shape; });
    if (shape != nodes.end() && shape != nodes.begin() && nodes.front().kind == Kind::stitch &&
        nodes.size() == 2 && nodes.front().times == 1)
      nodes.erase(nodes.begin());  // "Knit, decreasing 8 sts evenly"
  }

  static void apply(WorldNode& node, const RepeatWords& words) {
    node.until = words.until;
    node.times = words.times;
    node.tail = words.tail;
    node.next = words.next;
    node.plain = false;
  }
  static void wrap(Nodes& nodes, std::size_t from, const RepeatWords& words) {
    Nodes inside(std::make_move_iterator(nodes.begin() + static_cast<std::ptrdiff_t>(from)),
                 std::make_move_iterator(nodes.end()));
    nodes.resize(from);
    WorldNode node = inside.size() == 1 && shapes(inside.front()) && inside.front().times == 1 &&
                             !is_open(inside.front()) && inside.front().kind == Kind::stitch
                         ? std::move(inside.front())
                         : group(std::move(inside));
    apply(node, words);
    nodes.push_back(std::move(node));
  }

  // "* ... * around", "* ... *; rep from * to * 4 more times", "*...* twice"
  bool end_of_star(Nodes& nodes, std::size_t star) {
    at_.skip();
    if (nodes.size() == star) return false;
    std::size_t ahead = at_.at();
    while (at_.take({",", ";", ".", "-"})) {
    }
    if (at_.sees({"rep", "repeat", "repeating"})) {
      std::optional<std::size_t> from = star;
      return again(nodes, from, "");
    }
    if (at_.at() != ahead && !at_.sees({"around", "to", "across"})) at_.back_to(ahead);
    auto words = at_.repeat_words();
    if (!words) return false;
    wrap(nodes, star, *words);
    return true;
  }

  // "rep from * to end", "repeat around", "rep between * and * twice", "repeat 5 times"
  bool again(Nodes& nodes, const std::optional<std::size_t>& star, std::string_view close) {
    at_.skip();
    if (!close.empty() && at_.sees({close})) return true;  // "[K4, m1l; rep] 5x"
    const bool from = at_.star_words();
    if (nodes.empty() || nodes.size() == star.value_or(0)) return false;
    while (at_.sees({","}) && at_.sees({"to", "around", "until", "across", "ending", "end"}, 1)) at_.skip();
    auto words = at_.repeat_words();
    if (!words && !from && !star) return false;
    const bool told = words.has_value();
    if (!told) {
      words = RepeatWords{};
      words->until = Until::end;
    }
    // "rep from * 5 times" comes on top of the one just worked; "a total of 5 times" and "(k4, m1l) repeat 5 times" do not.
    if (words->until == Until::times && (from || words->more) && !words->in_all) ++words->times;
    std::size_t begin = star.value_or(0);
    const bool group_before = !star && !from && nodes.back().kind == Kind::repeat &&
                              nodes.back().times == 1 && !is_open(nodes.back());
    if (group_before) begin = nodes.size() - 1;
    if (from && !star) return false;
    wrap(nodes, begin, *words);
    return true;
  }

  // "k4, m1l around", "K1, kfb to end": all of it, or its last stitch.
  bool whole_repeat(Nodes& nodes, std::size_t from) {
    if (!at_.sees({"around", "to", "across", "until", "all"}) || !shapes(nodes.back()) ||
        is_open(nodes.back()))
      return false;
    const std::size_t before = at_.at();
    const bool around = at_.sees({"around", "across", "all"});
    const auto words = at_.repeat_words();
    if (!words) return false;
    if (words->until == Until::times) {
      at_.back_to(before);
      return false;
    }
    const bool single = nodes.size() - from == 1;
    const WorldNode& last = nodes.back();
    const bool can_single = !last.numbered && !around && (last.kind == Kind::repeat || last.takes > 0);
    if (!single && can_single) choice_ = true;
    wrap(nodes, !single && other_ && can_single ? nodes.size() - 1 : from, *words);
    return true;
  }

  std::optional<WorldNode> item(int depth) {
    if (at_.sees({"(", "["})) return bracket(depth + 1);
    if (at_.peek().is_number() && at_.sees({"x", "times"}, 1) && at_.sees({"(", "["}, 2)) {
      const std::int64_t times = at_.peek().value;
      at_.skip(2);
      auto node = bracket(depth + 1);
      if (node && !is_open(*node) && node->times == 1) node->times = times;
      return positive(std::move(node));
    }
    if (auto node = phrase_here(at_)) return node;
    const auto matched = at_.match();
    if (!matched) return std::nullopt;
    return stitch(*matched);
  }

  std::optional<WorldNode> positive(std::optional<WorldNode> node) {
    if (node && node->times < 1) fail("it is asked for 0 times.");
    return node;
  }

  std::optional<WorldNode> stitch(const MatchedWord& word) {
    WorldNode node;
    node.at = at_.peek().at;
    node.takes = word.takes;
    node.makes = word.makes;
    node.plain = word.plain;
    at_.skip(word.atoms);
    if (word.vague) {
      node.vague = choice_ = true;
      if (other_) node.takes = 0, node.makes = 1;
    }
    if (word.counts) count_of(node);
    at_.suffix();
    node.length = at_.behind() - node.at;
    if (node.plain || !word.counts || node.times == 1) {
      const std::size_t before = at_.at();
      const auto words = at_.repeat_words();
      const bool single = words && (node.plain || !word.counts || words->until != Until::end);
      // "m1l to end" and "K4, m1l around" repeat more than the last stitch: the sequence takes that up.
      const bool of_sequence = words && !words->each && words->until == Until::end && !node.plain;
      if (words && single && !of_sequence) {
        if (words->each && word.takes == 0) node.takes = 1, node.makes = 2;
        apply(node, *words);
        node.plain = false;
      } else if (words) {
        at_.back_to(before);
      }
    } else if (const auto words = at_.times_only()) {  // "k4 3 times"
      WorldNode inner = std::move(node);
      node = group({std::move(inner)});
      node.times = *words;
    }
    node.length = at_.behind() - node.at;
    return positive(std::move(node));
  }

  // "k4", "knit 4 sts", "knit the next 4", "k across next 7 sts", "slip next st"
  void count_of(WorldNode& node) {
    const std::size_t before = at_.at();
    at_.take({"across", "over"});
    const bool next = at_.take({"next", "following", "first", "other", "last"});
    if (at_.peek().is_number() && !at_.sees({"x", "times", "time", "more"}, 1) &&
        !at_.sees({"rnds", "rows", "rounds", "rnd", "row", "round"}, 1)) {
      node.times = at_.peek().value;
      node.plain = false;
      node.numbered = true;
      at_.skip();
      at_.take({"more", "remaining"});
      if (is_stitches(at_.peek())) at_.skip();
      return;
    }
    if (next && is_stitches(at_.peek())) {
      node.plain = false;
      at_.skip();
      return;
    }
    at_.back_to(before);
    if (!node.plain && is_stitches(at_.peek())) at_.skip();
  }

  std::optional<WorldNode> bracket(int depth) {
    const std::string_view close = at_.sees({"("}) ? ")" : "]";
    if (depth > most_depth) {
      fail("brackets stand more than " + std::to_string(most_depth) + " deep.");
      return std::nullopt;
    }
    const std::size_t begin = at_.peek().at;
    at_.skip();
    Nodes inside = sequence(close, depth);
    if (failed()) return std::nullopt;
    if (!at_.take({close})) {
      fail("a bracket is not closed.");
      return std::nullopt;
    }
    WorldNode node = group(std::move(inside));
    node.at = begin;
    node.length = at_.behind() - begin;
    if (at_.one_stitch()) {  // "(k1, yo, k1) in next st"
      const auto made = made_of(node.inside);
      if (!made) {
        fail("what is worked into one stitch is not clear.");
        return std::nullopt;
      }
      WorldNode one;
      one.takes = 1;
      one.makes = *made;
      one.at = node.at;
      one.length = node.length;
      node = std::move(one);
    }
    const std::size_t before = at_.at();
    while (at_.take({","})) {
    }
    const bool rep = at_.sees({"rep", "repeat"}) && !at_.sees({"from", "*", "between"}, 1);
    if (rep)
      at_.skip();
    else
      at_.back_to(before);
    if (const auto words = at_.repeat_words()) {
      if (node.kind == Kind::stitch && words->times == 1 && words->until == Until::times) return node;
      apply(node, *words);
    } else if (rep) {
      at_.back_to(before);
    }
    return positive(std::move(node));
  }

  static std::optional<std::int64_t> made_of(const Nodes& nodes) {
    std::int64_t made = 0;
    for (const WorldNode& node : nodes) {
      if (node.kind != Kind::stitch || is_open(node)) return std::nullopt;
      made = std::min(most_value, made + node.makes * node.times);
    }
    return made;
  }

  PhraseCursor at_;
  bool other_;
  bool choice_ = false;
  WorldRound round_;
};

}  // namespace

WorldRound world_round(std::span<const Atom> line, const Lexicon& lexicon, bool other) {
  return RoundParser(line, lexicon, other).run();
}

}  // namespace knit
