// Patterns with limbs in which one thing is wrong: each is refused, in the line where it can be told, or means the same.
#include <regex>
#include <set>
#include <sstream>

#include "knit/mesh/shapes.h"
#include "knit/model/stitch_size.h"
#include "knit/pattern/written_pattern.h"
#include "knit/reader/limbs_reader.h"
#include "knit/run/timeline.h"
#include "tests/support/bodies.h"
#include "tests/support/catch.h"
#include "tests/support/limb_hands.h"
#include "tests/support/random_fabric.h"
#include "tests/support/repeated.h"
#include "tests/support/ringed_fabric.h"
#include "tests/support/standing_run.h"

using namespace knit;

namespace {

using Lines = std::vector<std::string>;

struct Mutant {
  std::size_t line = 0;  // from 0
  std::string text;      // instead of it; empty: dropped
};

Lines lines_in(const std::string& text) {
  Lines lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// Numbers of lines that prove something: between INSTRUCTIONS and FINISHING, remarks apart.
std::vector<std::size_t> proving(const Lines& lines) {
  std::vector<std::size_t> found;
  bool inside = false;
  int depth = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i] == "INSTRUCTIONS") inside = true;
    if (lines[i] == "FINISHING") inside = false;
    if (!inside || lines[i].empty() || lines[i] == "INSTRUCTIONS") continue;
    const bool remark = depth > 0 || lines[i].front() == '(';
    if (remark) {
      depth += static_cast<int>(std::count(lines[i].begin(), lines[i].end(), '(') -
                                std::count(lines[i].begin(), lines[i].end(), ')'));
    } else {
      found.push_back(i);
    }
  }
  return found;
}

void change_numbers(const std::string& line, std::size_t at, std::vector<Mutant>& mutants) {
  const std::regex number("(^|[^mk0-9])([0-9]+)");  // not of m1l and k2tog
  for (auto found = std::sregex_iterator(line.begin(), line.end(), number); found != std::sregex_iterator();
       ++found) {
    const auto begin = static_cast<std::size_t>(found->position(2)),
               size = static_cast<std::size_t>(found->length(2));
    const long value = std::stol(found->str(2));
    for (const long changed : {value - 1, value + 1}) {
      if (changed >= 0)
        mutants.push_back({at, line.substr(0, begin) + std::to_string(changed) + line.substr(begin + size)});
    }
  }
}

void change_names(const std::string& line, std::size_t at, const std::set<std::string>& names,
                  std::vector<Mutant>& mutants) {
  const std::regex name("\\b[A-Z][a-z]+ [A-Z]\\b");
  for (auto found = std::sregex_iterator(line.begin(), line.end(), name); found != std::sregex_iterator();
       ++found) {
    const auto begin = static_cast<std::size_t>(found->position()),
               size = static_cast<std::size_t>(found->length());
    for (const std::string& other : names) {
      if (other != found->str())
        mutants.push_back({at, line.substr(0, begin) + other + line.substr(begin + size)});
    }
  }
}

void drop_words(const std::string& line, std::size_t at, std::vector<Mutant>& mutants) {
  for (const char* words : {"Slip last st back, ", ", marker moved back 1 st", "slip last st back, "}) {
    const std::size_t begin = line.find(words);
    if (begin != std::string::npos)
      mutants.push_back({at, std::string(line).erase(begin, std::string(words).size())});
  }
  const std::regex item("(keep|CO|pick up) [0-9]+ sts?( (over|along) gap [0-9]+)?, ");
  for (auto found = std::sregex_iterator(line.begin(), line.end(), item); found != std::sregex_iterator();
       ++found)
    mutants.push_back({at, std::string(line).erase(static_cast<std::size_t>(found->position()),
                                                   static_cast<std::size_t>(found->length()))});
}

std::vector<Mutant> mutants_of(const Lines& lines) {
  std::set<std::string> names{"Limb Z"};
  const std::regex heading("^([A-Z][a-z]+ [A-Z]): [0-9]+ rnd");
  std::smatch match;
  for (const std::string& line : lines) {
    if (std::regex_search(line, match, heading)) names.insert(match[1]);
  }
  std::vector<Mutant> mutants;
  for (const std::size_t at : proving(lines)) {
    change_numbers(lines[at], at, mutants);
    change_names(lines[at], at, names, mutants);
    drop_words(lines[at], at, mutants);
    mutants.push_back({at, ""});
  }
  return mutants;
}

