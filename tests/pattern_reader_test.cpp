// The reader of written patterns: what it understands, what it blames and where, and that nothing upsets it.
#include "knit/reader/pattern_reader.h"

#include "tests/support/catch.h"
#include "tests/support/random_pattern.h"

using namespace knit;
using test_support::RandomWriter;
using test_support::Style;

namespace {

std::string told(const ReadPattern& read) {
  std::string text;
  for (const PatternMistake& mistake : read.mistakes) text += mistake.sentence + "\n";
  return text;
}

// A round of these words on `before` stitches, with nothing stated.
ReadPattern one_round(int before, const std::string& words) {
  return read_pattern("CO " + std::to_string(before) + " sts.\nRnd 1: " + words + "\n");
}

// The hands of the round as letters: k l r t s.
std::string hands(const ReadPattern& read) {
  std::string text;
  if (read.rounds.rounds.empty()) return "none: " + told(read);
  for (const Operation& op : read.rounds.rounds.back().operations) text += "krlts"[static_cast<int>(op.hand)];
  return text;
}

std::string why(int before, const std::string& words) { return told(one_round(before, words)); }

}  // namespace

TEST_CASE("a round's words are worked as a knitter works them") {
  struct Case {
    int before;
    const char* words;
    const char* hands;
  };
  const Case cases[] = {
      {3, "K3.", "kkk"},
      {3, "k3", "kkk"},
      {3, "Knit.", "kkk"},
      {3, "knit", "kkk"},
      {3, "K.", "kkk"},
      {3, "K to end.", "kkk"},
      {3, "knit all sts", "kkk"},
      {3, "Knit around.", "kkk"},
      {3, "Knit every stitch to end of rnd.", "kkk"},
      {3, "k to end of round (3 sts)", "kkk"},
      {4, "knit 2, k 2", "kkkk"},
      {4, "knit two sts, k next 2 sts.", "kkkk"},
      {3, "k1, m1, k1, M1R, k1, m1l", "klkrkl"},
      {3, "K, m1l, K, K", "klkk"},
      {2, "kfb, kfb", "klkl"},
      {3, "kfb in each st around. (6 sts)", "klklkl"},
      {3, "Kfb 3 times - 6 sts.", "klklkl"},
      {6, "k2tog, ssk, k2tog [3 sts]", "tst"},
      {6, "k2tog to end", "ttt"},
      {6, "k2tog around", "ttt"},
      {6, "ssk 2 times, k2tog once", "sst"},
      {4, "[K2, m1l] 2 times. (6 sts)", "kklkkl"},
      {4, "(k2, m1l) 2 times", "kklkkl"},
      {4, "(k2, m1l) x 2", "kklkkl"},
      {4, "(k2, m1l) x2", "kklkkl"},
      {4, "(k2, m1l) 2x (6)", "kklkkl"},
      {4, "(k2, m1l) \xC3\x97 2", "kklkkl"},
      {4, "(k2, m1l) twice", "kklkkl"},
      {4, "[k2, m1l] two times", "kklkkl"},
      {4, "[k2, m1l] to end", "kklkkl"},
      {4, "[k2, m1l], repeat 2 times", "kklkkl"},
      {4, "*K2, m1l; rep from * to end.", "kklkkl"},
      {4, "*K2, m1l; rep from * around.", "kklkkl"},
      {4, "*K2, m1l; rep from * to end of rnd.", "kklkkl"},
      {4, "*k2, M1L, repeat from *. (6 sts)", "kklkkl"},
      {4, "*k2, m1l; rep from * 1 more time", "kklkkl"},
      {4, "*k2, m1l; rep from * once more", "kklkkl"},
      {4, "*k2, m1l; rep from * 1 time", "kklkkl"},
      {4, "*k2, m1l* 2 times", "kklkkl"},
      {4, "*k2, m1l*; rep from * to end", "kklkkl"},
      {5, "*k2, m1; rep from * to last st, k1", "kklkklk"},
      {7, "k1, *k2, m1; rep from * to last 2 sts, k2tog", "kkklkklt"},
      {7, "k1, *k2, m1; rep from * until 2 sts remain, k2tog", "kkklkklt"},
      {6, "K to last 2 sts, ssk", "kkkks"},
      {6, "[[k1, m1l] 2 times, k1] 2 times", "klklkklklk"},
      {6, "*[k1, m1l] twice, k1; rep from * to end", "klklkklklk"},
      {2, "pm, k1, sm, k1, place marker, slip the marker", "kk"},
      {2, "Join to work in the round, k2", "kk"},
      {2, "p1, purl 1", "kk"},
      {2, "K1 tbl, sl1", "kk"},
      {4, "K2 and k1, then k1; ", "kkkk"},
  };
  for (const Case& c : cases) {
    CAPTURE(c.words);
    const ReadPattern read = one_round(c.before, c.words);
    CHECK(hands(read) == c.hands);
    CHECK(told(read).empty());
  }
}

