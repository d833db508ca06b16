#include "knit/trade/world_lines.h"

#include <algorithm>
#include <array>

#include "knit/trade/world_phrases.h"

namespace knit {

namespace {

bool is_ordinal_end(const Atom& atom) { return is_any(atom, {"st", "nd", "rd", "th"}); }

std::optional<std::int64_t> ordinal(const Atom& atom) {
  constexpr std::array<std::string_view, 12> words{"first", "second", "third",    "fourth",
                                                   "fifth", "sixth",  "seventh",  "eighth",
                                                   "ninth", "tenth",  "eleventh", "twelfth"};
  const auto* const found = std::find(words.begin(), words.end(), atom.text);
  if (found == words.end()) return std::nullopt;
  return found - words.begin() + 1;
}

class LabelReader {
 public:
  LabelReader(std::span<const Atom> line, const Lexicon& lexicon)
      : at_(line, lexicon), lexicon_(lexicon), line_(line) {}

  std::optional<WorldLabel> run() {
    if (rule() || rounds_first() || ordinal_first() || number_alone() || named()) {
      label_.atoms = at_.at();
      return std::move(label_);
    }
    return std::nullopt;
  }

 private:
  bool restart() {
    at_.back_to(0);
    label_ = {};
    return false;
  }

  bool round_word() {
    if (!is_rounds(at_.peek())) return false;
    label_.rows = at_.sees({"row", "rows"});
    at_.skip();
    return true;
  }

  // "3", "3-5", "3, 5 and 7", "3rd"
  bool numbers() {
    if (!number_here()) return false;
    for (;;) {
      const std::size_t before = at_.at();
      bool between = false;
      while (at_.take({",", "and", "&", "+"})) between = true;
      if (!between || !number_here()) {
        at_.back_to(before);
        return true;
      }
    }
  }
  bool number_here() {
    std::optional<std::int64_t> first;
    if (at_.peek().is_number())
      first = at_.peek().value;
    else
      first = ordinal(at_.peek());
    if (!first) return false;
    at_.skip();
    if (is_ordinal_end(at_.peek()) && at_.peek().glued) at_.skip();
    std::int64_t last = *first;
    if (at_.sees({"-", "to", "through", "thru"}) && at_.peek(1).is_number() && !at_.sees({"x", "times"}, 2)) {
      last = at_.peek(1).value;
      at_.skip(2);
      if (is_ordinal_end(at_.peek()) && at_.peek().glued) at_.skip();
    }
    if (last < *first || (!label_.numbers.empty() && *first <= label_.numbers.back().second))
      label_.trouble = ": the round numbers run backwards.";
    if (!label_.numbers.empty() && *first == label_.numbers.back().second + 1)  // "15 & 16" is "15-16"
      label_.numbers.back().second = std::max(last, *first);
    else
      label_.numbers.emplace_back(*first, std::max(last, *first));
    return true;
  }

  // "(RS)", "(dec)", "(5 rnds)"
  void remarks() {
    while (at_.sees({"(", "["})) {
      const std::size_t before = at_.at();
      at_.skip();
      if (every()) {
        if (at_.take({")", "]"})) continue;
        at_.back_to(before);
        return;
      }
      label_.sided = label_.sided || at_.sees({"rs", "ws", "right", "wrong"});
      std::int64_t told = 0;
      if (at_.peek().is_number() && is_rounds(at_.peek(1))) told = at_.peek().value;
      while (!at_.done() && !at_.sees({")", "]"})) at_.skip();
      at_.take({")", "]"});
      if (!at_.sees({":", "-", "(", "[", ".", "="})) {
        // a remark is short and says no work: "Rnd 1 (RS) k5"
        const std::size_t end = at_.at();
        at_.back_to(before + 1);
        const bool work = at_.match().has_value() && !at_.sees({"inc", "dec", "increase", "decrease"});
        if (work || at_.peek().is_number()) {
          at_.back_to(before);
          return;
        }
        at_.back_to(end);
      }
      if (told > 0 && label_.trouble.empty() && told != rounds_told())
        label_.trouble = ": the label says " + std::to_string(told) + (told == 1 ? " round" : " rounds") +
                         " and names " + std::to_string(rounds_told()) + ".";
    }
  }
  [[nodiscard]] std::int64_t rounds_told() const {
    std::int64_t rounds = 0;
    for (const auto& [first, last] : label_.numbers) rounds += last - first + 1;
    return rounds;
  }