std::size_t check_mutants(const State& state, const LimbOptions& options = {}) {
  const std::string text =
      pattern_as_text(write_pattern(plan_limbs(state, options), {22.0, 32.0}, {}, "shape"));
  const ReadLimbs sound = read_limbs(text);
  REQUIRE(sound.mistakes.empty());
  const Lines lines = lines_in(text);
  const std::vector<Mutant> mutants = mutants_of(lines);
  for (std::size_t i = 0; i < mutants.size(); i += test_support::whole() ? 1 : 10) {
    const Mutant& mutant = mutants[i];
    Lines changed = lines;
    changed[mutant.line] = mutant.text;
    std::string whole;
    for (const std::string& line : changed) whole += line + "\n";
    const ReadLimbs read = read_limbs(whole);
    if (read.mistakes.empty() && test_support::same_graph(read, sound)) continue;  // another twin's rounds
    CAPTURE(lines[mutant.line], mutant.text);
    if (read.mistakes.size() != 1) {
      FAIL_CHECK("the mutant is not refused");
    } else {
      const PatternMistake& mistake = read.mistakes.front();
      if (mistake.line == 0 || mistake.sentence.find("line " + std::to_string(mistake.line) + ": ") != 0)
        FAIL_CHECK("the mistake has no line");
    }
  }
  return mutants.size();
}

Mesh standing_torus() {
  Mesh mesh = torus(32, 16, 1.0, 0.4);
  for (glm::dvec3& p : mesh.positions) p = {p.x, -p.z, p.y};
  return mesh;
}

std::string mistake_in(const std::string& text) {
  const ReadLimbs read = read_limbs(text);
  return read.mistakes.empty() ? "" : read.mistakes.front().sentence;
}

const std::string two_legs = R"(Legs A and B (make 2): 2 rnds, 8 sts at the end
Rnd 1: CO 6 sts. Join in the round, place marker. (6 sts)
Rnd 2: [K3, m1l] 2 times. (8 sts)
(Stuff each before it is joined.)
Leg A: Break yarn. Place 8 sts on a holder.
Leg B: Do not break yarn. Go on with Body C.

Body C: 1 rnd, 20 sts at the end
Join with Leg A: keep 3 sts, CO 2 sts over gap 1, 8 sts of Leg A (5 to 4), pick up 2 sts along gap 1, keep 5 sts. (20 sts)
Rnd 1: Knit. (20 sts)
BO all 20 sts. Fasten off.
)";

