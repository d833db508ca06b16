// The functions that are the same on every machine: against the C library's, which are right to nearly the last bit,
// and against values that were worked out elsewhere.
#include "knit/mesh/elementary.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/support/catch.h"
#include "tests/support/rough_sphere.h"

using namespace knit;

namespace {

// In units of the last place.
double off(double found, double wanted) {
  if (found == wanted) return 0.0;
  const double place =
      std::abs(wanted - std::nextafter(wanted, wanted > 0.0 ? 0.0 : std::numeric_limits<double>::infinity()));
  return std::abs(found - wanted) / place;
}

}  // namespace

TEST_CASE("elementary: no more than a last place away from the C library's", "[elementary]") {
  test_support::Dice dice(7);
  for (int i = 0; i < 3000; ++i) {
    const double angle = dice.between(-8.0, 8.0);
    CHECK(off(sine(angle), std::sin(angle)) <= 1.0);
    CHECK(off(cosine(angle), std::cos(angle)) <= 1.0);
    const double power = dice.between(-40.0, 40.0);
    CHECK(off(exponential(power), std::exp(power)) <= 1.0);
    const double x = dice.between(-1.0, 1.0) * std::ldexp(1.0, static_cast<int>(dice.below(60)) - 30);
    const double y = dice.between(0.0, 1.0);
    CHECK(off(angle_to(x, y), std::atan2(y, x)) <= 1.0);
    CHECK(off(hypotenuse(x, y), std::hypot(x, y)) <= 1.0);
    CHECK(off(hypotenuse(x, y, angle), std::hypot(std::hypot(x, y), angle)) <= 4.0);
  }
}

TEST_CASE("elementary: the bits that every machine must give", "[elementary]") {
  CHECK(sine(0.5) == 0x1.eaee8744b05f0p-2);
  CHECK(sine(3.0) == 0x1.210386db6d55bp-3);
  CHECK(sine(std::numbers::pi) == 0x1.1a62633145c07p-53);
  CHECK(cosine(1.0) == 0x1.14a280fb5068cp-1);
  CHECK(cosine(0.5 * std::numbers::pi) == 0x1.1a62633145c07p-54);
  CHECK(exponential(1.0) == 0x1.5bf0a8b145769p+1);
  CHECK(exponential(-3.61) == 0x1.bb37ab65978ddp-6);
  CHECK(angle_to(1.0, 1.0) == 0x1.921fb54442d18p-1);
  CHECK(angle_to(-1.0, 0.0) == std::numbers::pi);
  CHECK(angle_to(2.0, 0.9) == 0x1.b1009e9ee79bcp-2);
  CHECK(hypotenuse(1.0, 1.0) == 0x1.6a09e667f3bcdp+0);
}

TEST_CASE("elementary: at the ends of what they take", "[elementary]") {
  CHECK(sine(0.0) == 0.0);
  CHECK(cosine(0.0) == 1.0);
  CHECK(exponential(0.0) == 1.0);
  CHECK(angle_to(0.0, 0.0) == 0.0);
  CHECK(angle_to(3.0, 0.0) == 0.0);
  CHECK(angle_to(0.0, 2.0) == 0.5 * std::numbers::pi);
  CHECK(angle_to(0x1p1000, 0x1p1000) == angle_to(1.0, 1.0));
  CHECK(angle_to(-0x1p-1060, 0x1p-1060) == angle_to(-1.0, 1.0));
  CHECK(hypotenuse(0.0, 0.0) == 0.0);
  CHECK(hypotenuse(3.0, -4.0) == 5.0);
  CHECK(hypotenuse(0x3p1020, 0x4p1020) == 0x5p1020);
  CHECK(hypotenuse(0x3p-1000, 0x4p-1000) == 0x5p-1000);
  CHECK(hypotenuse(1e-217, 0.0) == 1e-217);
  CHECK(hypotenuse(0.0, 0.0, 0.0) == 0.0);
  CHECK(hypotenuse(2e200, -3e200, 6e200) == Approx(7e200));
}