  // "and every alternate rnd", "and all even rnds", "and every following 4th row"
  bool every() {
    const std::size_t before = at_.at();
    at_.take({"and", "&"});
    if (!at_.take({"every", "all", "each"}) || label_.numbers.empty()) {
      at_.back_to(before);
      return false;
    }
    std::int64_t step = 0;
    for (;;) {
      if (at_.take({"even", "odd", "alternate", "alt", "other", "ws", "rs"})) {
        step = 2;
      } else if (at_.peek().is_number() && is_ordinal_end(at_.peek(1))) {
        step = at_.peek().value;
        at_.skip(2);
      } else if (!at_.take({"following", "foll", "numbered", "-", "of"})) {
        break;
      }
    }
    if (!is_rounds(at_.peek()) || step < 1) {
      at_.back_to(before);
      return false;
    }
    at_.skip();
    at_.take({"thereafter", "after"});
    label_.every_from = label_.numbers.back().second;
    label_.every_step = step;
    return true;
  }

  bool colon() {
    if (at_.take({":"})) {
      at_.take({"-"});
      return true;
    }
    if (at_.sees({".", "-", "=", ")"}) && !at_.peek(1).text.empty()) {
      at_.skip();
      return true;
    }
    return false;
  }

  // "All even rounds:", "Even rnds:", "Every other rnd:"
  bool rule() {
    at_.take({"on", "work"});
    at_.take({"all", "every", "rem", "remaining"});
    const bool odd = at_.sees({"odd"});
    if (!at_.take({"even", "odd"}) && !(at_.at() > 0 && at_.take({"other", "alternate", "alt", "ws"})))
      return restart();
    at_.take({"-"});
    at_.take({"numbered"});
    if (!round_word()) return restart();
    remarks();
    if (!colon() && !at_.take({","}) && !at_.match()) return restart();
    label_.every_from = odd ? 1 : 2;
    return true;
  }

  bool rounds_first() {
    if (at_.sees({"r", "rn"}) && at_.peek(1).is_number() && at_.peek(1).glued)
      at_.skip();
    else if (!round_word())
      return restart();
    at_.take({"."});
    if (at_.take({"no", "nr", "number", "#"})) at_.take({"."});
    if (!numbers()) {
      if (at_.at() > 0 && at_.take({":"})) {
        label_.name = "rnd";
        return true;
      }
      return restart();
    }
    every();
    remarks();
    if (at_.take({"only"})) {
    }
    every();
    if (colon()) {
      remarks_behind();
      return true;
    }
    // without a colon only what begins as work is a round
    if (at_.done() || at_.sees({"and", "to", "is", "of", "from", "more", "are", "in", ",", "for", "as"}))
      return restart();
    const bool work =
        at_.match() ||
        at_.sees({"(", "[", "*", "work", "co", "cast", "bo", "bind", "rep", "repeat", "place", "sm", "pm"}) ||
        at_.peek().is_number();
    if (!work) return restart();
    return true;
  }
  // "Rnd 1: (RS) k5"
  void remarks_behind() {
    if (at_.sees({"("}) && at_.sees({"rs", "ws"}, 1) && at_.sees({")"}, 2)) {
      label_.sided = true;
      at_.skip(3);
    }
  }

  // "2nd rnd:", "1st and 3rd rows:", "Second round:"
  bool ordinal_first() {
    at_.take({"on"});
    const bool first =
        ordinal(at_.peek()).has_value() || (at_.peek().is_number() && is_ordinal_end(at_.peek(1)));
    if (!first || !numbers()) return restart();
    if (at_.sees({"and"}) && at_.sees({"every", "all", "each"}, 1)) {
      if (!every()) return restart();
    } else if (!round_word()) {
      return restart();
    } else {
      every();
    }
    remarks();
    if (!colon() && !at_.match() && !at_.take({","})) return restart();
    return true;
  }

  // "7.", "7:", "7)"
  bool number_alone() {
    const bool range = at_.sees({"-"}, 1) && at_.peek(2).is_number() && at_.sees({".", ":"}, 3);
    if (!at_.peek().is_number() || !(range || at_.sees({".", ":", ")"}, 1)) || !at_.peek(1).glued)
      return restart();
    if (!range && at_.peek(2).is_number() && at_.peek(2).glued) return restart();  // 7.5 mm
    numbers();
    if (!at_.take({".", ":", ")"})) return restart();
    if (at_.done()) return restart();
    label_.bare_number = true;
    const bool work = at_.match() || at_.sees({"(", "[", "*", "co", "rep", "repeat"}) ||
                      (at_.peek().is_number() && at_.sees({"x"}, 1)) ||
                      looks_like_work(line_.subspan(at_.at()), lexicon_);
    if (!work) return restart();
    return true;
  }