TEST_CASE("three into one is counted, though Rounds cannot hold it") {
  const ReadPattern read =
      read_pattern("CO 6 sts\nRnd 1: s2kp, k3tog (2 sts)\nRnd 2: Knit. (2 sts)\nBO 2 sts.");
  CHECK(told(read).empty());
  CHECK(read.rounds_read == 2);
  CHECK(read.stitches == 10);
  CHECK(read.rounds.rounds.empty());
  CHECK(read.closed_with == 2);
}

TEST_CASE("what is wrong with a round is said in plain words") {
  const std::string at = "line 2: Rnd 1";
  CHECK(why(4, "Kint.") == at + ": the word \"kint\" is not known.\n");
  CHECK(why(4, "K3, m11") == at + ": the word \"m11\" is not known.\n");
  CHECK(why(4, "[K2, m1l 2 times. (6 sts)") == at + ": the bracket \"[\" is not closed.\n");
  CHECK(why(4, "(K2, m1l] 2 times.") == at + ": a \"]\" closes a bracket that is not open.\n");
  CHECK(why(4, "K2, m1l] 2 times.") == at + ": a \"]\" closes a bracket that is not open.\n");
  CHECK(why(4, "[K2, m1l] times.") == at + ": \"times\" stands without a number.\n");
  CHECK(why(4, "[K2, m1l] 2.") == at + ": the number 2 after the bracket has no \"times\".\n");
  CHECK(why(4, "[K2, m1l].") == at + ": a bracket closes and nothing says how many times it is worked.\n");
  CHECK(why(4, "[K2] 0 times.") == at + ": the repeat is asked for 0 times.\n");
  CHECK(why(4, "[] 2 times, k4") == at + ": the repeat holds nothing to work.\n");
  CHECK(why(4, "*K2, m1l.") == at + ": the * is never repeated; \"rep from *\" and how often is missing.\n");
  CHECK(why(4, "K2, m1l; rep from * to end") == at + ": \"rep\" has no * to repeat from.\n");
  CHECK(why(13, "*K4, k1; rep from * to end") == at + ": the repeat takes 5 stitches, and 13 are left.\n");
  CHECK(why(4, "*m1l; rep from * to end") ==
        at + ": the repeat takes no stitches, so it never comes to the end.\n");
  CHECK(why(4, "K3, k2tog.") == at + ": k2tog takes 2 stitches, and 1 is left.\n");
  CHECK(why(4, "[K2, m1l] 3 times") == at + ": the repeat 3 times takes 6 stitches, and 4 are left.\n");
  CHECK(why(4, "K3.") == at + " leaves 1 stitch of the round before unworked.\n");
  CHECK(why(4, "K4, m1l. (6 sts)") == at + " makes 5 stitches, the line says 6.\n");
  CHECK(why(4, "K to last 5 sts") == at + ": 5 stitches are to be kept, and 4 are left.\n");
  CHECK(why(4, "[[[k1] 2 times] 2 times] 1 time") ==
        at + ": repeats stand more than 2 deep; write the inner one out.\n");
  CHECK(why(4, "[k to end] 2 times") == at + ": a repeat to the end stands within another repeat.\n");
  CHECK(why(4, "Rep Rnd 1.") == at + ": it repeats other rounds by their numbers; write those rounds out.\n");
  CHECK(why(4, "") == at + ": it says nothing to work.\n");
  CHECK(why(4, "K4 (4 sts) k2tog") == at + ": \"k2tog\" stands behind the count; the count comes last.\n");
  CHECK(why(4, "[[m1l] 999999999 times] 999999999 times, k4") ==
        at + ": it makes more than 100000 stitches.\n");
  CHECK(why(4, "[k999999999] 999999999 times") ==
        at + ": the repeat 999999999 times takes 999999998000000001 stitches, and 4 are left.\n");
}

