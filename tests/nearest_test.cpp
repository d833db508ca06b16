// Placement nearest: which stitch hangs on which, and the labels that follow.
#include "knit/stitches/nearest.h"

#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <numbers>

#include "tests/support/catch.h"
#include "tests/support/join.h"
#include "tests/support/rough_sphere.h"

using namespace knit;
using test_support::Cells;
using test_support::Dice;
using test_support::shaping_cells;

namespace {

constexpr double pi = std::numbers::pi;
using Stitches = std::vector<Stitch>;
using Flags = std::vector<std::uint8_t>;

// A round about y; `jitter` is in stitches.
Stitches round_of(int count, double y, Dice& dice, double jitter = 0.0) {
  Stitches stitches;
  const double radius = count / 20.0;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * pi * (i + dice.between(-jitter, jitter)) / count;
    const glm::dvec3 at(radius * std::sin(angle), y + dice.between(-0.05, 0.05) * jitter,
                        -radius * std::cos(angle));
    stitches.push_back({at, no_vertex});
  }
  return stitches;
}
Stitches even_round(int count, double y) {
  Dice dice(1);
  return round_of(count, y, dice);
}

struct Pair {
  Stitches below, above;
  Cells mains{};
  Flags shaped{};
  [[nodiscard]] Join planned(const NearestPenalties& penalties = {}) const {
    return plan_nearest({below, above, mains, shaped}, penalties, 2);
  }
  [[nodiscard]] bool grows() const { return above.size() >= below.size(); }
  [[nodiscard]] const Stitches& small() const { return grows() ? below : above; }
  [[nodiscard]] const Stitches& big() const { return grows() ? above : below; }
};

Pair even_pair(int below, int above) { return {even_round(below, 0.0), even_round(above, 0.1)}; }

Pair random_pair(Dice& dice, int most) {
  const int below = 3 + static_cast<int>(dice.below(static_cast<std::size_t>(most) - 2));
  const int least = std::max(3, (below + 1) / 2);
  const int above = least + static_cast<int>(dice.below(static_cast<std::size_t>(2 * below - least) + 1));
  Pair pair{round_of(below, 0.0, dice, 1.5), round_of(above, 0.1, dice, 1.5)};
  for (int i = 0; i < below; ++i) {
    pair.shaped.push_back(static_cast<std::uint8_t>(dice.below(2)));
    if (dice.below(5) == 0) pair.mains.push_back(i);
  }
  return pair;
}

double squared(const Stitch& a, const Stitch& b) {
  const glm::dvec3 d = a.position - b.position;
  return glm::dot(d, d);
}

// Of a matching by its links: squares, and `stacking` for each doubling that involves a shaped stitch.
double cost_of(const Pair& pair, const Cells& link, double stacking) {
  double sum = 0.0;
  for (std::size_t cell = 0; cell < link.size(); ++cell) {
    sum += squared(pair.small()[static_cast<std::size_t>(link[cell])], pair.big()[cell]);
    if (cell == 0 || link[cell] != link[cell - 1]) continue;
    const auto j = static_cast<std::size_t>(link[cell]);
    const bool stacked =
        pair.grows() ? pair.shaped[j] != 0 : (pair.shaped[cell - 1] | pair.shaped[cell]) != 0;
    if (stacked) sum += stacking;
  }
  return sum;
}

// The least over all matchings, by trying each; the first stitch is doubled only where all are.
double least_cost(const Pair& pair, double stacking) {
  const std::size_t n = pair.small().size();
  double least = 1e300;
  for (unsigned doubled = 0; doubled < (1U << n); ++doubled) {
    if ((doubled & 1U) != 0 && doubled + 1 != 1U << n) continue;
    Cells link;
    for (unsigned j = 0; j < n; ++j)
      link.insert(link.end(), (doubled >> j & 1U) != 0 ? 2U : 1U, static_cast<std::int32_t>(j));
    if (link.size() == pair.big().size()) least = std::min(least, cost_of(pair, link, stacking));
  }
  return least;
}

