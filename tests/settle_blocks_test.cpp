// The block solver of settling against the system that it was given.
#include "knit/settle/blocks.h"

#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <vector>

#include "tests/support/catch.h"
#include "tests/support/rough_sphere.h"

using namespace knit;

namespace {

using Pairs = std::vector<std::array<std::uint32_t, 2>>;

}  // namespace

TEST_CASE("settle: a system of blocks is solved, and one that is not positive is refused") {
  constexpr std::uint32_t side = 17;
  test_support::Dice dice(7);
  std::vector<glm::dvec3> places;
  Pairs pairs;
  const auto number = [&](std::uint32_t i, std::uint32_t j) { return i * side + j; };
  for (std::uint32_t i = 0; i < side; ++i) {
    for (std::uint32_t j = 0; j < side; ++j) {
      places.emplace_back(i + dice.between(0, 0.1), j + dice.between(0, 0.1), dice.between(0, 1));
      if (j + 1 < side) pairs.push_back({number(i, j), number(i, j + 1)});
      if (i + 1 < side) pairs.push_back({number(i, j), number(i + 1, j)});
      if (i + 1 < side && j + 1 < side) pairs.push_back({number(i, j), number(i + 1, j + 1)});
    }
  }
  places.emplace_back(50, 50, 50);  // beside nothing
  const BlockPattern pattern = make_block_pattern(pairs, places);
  BlockSystem system;
  system.diagonal.assign(places.size(), Block{7.0, 0.5, 0.5, 8.0});
  for (std::size_t i = 0; i < pairs.size(); ++i)
    system.below.push_back(
        {dice.between(-1, 1), dice.between(-1, 1), dice.between(-1, 1), dice.between(-1, 1)});
  for (std::size_t i = 0; i < places.size(); ++i)
    system.right.emplace_back(dice.between(-1, 1), dice.between(-1, 1));
  BlockSolver solver(pattern);
  std::vector<glm::dvec2> solution;
  REQUIRE(solver.solve(system, 0.25, solution));
  const std::vector<glm::dvec2> first = solution;
  REQUIRE(solver.solve(system, 0.25, solution));
  CHECK(solution == first);

  std::vector<glm::dvec2> left(places.size());  // what the product is short of
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::uint32_t at = pattern.place[i];
    left[at] += system.right[at] - glm::dvec2(7.25 * solution[i].x + 0.5 * solution[i].y,
                                              0.5 * solution[i].x + 8.25 * solution[i].y);
  }
  for (const auto& [a, b] : pairs) {
    const Block& m = system.below[pattern.slot(a, b)];
    const bool a_is_row = pattern.place[a] > pattern.place[b];
    const std::uint32_t row = a_is_row ? a : b, column = a_is_row ? b : a;
    left[pattern.place[row]] -= glm::dvec2(m[0] * solution[column].x + m[1] * solution[column].y,
                                           m[2] * solution[column].x + m[3] * solution[column].y);
    left[pattern.place[column]] -= glm::dvec2(m[0] * solution[row].x + m[2] * solution[row].y,
                                              m[1] * solution[row].x + m[3] * solution[row].y);
  }
  for (const glm::dvec2& l : left) CHECK(glm::length(l) < 1e-12);

  system.diagonal[3] = {-1.0, 0.0, 0.0, 1.0};
  CHECK_FALSE(solver.solve(system, 0.25, solution));
}

// The last four columns of a panel are worked at once, though it may have but two of them left: what is written then lies
// behind it, and there must be room however short the panels after it are (found by the sanitizers).
TEST_CASE("settle: long panels of an odd number of stitches stand before and behind a short one") {
  for (const double lone : {-50.0, 50.0}) {
    constexpr std::uint32_t many = 31;
    std::vector<glm::dvec3> places;
    Pairs pairs;
    for (std::uint32_t i = 0; i < many; ++i) {
      places.emplace_back(0.01 * i, 0.0, 0.0);
      for (std::uint32_t j = 0; j < i; ++j) pairs.push_back({j, i});
    }
    places.emplace_back(lone, lone, lone);
    const BlockPattern pattern = make_block_pattern(pairs, places);
    BlockSystem system;
    system.diagonal.assign(places.size(), Block{40.0, 0.0, 0.0, 40.0});
    system.below.assign(pairs.size(), Block{1.0, 0.0, 0.0, 1.0});
    system.right.assign(places.size(), glm::dvec2(70.0, 140.0));
    system.right[pattern.place[many]] = {40.0, 80.0};
    BlockSolver solver(pattern);
    std::vector<glm::dvec2> solution;
    REQUIRE(solver.solve(system, 0.0, solution));
    for (const glm::dvec2& found : solution) CHECK(glm::length(found - glm::dvec2(1.0, 2.0)) < 1e-12);
  }
}