TEST_CASE("what is wrong with the rounds' order is said where it shows") {
  const auto after = [](const std::string& lines) { return told(read_pattern("CO 6 sts.\n" + lines)); };
  CHECK(after("Rnd 1: Knit.\nRnd 2: Knit.\nBO all.") == "");
  CHECK(after("Rnd 1: Knit.\nNext rnd: Knit.\nRnd 3: Knit.") == "");
  CHECK(after("Rnds 1-4: Knit.\nRnds 5 and 6: Knit.\nRnds 7 to 9: Knit\nRnd 10 (RS): Knit.") == "");
  CHECK(after("Rnds 1-4 (4 rnds): Knit.") == "");
  CHECK(after("Rnd 1: Knit.\nRnd 3: Knit.\nRnd 4: Knit.") ==
        "line 3: Rnd 3 stands here, and Rnd 2 is missing.\n");
  CHECK(after("Rnd 1: Knit.\nRnd 5: Knit.") == "line 3: Rnd 5 stands here, and Rnds 2-4 are missing.\n");
  CHECK(after("Rnd 1: Knit.\nRnd 1: Knit.\nRnd 2: Knit.") ==
        "line 3: Rnd 1 stands here, and Rnd 1 was read already; Rnd 2 comes next.\n");
  CHECK(after("Rnd 2: Knit.\nRnd 3: Knit.") ==
        "line 2: Rnd 2 stands first, and Rnd 1 is missing; if the cast on is Rnd 1, its line must say so.\n");
  CHECK(after("Rnds 3-1: Knit.") == "line 2: Rnd 3: the round numbers run backwards.\n");
  CHECK(after("Rnds 1, 3: Knit.\nRnd 4: Knit.") ==
        "line 2: Rnds 1-3: the rounds do not follow each other; write them in working order.\n");
  CHECK(after("Rnds 1-4 (5 rnds): Knit.") == "line 2: Rnds 1-4: the label says 5 rounds and names 4.\n");
  CHECK(after("Rnd: Knit.\nRnd 2: Knit.") == "line 2: the round has no number.\n");
  CHECK(after("Rnd 1 Knit.\nRnd 2: Knit.") ==
        "line 2: Rnd 1: the colon after the round's number is missing.\n");
  CHECK(after("Rdn 1: Knit.\nRnd 2: Knit.") ==
        "line 2: Rnd 1: the word \"rdn\" is not known; it may stand for \"Rnd\".\n");
  CHECK(after("Rnd 1: Knit.\nBO all.\nRnd 2: Knit.") ==
        "line 4: Rnd 2 comes after the stitches were closed in line 3.\n");
  CHECK(after("Rnds 1-999999999: Knit.") ==
        "line 2: Rnds 1-999999999 are more than 10000 rounds in one line.\n");
}