// As a mirror shows them: the same first stitch, and round the other way.
Cells mirrored(const Cells& mains, std::int32_t size) {
  Cells image;
  for (const std::int32_t main : mains) image.push_back((size - main) % size);
  std::sort(image.begin(), image.end());
  return image;
}
Pair mirrored(const Pair& pair) {
  using test_support::round_the_other_way;
  Pair image{round_the_other_way(pair.below), round_the_other_way(pair.above),
             mirrored(pair.mains, static_cast<std::int32_t>(pair.below.size())),
             round_the_other_way(pair.shaped)};
  for (Stitches* row : {&image.below, &image.above})
    for (Stitch& stitch : *row) stitch.position.x *= -1.0;
  return image;
}

// Doublings that involve what shaping made in the row below.
std::int32_t stacked(const Pair& pair, const Join& t) {
  return static_cast<std::int32_t>(std::lround(cost_of(pair, t.link, 1e6) / 1e6));
}

}  // namespace

TEST_CASE("nearest: any legal pair of rows is matched soundly", "[nearest]") {
  Dice dice(2024);
  for (int i = 0; i < 1000; ++i) {
    const Pair pair = random_pair(dice, 40);
    const NearestPenalties penalties{i % 3 == 0 ? 0.01 : 0.0, i % 4 == 0 ? 0.01 : 0.0};
    const Join t = pair.planned(penalties);
    INFO("pair " << i << ": " << pair.below.size() << " to " << pair.above.size());
    REQUIRE(test_support::links_sound(t));
    REQUIRE(test_support::labels_agree(t));
    REQUIRE(test_support::placed_agree(t));
    REQUIRE(test_support::mains_sound(t, pair.mains));
    REQUIRE(test_support::counts_agree(t));
    CHECK(t.to == 2);
    CHECK(t.rule == Rule::nearest);
    CHECK(t.sum_of_squares == Approx(cost_of(pair, t.link, 0.0)));
    double longest = 0.0;
    for (std::size_t cell = 0; cell < t.link.size(); ++cell)
      longest =
          std::max(longest, squared(pair.small()[static_cast<std::size_t>(t.link[cell])], pair.big()[cell]));
    CHECK(t.longest_square == longest);
  }
}

TEST_CASE("nearest: no other matching is nearer", "[nearest]") {
  Dice dice(7);
  for (int i = 0; i < 300; ++i) {
    const Pair pair = random_pair(dice, 8);
    INFO("pair " << i << ": " << pair.below.size() << " to " << pair.above.size());
    const Join t = pair.planned();
    CHECK(t.sum_of_squares == Approx(least_cost(pair, 0.0)).epsilon(1e-12));
    for (const double stacking : {0.02, 5.0}) {
      const Join spread = pair.planned({stacking, 0.0});
      CHECK(cost_of(pair, spread.link, stacking) == Approx(least_cost(pair, stacking)).epsilon(1e-12));
    }
  }
}

