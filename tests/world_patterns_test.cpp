// The checker on patterns of the world's forms: what is right is never called wrong, and what is wrong is never said to hold. The
// patterns come from a generator with a count of its own (tests/support/world_model.h). KNIT_WHOLE tries ten thousand of each,
// an ordinary run a share. KNIT_TALLY tells the shares, and the first of what goes wrong.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "knit/reader/checked_pattern.h"
#include "tests/support/catch.h"
#include "tests/support/world_model.h"

using knit::CheckedLine;
using knit::CheckedPattern;
using knit::LineVerdict;
using knit::PatternVerdict;

namespace {

std::uint32_t many(std::uint32_t all) { return std::getenv("KNIT_WHOLE") != nullptr ? all : all / 25; }
bool is_told() { return std::getenv("KNIT_TALLY") != nullptr; }

// The lines that a verdict hangs on, each with its sentence.
std::string lines_with(const CheckedPattern& checked, LineVerdict verdict, const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  for (const knit::CheckedSize& size : checked.sizes) {
    for (const CheckedLine& line : size.lines) {
      if (line.verdict == verdict && line.number <= lines.size())
        return lines[line.number - 1] + " | " + line.sentence;
    }
  }
  return "(no line)";
}

struct WorldTally {
  std::size_t holds = 0, wrong = 0, not_understood = 0, told = 0;
  void take(PatternVerdict verdict) {
    (verdict == PatternVerdict::holds             ? holds
     : verdict == PatternVerdict::does_not_add_up ? wrong
                                                  : not_understood) += 1;
  }
  [[nodiscard]] std::string told_as() const {
    return "holds " + std::to_string(holds) + ", does not add up " + std::to_string(wrong) +
           ", not understood " + std::to_string(not_understood);
  }
};

}  // namespace

TEST_CASE("world: every pattern of the generator adds up by its own count, and each of its forms comes up") {
  std::map<std::string, int> forms;
  std::size_t unsound = 0;
  for (std::uint32_t seed = 0; seed < 4000; ++seed) {
    const world::Pattern pattern = world::make(seed);
    unsound += world::work(pattern).truth == world::Truth::right ? 0U : 1U;
    for (const std::string& form : world::say(pattern).forms) ++forms[form];
  }
  CHECK(unsound == 0);
  CHECK(world::all_forms().size() > 200);
  std::string rare;
  for (const std::string& form : world::all_forms()) {
    if (forms[form] < 2) rare += form + "\n";
  }
  CHECK(rare.empty());
  for (const char* other :
       {"text: capitals", "text: several rounds in a paragraph", "bullet: * ", "repeat times: ({u}) twice",
        "sizes: n (n, n)", "sizes: n[n, n]", "sizes: n (n:n)"})
    CHECK(forms[other] > 2);
}

TEST_CASE("world: the same seed gives the same text") {
  CHECK(world::say(world::make(7)).text == world::say(world::make(7)).text);
  CHECK(world::say(world::make(7)).text != world::say(world::make(8)).text);
}

TEST_CASE("world: no right pattern is said not to add up") {
  WorldTally tally;
  for (std::uint32_t seed = 0; seed < many(10000); ++seed) {
    const std::string text = world::say(world::make(seed)).text;
    const CheckedPattern checked = knit::check_pattern(text);
    tally.take(checked.verdict);
    if (checked.verdict != PatternVerdict::does_not_add_up) continue;
    if (++tally.told <= 5)
      UNSCOPED_INFO(seed << ": " << lines_with(checked, LineVerdict::does_not_add_up, text));
  }
  if (is_told()) WARN(tally.told_as());
  CHECK(tally.wrong == 0);
  // A form that nobody has heard of is no mistake, but the world's are to be read.
  CHECK(tally.not_understood * 100 <= 5 * (tally.holds + tally.wrong + tally.not_understood));
}

TEST_CASE("world: no pattern with one thing changed is said to hold when it does not") {
  WorldTally tally;
  std::map<std::string, std::size_t> kinds;
  world::Dice dice(21);
  for (std::uint32_t seed = 0, done = 0; done < many(10000); ++seed) {
    const world::Pattern pattern = world::make(seed);
    for (int turn = 0; turn < 6; ++turn) {
      const auto changed = world::change(pattern, dice);
      if (!changed || world::work(changed->pattern).truth != world::Truth::wrong) continue;
      ++done;
      ++kinds[changed->what];
      const std::string text = world::say(changed->pattern).text;
      const CheckedPattern checked = knit::check_pattern(text);
      tally.take(checked.verdict);
      if (checked.verdict == PatternVerdict::holds && ++tally.told <= 5)
        UNSCOPED_INFO(seed << " " << changed->what << "\n" << text);
    }
  }
  if (is_told()) WARN(tally.told_as());
  CHECK(tally.holds == 0);
  for (const char* kind : {"a number", "a word", "a line twice", "a line left out"}) CHECK(kinds[kind] > 10);
}

namespace {

struct Probe {
  std::string kind, cast_on, lines;
  int count = 0;
};

std::vector<Probe> probes() {
  std::ifstream file(std::string(KNIT_SOURCE_DIR) + "/tests/fixtures/probes.tsv");
  std::vector<Probe> all;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream in(line);
    Probe probe;
    std::string count;
    std::getline(in, probe.kind, '\t');
    std::getline(in, probe.cast_on, '\t');
    std::getline(in, probe.lines, '\t');
    std::getline(in, count);
    probe.count = std::stoi(count);
    all.push_back(std::move(probe));
  }
  return all;
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

std::string text_of(const Probe& probe, int count) {
  const std::string said = std::to_string(count);
  std::string text = probe.lines;
  replace_all(text, "\\n", "\n");
  if (text.rfind("@CO@", 0) == 0) {
    text.erase(0, 4);
    const char* label = text.rfind("Rnd 1", 0) == 0 || text.rfind("Round 1", 0) == 0 ? "2" : "1";
    return text + "\nRnd " + label + ": K" + said + ". (" + said + " sts)\n";
  }
  replace_all(text, "{N}", said);
  return "CO " + probe.cast_on + " sts. Join to work in the round.\n" + text + "\nBO " + said + " sts.\n";
}

}  // namespace

TEST_CASE("world: each single construct holds with its right count, and does not add up with one too many") {
  const std::vector<Probe> all = probes();
  REQUIRE(all.size() == 154);
  std::size_t right = 0, found = 0;
  for (const Probe& probe : all) {
    CAPTURE(probe.kind, probe.lines);
    const bool holds = knit::check_pattern(text_of(probe, probe.count)).verdict == PatternVerdict::holds;
    // One fewer a time until so many remain: with one too many it is another pattern, and right.
    const bool ends_sooner = probe.lines.find("until {N} sts") != std::string::npos;
    const bool is_found = ends_sooner || knit::check_pattern(text_of(probe, probe.count + 1)).verdict ==
                                             PatternVerdict::does_not_add_up;
    right += holds ? 1U : 0U;
    found += is_found ? 1U : 0U;
    CHECK(holds);
    CHECK(is_found);
  }
  if (is_told())
    WARN("of " << all.size() << " constructs hold " << right << ", found with one too many " << found);
}
