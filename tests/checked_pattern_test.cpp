// What the checker says of the world's forms: a text and the verdict of each of its lines.
#include "knit/reader/checked_pattern.h"

#include <fstream>
#include <iterator>

#include "knit/trade/world_words.h"
#include "tests/support/catch.h"

using namespace knit;

namespace {

char sign_of(LineVerdict verdict) {
  switch (verdict) {
    case LineVerdict::holds:
      return '+';
    case LineVerdict::does_not_add_up:
      return '!';
    case LineVerdict::not_understood:
      return '?';
    case LineVerdict::not_claimed:
      return '~';
    case LineVerdict::no_instruction:
      return '.';
  }
  return ' ';
}

// A sign a line: + holds, ! does not add up, ? not understood, ~ not claimed, . no instruction.
std::string signs_of(const std::string& text) {
  const CheckedPattern checked = check_pattern(text);
  std::string signs;
  for (const CheckedLine& line : checked.sizes.front().lines) signs += sign_of(line.verdict);
  return signs;
}

struct Case {
  std::string text, signs;
};
void check_cases(const std::vector<Case>& cases) {
  for (const Case& one : cases) {
    CAPTURE(one.text);
    CHECK(signs_of(one.text) == one.signs);
  }
}

}  // namespace

TEST_CASE("checked pattern: labels of all forms") {
  for (const char* label : {"Rnd 2:", "2nd rnd:", "R2:", "2.", "2:", "Round two:", "Dec rnd:", "Set-up rnd:",
                            "Next round (decrease):", "Rnd 2 -", "**Rnd 2:**",
                            "- Rnd 2:", "* Rnd 2:", "Rnd 2 (RS):", "Second round:", "RND 2.", ""}) {
    CAPTURE(label);
    CHECK(signs_of("CO 20 sts.\nRnd 1: Knit.\n" + std::string(label) + " [K3, k2tog] 4 times. (16 sts)") ==
          "+++");
    CHECK(signs_of("CO 20 sts.\nRnd 1: Knit.\n" + std::string(label) + " [K3, k2tog] 4 times. (17 sts)") ==
          "++!");
    CHECK(signs_of("CO 20 sts.\nRnd 1: Knit.\n" + std::string(label) + " [K3, k2tag] 4 times. (16 sts)") ==
          "++?");
  }
}

TEST_CASE("checked pattern: what is not understood claims nothing of what hangs on it") {
  check_cases(
      {{"CO 20 sts.\nRnd 1: K10, frob 2, k to end.\nRnd 2: Knit.\nRnd 3: [K4, k2tog] 4 times. (20 sts)",
        "+?~~"},
       {"CO 20 sts.\nRnd 1: K10, frob 2, k to end.\nRnd 2: [K4, k2tog] 4 times. (21 sts)", "+?!"},
       {"CO 20 sts.\nRnd 1: K10, frob 2, k to end. (22 sts)\nRnd 2: [K9, k2tog] 2 times. (20 sts)", "+?+"}});
  const CheckedPattern checked = check_pattern("CO 20 sts.\nRnd 1: K10, frob 2, k to end.\n");
  CHECK(checked.verdict == PatternVerdict::not_understood);
  const CheckedLine& line = checked.sizes[0].lines[1];
  CHECK(line.sentence == "line 2: Rnd 1: the word \"frob\" is not known.");
  CHECK(line.word_at == 12);
  CHECK(line.word_length == 4);
}

TEST_CASE("checked pattern: the count may stand in many forms and is compared in all of them") {
  for (const char* count :
       {"(21 sts)", "[21]", "- 21 sts", "= 21", "21 sts.", "(21)", "You should have 21 sts.",
        "Place marker. (21 sts)", "21 total.", "(1 st inc'd, 21 sts)", "(+1 st)"}) {
    CAPTURE(count);
    CHECK(signs_of("CO 20 sts.\nRnd 1: K20. " + std::string(count)) == "+!");
  }
}