TEST_CASE("cast on and closing are found in prose") {
  const auto cast_on = [](const std::string& line) {
    return read_pattern(line + "\nRnd 1: Knit.").rounds.cast_on;
  };
  CHECK(cast_on("Using double-pointed needles, CO 6 sts. Join to work in the round.") == 6);
  CHECK(cast_on("cast on 6 stitches") == 6);
  CHECK(cast_on("Cast on a total of six sts and join.") == 6);
  CHECK(cast_on("Abbreviations:\nCO: cast on\nBO / CO cast on 9 sts\nCast on with 3.5 mm needles.\nCO 6.") ==
        6);
  CHECK(read_pattern("Rnd 1: CO 6 sts. (6 sts)\nRnd 2: Knit.").mistakes.empty());
  CHECK(read_pattern("CO 6 sts (Rnd 1).\nRnd 2: Knit.").mistakes.empty());
  CHECK(told(read_pattern("Rnd 1: K6. (6 sts)\nRnd 2: Knit. (6 sts)")) ==
        "line 1: Rnd 1 begins and no stitches are cast on; say \"CO 6 sts\" before it.\n");
  CHECK(told(read_pattern("CO 6 sts.\nCO 8 sts.\nRnd 1: K6.")) ==
        "line 2: casts on 8 stitches, and 6 are cast on already.\n");
  CHECK(told(read_pattern("Rnd 1: CO 6 sts. (8 sts)\nRnd 2: K6.")) ==
        "line 1: the cast on makes 6 stitches, the line says 8.\n");
  CHECK(told(read_pattern("Rnd 1: CO 6 sts, k2tog.\nRnd 2: K6.")) ==
        "line 1: Rnd 1 casts on and works \"k2tog\"; give what is worked a round of its own.\n");
  CHECK(told(read_pattern("CO 0 sts.\nRnd 1: K6.")) ==
        "line 1: casts on 0 stitches; give a number from 1 to 100000.\n");

  const auto closed = [](const std::string& line) {
    return read_pattern("CO 6 sts.\nRnd 1: Knit.\n" + line);
  };
  for (const char* line :
       {"BO all.", "BO all 6 sts", "Bind off.",
        "Break yarn, thread through remaining 6 sts and pull tightly.", "Cut the yarn and draw yarn through.",
        "Draw the tail through the remaining six stitches.", "Rnd 2: BO all sts.",
        "Rnd 2: Knit. (6 sts) Break yarn, thread through remaining 6 sts.",
        "Rnd 2: Knit, break yarn and thread through all 6 sts."}) {
    CAPTURE(line);
    const ReadPattern read = closed(line);
    CHECK(told(read).empty());
    CHECK(read.closed_with == 6);
  }
  CHECK(closed("Weave in ends.").closed_with == 0);
  CHECK(told(closed("Thread through remaining 7 sts.")) ==
        "line 3: closes 7 stitches, and 6 are on the needles.\n");
  CHECK(
      told(closed("BO all.\nLeg: CO 4 sts.\nRnd 1: Knit.")) ==
      "line 4: another cast on stands here, and one piece is read; put each piece into a text of its own.\n");
}

TEST_CASE("prose is passed over, wrapped lines are joined") {
  const ReadPattern read = read_pattern(
      "\xEF\xBB\xBF# Ball\r\n\r\n**Gauge:** 22 sts and 34 rnds = 10 cm (4 in)\r\nRound the corners with "
      "care.\r\n"
      "Rounds 1 to 3 form the base.\r\n"
      "Using double-pointed needles of the size that gives you the gauge above, cast on\r\n6 sts. Join.\r\n"
      "- **Rnd 1:** \\*K1, m1l; rep from \\* to end. (12 sts)\r\n"
      "Rnd 2: K1, m1l, k1,\r\n  m1l, k10.\r\n  (14 sts)\r\n"
      "Stuff firmly: 20 g are enough.\r\n"
      "Rnd 3: Knit. (14 sts) Rnd 4: [k2tog] 7 times. (7 sts)\r\n"
      "Break yarn, thread through the remaining stitches of the last round, which are\r\n7 sts, and "
      "pull.\r\n");
  CHECK(told(read).empty());
  CHECK(read.rounds_read == 4);
  CHECK(read.rounds.last_count() == 7);
  CHECK(read.closed_with == 7);
}

