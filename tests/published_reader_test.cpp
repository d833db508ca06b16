// Patterns with limbs as they are published: right ones pass, a wrong count is found in its line.
#include "knit/reader/checked_pattern.h"

#include "tests/support/catch.h"

using namespace knit;

namespace {

std::string mistake_in(const std::string& text) {
  const CheckedPattern checked = check_pattern(text);
  for (const CheckedLine& line : checked.sizes.front().lines) {
    if (!line.sentence.empty()) return line.sentence;
  }
  return "";
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

// A mitten: the thumb waits on waste yarn.
const std::string mitten = R"(MITTEN
Cast on 28 sts. Join in the round, being careful not to twist.
Rnds 1-8: *k2, p2; rep from * to end. (28 sts)
Rnd 9: K13, m1, k2, m1, k13. (30 sts)
Rnds 10-11: Knit. (30 sts)
Rnd 12: K13, m1, k4, m1, k13. (32 sts)
Rnd 13: K13, place next 6 sts on waste yarn for thumb, CO 2 sts over the gap (backward loop), k to end. (28 sts)
Rnds 14-20: Knit. (28 sts)
Rnd 21: *K2tog; rep from * to end. (14 sts)
Break yarn, thread through remaining 14 sts and pull tightly.

THUMB
Place the held 6 sts of the thumb on the needles. Rejoin yarn, pick up and knit 2 sts along the cast on edge. (8 sts)
Rnds 1-5: Knit. (8 sts)
Rnd 6: [K2tog] 4 times. (4 sts)
Break yarn, thread through remaining 4 sts.
)";

// A gingerbread man's legs.
const std::string two_legs = R"(First leg
CO 7 sts. Join to work in the round.
Rnds 1-5: Knit. (7 sts)
Break yarn, place sts on a holder.

Second leg
Work as for first leg but do not break yarn.

Body
Rnd 6: K7, then k across held 7 sts of first leg. (14 sts)
Rnd 7: K7, m1, k7, m1. (16 sts)
Rnds 8-12: Knit. (16 sts)
BO all 16 sts.
)";

const std::string trousers = R"(LEGS (make 2)
CO 10 sts.
Rnd 1: Knit. (10 sts)
Break yarn, leave sts on a spare needle.

BODY
Place 10 held sts on the needle.
Rnd 2: K10, CO 3 sts, knit across the held sts, CO 3 sts. (26 sts)
Rnd 3: Knit. (26 sts)
BO 26 sts.
)";

const std::string pouch = R"(FRONT
CO 12 sts.
Rnd 1: Knit. (12 sts)
Place 12 sts on a holder.

BACK
CO 12 sts.
Rnd 1: Knit. (12 sts)
Join both sides with a three-needle bind off.
)";

}  // namespace

TEST_CASE("published limbs: a thumb on waste yarn") {
  CHECK(mistake_in(mitten) == "");
  CHECK(check_pattern(mitten).rounds == 27);
  CHECK(mistake_in(with(mitten, "k to end. (28 sts)", "k to end. (29 sts)")) ==
        "line 7: Rnd 13 makes 28 stitches, the line says 29.");
  CHECK(mistake_in(with(mitten, "next 6 sts", "next 60 sts")) ==
        "line 7: Rnd 13: 60 stitches are to go on a holder, and 19 stitches are left.");
  CHECK(mistake_in(with(mitten, "the held 6 sts", "the held 7 sts")) ==
        "line 13: the holder of the thumb has 6 stitches, the line says 7.");
  CHECK(mistake_in(with(mitten, "knit 2 sts along", "knit 3 sts along")) ==
        "line 13: 9 stitches are on the needle, the line says 8.");
  CHECK(mistake_in(with(mitten, "remaining 4 sts", "remaining 5 sts")) ==
        "line 16: closes 5 stitches, and 4 are on the needles.");
  CHECK(mistake_in(with(mitten, "Rnd 12: K13, m1, k4", "Rnd 12: K13, m1, k5")).starts_with("line 6: Rnd 12"));
}

TEST_CASE("published limbs: a leg on a holder, knitted across") {
  CHECK(mistake_in(two_legs) == "");
  CHECK(mistake_in(with(two_legs, "held 7 sts", "held 8 sts")) ==
        "line 10: Rnd 6: the holder of the first leg has 7 stitches, the line says 8.");
  CHECK(mistake_in(with(two_legs, "first leg. (14 sts)", "first leg. (15 sts)")) ==
        "line 10: Rnd 6 makes 14 stitches, the line says 15.");
  CHECK(mistake_in(with(two_legs, "of first leg. (14", "of left arm. (14")) ==
        "line 10: Rnd 6: there are no held stitches of the left arm; held are 7 of the first leg (line 4).");
  CHECK(mistake_in(with(two_legs, "Rnd 6: K7", "Rnd 6: K6")) ==
        "line 10: Rnd 6 leaves 1 stitch of the round before unworked.");
  CHECK(
      mistake_in(
          with(two_legs,
               ", then k across held 7 sts of first leg. (14 sts)\nRnd 7: K7, m1, k7, m1. (16 sts)\n"
               "Rnds 8-12: Knit. (16 sts)\nBO all 16 sts.",
               ". (7 sts)\nRnd 7: K1, k across held 7 sts of second leg, k6. (14 sts)\nBO all sts.")) ==
      "line 11: Rnd 7: there are no held stitches of the second leg; held are 7 of the first leg (line 4).");
  CHECK(mistake_in(with(two_legs, "BO all 16 sts", "BO all 15 sts")) ==
        "line 13: closes 15 stitches, and 16 are on the needles.");
}

TEST_CASE("published limbs: two made alike, with a crotch cast on") {
  CHECK(mistake_in(trousers) == "");
  CHECK(mistake_in(
            with(trousers, "across the held sts, CO 3 sts. (26", "across the held sts, CO 2 sts. (26")) ==
        "line 8: Rnd 2 makes 25 stitches, the line says 26.");
  CHECK(mistake_in(with(trousers, "(make 2)", "(make 3)")) ==
        "line 4: 10 stitches are left on the holder of the legs, and no line takes them off.");
}

TEST_CASE("published limbs: two live ends are bound off together") {
  CHECK(mistake_in(pouch) == "");
  CHECK(mistake_in(with(pouch, "BACK\nCO 12 sts.\nRnd 1: Knit. (12 sts)",
                        "BACK\nCO 11 sts.\nRnd 1: Knit. (11 sts)")) ==
        "line 9: two live ends are joined, and they have 11 and 12 stitches.");
}