  // "Dec rnd:", "Next round (decrease):", "Set-up rnd:", "Next 3 rnds:", "Inc rnd A:"
  bool named() {
    constexpr std::size_t most_words = 6;
    std::string name;
    std::size_t words = 0;
    while (!at_.done() && words < most_words && !is_rounds(at_.peek())) {
      if (at_.peek().is_number()) {
        label_.rounds = at_.peek().value;
        if (!is_rounds(at_.peek(1)) || words == 0 || label_.rounds < 1) return restart();
      } else if (at_.peek().is_word()) {
        if (at_.sees({"rep", "repeat", "until", "for", "k", "knit", "p", "purl", "work", "every"}))
          return restart();
        name += (name.empty() ? "" : " ") + at_.peek().text;
      } else if (!at_.sees({"-", "/"})) {
        return restart();
      }
      at_.skip();
      ++words;
    }
    if (words == 0 || !round_word()) return restart();
    name += " rnd";
    if (at_.peek().is_word() && at_.peek().length == 1 && at_.sees({":"}, 1)) {
      name += " " + at_.peek().text;
      at_.skip();
    }
    remarks();
    if (at_.take({":"}) || (at_.sees({"-", "=", "."}) && (at_.match(1) || at_.sees({"(", "[", "*"}, 1)) &&
                            at_.take({"-", "=", "."}))) {
      label_.name = name;
      remarks_behind();
      return true;
    }
    // "Next rnd k2tog around"
    const bool next = name.starts_with("next ") || name.starts_with("dec") || name.starts_with("inc") ||
                      name.starts_with("set");
    if (next && (at_.match() || at_.sees({"(", "[", "*", "work"}) || at_.take({","}))) {
      label_.name = name;
      return true;
    }
    return restart();
  }

  PhraseCursor at_;
  const Lexicon& lexicon_;
  std::span<const Atom> line_;
  WorldLabel label_;
};

// "(make 2)": how often the piece is made. Leaves `at` on the closing bracket; false: its number is none of pieces.
bool read_made(std::span<const Atom> line, std::size_t& at, WorldTitle& title) {
  const std::size_t open = at;
  std::size_t end = open + 1;
  for (; end < line.size() && !line[end].is(")"); ++end) {
    if (!line[end].is_number()) continue;
    if (holds_any(line.subspan(open, end - open + 1), {"make", "both", "work", "knit", "x"}))
      title.made = line[end].value;
    if (!holds_any(line.subspan(open), {"make", "x", "work", "knit", "of"})) return false;
  }
  if (holds_any(line.subspan(open, end - open), {"twice"})) title.made = 2;
  at = end;
  return true;
}

// Words that no title has: of stitches and rounds, but for those that may name a piece too, beside another.
bool is_work_word(std::span<const Atom> line, std::size_t at, const Lexicon& lexicon) {
  if (is_stitches(line[at]) || is_rounds(line[at])) return true;
  const bool names_too =
      line.size() > 1 && is_any(line[at], {"slip", "knit", "purl", "increase", "decrease"});
  return !names_too && lexicon.match(line, at);
}

// What a line of work begins with, and a title does not.
bool is_order(const Atom& atom) {
  return is_any(
      atom,
      {"k",     "p",   "knit",  "purl",   "work",  "co",     "bo",       "cast",   "bind", "join", "repeat",
       "rep",   "cut", "break", "fasten", "turn",  "place",  "continue", "slip",   "sl",   "pick", "stuff",
       "graft", "sew", "weave", "put",    "leave", "return", "transfer", "thread", "draw", "pull", "make"});
}

// "as rnd 3", "same as rnd 3", "work as for round 3": a round that is told by another.
bool is_like_round(std::span<const Atom> line) {
  constexpr std::size_t most_words = 5;
  if (line.empty() || !is_any(line[0], {"as", "like", "same", "work", "rep", "repeat"})) return false;
  const bool says_as = is_any(line[0], {"rep", "repeat"}) ||
                       holds_any(line.first(std::min<std::size_t>(line.size(), 2)), {"as", "like"});
  for (std::size_t i = 1; says_as && i + 1 < std::min(line.size(), most_words); ++i) {
    if (is_rounds(line[i]) && line[i + 1].is_number()) return true;
  }
  return false;
}

// MATERIALS, NOTES: a section that tells about the pattern.
bool tells_about(std::span<const Atom> line) {
  return holds_any(line, {"materials",  "gauge",    "tension", "abbreviations", "notes",     "note",
                          "finished",   "size",     "sizes",   "needles",       "yarn",      "chart",
                          "finishing",  "assembly", "key",     "measurements",  "skills",    "supplies",
                          "techniques", "stitches", "making",  "level",         "equipment", "glossary"});
}

}  // namespace

std::optional<WorldLabel> world_label(std::span<const Atom> line, const Lexicon& lexicon) {
  return LabelReader(line, lexicon).run();
}

std::optional<WorldTitle> world_title(std::span<const Atom> line, const Lexicon& lexicon) {
  constexpr std::size_t most_words = 6;
  WorldTitle title;
  std::size_t words = 0;
  bool strange = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i].is("(")) {
      if (!read_made(line, i, title)) return std::nullopt;
    } else if (is_any(line[i], {"-", ":", "/", "=", "#", "_", "'", "&"})) {
      continue;
    } else if (line[i].is("make") && i + 1 < line.size() && line[i + 1].is_number()) {
      title.made = line[i + 1].value;
      ++i;
    } else if (!line[i].is_word()) {
      strange = true;
    } else if (is_work_word(line, i, lexicon)) {
      return std::nullopt;
    } else {
      title.name += (title.name.empty() ? "" : " ") + line[i].text;
      ++words;
    }
  }
  if (strange || words == 0 || words > most_words || title.made < 1 || is_order(line[0])) return std::nullopt;
  title.tells = tells_about(line);
  return title;
}