TEST_CASE("checked pattern: groups and repeats of rounds") {
  check_cases({
      {"CO 20 sts.\nAll even rnds: Knit.\nRnd 1: [K4, m1] 5 times. (25 sts)\nRnd 3: [K5, m1] 5 times. (30 "
       "sts)",
       "++++"},
      {"CO 20 sts.\nRnds 2 and 4: Knit.\nRnd 1: [K4, m1] 5 times. (25 sts)\nRnd 3: [K5, m1] 5 times. (30 "
       "sts)",
       "++++"},
      {"CO 20 sts.\nRnd 1: K2tog, k to end. (19 sts)\nRnd 2: Knit.\nRep rnds 1-2 4 times. (15 sts)", "++++"},
      {"CO 20 sts.\nRnd 1: K2tog, k to end. (19 sts)\nRnd 2: Knit.\nRep rnds 1-2 4 times. (16 sts)", "+++!"},
      {"CO 20 sts.\nDec rnd: K2tog, k to end. (19 sts)\nRepeat dec rnd every other rnd 3 times more. (16 "
       "sts)",
       "+++"},
      {"CO 20 sts.\nRnd 1: K2tog, k to end.\nRepeat rnd 1 until 12 sts remain.\nBO 12 sts.", "++++"},
      {"CO 20 sts.\nRnd 1: K2tog, k2tog, k to end.\nRepeat rnd 1 until 13 sts remain.", "++!"},
      {"CO 20 sts.\nRnds 1-4: Knit.\nRnd 6: Knit.", "++!"},
      {"CO 20 sts.\nRnd 1: Knit.\nKnit 3 rnds.\nKnit 1 rnd, decreasing 8 sts evenly. (12 sts)", "++++"},
      {"CO 20 sts.\nRnd 1: Knit.\nKnit 1 rnd, decreasing 8 sts evenly. (13 sts)", "++!"},
  });
}

TEST_CASE("checked pattern: an increase of one is worked into a stitch or between two, as the count has it") {
  check_cases({
      {"CO 6 sts.\nRnd 1: [inc 1] 6 times. (12 sts)\nRnd 2: [K1, inc 1] 6 times. (18 sts)", "+++"},
      {"CO 10 sts.\nRnd 1: *K1, inc 1; rep from * around. (20 sts)", "++"},
      {"CO 10 sts.\nRnd 1: *K1, increase 1 st; rep from * around. (15 sts)", "++"},
      {"CO 10 sts.\nRnd 1: *K1, inc 1; rep from * around. (16 sts)", "+!"},
      {"CO 10 sts.\nRnd 1: *K1, inc 1; rep from * around.", "+?"},
  });
}

TEST_CASE("checked pattern: each size is worked apart") {
  const CheckedPattern checked =
      check_pattern("CO 80 (88, 96) sts.\nRnd 1: [K6, k2tog] 10 (11, 12) times. (70 (77, 83) sts)\n");
  REQUIRE(checked.sizes.size() == 3);
  CHECK(checked.sizes[1].name == "88");
  CHECK(checked.sizes[0].verdict == PatternVerdict::holds);
  CHECK(checked.sizes[1].verdict == PatternVerdict::holds);
  CHECK(checked.sizes[2].verdict == PatternVerdict::does_not_add_up);
  CHECK(checked.verdict == PatternVerdict::does_not_add_up);
  CHECK(check_pattern("CO 80 (88, 96) sts.\nRnd 1: [K6, k2tog] 10 (11) times.\n").verdict ==
        PatternVerdict::not_understood);
}

TEST_CASE("checked pattern: pieces, holders and edges") {
  check_cases({
      {"Head\nCO 6 sts.\nRnd 1: [kfb] 6 times. (12 sts)\nBO 12 sts.\nLeg (make 2)\nCO 8 sts.\nRnd 1: Knit. "
       "(8 sts)\nBO 8 sts.",
       ".+++.+++"},
      {"Leg\nCO 7 sts.\nRnd 1: Knit.\nPlace sts on a holder.\nBody\nCO 7 sts.\nRnd 1: K7, k across held 7 "
       "sts of leg. (14 sts)",
       ".+++.++"},
      {"Leg\nCO 7 sts.\nRnd 1: Knit.\nPlace sts on a holder.\nBody\nCO 7 sts.\nRnd 1: K7, k across held 8 "
       "sts of leg. (14 sts)",
       ".+++.+!"},
      {"CO 20 sts.\nRnd 1: K8, place next 4 sts on a holder for thumb, CO 2 sts, k to end. (18 sts)\nBO 18 "
       "sts.\nThumb\n"
       "Place the 4 held sts of the thumb on needles. Pick up and knit 2 sts in the gap. (6 sts)\nRnd 1: "
       "Knit. (6 sts)",
       "+++.++"},
  });
}