std::string with(const std::string& from, const std::string& to) {
  std::string text = two_legs;
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("limbs mutants: one wrong number, name or line is refused") {
  std::size_t mutants = check_mutants(test_support::standing_run(standing_torus(), 0.05));
  mutants += check_mutants(test_support::standing_run(torus(48, 24, 1.0, 0.4), 0.06));
  mutants += check_mutants(test_support::standing_run(test_support::arch(), 0.06));
  CHECK(mutants > 700);
}

TEST_CASE("limbs mutants: fabrics of no shape") {
  std::size_t mutants = 0;
  for (unsigned seed = 0; seed < 12; ++seed) {
    CAPTURE(seed);
    const State state = test_support::RandomFabric(seed).run(4);
    if (has_limbs(state)) mutants += check_mutants(state);
  }
  CHECK(mutants > 800);
}

TEST_CASE("limbs mutants: rims that are bound off together") {
  LimbOptions three;
  three.three_needle = true;
  std::size_t mutants = 0;
  for (unsigned seed = 0; seed < 60 && mutants < 400; ++seed) {
    CAPTURE(seed);
    State state = test_support::RingedFabric(seed).of(test_support::RandomFabric(seed).run(2));
    if (!has_limbs(state)) continue;
    state.work = Finished{};
    const LimbPlan plan = plan_limbs(state, three);
    const bool together = std::any_of(plan.pieces.begin(), plan.pieces.end(),
                                      [](const LimbPiece& piece) { return piece.end.three_needle; });
    if (together) mutants += check_mutants(state, three);
  }
  CHECK(mutants >= 400);
}

TEST_CASE("limbs reader: a pattern written by hand is read without a title") {
  const ReadLimbs read = read_limbs(two_legs);
  REQUIRE(read.mistakes.empty());
  REQUIRE(read.limbs.size() == 3);
  CHECK(read.limbs[0].name == "Leg A");
  CHECK(read.limbs[1].rows.size() == 2);
  CHECK(read.limbs[2].live.size() == 20);
  CHECK(read.gaps == std::vector<std::vector<std::int32_t>>{{28, 29}});
  // From the marker: three of leg B, the gap, leg A from its fifth stitch on, the gap backwards, the rest of leg B.
  const std::vector<std::int32_t> live{20, 21, 22, 28, 29, 10, 11, 12, 13, 6,
                                       7,  8,  9,  29, 28, 23, 24, 25, 26, 27};
  CHECK(read.limbs[2].live == live);
  CHECK(read_pattern(two_legs).mistakes.empty());
  CHECK(read_pattern(two_legs).rounds.cast_on == 12);
}

TEST_CASE("limbs reader: what is wrong is said with its line") {
  CHECK(mistake_in(with("(20 sts)\nRnd", "(21 sts)\nRnd")) == "line 9: 20 sts come out, the line says 21.");
  CHECK(mistake_in(with("[K3, m1l] 2 times", "K3, m1l, K3")) ==
        "line 3: Rnd 2 makes 7 sts, the line says 8.");
  CHECK(mistake_in(with("Rnd 2: [", "Rnd 3: [")) == "line 3: Rnd 2 is next, the line says 3.");
  CHECK(mistake_in(with("Join with Leg A", "Join with Leg Z")) == "line 9: there is no piece Leg Z.");
  CHECK(mistake_in(with("Go on with Body C", "Go on with Body D")) == "line 6: there is no piece Body D.");
  CHECK(mistake_in(with("(make 2)", "(make 3)")) == "line 1: 2 names, but make 3.");
  CHECK(mistake_in(with("2 rnds, 8 sts", "2 rnds, 9 sts")) ==
        "line 5: Leg A ends with 8 sts, its heading says 9.");
  CHECK(mistake_in(with("CO 2 sts over gap 1, ", "")) == "line 9: gap 1 was not cast on.");
  CHECK(mistake_in(with("pick up 2 sts along gap 1, ", "")) ==
        "line 9: gap 1 is cast on, not picked up on the way back.");
  CHECK(mistake_in(with("pick up 2 sts", "pick up 3 sts")) ==
        "line 9: gap 1 has 2 sts to pick up, the line says 3.");
  CHECK(mistake_in(with("(5 to 4)", "(5 to 3)")) == "line 9: 5 to 3 of 8 sts are not 8 sts.");
  CHECK(
      mistake_in(with("8 sts of Leg A (5 to 4), pick up 2 sts along gap 1",
                      "6 sts of Leg A (5 to 2), pick up 2 sts along gap 1, 2 sts of Leg A (3 to 4)")) ==
      "line 9: 6 of the 8 sts of Leg A stand between the cast on and the pick up of gap 1: all or none can.");
  CHECK(mistake_in(with("CO 2 sts over gap 1, 8 sts of Leg A (5 to 4)",
                        "8 sts of Leg A (5 to 4), CO 2 sts over gap 1")) ==
        "line 9: nothing stands between the cast on and the pick up of gap 1.");
  CHECK(mistake_in(with("8 sts of Leg A (5 to 4), pick up", "8 sts of Leg A (5 to 4), keep 1 st, pick up")) ==
        "line 9: sts are kept between the cast on and the pick up of gap 1.");
  CHECK(mistake_in(with("keep 3 sts", "keep 2 sts")) == "line 9: 7 of 8 sts on the needle are used.");
  CHECK(mistake_in(with("Leg A: Break yarn. Place 8 sts on a holder.\n", "")) ==
        "line 5: Leg A has no end: its sts are neither held, bound off, grafted nor worked on.");
  CHECK(mistake_in(with("BO all 20 sts. Fasten off.", "Break yarn. Place 20 sts on a holder.")) ==
        "line 11: 20 sts are left on the holder of Body C.");
  CHECK(mistake_in(with("Rnd 1: Knit.", "Purl it.\nRnd 1: Knit.")) ==
        "line 10: not understood: \"Purl it.\".");
  CHECK(mistake_in(with("Join with Leg A: ", "Rejoin yarn: ")) ==
        "line 9: 8 sts of Leg B are still on the needle: hold them or bind them off first.");
}
