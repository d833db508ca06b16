// Elimination that can be heard: it solves, and it is broken off.
#include "knit/timing/elimination.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "tests/support/catch.h"

using namespace knit;

namespace {

// Column by column.
struct Half {
  std::vector<int> first{0}, row;
  std::vector<double> value;
  [[nodiscard]] LowerHalf view() const { return {first, row, value}; }
};

// A square grid's Laplacian with uneven weights, and something on the diagonal.
Half grid(int side) {
  std::mt19937 random(20260101);
  const int count = side * side;
  std::vector<double> diagonal(static_cast<std::size_t>(count), 1e-3);
  Half half;
  for (int i = 0; i < count; ++i) {
    const std::size_t own = half.value.size();
    half.row.push_back(i);
    half.value.push_back(0.0);
    for (const int other : {i + 1, i + side}) {
      if (other >= count || (other == i + 1 && other % side == 0) || half.row.back() == other) continue;
      const double weight = 0.1 + static_cast<double>(random() % 1000) / 500.0;
      half.row.push_back(other);
      half.value.push_back(-weight);
      diagonal[static_cast<std::size_t>(i)] += weight;
      diagonal[static_cast<std::size_t>(other)] += weight;
    }
    half.value[own] = diagonal[static_cast<std::size_t>(i)];
    half.first.push_back(static_cast<int>(half.row.size()));
  }
  return half;
}

std::vector<double> numbers(std::size_t count) {
  std::mt19937 random(7);
  std::vector<double> values(count);
  for (double& value : values) value = static_cast<double>(random() % 2000) - 1000.0;
  return values;
}

std::vector<double> product(const LowerHalf& a, const std::vector<double>& x) {
  std::vector<double> y(x.size(), 0.0);
  for (std::size_t j = 0; j < a.size(); ++j) {
    for (auto at = static_cast<std::size_t>(a.first[j]); at < static_cast<std::size_t>(a.first[j + 1]);
         ++at) {
      const auto i = static_cast<std::size_t>(a.row[at]);
      y[i] += a.value[at] * x[j];
      if (i != j) y[j] += a.value[at] * x[i];
    }
  }
  return y;
}

}  // namespace

TEST_CASE("elimination: what is solved for is what the matrix makes the right side of") {
  for (const int side : {1, 2, 7, 40}) {
    CAPTURE(side);
    const Half half = grid(side);
    const Elimination factors(half.view());
    REQUIRE(factors.factored());
    const std::vector<double> right = numbers(half.view().size());
    std::vector<double> found = right;
    factors.solve(found);
    const std::vector<double> back = product(half.view(), found);
    double worst = 0.0;
    for (std::size_t i = 0; i < right.size(); ++i) worst = std::max(worst, std::abs(back[i] - right[i]));
    CHECK(worst < 1e-6);
  }
}

TEST_CASE("elimination: without a pivot nothing is factored") {
  const Half half{{0, 2, 3}, {0, 1, 1}, {1.0, 1.0, 1.0}};
  CHECK_FALSE(Elimination(half.view()).factored());
}

TEST_CASE("elimination: it is heard, and broken off") {
  const Half half = grid(100);
  std::vector<double> shares;
  const Elimination factors(half.view(), [&](double share) { shares.push_back(share); });
  REQUIRE(factors.factored());
  CHECK(shares.size() >= 10);
  CHECK(std::is_sorted(shares.begin(), shares.end()));
  CHECK(shares.back() > 0.8);
  CHECK(shares.back() <= 1.0);
  shares.clear();
  std::vector<double> found = numbers(half.view().size()), again = found;
  factors.solve(found, [&](double share) { shares.push_back(share); });
  factors.solve(again);
  CHECK(found == again);
  CHECK(std::is_sorted(shares.begin(), shares.end()));
  CHECK(shares.size() >= 2);
  struct BrokenOff {};
  CHECK_THROWS_AS(Elimination(half.view(), [](double /*share*/) { throw BrokenOff{}; }), BrokenOff);
}