TEST_CASE("checked pattern: rounds of an earlier piece are worked by its name") {
  const std::string first =
      "FIRST LEG\nCO 8 sts.\nRnd 1: Knit.\nRnd 2: [K2, m1] 4 times. (12 sts)\nRnd 3: Knit.\nPlace sts on a "
      "holder.\nSECOND LEG\nCO 8 sts.\n";
  const std::string end = "\nRnd 4: K12, k across the 12 held sts of the first leg. (24 sts)\nBO 24 sts.";
  for (const char* line :
       {"Rnds 1-3: As rnds 1-3 of first leg. (12 sts)", "Rnds 1-3: Work as for rnds 1-3 of the first leg.",
        "Work as rnds 1-3 of the first leg. (12 sts)", "Work rnds 1-3 of first leg.",
        "Repeat rnds 1-3 of first leg once. (12 sts)", "Rnds 1-3: As first leg. (12 sts)",
        "Rnds 1-3: Work as for first leg. (12 sts)", "Work as for rnds 1 to 3 of first leg. (12 sts)",
        "Rnds 1-3: Same as rounds 1-3 of the First Leg"}) {
    CAPTURE(line);
    CHECK(signs_of(first + line + end) == ".+++++.++++");
  }
  const std::string held = "Place sts on a holder.";
  std::string bound_off = first;
  bound_off.replace(first.find(held), held.size(), "BO 12 sts.");
  for (const char* line :
       {"Rnds 1-3: As rnds 1-3 of first leg. (13 sts)", "Work as rnds 1-3 of the first leg. (13 sts)",
        "Rnds 1-3: As first leg. (13 sts)"}) {
    CAPTURE(line);
    CHECK(signs_of(bound_off + line) == ".+++++.+!");
  }
  // No such piece, and no such round of it.
  for (const char* line :
       {"Rnds 1-3: As rnds 1-3 of left arm. (12 sts)", "Work as rnds 1-3 of the left arm. (12 sts)",
        "Rnds 1-4: As rnds 1-4 of first leg. (12 sts)", "Rep rnds 2-7 of first leg.",
        "Rnds 1-3: As left arm. (12 sts)"}) {
    CAPTURE(line);
    CHECK(signs_of(first + line) == ".+++++.+?");
  }
}

TEST_CASE("checked pattern: rows are worked to and fro") {
  // Row 2 comes to the marker from the other side.
  check_cases(
      {{"CO 20 sts.\nRow 1 (RS): K5, pm, k15.\nRow 2 (WS): P to marker, sm, p5. (20 sts)", "+++"},
       {"CO 20 sts.\nRow 1 (RS): K5, pm, k15.\nRow 2 (WS): P to marker, sm, p15. (20 sts)", "++!"},
       {"CO 20 sts.\nRow 1 (RS): K15, turn.\nRow 2 (WS): P10, turn.\nRow 3 (RS): Knit. (20 sts)\nBO 20 sts.",
        "+++++"}});
}

TEST_CASE("checked pattern: crochet and stitch patterns are told for what they are") {
  const CheckedPattern crochet = check_pattern(
      "Ball\nRnd 1: 6 sc in magic ring. (6)\nRnd 2: 2 sc in each st. (12)\nRnd 3: [sc, inc] 6 times. (18)\n");
  CHECK(crochet.verdict == PatternVerdict::not_understood);
  CHECK(crochet.remark.starts_with("This is crochet"));
  const CheckedPattern rib = check_pattern(
      "Multiple of 4 sts plus 2.\nRow 1: *K2, p2; rep from * to last 2 sts, k2.\nRow 2: P2, *k2, p2; rep "
      "from * to end.\n");
  CHECK(rib.verdict == PatternVerdict::holds);
  CHECK(rib.remark.find("a multiple of 4 plus 2") != std::string::npos);
}

TEST_CASE("checked pattern: what is not understood or wrong is told in a sentence") {
  for (const char* text :
       {"12th round: *(k1, p1) in next st* around. (64 sts)\n13th rou7.nd: K 3, p 1 to end.ch 6 (64 "
        "sts)\nCut "
        "end.ch 6 (64 sts)",
        "Rnd 1: 6 sc in magic ring. (6)\nRnd 2: 2 sc in each st. (12)\n", "Rnd 2: K4, frob.\n"}) {
    CAPTURE(text);
    const CheckedPattern checked = check_pattern(text);
    for (const CheckedLine& line : checked.sizes.front().lines) {
      if (line.verdict != LineVerdict::does_not_add_up && line.verdict != LineVerdict::not_understood)
        continue;
      CHECK(line.sentence.starts_with("line " + std::to_string(line.number) + ": "));
      CHECK(line.sentence.ends_with("."));
    }
  }
}