bool is_word_list(std::span<const Atom> line, const Lexicon& lexicon) {
  constexpr std::size_t farthest = 12;
  for (std::size_t i = 1; i < std::min(line.size(), farthest); ++i) {
    if (!is_any(line[i], {":", "=", "-"})) continue;
    const bool symbol =
        line[0].text.size() == 1 && lexicon.match(line, 1);  // "L  m1l: make 1 left", of a chart
    const bool abbreviation =
        symbol || lexicon.match(line, 0) ||
        is_any(line[0], {"co",  "bo",   "rnd",  "rnds", "st",     "sts",  "pm",   "sm",  "m",    "rep",
                         "rs",  "ws",   "tog",  "beg",  "rem",    "mc",   "cc",   "dpn", "dpns", "w",
                         "est", "patt", "psso", "tbl",  "approx", "cont", "foll", "alt", "bor"});
    if (!abbreviation) return false;
    // "K5 - 5 sts" is work
    const bool explains = i + 1 < line.size() && line[i + 1].is_word() &&
                          !(line[i].is("-") && line[i].glued && line[i + 1].glued);
    const bool figures =
        std::any_of(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(i), [](const Atom& a) {
          return is_any(a, {",", "[", "*"});
        });
    return explains && !figures;
  }
  for (std::size_t i = 0; i + 1 < line.size() && i < 4; ++i) {  // "CO cast on", "K knit"
    if (i == 1 && is_any(line[0], {"co", "bo"}) && is_any(line[1], {"cast", "bind"})) return true;
  }
  return false;
}

bool looks_like_work(std::span<const Atom> line, const Lexicon& lexicon) {
  if (line.empty()) return false;
  if (is_like_round(line)) return true;
  bool figures = false, words = false, count = false;
  const bool order =
      is_any(line[0], {"k",    "p",    "knit",     "purl",     "work", "rep",  "repeat", "continue",
                       "inc",  "dec",  "increase", "decrease", "slip", "sl",   "bind",   "cast",
                       "co",   "bo",   "pick",     "[",        "*",    "rnd",  "row",    "round",
                       "rnds", "rows", "rounds",   "next",     "all",  "every"});
  bool rounds = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    rounds = rounds || is_rounds(line[i]);
    const bool next_number = i + 1 < line.size() && line[i + 1].is_number();
    if (is_any(line[i], {"k", "p"}) && next_number && (line[i + 1].glued || i == 0)) figures = true;
    if (is_any(line[i], {"(", "["}) && i + 2 < line.size() && line[i + 1].is_number() &&
        (is_stitches(line[i + 2]) || is_any(line[i + 2], {")", "]"})) && i > 0)
      count = true;
    const auto word = lexicon.match(line, i);
    if (!word) continue;
    const bool plain_word =
        word->atoms < 2 && is_any(line[i], {"k", "knit", "p", "purl", "slip", "sl", "increase", "decrease",
                                            "inc", "dec", "bobble", "make", "yarn"});
    if (!plain_word) words = true;
    i += word->atoms - 1;
  }
  if (figures || words) return true;
  if (line[0].is("work") && line.size() > 1 && is_any(line[1], {"even", "straight", "in"})) return true;
  return order &&
         (rounds || count ||
          holds_any(line, {"end", "around", "times", "twice", "sts", "st", "stitches", "knit", "purl"}));
}

std::size_t crochet_words(std::span<const Atom> line) {
  std::size_t found = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (is_any(line[i], {"sc", "hdc", "dc", "tr", "slst", "invdec", "inv", "ss"})) ++found;
    if (line[i].is("ch") && i + 1 < line.size() && (line[i + 1].is_number() || line[i + 1].is("sp"))) ++found;
    if (line[i].is("sl") && i + 1 < line.size() && line[i + 1].is("st"))
      found += holds_any(line, {"ch", "sc", "dc"}) ? 1 : 0;
    if (is_any(line[i], {"crochet", "crocheted"})) ++found;
    if (line[i].is("magic") && i + 1 < line.size() && is_any(line[i + 1], {"ring", "circle"})) ++found;
  }
  return found;
}

}  // namespace knit
