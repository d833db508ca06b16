// Thirty mutants of the pattern of every example: one number, word, letter or line is changed, and the reader refuses each.
//
// Where: reading goes from the top, so never above the changed line, and
//   a round            there, or at the next line that proves something (a last number too low or too high, lines exchanged);
//   a heading          by the end of its piece: what it says of rounds and stitches is held against them when they are worked;
//   a deal, an end     where the holder, gap or needle that it says too much or too little of is next asked for, which may be last.
// A step that is told one item a line is one line, and goes by its first. A piece whose end is missing is named with the last line
// that it has, a piece whose heading is missing where it is first spoken of. A mutant that leads to the same graph is no mistake:
// the rounds of another twin are named, or a single tube does not say how it ends. Two shapings exchanged that count alike, k2tog
// for ssk, are another pattern, so none is made of them.
#include <algorithm>
#include <functional>
#include <random>
#include <regex>
#include <set>
#include <sstream>

#include "knit/mesh/branching_shapes.h"
#include "knit/mesh/shapes.h"
#include "knit/model/stitch_size.h"
#include "knit/pattern/written_pattern.h"
#include "knit/reader/limbs_reader.h"
#include "knit/reader/pattern_reader.h"
#include "knit/run/timeline.h"
#include "tests/support/catch.h"
#include "tests/support/limb_hands.h"
#include "tests/support/repeated.h"
#include "tests/support/standing_run.h"

using namespace knit;