TEST_CASE("checked pattern: stitches that no line casts on stand in the first line of work") {
  for (const char* text :
       {"Ribbing\n\nMultiple of 4 sts plus 2.\nRow 1: *K2, p2; rep from * to last 2 sts, k2.\n",
        "xt rnd: knit 1, (k2, p3) x 3.\nBind off.\nWeave in ends.",
        "Ribbing\nRnd 1: *K2, p2; rep from * to end.\n"}) {
    CAPTURE(text);
    const CheckedPattern checked = check_pattern(text);
    for (const CheckedPiece& piece : checked.sizes.front().pieces) {
      for (const CheckedRound& round : piece.rounds)
        CHECK((round.line >= 1 && round.line <= checked.sizes.front().lines.size()));
    }
  }
  CHECK(check_pattern("Ribbing\nRnd 1: *K2, p2; rep from * to end.\n").sizes[0].pieces[0].rounds[0].line ==
        2);
}

TEST_CASE("checked pattern: without a cast on the fewest stitches are found on which the rounds come out") {
  const auto remark = [](const char* text) { return check_pattern(text).remark; };
  CHECK(remark("Rnd 1: *K2, p2; rep from * to end.\nRnd 2: *K2, p2; rep from * to end.\n")
            .starts_with("No stitches are cast on; it is worked on 4 stitches"));
  CHECK(
      remark("Row 1: *K3, p4; rep from * to last 3 sts, k3.\nRow 2: *P3, k4; rep from * to last 3 sts, p3.\n")
          .find("worked on 3 stitches") != std::string::npos);
  CHECK(
      remark("Rnd 1: *K3, yo, k2tog; rep from * to end.\nRnd 2: Knit.\nRnd 3: *K4, p3; rep from * to end.\n")
          .find("worked on 35 stitches") != std::string::npos);
  CHECK(remark("Rnd 1: Knit. (41 sts)\nRnd 2: Knit.\n").find("worked on 41 stitches") != std::string::npos);
  // Half a pattern: it ends, or its rounds do not come back to where they began.
  CHECK(remark("Rnd 1: Knit.\nRnd 2: [K2tog] to end.\nBO all sts.\n").empty());
  CHECK(remark("Rnd 1: Knit.\nRnd 2: K1, k2tog, k to end.\n").empty());
}

TEST_CASE("checked pattern: a cast on in small letters is not joined to a long line before it") {
  check_cases(
      {{"Materials: 50 g of DK yarn, 3.25 mm dpns, stuffing, stitch holder\ncast on 20 sts\nRnd 1: Knit "
        "20. (20 sts)",
        ".++"}});
}

TEST_CASE("checked pattern: a count of sizes ends its line, however wide it is") {
  check_cases(
      {{"CO 8 (10) sts.\nNext rnd (decrease): k1, knit 2 together, k until 3 sts remain, knit two together, "
        "knit 1 = 6 (8) sts\nBreak yarn, thread through remaining 6 (8) sts and pull tightly.",
        "+++"}});
}

TEST_CASE("checked pattern: neighbours told one by one are a range") {
  check_cases({{"CO 14 sts.\nRnd 1: Knit.\nKnit 9 rounds.\nRnds 11 & 12: Work even.\nBO 14 sts.", "+++++"}});
}

TEST_CASE("checked pattern: a holder that nobody filled holds nothing below another piece") {
  CHECK(signs_of(
            "MITTEN\nCO 20 sts.\nRnd 1: Knit.\nBO 20 sts.\n\nTHUMB\nSlip the 5 thumb sts onto dpns. Rejoin "
            "yarn, pick up and knit 1 st in the gap. (6 sts)\nRnd 1: Knit. (6 sts)\nBO 6 sts.")
            .find('!') != std::string::npos);
  CHECK(check_pattern("THUMB\nSlip the 5 thumb sts onto dpns.\nRnd 1: Knit. (5 sts)\nBO 5 sts.").verdict ==
        PatternVerdict::holds);
}

