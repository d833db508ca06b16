// Mutants of the program's own patterns and of small ones that were reported: one number, word or line is changed so that it cannot be
// right, and the checker never says that it holds. Why each cannot be right:
//
//   a stated count, one off      the stitches before it are as they were
//   a run or a repeat, one off   the round takes more or fewer stitches than there are
//   a shaping by a knit stitch   the same, or what the round makes is not what it says
//   a shaping round left out     what follows is worked on another count; and so is it where the round stands twice
//
// KNIT_WHOLE tries every one of every shape, an ordinary run a share of some.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <regex>
#include <sstream>

#include "knit/mesh/branching_shapes.h"
#include "knit/mesh/shapes.h"
#include "knit/pattern/written_pattern.h"
#include "knit/reader/checked_pattern.h"
#include "tests/support/catch.h"
#include "tests/support/rhythm_rounds.h"
#include "tests/support/standing_run.h"

using namespace knit;

namespace {

bool is_whole() { return std::getenv("KNIT_WHOLE") != nullptr; }

struct WrongText {
  std::string text, what;
};

using TextRows = std::vector<std::string>;

TextRows rows_of_text(const std::string& text) {
  TextRows rows;
  std::istringstream in(text);
  for (std::string row; std::getline(in, row);) rows.push_back(row);
  return rows;
}

std::string joined(const TextRows& rows) {
  std::string text;
  for (const std::string& row : rows) text += row + "\n";
  return text;
}

bool is_work(const std::string& row) {
  static const std::regex work("^(Rnd|Rnds|Row|Rows|Repeat|CO|BO|Using|Break|Inc rnd|Dec rnd)\\b.*");
  return std::regex_match(row, work);
}

class WrongMaker {
 public:
  explicit WrongMaker(const std::string& text) : rows_(rows_of_text(text)) {
    const auto begin = std::find(rows_.begin(), rows_.end(), "INSTRUCTIONS");
    first_ = begin == rows_.end() ? 0 : static_cast<std::size_t>(begin - rows_.begin());
    const auto end = std::find(rows_.begin(), rows_.end(), "FINISHING");
    last_ = static_cast<std::size_t>(end - rows_.begin());
  }

  // `runs`: those of knit stitches too; where they go as far as a marker they say nothing.
  std::vector<WrongText> all(bool runs) {
    std::vector<const char*> numbers{"(\\b|, )([0-9]+)(?=(, [0-9]+)* sts?\\))", "(\\] )([0-9]+)(?= times)",
                                     "(\\bCO )([0-9]+)", "(\\bBO )([0-9]+)", "(remaining )([0-9]+)"};
    if (runs) numbers.push_back("(\\b[Kk])([0-9]+)(?=[,\\].)])");
    for (std::size_t at = first_; at < last_; ++at) {
      if (!is_work(rows_[at])) continue;
      for (const char* number : numbers) change_numbers(at, std::regex(number));
      if (!runs) continue;
      change_words(at);
      if (is_shaping(at)) leave_out_and_double(at);
    }
    return std::move(made_);
  }

 private:
  void put(std::size_t at, const std::smatch& match, const std::string& other) {
    TextRows changed = rows_;
    changed[at].replace(static_cast<std::size_t>(match.position(2)), match.str(2).size(), other);
    made_.push_back({joined(changed), rows_[at] + "  ->  " + changed[at]});
  }
  void change_numbers(std::size_t at, const std::regex& found) {
    const std::string& row = rows_[at];
    for (std::sregex_iterator it(row.begin(), row.end(), found), end; it != end; ++it) {
      const int value = std::stoi(it->str(2));
      put(at, *it, std::to_string(value + 1));
      if (value > 1) put(at, *it, std::to_string(value - 1));
    }
  }
  void change_words(std::size_t at) {
    static const std::regex shaping("()\\b(m1l|m1r|k2tog|ssk)\\b");
    const std::string& row = rows_[at];
    for (std::sregex_iterator it(row.begin(), row.end(), shaping), end; it != end; ++it) put(at, *it, "k1");
  }
  [[nodiscard]] bool is_shaping(std::size_t at) const {
    static const std::regex shaping("^Rnd [0-9]+:.*\\b(m1l|m1r|k2tog|ssk)\\b.*");
    if (!std::regex_match(rows_[at], shaping)) return false;
    // As many more as fewer, and nothing after it is another.
    static const std::regex grows("m1"), shrinks("k2tog|ssk");
    return !(std::regex_search(rows_[at], grows) && std::regex_search(rows_[at], shrinks));
  }
  void leave_out_and_double(std::size_t at) {
    TextRows less = rows_, more = rows_;
    less.erase(less.begin() + static_cast<std::ptrdiff_t>(at));
    more.insert(more.begin() + static_cast<std::ptrdiff_t>(at), rows_[at]);
    made_.push_back({joined(less), "left out: " + rows_[at]});
    made_.push_back({joined(more), "twice: " + rows_[at]});
  }