namespace {

using TextLines = std::vector<std::string>;

TextLines lines_from(const std::string& text) {
  TextLines lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::string text_from(const TextLines& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

struct ProvingLines {
  std::vector<std::size_t> lines;  // that prove something, from 0
  std::vector<std::size_t> heads;  // of those the ones that begin a sentence
  [[nodiscard]] std::size_t head(std::size_t line) const {
    return *std::prev(std::upper_bound(heads.begin(), heads.end(), line));
  }
  [[nodiscard]] std::size_t head_before(std::size_t line) const {
    const auto here = std::lower_bound(heads.begin(), heads.end(), head(line));
    return here == heads.begin() ? *here : *std::prev(here);
  }
  [[nodiscard]] std::size_t next(std::size_t line) const {
    const auto after = std::upper_bound(heads.begin(), heads.end(), line);
    return after == heads.end() ? lines.back() : *after;
  }
};

bool is_heading_line(const std::string& line) {
  return std::regex_search(line, std::regex("^[A-Z][a-z]+ .*: [0-9]+ rnds?, [0-9]+ sts? at the end"));
}
bool is_round_line(const std::string& line) { return line.rfind("Rnd", 0) == 0; }
bool is_close_line(const std::string& line) { return line.rfind("Break yarn, thread", 0) == 0; }

// Between INSTRUCTIONS and FINISHING, remarks in brackets apart. Of one tube the rounds, the cast on and the close.
ProvingLines proof_of(const TextLines& lines, bool limbs) {
  ProvingLines proof;
  bool inside = false;
  int depth = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string& line = lines[i];
    inside = (inside || line == "INSTRUCTIONS") && line != "FINISHING";
    if (!inside || line.empty() || line == "INSTRUCTIONS") continue;
    if (depth > 0 || line.front() == '(') {
      depth += static_cast<int>(std::count(line.begin(), line.end(), '(') -
                                std::count(line.begin(), line.end(), ')'));
      continue;
    }
    if (!limbs && !is_round_line(line) && !is_close_line(line)) continue;
    proof.lines.push_back(i);
    if (line.front() != ' ') proof.heads.push_back(i);
  }
  return proof;
}

struct MutantText {
  TextLines lines;
  std::size_t first = 0;  // changed line, from 0
  std::string what;
};

class MutantMaker {
 public:
  MutantMaker(const TextLines& lines, const ProvingLines& proof) : lines_(lines), proof_(proof) {}

  // Every change of a kind.
  std::vector<MutantText> numbers() {
    return each(std::regex("(^|[^mk0-9])([0-9]+)"), [](const std::string& found) {
      const long value = std::stol(found);
      return std::vector<std::string>{std::to_string(value - 1), std::to_string(value + 1)};
    });
  }
  std::vector<MutantText> words() {
    const std::regex word(
        "()\\b(k2tog|ssk|m1l|m1r|Knit|times|Rnds?|keep|gap|holder|held|Place|Divide|Rejoin|Join|Break|Work|"
        "Graft)\\b");
    return each(word, [](std::string found) {
      std::swap(found[1], found[2]);
      return std::vector<std::string>{found};
    });
  }
  std::vector<MutantText> letters() {
    std::set<std::string> names{"Z"};
    for (const std::size_t at : proof_.lines) {
      std::smatch match;
      if (is_heading_line(lines_[at]) &&
          std::regex_search(lines_[at], match, std::regex("^[A-Z][a-z]+ ([A-Z]):")))
        names.insert(match[1]);
    }
    return each(std::regex("([A-Z][a-z]+ )([A-Z])\\b"), [&](const std::string& found) {
      std::vector<std::string> others(names.begin(), names.end());
      others.erase(std::remove(others.begin(), others.end(), found), others.end());
      return others;
    });
  }
  std::vector<MutantText> exchanged() {
    std::vector<MutantText> all;
    for (std::size_t i = 0; i + 1 < proof_.lines.size(); ++i) {
      const std::size_t a = proof_.lines[i], b = proof_.lines[i + 1];
      if (lines_[a] == lines_[b]) continue;
      MutantText change{lines_, a, "exchanged"};
      std::swap(change.lines[a], change.lines[b]);
      all.push_back(std::move(change));
    }
    return all;
  }
  std::vector<MutantText> missing() {
    std::vector<MutantText> all;
    for (const std::size_t at : proof_.lines) {
      all.push_back({lines_, at, "missing"});
      all.back().lines[at].clear();
    }
    return all;
  }

 private:
  // What stands in the second group of `found`, one at a time, gives way to each of what is put for it.
  std::vector<MutantText> each(const std::regex& found,
                               const std::function<std::vector<std::string>(const std::string&)>& put) {
    std::vector<MutantText> all;
    for (const std::size_t at : proof_.lines) {
      const std::string& line = lines_[at];
      for (auto it = std::sregex_iterator(line.begin(), line.end(), found); it != std::sregex_iterator();
           ++it) {
        for (const std::string& other : put(it->str(2))) {
          MutantText change{lines_, at, it->str(2) + " -> " + other};
          change.lines[at].replace(static_cast<std::size_t>(it->position(2)),
                                   static_cast<std::size_t>(it->length(2)), other);
          all.push_back(std::move(change));
        }
      }
    }
    return all;
  }

  const TextLines& lines_;
  const ProvingLines& proof_;
};

// The last line, from 0, in which a change may be seen.
std::size_t seen_by(const TextLines& sound, const ProvingLines& proof, const MutantText& change) {
  const std::string& line = sound[proof.head(change.first)];
  if (is_round_line(line)) return proof.next(change.first);
  if (is_heading_line(line)) {
    std::size_t last = change.first;
    for (const std::size_t at : proof.lines) {
      if (at > change.first && is_heading_line(sound[at])) return proof.next(last);
      if (at > change.first) last = at;
    }
  }
  return sound.size();
}

struct MutantShape {
  const char* name;
  std::function<Mesh()> mesh;
  double width_share;
};

constexpr std::size_t wanted = 30;

struct MutantTally {
  std::size_t refused = 0, same = 0, there = 0, next = 0, later = 0;
};

MutantTally check_example(const MutantShape& example) {
  const State state = test_support::standing_run(example.mesh(), example.width_share);
  const bool limbs = has_limbs(state);
  const WrittenPattern words = limbs ? write_pattern(plan_limbs(state), {22.0, 32.0}, {}, example.name)
                                     : write_pattern(rounds_of(state), {22.0, 32.0}, {}, example.name);
  const std::string text = pattern_as_text(words);
  REQUIRE(read_pattern(text).mistakes.empty());
  const ReadLimbs graph = read_limbs(text);
  const KnitGraph rounds = graph_of(read_pattern(text).rounds);
  const TextLines sound = lines_from(text);
  const ProvingLines proof = proof_of(sound, limbs);
  MutantMaker changes(sound, proof);
  std::vector<std::vector<MutantText>> kinds{changes.numbers(), changes.words(), changes.exchanged(),
                                             changes.missing()};
  if (limbs) kinds.push_back(changes.letters());
  std::mt19937 random(18);
  MutantTally tally;
  for (std::size_t turn = 0; tally.refused < wanted && turn < 10 * wanted; ++turn) {
    const std::vector<MutantText>& kind = kinds[turn % kinds.size()];
    if (kind.empty()) continue;
    const MutantText& change = kind[random() % kind.size()];
    const std::string whole = text_from(change.lines);
    const ReadPattern read = read_pattern(whole);
    CAPTURE(example.name, change.what, change.first + 1, sound[change.first]);
    if (read.mistakes.empty()) {
      ++tally.same;
      if (limbs ? !test_support::same_graph(read_limbs(whole), graph) : !(graph_of(read.rounds) == rounds))
        FAIL_CHECK("the mutant is not refused");
      continue;
    }
    ++tally.refused;
    const std::size_t line = read.mistakes.front().line;
    CAPTURE(read.mistakes.front().sentence);
    const bool no_end = read.mistakes.front().sentence.find(" has no end: ") != std::string::npos;
    const std::size_t first = no_end ? proof.head_before(change.first) : proof.head(change.first);
    // The line that speaks of a piece may stand above its heading.
    const bool no_piece = change.what == std::string("missing") &&
                          read.mistakes.front().sentence.find("there is no piece ") != std::string::npos;
    if (line < first + 1 && !no_piece) FAIL_CHECK("refused above the change");
    if (line > seen_by(sound, proof, change) + 1) FAIL_CHECK("refused too late");
    tally.there += line == first + 1 ? 1 : 0;
    tally.next += line == proof.next(change.first) + 1 ? 1 : 0;
    tally.later += line > proof.next(change.first) + 1 ? 1 : 0;
  }
  if (std::getenv("KNIT_TALLY") != nullptr)
    WARN(example.name << " refused " << tally.refused << " same " << tally.same << " there " << tally.there
                      << " next " << tally.next << " later " << tally.later);
  return tally;
}

std::vector<MutantShape> examples() {
  return {{"trousers", [] { return trousers(0.08); }, 0.05},
          {"sphere", [] { return sphere(32, 17, false); }, 0.05},
          {"mug", [] { return mug(0.08); }, 0.05},
          {"thesis sphere", [] { return sphere(64, 33, false); }, 0.04},
          {"stretched sphere", [] { return stretched_sphere(64, 0.1); }, 0.05},
          {"egg", [] { return egg(64, 0.1); }, 0.05},
          {"capsule", [] { return capsule(64, 0.1); }, 0.05},
          {"cone", [] { return cone(64, 0.1); }, 0.05},
          {"vase", [] { return vase(64, 0.1); }, 0.05},
          {"torus", [] { return torus(48, 24, 1.0, 0.4); }, 0.04},
          {"y", [] { return letter_y(0.08); }, 0.04},
          {"starfish", [] { return starfish(0.08); }, 0.04},
          {"octopus", [] { return octopus(0.08); }, 0.04},
          {"cup", [] { return cup(0.08); }, 0.04},
          {"double torus", [] { return double_torus(0.08); }, 0.04},
          {"chain of three", [] { return chain_of_three(0.08); }, 0.04}};
}

}  // namespace

TEST_CASE("mutants: thirty of each example's pattern are refused, each in its line") {
  std::size_t done = 0;
  for (const MutantShape& example : examples()) {
    if (done == 3 && !test_support::whole()) break;
    CHECK(check_example(example).refused == wanted);
    ++done;
  }
}