TEST_CASE("checked pattern: held stitches begin a round and pieces are joined") {
  check_cases(
      {{"GLOVE\nCO 24 sts.\nRnd 1: K12, place next 12 sts on a holder for second finger, CO 2 sts. (14 sts)\n"
        "BO 14 sts.\nSECOND FINGER\nRnd 1: Knit across the 12 held sts of second finger, pick up and knit 2 "
        "sts "
        "along the gap. (14 sts)\nBO 14 sts.",
        ".+++.++"},
       {"LEGS (make 2)\nCO 6 sts.\nRnd 1: Knit. (6 sts)\nCut yarn and place sts on waste yarn.\nHEAD\nRnd 1: "
        "Knit "
        "across 6 held sts, knit across 6 held sts. (12 sts)\nBO 12 sts.",
        ".+++.++"},
       {"LEGS (make 2)\nCO 10 sts.\nRnd 1: Knit. (10 sts)\nBreak yarn, leave sts on waste yarn.\nBODY\nPlace "
        "the 10 "
        "held sts of one leg on the needles, cast on 3 sts, knit across the 10 held sts of the other leg, "
        "cast on 3 "
        "sts. (26 sts)\nBO 26 sts.",
        ".+++.++"},
       {"TROUSERS\nCO 40 sts.\nRnd 1: K20, place the remaining 20 sts on hold for left leg. (20 sts)\nRIGHT "
        "LEG\nCast on 2 sts. (22 sts)\nBO 22 sts.\nLEFT LEG\nTransfer the 20 held sts to needles. (20 "
        "sts)\nBO 20 sts.",
        ".++.++.++"},
       {"FRONT\nCO 12 sts.\nRnd 1: Knit. (12 sts)\nPlace 12 sts on a holder.\nBACK\nCO 12 sts.\nRnd 1: Knit. "
        "(12 "
        "sts)\nJoin both sides with a three-needle bind off.",
        ".+++.+++"},
       {"MITTEN\nCO 24 sts.\nRnd 1: K1, with waste yarn k5 for thumb, slip these 5 sts back to left needle "
        "and knit "
        "them again with main yarn, k to end. (24 sts)\nRnd 2: K12, CO 5 sts (backward loop), k to end. (29 "
        "sts)",
        ".+++"}});
}

TEST_CASE("checked pattern: stitches that waste yarn parts are taken from both sides of it") {
  check_cases({{"MITTEN\nCO 24 sts.\nRnd 1: K1, with waste yarn k5 for thumb, slip these 5 sts back to left "
                "needle and knit "
                "them again with main yarn, k to end. (24 sts)\nBO 24 sts.\nTHUMB\nRemove the waste yarn and "
                "place the 10 held "
                "sts on needles. Pick up and knit 1 st at each side. (12 sts)\nBO 12 sts.",
                ".+++.++"},
               {"SOCK\nCO 32 sts.\nRnd 1: With waste yarn knit 16 sts for heel, slip these 16 sts back to "
                "left needle, k to "
                "end. (32 sts)\nBO 32 sts.\nHEEL\nRemove waste yarn and place the 32 heel sts back on "
                "needles, pick up 1 st at "
                "each side. (34 sts)\nBO 34 sts.",
                ".+++.++"}});
  CHECK(check_pattern(
            "MITTEN\nCO 24 sts.\nRnd 1: K1, with waste yarn k5 for thumb, slip these 5 sts back to left "
            "needle and knit them again with main yarn, k to end. (24 sts)\nBO 24 sts.\nTHUMB\nRemove the "
            "waste yarn and place the 14 held sts on needles. (14 sts)\nBO 14 sts.")
            .verdict == PatternVerdict::does_not_add_up);
}

TEST_CASE("checked pattern: more rounds than can be worked are told") {
  std::string text = "CO 8 sts.\nRnd 1: Knit. (8 sts)\n";
  for (int i = 0; i < 12; ++i) text += "Repeat the last rnd 99999 times more.\n";
  const CheckedPattern checked = check_pattern(text);
  CHECK(checked.verdict == PatternVerdict::not_understood);
  std::string said;
  for (const CheckedLine& line : checked.sizes[0].lines) said += line.sentence;
  CHECK(said.find("longer than can be worked") != std::string::npos);
}

TEST_CASE("checked pattern: a line of work is never passed over") {
  for (const char* line : {"K 18.", "Zigzag rnd: K3, frob, k2tog. (13 sts)", "Purl 3 together around.",
                           "(K1, k2tog) all over. (13 sts)", "Repeat the second and fourth rnd. (13 sts)",
                           "Work the lace panel, decreasing as charted. (13 sts)"}) {
    CAPTURE(line);
    CHECK(check_pattern("CO 20 sts.\nRnd 1: Knit. (20 sts)\n" + std::string(line) + "\n").verdict !=
          PatternVerdict::holds);
  }
}

