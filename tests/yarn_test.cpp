// Yarn for a gauge, against the sources' own figures.
#include "knit/pattern/yarn.h"

#include "tests/support/catch.h"

using namespace knit;

TEST_CASE("the weight class is the one whose stitches the gauge has") {
  const auto number = [](double stitches) { return weight_class_of({stitches, 30.0}).number; };
  // The middle of each of the council's ranges, and beyond both ends of the table.
  CHECK(number(36.0) == 0);
  CHECK(number(29.0) == 1);
  CHECK(number(24.5) == 2);
  CHECK(number(22.0) == 3);
  CHECK(number(18.0) == 4);
  CHECK(number(13.5) == 5);
  CHECK(number(9.0) == 6);
  CHECK(number(5.0) == 7);
  CHECK(number(60.0) == 0);
  CHECK(number(1.0) == 7);
  CHECK(weight_class_of({22.0, 32.0}).name == "Light");
}

TEST_CASE("a finer yarn has thinner needles and more metres") {
  double metres = 0.0;
  double needle = 100.0;
  for (const double stitches : {5.0, 9.0, 13.5, 18.0, 22.0, 24.5, 29.0, 36.0}) {
    const WeightClass weight = weight_class_of({stitches, 30.0});
    CHECK(weight.metres_in_100_g > metres);
    CHECK(weight.needle_mm < needle);
    metres = weight.metres_in_100_g;
    needle = weight.needle_mm;
  }
}

TEST_CASE("a stitch takes Munden's length of yarn") {
  // 2.2 * 3.2 stitches in a square centimetre.
  CHECK(stitch_length_cm({22.0, 32.0}) == Approx(1.7271).epsilon(1e-4));
  // Stitches twice as small take half the yarn.
  CHECK(stitch_length_cm({44.0, 64.0}) == Approx(stitch_length_cm({22.0, 32.0}) / 2.0));
}

TEST_CASE("metres and grams of a piece, with spare") {
  const YarnNeeded yarn = yarn_needed(1000, {22.0, 32.0});
  CHECK(yarn.metres == Approx(17.271).epsilon(1e-4));
  CHECK(yarn.metres_with_spare == Approx(19.862).epsilon(1e-4));
  CHECK(yarn.grams == Approx(19.862 / 2.4).epsilon(1e-4));
}

TEST_CASE("needles are named in both systems where both have the size") {
  CHECK(needle_text(3.25) == "3.25 mm (US 3)");
  CHECK(needle_text(4.0) == "4 mm (US 6)");
  CHECK(needle_text(6.5) == "6.5 mm (US 10.5)");
  CHECK(needle_text(7.0) == "7 mm");
}
