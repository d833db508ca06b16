// What the front and back halves of a tube hold, row by row.
#include "knit/rows/body_halves.h"

#include <cmath>
#include <numbers>

#include "tests/support/catch.h"

using namespace knit;

namespace {

// Circles with their backs above each other: what they lose is lost in front.
Tube leaning_back(double widest, double less, int rows) {
  Tube tube;
  for (int row = 0; row < rows; ++row) {
    const double radius = widest - row * less;
    Ring ring;
    for (int i = 0; i < 720; ++i) {
      const double angle = std::numbers::pi * (2 * i + 1) / 720.0;
      ring.points.emplace_back(radius * std::sin(angle), row, radius - widest - radius * std::cos(angle));
    }
    measure_arcs(ring);
    tube.longest = std::max(tube.longest, ring.length);
    tube.lengths.push_back(ring.length);
    tube.curves.emplace_back(std::move(ring));
  }
  return tube;
}

double most_changed(const std::vector<double>& half) {
  double most = 0.0;
  for (std::size_t row = 1; row < half.size(); ++row)
    most = std::max(most, std::abs(half[row] - half[row - 1]));
  return most;
}

}  // namespace

TEST_CASE("halves change by no more stitches than a round gives or takes") {
  const Tube tube = leaning_back(12.0, 0.95, 7);  // six stitches a row
  const auto ideals = half_ideals(tube, MirrorPlane{}, 1.0);
  REQUIRE(ideals);
  CHECK(std::abs(ideals->front.front() - ideals->back.front()) < 0.01);
  CHECK(most_changed(ideals->front) <= 4.001);
  CHECK(most_changed(ideals->back) <= 4.001);
  CHECK(ideals->front.back() < ideals->back.back() - 6.0);
  for (std::size_t row = 0; row < tube.lengths.size(); ++row)
    CHECK(std::abs(ideals->front[row] + ideals->back[row] - tube.lengths[row]) < 1e-9);
}

TEST_CASE("halves share what is more than both may change by") {
  const auto ideals = half_ideals(leaning_back(12.0, 2.0, 3), MirrorPlane{}, 1.0);  // twelve stitches a row
  REQUIRE(ideals);
  const double front = ideals->front[0] - ideals->front[1], back = ideals->back[0] - ideals->back[1];
  CHECK(std::abs(front - back) < 0.01);
}
