// Rounds as phrases: what they are worth in words, and that they say what was there.
#include "knit/pattern/fold.h"

#include <algorithm>
#include <random>
#include <string>

#include "knit/pattern/pattern_words.h"
#include "tests/support/catch.h"

using namespace knit;

namespace {

// k m1l m1r k2tog ssk as . l r / and a backslash; a comma is k at a main line.
std::vector<Operation> round_of(const std::string& signs) {
  std::vector<Operation> operations;
  for (const char sign : signs) {
    if (sign == '.') operations.push_back({Hand::knit, false});
    if (sign == ',') operations.push_back({Hand::knit, true});
    if (sign == 'l') operations.push_back({Hand::m1l, false});
    if (sign == 'r') operations.push_back({Hand::m1r, false});
    if (sign == '/') operations.push_back({Hand::k2tog, false});
    if (sign == '\\') operations.push_back({Hand::ssk, false});
  }
  return operations;
}

std::string times(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

std::string written(const std::string& signs, bool markers = false) {
  return words_of(fold(round_of(signs), {markers}));
}

std::vector<Hand> hands_of(const std::vector<Operation>& operations) {
  std::vector<Hand> hands;
  for (const Operation& operation : operations) hands.push_back(operation.hand);
  return hands;
}

void put(std::vector<Hand>& hands, const Run& run) {
  hands.insert(hands.end(), static_cast<std::size_t>(run.count), run.hand);
}

// The operations that phrases say.
std::vector<Hand> unfold(std::span<const Phrase> phrases) {
  std::vector<Hand> hands;
  for (const Phrase& phrase : phrases) {
    if (const auto* run = std::get_if<Run>(&phrase)) {
      put(hands, *run);
    } else {
      const auto& repeat = std::get<Repeat>(phrase);
      for (std::int32_t time = 0; time < repeat.times; ++time) {
        for (const Run& part : repeat.runs) put(hands, part);
      }
    }
  }
  return hands;
}

int words_in(std::span<const Phrase> phrases) {
  int words = 0;
  for (const Phrase& phrase : phrases) {
    const auto* repeat = std::get_if<Repeat>(&phrase);
    words += repeat == nullptr ? 1 : 1 + static_cast<int>(repeat->runs.size());
  }
  return words;
}

// Tried stitch by stitch: every cut of the round into runs and repeats of any block.
int fewest_words(const std::vector<Operation>& round) {
  const std::size_t size = round.size();
  const auto words_of_block = [&](std::size_t from, std::size_t to) {
    int words = 0;
    for (std::size_t i = from; i < to; ++i)
      words += i == from || round[i].hand != Hand::knit || round[i - 1].hand != Hand::knit ? 1 : 0;
    return words;
  };
  std::vector<int> best(size + 1, static_cast<int>(size) + 1);
  best[0] = 0;
  for (std::size_t from = 0; from < size; ++from) {
    for (std::size_t to = from + 1; to <= size; ++to) {
      const std::size_t length = to - from;
      best[to] = std::min(best[to], best[from] + words_of_block(from, to));
      for (std::size_t end = to; end + length <= size; end += length) {
        const auto at = [&](std::size_t i) { return round.begin() + static_cast<std::ptrdiff_t>(i); };
        const auto same = [](const Operation& a, const Operation& b) { return a.hand == b.hand; };
        if (!std::equal(at(from), at(to), at(end), same)) break;
        best[end + length] = std::min(best[end + length], best[from] + words_of_block(from, to) + 1);
      }
    }
  }
  return best[size];
}

// Rounds as they come: random, evenly shaped, and with a mistake in the evenness.
class RandomRounds {
 public:
  std::vector<Operation> next() {
    const int kind = below(3);
    std::vector<Operation> round;
    if (kind == 0) {
      for (int i = below(60); i >= 0; --i) round.push_back(any());
      return round;
    }
    std::vector<Operation> part;
    for (int i = below(12); i >= 0; --i) part.push_back(any());
    for (int i = below(12); i >= 0; --i) round.insert(round.end(), part.begin(), part.end());
    const auto turn = static_cast<std::ptrdiff_t>(below(static_cast<int>(part.size())));
    std::rotate(round.begin(), round.begin() + turn, round.end());
    if (kind == 2) round[static_cast<std::size_t>(below(static_cast<int>(round.size())))] = any();
    return round;
  }

 private:
  int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
  Operation any() {
    const bool shaped = below(3) == 0;
    return {shaped ? static_cast<Hand>(1 + below(4)) : Hand::knit, below(6) == 0};
  }
  std::mt19937 random_{20240607};
};

}  // namespace

TEST_CASE("rounds are folded to the text a knitter would write") {
  CHECK(written("......") == "K6");
  CHECK(written(times("....l", 6)) == "[K4, m1l] 6 times");
  CHECK(written(".." + times("....l", 5) + "..") == "K2, [K4, m1l] 5 times, K2");
  CHECK(written("....l........l....") == "[K4, m1l, K4] 2 times");
  CHECK(written("....l........l........l....") == "[K4, m1l, K4] 3 times");
  CHECK(written("......l........l........l....") == "[K6, m1l, K2] 3 times, K2");
  CHECK(written("....l........l........l......") == "[K4, m1l, K4] 3 times, K2");
  CHECK(written("//////") == "[k2tog] 6 times");
  CHECK(written("ll") == "m1l, m1l");
  CHECK(written("....l.....r") == "K4, m1l, K5, m1r");
  CHECK(written("r.l...r.l...") == "[m1r, K1, m1l, K3] 2 times");
  CHECK(written("r.l...r.l....") == "[m1r, K1, m1l, K3] 2 times, K1");
  CHECK(written(times("\\..", 4) + times("/...", 3)) == "[ssk, K2] 4 times, [k2tog, K3] 3 times");
  CHECK(fold({}).empty());
}

TEST_CASE("of equally short texts the one with fewer repeats is taken") {
  CHECK(written("./.") == "K1, k2tog, K1");
  // Three words either way for two of a kind.
  CHECK(written("l.l.") == "[m1l, K1] 2 times");
  CHECK(written("ll.") == "m1l, m1l, K1");
}

TEST_CASE("markers stand before main stitches, and no run crosses one") {
  CHECK(written(times(",..l", 6), true) == "[sm, K3, m1l] 6 times");
  CHECK(written(times(",..l", 6), false) == "[K3, m1l] 6 times");
  CHECK(written("..,..,..", true) == "K2, [sm, K3] 2 times");
  // No run is cut: without markers this is "K2, [K4, m1l] 3 times".
  CHECK(written(",.....l....l....l", true) == "sm, K6, [m1l, K4] 2 times, m1l");
  CHECK(written(",.....l....l....l", false) == "K2, [K4, m1l] 3 times");
}

TEST_CASE("the stars' style is for rounds that are one repeat") {
  const auto even = round_of(times("....l", 6));
  CHECK(words_of(fold(even), {.stars = true}) == "*K4, m1l; rep from * to end");
  const auto uneven = round_of(times("....l", 6) + "..");
  CHECK(words_of(fold(uneven), {.stars = true}) == "[K4, m1l] 6 times, K2");
}

TEST_CASE("unfolding gives 10000 random rounds back, and folding never makes them longer") {
  RandomRounds random;
  int repeats = 0;
  for (int i = 0; i < 10000; ++i) {
    const std::vector<Operation> round = random.next();
    for (const bool markers : {false, true}) {
      const std::vector<Phrase> phrases = fold(round, {markers});
      REQUIRE(unfold(phrases) == hands_of(round));
      if (markers) continue;
      for (const Phrase& phrase : phrases) repeats += std::holds_alternative<Repeat>(phrase) ? 1 : 0;
      std::vector<Operation> plain = round;
      int runs = 0;
      for (std::size_t k = 0; k < plain.size(); ++k)
        runs += k == 0 || plain[k].hand != Hand::knit || plain[k - 1].hand != Hand::knit ? 1 : 0;
      REQUIRE(words_in(phrases) <= runs);
    }
  }
  CHECK(repeats > 5000);
}

TEST_CASE("no other way to write a round is shorter") {
  RandomRounds random;
  int tried = 0;
  for (int i = 0; i < 3000; ++i) {
    const std::vector<Operation> round = random.next();
    if (round.size() > 40) continue;
    ++tried;
    INFO(words_of(fold(round)));
    REQUIRE(words_in(fold(round)) == fewest_words(round));
  }
  CHECK(tried > 1000);
}

TEST_CASE("every marker is written before the stitch it belongs to") {
  RandomRounds random;
  for (int i = 0; i < 2000; ++i) {
    const std::vector<Operation> round = random.next();
    std::vector<bool> expected;
    for (const Operation& operation : round) expected.push_back(operation.at_main);
    std::vector<bool> marked;
    const auto work = [&](const Run& run) {
      for (int k = 0; k < run.count; ++k) marked.push_back(k == 0 && run.marker);
    };
    for (const Phrase& phrase : fold(round, {.markers = true})) {
      if (const auto* run = std::get_if<Run>(&phrase)) work(*run);
      if (const auto* repeat = std::get_if<Repeat>(&phrase)) {
        for (int time = 0; time < repeat->times; ++time) {
          for (const Run& run : repeat->runs) work(run);
        }
      }
    }
    REQUIRE(marked == expected);
  }
}

TEST_CASE("a round of 3000 stitches is folded too") {
  CHECK(written(times("..l", 1500)) == "[K2, m1l] 1500 times");
  CHECK(written(times("/", 1500)) == "[k2tog] 1500 times");
  std::string uneven;
  for (int i = 0; i < 1000; ++i) uneven += i * 7 % 10 < 7 ? "..l" : ".l";
  CHECK(unfold(fold(round_of(uneven))) == hands_of(round_of(uneven)));
}