TEST_CASE("checked pattern: the docs print the table of stitch words") {
  std::ifstream file(std::string(KNIT_SOURCE_DIR) + "/docs/pattern.md");
  const std::string docs{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  CHECK(docs.find(trade_words_table()) != std::string::npos);
}

TEST_CASE("checked pattern: the legend of a chart is no work") {
  CHECK(
      signs_of(
          "CO 6 sts.\nRnd 1: [K1, m1l] 6 times. (12 sts)\n  (blank)  k: knit\n     R     m1r: make 1 right\n"
          "     L     m1l: make 1 left\n     /     k2tog: knit 2 together") == "++....");
}

TEST_CASE("checked pattern: short rows in this program's words are worked to the graph") {
  const std::string begin = "CO 10 sts (Rnd 1). Join to work in the round.\n";
  const std::string rows =
      "Short row 1 (RS): K6, turn. (6 sts after BOR)\nShort row 2 (WS): DS, p5, turn. (at BOR)\n";
  const std::string end = "Rnd 2 (cont.): DS, knit to end. (10 sts)\n";
  CHECK(check_pattern(begin + rows + end).verdict == PatternVerdict::holds);
  CHECK(check_pattern(begin + rows + "Rnd 2 (cont.): DS, knit to end. (11 sts)\n").verdict ==
        PatternVerdict::does_not_add_up);
  CHECK(check_pattern(begin + rows + "Dec rnd: [K3, k2tog] 2 times.\n" + end).verdict !=
        PatternVerdict::holds);
}

TEST_CASE("checked pattern: a rule told before the first numbered round holds from there on") {
  const std::string text =
      "CO 20 sts.\nWork 6 rounds without shaping.\nAll even rounds: knit.\nRnd 7: [k4, m1] "
      "5 times. (25 sts)\nRnd 9: [k5, m1] 5 times. (30 sts)\nBO 30 sts.";
  CHECK(signs_of(text) == "++++++");
  CHECK(signs_of("CO 20 sts.\nRnd 1: Knit.\nRnd 3: [k4, m1] 5 times. (25 sts)") == "++!");
}

TEST_CASE("checked pattern: markers that are removed stand nowhere any more") {
  const std::string begin = "CO 20 sts.\nRnd 1: K5, pm, k15.\n", end = "Rnd 2: K10, pm, k10.\nRnd 3: K to ";
  CHECK(signs_of(begin + "Remove marker.\n" + end + "2 sts before marker, k2tog, sm, k10. (19 sts)").back() ==
        '+');
  CHECK(signs_of(begin + "Remove marker.\n" + end + "marker, k2tog, k8. (19 sts)").back() == '+');
  CHECK(signs_of(begin + end + "marker, k2tog, k8. (19 sts)").back() == '!');
}

TEST_CASE("checked pattern: rounds of the piece before are not those of this one") {
  const std::string head = "Head\nCO 8 sts.\nRnds 1 to 6: knit.\nBind off.\n";
  const std::string leg = "Leg\nCO 20 sts.\nRnd 1: knit.\nRnd 2: K to last 3 sts, k2tog, k1. (19 sts)\n";
  CHECK(signs_of(head + leg + "Repeat rnds 2 and 3 until 16 sts remain.") == ".+++.+++?");
  CHECK(signs_of(head + leg + "Rnd 3: knit.\nRepeat rnds 2 and 3 until 16 sts remain.") == ".+++.+++++");
  CHECK(signs_of(head + leg + "BO.\nArm\nRnd 1: Pick up and knit 9 sts.\nRepeat rnds 1 and 2.").back() ==
        '?');
}

TEST_CASE("checked pattern: stitches between markers are counted between them") {
  const std::string text =
      "CO 36 sts.\nRnd 1: K17, pm, m1, k2, m1, pm, k to end. (38 sts)\nRnd 2: Knit.\n"
      "Rnd 3: K to marker, sm, m1, k to marker, m1, sm, k to end. (40 sts)\n"
      "Repeat rnds 2 and 3 until there are ";
  CHECK(signs_of(text + "12 sts between markers. (46 sts)") == "+++++");
  CHECK(signs_of(text + "12 sts between markers. (48 sts)") == "++++!");
  CHECK(signs_of(text + "13 sts between markers.") == "++++!");
}

TEST_CASE("checked pattern: held stitches are taken by the name before them") {
  const std::string text =
      "Arm\nCO 8 sts.\nRnd 1: Knit.\nPlace sts on a holder.\nBody\nCO 10 sts.\nRnd 1: K10, "
      "knit across 8 held ";
  CHECK(signs_of(text + "arm sts. (18 sts)").back() == '+');
  CHECK(signs_of(text + "wing sts. (18 sts)").back() == '!');
}

TEST_CASE("checked pattern: a count that does not hold is said once") {
  CHECK(signs_of("CO 12 sts.\nRnd 1: [k1, k2tog] 4 times. (9 sts)\nRnds 2-3: Knit.\nRnd 4: Knit. (8 sts)\nBO "
                 "8 sts.") == "+!+++");
  CHECK(signs_of("CO 12 sts.\nRnd 1: [k1, k2tog] 4 times. (9 sts)\nBO 8 sts.") == "+!+");
}

TEST_CASE("checked pattern: a round that is told by another is work whatever its label") {
  for (const char* line : {"3. As rnd 1", "3: Same as rnd 1", "3: Work as for round 1", "- 3: as rnd 1",
                           "As rnd 1", "Rnd 3: Rep rnd 1", "3. Rep rnd 1"}) {
    CAPTURE(line);
    const std::string text = "CO 20 sts.\n1. K2tog, k to end. (19 sts)\n2. Knit.\n" + std::string(line);
    CHECK(signs_of(text + " (18 sts)\nBO 18 sts.") == "+++++");
    CHECK(signs_of(text + " (19 sts)") == "+++!");
    CHECK(signs_of(text + "\nBO 19 sts.") == "++++!");
  }
}

// Each round walks through all segments between markers: thousands of them are more than anybody works.
TEST_CASE("checked pattern: markers that pile up round after round come to an end") {
  CHECK(signs_of("CO 64 sts.\nRnds 1-30: K16, pm, k to end of rnd.\nBO 64 sts.") == "+++");
  const CheckedPattern checked = check_pattern("CO 64 sts.\nRnds 1-9999: K16, pm, k to end of rnd.");
  CHECK(checked.verdict == PatternVerdict::not_understood);
  CHECK(checked.sizes.front().lines.at(1).sentence.find("longer than can be worked") != std::string::npos);
}

TEST_CASE("checked pattern: a line that does not add up tells what it makes") {
  const auto made = [](const std::string& text) {
    const CheckedPattern checked = check_pattern(text);
    const CheckedLine& line = checked.sizes.front().lines.back();
    CHECK(line.verdict == LineVerdict::does_not_add_up);
    return line.stitches.value_or(-1);
  };
  CHECK(made("CO 20 sts.\nRnd 1: [k1, k2tog] 6 times, k2. (13 sts)") == 14);
  CHECK(made("CO 20 sts.\nRnd 1: Inc 4 sts evenly. (25 sts)") == 24);
  CHECK(made("CO 20 sts.\nRnd 1: K2tog, k to end.\nRepeat rnd 1 three times more. (15 sts)") == 16);
  CHECK(made("CO 20 sts.\nRnd 1: [k1, k2tog] 6 times, k2. (14 sts) Rnd 2: Knit. (13 sts)") == 14);
  CHECK(made("CO 20 sts.\nKnit 3 rnds. (19 sts)") == 20);
  CHECK(made("Rnd 3: [k1, k2tog] 6 times. (13 sts)") == 12);
  CHECK(made("CO 20 sts.\nRnd 1: K22.") == -1);  // it cannot be worked
  // What follows goes on with what the line says.
  CHECK(check_pattern("CO 20 sts.\nRnd 1: [k1, k2tog] 6 times, k2. (13 sts)\nRnd 2: Knit.")
            .sizes.front()
            .lines.back()
            .stitches == 13);
}

// A marker after every stitch: each one that is slipped walks over all.
TEST_CASE("checked pattern: markers that pile up within a round come to an end") {
  CHECK(signs_of("CO 4000000 sts.\nRnd 1: *K1, pm, sm; rep from * to end.\nBO.") == "+?~");
  CHECK(signs_of("CO 60 sts.\nRnd 1: *K1, pm, sm; rep from * to end. (60 sts)\nBO 60 sts.") == "+++");
}