TEST_CASE("a pattern in HTML is read by its elements") {
  const ReadPattern read = read_pattern(
      "<!DOCTYPE html><html><head><title>Rnd 9: K9</title><style>p { margin: 0 }</style></head>\n<body>\n"
      "<script>if (1 < 2) document.write('Rnd 7: x');</script><svg><text>Rnd 8: K8</text></svg>\n"
      "<p>Using needles, <b>CO 6&nbsp;sts</b>.</p>\n"
      "<p><strong>Rnd&#160;1:</strong> &#42;K1, <abbr title=\"make 1 left\">m1l</abbr>; rep from &#x2A; to "
      "end.\n"
      "  (12 sts)</p>\n"
      "<ul><li>Rnds 2&ndash;4: Knit. (12 sts)</li><li>Rnd 5: (k2tog) &times; 6 (6 sts)</ul>\n"
      "<table><tr><td>Rnd 6:</td><td>K6.</td><td>(6 sts)</td></tr><tr><td>Rnd 7: Knit.</td><td>Rnd 8: "
      "Knot.</td>"
      "</tr></table>\n<!-- <p>Rnd 9: K1</p> --><div>BO all.</div></body></html>");
  CHECK(told(read) == "line 8: Rnd 8: the word \"knot\" is not known.\n");
  CHECK(read.rounds_read == 8);
  CHECK(read.rounds.rounds.size() == 7);
  CHECK(read.stitches == 6 + 4 * 12 + 3 * 6);
}

TEST_CASE("balls as they are published are read without a mistake") {
  const char* const balls[] = {
      "Small Ball\n\nCO 6 sts. Join, being careful not to twist. Place marker.\nRnd 1: Knit.\n"
      "Rnd 2: [K1, m1l] 6 times. (12 sts)\nRnd 3: Knit.\nRnd 4: [K2, m1l] 6 times. (18 sts)\nRnds 5-9: "
      "Knit.\n"
      "Rnd 10: [K1, k2tog] 6 times. (12 sts)\nRnd 11: Knit.\nStuff the ball.\nRnd 12: [K2tog] 6 times. (6 "
      "sts)\n"
      "Break yarn, thread through remaining 6 sts and pull tightly. Fasten off.\n",
      "Tiny Ball\nCast on 3 stitches.\nRound 1: Kfb in each st. (6 sts)\nRound 2: *k1, M1L, repeat from *. "
      "(12 sts)\n"
      "Rounds 3-6: Knit.\nRound 7: *k2tog, repeat from *. (6 sts)\nRound 8: *ssk; rep from * to end. [3 "
      "sts]\n"
      "Cut yarn, draw yarn through.\n",
      "Ball\nUsing DPNs CO 6 sts (Rnd 1).\nRnd 2: *Kfb; rep from * to end - 12 sts.\nRnd 3 and all that "
      "follow are "
      "worked plain unless told.\nRnd 3: K to end.\nRnd 4: *K2, m1r; rep from * to last 2 sts, k2. (17 sts)\n"
      "Rnd 5: K15, ssk. (16 sts)\nRnd 6: *K2, k2tog; rep from * 3 more times. (12 sts)\nBind off all 12 "
      "sts.\n"};
  const std::size_t rounds[] = {12, 8, 5};
  for (std::size_t i = 0; i < 3; ++i) {
    const ReadPattern read = read_pattern(balls[i]);
    CHECK(told(read).empty());
    CHECK(read.rounds_read == rounds[i]);
    CHECK(read.rounds.rounds.size() == rounds[i]);
    CHECK(read.closed_with == read.rounds.last_count());
  }
}

TEST_CASE("a thousand random patterns come back as they were") {
  for (std::uint32_t seed = 1; seed <= 1000; ++seed) {
    const Rounds rounds = test_support::random_pattern_rounds(seed);
    const auto style = static_cast<Style>(seed % 4);
    const std::string text = RandomWriter::joined(RandomWriter(style, seed).lines(rounds, false));
    CAPTURE(seed, text);
    const ReadPattern read = read_pattern(text);
    REQUIRE(told(read).empty());
    REQUIRE(read.rounds == rounds);
    REQUIRE(read.rounds_read == rounds.rounds.size());
    REQUIRE(read.closed_with == rounds.last_count());
  }
}