  TextRows rows_;
  std::size_t first_ = 0, last_ = 0;
  std::vector<WrongText> made_;
};

// How many of `tried` there were; those that are said to hold are told.
std::size_t check_wrong(std::vector<WrongText> all, std::size_t most) {
  std::mt19937 random(21);
  for (std::size_t i = 0; i < std::min(most, all.size()); ++i)
    std::swap(all[i], all[i + random() % (all.size() - i)]);
  all.resize(std::min(most, all.size()));
  std::size_t holds = 0;
  for (const WrongText& wrong : all) {
    if (check_pattern(wrong.text).verdict != PatternVerdict::holds) continue;
    if (++holds <= 3) UNSCOPED_INFO(wrong.what);
  }
  CHECK(holds == 0);
  return all.size();
}

std::size_t check_own(const WrittenPattern& words, bool runs, std::size_t most) {
  const std::string text = pattern_as_text(words);
  CHECK(check_pattern(text).verdict == PatternVerdict::holds);
  return check_wrong(WrongMaker(text).all(runs), most);
}

std::size_t check_mesh(const Mesh& mesh, double width_share, bool stars) {
  const State state = test_support::standing_run(mesh, width_share);
  PatternOptions options;
  options.stars = stars;
  options.form = PatternForm::full;
  const WrittenPattern words = has_limbs(state)
                                   ? write_pattern(plan_limbs(state), {22.0, 32.0}, options, "piece")
                                   : write_pattern(rounds_of(state), {22.0, 32.0}, options, "piece");
  return check_own(words, !stars, is_whole() ? 5000 : 40);
}

std::string text_of_file(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("world mutants: of the program's own patterns none is said to hold") {
  std::size_t tried = check_mesh(sphere(24, 13, false), 0.06, false);
  tried += check_mesh(sphere(24, 13, false), 0.06, true);
  tried += check_mesh(trousers(0.08), 0.05, false);
  if (is_whole()) {
    for (const Mesh& mesh :
         {mug(0.08), egg(64, 0.1), vase(64, 0.1), cone(64, 0.1), capsule(64, 0.1), letter_y(0.08),
          starfish(0.08), octopus(0.08), cup(0.08), stretched_sphere(64, 0.1)})
      tried += check_mesh(mesh, 0.03, false);
    CHECK(tried >= 4500);
  }
  if (std::getenv("KNIT_TALLY") != nullptr) WARN(tried << " mutants");
}

TEST_CASE("world mutants: of the short form none is said to hold") {
  for (const auto style : {test_support::SectionStyle::lines, test_support::SectionStyle::pairs}) {
    const Rounds rounds = test_support::RhythmRounds(8, 16, style)
                              .grow(1, 4)
                              .grow(2, 3)
                              .plain(6)
                              .shrink(2, 3)
                              .shrink(1, 4)
                              .rounds();
    PatternOptions options;
    options.form = PatternForm::short_form;
    check_own(write_pattern(rounds, {22.0, 32.0}, options, "ball"), false, is_whole() ? 1000 : 40);
  }
}

TEST_CASE("world mutants: reported patterns that are right hold, wrong ones and mutants never do") {
  const std::filesystem::path folder = std::filesystem::path(KNIT_SOURCE_DIR) / "tests/fixtures/patterns";
  std::size_t right = 0, wrong = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string(), text = text_of_file(entry.path());
    CAPTURE(name);
    const PatternVerdict verdict = check_pattern(text).verdict;
    if (name.find("wrong") != std::string::npos) {
      CHECK(verdict == PatternVerdict::does_not_add_up);
      ++wrong;
      continue;
    }
    CHECK(verdict == PatternVerdict::holds);
    check_wrong(WrongMaker(text).all(true), 200);
    ++right;
  }
  CHECK(right == 4);
  CHECK(wrong == 9);
}