TEST_CASE("nearest: equal rows hang straight, a row twice as large doubles every stitch", "[nearest]") {
  const Join plain = even_pair(10, 10).planned();
  CHECK(plain.link == Cells{0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
  CHECK(plain.mains == Cells{0, 2, 3, 5, 7, 8});
  CHECK(shaping_cells(plain).empty());
  CHECK(even_pair(4, 8).planned().link == Cells{0, 0, 1, 1, 2, 2, 3, 3});
  CHECK(even_pair(7, 4).planned().link.size() == 7);
  CHECK(shaping_cells(even_pair(7, 4).planned()).size() == 3);
}

TEST_CASE("nearest: mirrored rounds are worked mirrored, right for left", "[nearest]") {
  Dice dice(31);
  for (int i = 0; i < 400; ++i) {
    Pair pair = random_pair(dice, 30);
    if (i % 2 == 0) pair.mains.clear();  // cast on
    if (pair.big().size() == 2 * pair.small().size()) continue;
    const NearestPenalties penalties{i % 3 == 0 ? 0.01 : 0.0, i % 5 == 0 ? 0.01 : 0.0};
    const Join t = pair.planned(penalties);
    const Join image = mirrored(pair).planned(penalties);
    INFO("pair " << i << ": " << pair.below.size() << " to " << pair.above.size());
    CHECK(image.labels == test_support::mirrored_labels(t.labels));
    CHECK(image.mains == mirrored(t.mains, t.above));
    CHECK(image.link == test_support::mirrored_links(t));
    CHECK(image.sum_of_squares == Approx(t.sum_of_squares));
  }
}

TEST_CASE("nearest: the round's first stitch is doubled only where all are", "[nearest]") {
  Dice dice(12);
  for (int i = 0; i < 300; ++i) {
    const Pair pair = random_pair(dice, 12);
    const bool all = pair.big().size() == 2 * pair.small().size();
    CHECK((pair.planned().link[1] == 0) == all);
  }
}

TEST_CASE("nearest: shaping leans by the side on which the nearest main stands", "[nearest]") {
  // Increases: stitch 4 of 8 is pulled apart; the main is before it, after it, or itself.
  Pair grows{even_round(8, 0.0), {}};
  for (const double at : {0.0, 1.0, 2.0, 3.0, 3.95, 4.1, 5.0, 6.0, 7.0})
    grows.above.push_back({{0.4 * std::sin(pi * at / 4), 0.1, -0.4 * std::cos(pi * at / 4)}, no_vertex});
  const auto shaped = [](Pair pair, std::int32_t main) {
    pair.mains = {main};
    const Join t = pair.planned();
    const Cells cells = shaping_cells(t);
    REQUIRE(cells.size() == 1);
    const auto cell = static_cast<std::size_t>(cells[0]);
    return std::tuple(cells[0], t.labels[cell], t.partner[cell]);
  };
  CHECK(shaped(grows, 3) == std::tuple(4, Label::m1r, 5));
  CHECK(shaped(grows, 5) == std::tuple(5, Label::m1l, 4));
  CHECK(shaped(grows, 4) == std::tuple(5, Label::m1r, 4));  // on the main itself: beside it
  // Decreases: the same upside down.
  const Pair shrinks{grows.above, grows.below};
  CHECK(shaped(shrinks, 3) == std::tuple(4, Label::ssk, 5));
  CHECK(shaped(shrinks, 6) == std::tuple(5, Label::k2tog, 4));
  CHECK(shaped(shrinks, 4) == std::tuple(5, Label::ssk, 4));
  CHECK(shaped(shrinks, 5) == std::tuple(4, Label::k2tog, 5));
  // On the main, which goes on in the nearer of its two cells.
  grows.above[4] = {{0.4 * std::sin(pi * 3.9 / 4), 0.1, -0.4 * std::cos(pi * 3.9 / 4)}, no_vertex};
  grows.above[5] = {{0.4 * std::sin(pi * 4.05 / 4), 0.1, -0.4 * std::cos(pi * 4.05 / 4)}, no_vertex};
  CHECK(shaped(grows, 4) == std::tuple(4, Label::m1l, 5));
}

TEST_CASE("nearest: mains are wales, carried up and down along the links", "[nearest]") {
  Dice dice(99);
  for (int i = 0; i < 200; ++i) {
    Pair pair = random_pair(dice, 30);
    if (pair.mains.empty()) pair.mains = {static_cast<std::int32_t>(pair.below.size()) - 1};
    const Join t = pair.planned();
    Cells expected;
    for (const std::int32_t main : pair.mains) {
      const auto m = static_cast<std::size_t>(main);
      auto cell = static_cast<std::size_t>(std::find(t.link.begin(), t.link.end(), main) - t.link.begin());
      const bool all = pair.big().size() == 2 * pair.small().size();
      const bool doubled = pair.grows() && !all && cell + 1 < t.link.size() && t.link[cell + 1] == main;
      if (doubled && squared(pair.below[m], pair.above[cell + 1]) < squared(pair.below[m], pair.above[cell]))
        ++cell;
      const auto above = pair.grows() ? static_cast<std::int32_t>(cell) : t.link[m];
      if (expected.empty() || expected.back() != above) expected.push_back(above);
    }
    CHECK(t.mains == expected);
    // In a row that grows a main is a main above; in one that shrinks its cell may be worked by shaping.
    if (pair.grows())
      for (const std::int32_t main : t.mains) CHECK(t.labels[static_cast<std::size_t>(main)] == Label::main);
  }
  CHECK(even_pair(4, 4).planned().mains == Cells{0, 1, 2, 3});
  CHECK(even_pair(24, 24).planned().mains == Cells{0, 4, 8, 12, 16, 20});
  CHECK(even_pair(7, 7).planned().mains == Cells{0, 1, 3, 4, 6});  // six would not stand alike on both sides
}

TEST_CASE("nearest: shaped_by names the stitches that shaping made", "[nearest]") {
  Dice dice(5);
  for (int i = 0; i < 200; ++i) {
    const Join t = random_pair(dice, 20).planned();
    Flags expected(static_cast<std::size_t>(t.above), 0);
    for (std::size_t cell = 1; cell < t.link.size(); ++cell) {
      if (t.link[cell] != t.link[cell - 1]) continue;
      if (t.change() < 0) expected[static_cast<std::size_t>(t.link[cell])] = 1;
      if (t.change() > 0) expected[cell] = expected[cell - 1] = 1;
    }
    CHECK(shaped_by(t) == expected);
  }
}

TEST_CASE("nearest: the stacking penalty keeps shaping off what shaping made", "[nearest]") {
  const double square = std::pow(2.0 * pi / 20.0, 2.0);  // of a stitch width
  for (const auto& [first, second, third] :
       {std::tuple(20, 26, 32), {30, 35, 41}, {32, 26, 20}, {41, 35, 30}}) {
    INFO(first << ", " << second << ", " << third);
    Pair pair = even_pair(second, third);
    pair.shaped = shaped_by(even_pair(first, second).planned());
    const std::int32_t without = stacked(pair, pair.planned());
    std::int32_t last = without;
    for (const double penalty : {0.1, 1.0, 20.0}) {
      const std::int32_t with = stacked(pair, pair.planned({penalty * square, 0.0}));
      CHECK(with <= last);
      CHECK(pair.planned({penalty * square, 0.0}).sum_of_squares >= pair.planned().sum_of_squares);
      last = with;
    }
    CHECK(without > 0);
    CHECK(last == 0);
  }
}

TEST_CASE("nearest: followed mains have all shaping beside them", "[nearest]") {
  const auto farthest = [](const Join& t) {
    std::int32_t far = 0;
    const auto size = static_cast<std::int32_t>(t.labels.size());
    for (const std::int32_t cell : shaping_cells(t)) {
      std::int32_t near = size;
      for (std::int32_t other = 0; other < size; ++other) {
        if (t.labels[static_cast<std::size_t>(other)] != Label::main) continue;
        const std::int32_t apart = std::abs(other - cell);
        near = std::min({near, apart, size - apart});
      }
      far = std::max(far, near);
    }
    return far;
  };
  for (const auto& [below, above] : {std::pair(30, 36), {36, 42}, {36, 30}, {42, 37}, {48, 44}}) {
    INFO(below << " to " << above);
    Pair pair = even_pair(below, above);
    for (int i = 0; i < 6; ++i) pair.mains.push_back(i * below / 6 + 1);
    CHECK(farthest(pair.planned({0.0, 1.0})) == 1);
    CHECK(farthest(pair.planned()) > 1);
  }
}
