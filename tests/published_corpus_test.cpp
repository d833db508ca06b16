// Patterns with limbs in the usual forms of published ones, written here: right ones pass, and a wrong one is named in its line,
// once and without mistakes that only follow from it.
#include "knit/reader/checked_pattern.h"
#include "tests/support/catch.h"

using namespace knit;

namespace {

struct PublishedMutant {
  std::string from, to;
  std::size_t line = 0;
  std::string says;  // part of the sentence
};
struct PublishedText {
  std::string name, text;
  std::vector<PublishedMutant> mutants;
};

std::string changed(std::string text, const PublishedMutant& mutant) {
  const std::size_t at = text.find(mutant.from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, mutant.from.size(), mutant.to);
}

// NOLINTBEGIN(cert-err58-cpp)
const std::vector<PublishedText> mittens{
    {"gusset on waste yarn",
     R"(LEFT MITTEN
Using dpns, cast on 32 sts. Place marker and join for working in the round.
Rnds 1-10: *K1, p1; rep from * around. (32 sts)
Next rnd: K15, pm, m1l, k2, m1r, pm, k to end. (34 sts)
Knit 2 rnds.
Inc rnd: K to marker, sm, m1l, k to marker, m1r, sm, k to end. (36 sts)
Knit 2 rnds.
Inc rnd: K to marker, sm, m1l, k to marker, m1r, sm, k to end. (38 sts)
Knit 1 rnd.
Dividing rnd: K to marker, remove marker, place next 8 sts on waste yarn for thumb, cast on 2 sts using backward loop, k to end. (32 sts)
Work even for 15 rnds.
Dec rnd: [K6, k2tog] 4 times. (28 sts)
Next rnd: [K5, k2tog] 4 times. (24 sts)
Next rnd: [K2tog] 12 times. (12 sts)
Cut yarn, thread through remaining 12 sts and fasten off.

THUMB
Slip the 8 thumb sts onto dpns. Rejoin yarn, pick up and knit 3 sts in the gap. (11 sts)
Rnds 1-8: Knit.
Rnd 9: K2tog 5 times, k1. (6 sts)
Cut yarn and thread through remaining sts.
)",
     {{"next 8 sts on waste", "next 9 sts on waste", 10, "makes 31 stitches, the line says 32"},
      {"knit 3 sts in the gap", "knit 4 sts in the gap", 18,
       "12 stitches are on the needle, the line says 11"},
      {"the 8 thumb sts", "the 9 thumb sts", 18, "has 8 stitches, the line says 9"},
      {"Slip the 8 thumb sts onto dpns. Rejoin yarn, pick", "Pick", 18,
       "3 stitches are on the needle, the line says 11; 8 of the thumb are still held (line 10)"}}},
    {"afterthought thumb",
     R"(MITTEN
CO 24 sts and join in the round.
Rnds 1-6: *K2, p2* around. (24 sts)
Rnds 7-15: Knit. (24 sts)
Rnd 16: K1, with waste yarn k5 for thumb, slip these 5 sts back to left needle and knit them again with main yarn, k to end. (24 sts)
Rnds 17-30: Knit. (24 sts)
Rnd 31: Ssk, k8, k2tog, ssk, k8, k2tog. (20 sts)
Rnd 32: Ssk, k6, k2tog, ssk, k6, k2tog. (16 sts)
Graft the remaining 16 sts with kitchener stitch.

THUMB
Remove the waste yarn and place the 10 held sts on needles. Pick up and knit 1 st at each side. (12 sts)
Rnds 1-9: Knit. (12 sts)
Rnd 10: [K2tog] 6 times. (6 sts)
Draw yarn through remaining 6 sts.
)",
     {{"place the 10 held sts", "place the 14 held sts", 12,
       "holder of the thumb has 10 stitches, the line says 14"},
      {"Graft the remaining 16 sts", "Graft the remaining 18 sts", 9, "18 stitches are to be joined"},
      {"Rnd 31: Ssk, k8", "Rnd 31: Ssk, k9", 7, "Rnd 31"}}},
    {"fingerless mitt, held on a stitch holder",
     R"(Cuff
CO 36 sts. Join to work in the round.
Rnds 1-12: [K2, p2] 9 times. (36 sts)
Hand
Rnd 13: K17, m1, k2, m1, k17. (38 sts)
Rnd 14: Knit.
Rnd 15: K17, m1, k4, m1, k17. (40 sts)
Rnd 16: Knit. (40 sts)
Rnd 17: K17, slip 6 sts to a stitch holder, CO 2, k17. (36 sts)
Rnds 18-22: Knit. (36 sts)
Bind off all 36 sts loosely.
Thumb
Return the 6 held sts to needles, rejoin yarn.
Rnd 1: K6, pick up and knit 2 sts from the cast-on edge. (8 sts)
Rnds 2-3: Knit.
Bind off all sts.
Make second mitt the same as the first.
)",
     {{"CO 2, k17. (36 sts)", "CO 3, k17. (36 sts)", 9, "makes 37 stitches"},
      {"Bind off all 36 sts", "Bind off all 35 sts", 11, "closes 35 stitches, and 36 are on the needles"},
      {"Return the 6 held sts to needles, rejoin yarn.\n", "\n", 9, "6 stitches are left on the holder"}}},
    {"thumbhole and thumb, told without labels",
     R"(MITT
Cast on 20 sts and join.
Knit 6 rnds.
K8, m1, k4, m1, k8. (22 sts)
K9, place next 4 sts on scrap yarn for the thumb, cast on 2 sts over the gap, k9. (20 sts)
Knit 8 rounds.
K2tog around. (10 sts)
Cut yarn, thread through all sts.
THUMB
Return the thumb sts to the needles. With new yarn, pick up and k 2 sts in the gap. (6 sts)
Knit 5 rnds.
Thread yarn through the remaining 6 sts.
)",
     {{"next 4 sts on scrap", "next 5 sts on scrap", 5,
       "9 stitches are to be worked, and 8 stitches are left"},
      {"k4, m1, k8. (22 sts)", "k4, k8. (22 sts)", 4, "makes 21 stitches, the line says 22"},
      {"k 2 sts in the gap. (6", "k 2 sts in the gap. (7", 10,
       "6 stitches are on the needle, the line says 7"}}},
    {"sock with an afterthought heel and a grafted toe",
     R"(SOCK
CO 32 sts, join in the round.
Rnds 1-10: Knit. (32 sts)
Rnd 11: With waste yarn knit 16 sts for heel, slip these 16 sts back to left needle, k to end. (32 sts)
Rnds 12-24: Knit. (32 sts)
Rnd 25: K1, ssk, k to last 3 sts, k2tog, k1. (30 sts)
Rnd 26: Knit. (30 sts)
Rnds 27-32: Repeat rnds 25 and 26. (24 sts)
Graft the remaining 24 sts.
HEEL
Remove waste yarn and place the 32 heel sts back on needles, pick up 1 st at each side. (34 sts)
Rnd 1: K2tog, k15, k2tog, k15. (32 sts)
Graft the toe of the heel together (16 sts on each needle).
)",
     {{"rnds 25 and 26. (24 sts)", "rnds 25 and 26. (26 sts)", 8, "makes 24 stitches, the line says 26"},
      {"the 32 heel sts", "the 36 heel sts", 11, "holder of the heel has 32 stitches, the line says 36"}}},
    {"gusset between markers, told by its stitches",
     R"(MATERIALS: 50 g worsted yarn, set of 4 dpns, stitch holder, tapestry needle
GAUGE: 20 sts = 4 inches

CUFF
With smaller needles, CO 36 sts loosely. Divide sts evenly over 3 needles. Join, being careful not to twist sts.
Work in k1, p1 rib for 2 inches.
Change to larger needles and knit 2 rnds.

THUMB GUSSET
Rnd 1: Knit 17, place marker, M1, knit 2, M1, place marker, knit to end of rnd - 38 sts.
Rnds 2 and 3: Knit.
Rnd 4: Knit to marker, slip marker, M1, knit to next marker, M1, slip marker, knit to end of rnd - 40 sts.
Repeat Rnds 2-4 until there are 12 sts between markers. (46 sts)
Next Rnd: Knit to marker, place 12 gusset sts on holder, CO 4 sts, knit to end of rnd - 38 sts.

HAND
Knit every rnd until piece measures 8 inches from beginning.
Shape Top
Rnd 1: *K2, k2tog; rep from * to last 2 sts, k2. (29 sts)
Rnd 2: Knit.
Rnd 3: *K1, k2tog; repeat from * to last 2 sts, k2. (20 sts)
Rnd 4: *K2tog; repeat from * around. (10 sts)
Cut yarn, leaving a 6 inch tail. Thread tail through remaining sts, pull tight and fasten securely.

THUMB
Place thumb sts on needles. Join yarn and pick up 2 sts at the base of thumb - 14 sts.
Knit 10 rnds.
Next Rnd: K2tog around - 7 sts.
Cut yarn and draw through sts.
)",
     {{"Place thumb sts on needles. Join yarn and pick up 2 sts at the base of thumb - 14",
       "Place thumb sts on needles. Join yarn and pick up 3 sts at the base of thumb - 14", 26,
       "15 stitches are on the needle, the line says 14"},
      {"Next Rnd: K2tog around - 7", "Next Rnd: K2tog around - 8", 28, "makes 7 stitches, the line says 8"},
      {"place 12 gusset sts", "place 13 gusset sts", 14, "makes 37 stitches, the line says 38"}}},
};

const std::vector<PublishedText> gloves{
    {"glove fingers",
     R"(GLOVE
CO 40 sts. Join in the round.
Rnds 1-20: Knit. (40 sts)
Little finger
Rnd 1: K5, place next 30 sts on waste yarn for hand, CO 2 sts over the gap, k5. (12 sts)
Rnds 2-15: Knit. (12 sts)
Rnd 16: [K2tog] 6 times. (6 sts)
Break yarn, draw through remaining 6 sts.
Hand
Place the 30 held sts of the hand back on the needles. Rejoin yarn, pick up and knit 2 sts at the base of the little finger. (32 sts)
Rnds 1-2: Knit. (32 sts)
Ring finger
Rnd 1: K6, place next 20 sts on waste yarn for other fingers, CO 2 sts over the gap, k6. (14 sts)
Rnds 2-18: Knit. (14 sts)
Rnd 19: [K2tog] 7 times. (7 sts)
Break yarn, draw through remaining 7 sts.
Middle finger
Place the 20 held sts of the other fingers on needles, pick up and knit 2 sts in the gap. (22 sts)
Rnds 1-20: Knit. (22 sts)
Bind off all sts.
)",
     {{"place next 20 sts on waste yarn", "place next 22 sts on waste yarn", 13,
       "6 stitches are to be worked, and 4 stitches are left"},
      {"Place the 30 held sts", "Place the 32 held sts", 10, "has 30 stitches, the line says 32"},
      {"Place the 20 held sts of the other fingers", "Place the 20 held sts of the thumb", 18,
       "there are no held stitches of the thumb; held are 20 of the fingers (line 13)"}}},
    {"two fingers from holders",
     R"(GLOVE
Cast on 24 sts.
Rnds 1-5: Knit. (24 sts)
Rnd 6: K12, place next 12 sts on a holder for second finger, CO 2 sts. (14 sts)
FIRST FINGER
Rnds 7-10: Knit. (14 sts)
Rnd 11: [K2tog] 7 times. (7 sts)
Cut yarn and pull through the remaining 7 sts.
SECOND FINGER
Rnd 1: Knit across the 12 held sts of second finger, pick up and knit 2 sts along the gap. (14 sts)
Rnds 2-5: Knit. (14 sts)
Rnd 6: [K2tog] 7 times. (7 sts)
Cut yarn and pull through the remaining 7 sts.
)",
     {{"Rnd 11: [K2tog] 7 times. (7", "Rnd 11: [K2tog] 7 times. (8", 7,
       "Rnd 11 makes 7 stitches, the line says 8"},
      {"the 12 held sts of second", "the 12 held sts of third", 10,
       "there are no held stitches of the third finger"}}},
};

const std::vector<PublishedText> yokes{
    {"raglan from the top",
     R"(YOKE
CO 60 sts. Join to work in the round.
Rnd 1: Knit. (60 sts)
Rnd 2: [K14, m1, k1, m1] 4 times. (68 sts)
Rnd 3: Knit. (68 sts)
BODY
Separating rnd: K17, place next 17 sts on waste yarn for left sleeve, cast on 4 sts for underarm, k17, place next 17 sts on waste yarn for right sleeve, cast on 4 sts for underarm. (42 sts)
Work 20 rnds in stockinette.
Bind off all 42 sts.
LEFT SLEEVE
Place the 17 held sts of the left sleeve on needles. Beginning at centre of underarm, pick up and knit 4 sts along the underarm edge. (21 sts)
Knit 10 rnds.
Dec rnd: K1, k2tog, k to last 3 sts, ssk, k1. (19 sts)
Bind off all sts.
RIGHT SLEEVE
Work as for left sleeve.
)",
     {{"k17, place next 17 sts on waste yarn for right", "k17, place next 16 sts on waste yarn for right", 7,
       "leaves 1 stitch of the round before unworked"},
      {"of the left sleeve on", "of the left leg on", 11, "there are no held stitches of the left leg"},
      {"for left sleeve, cast on 4 sts", "for left sleeve, cast on 5 sts", 7, "makes 43 stitches"}}},
    {"yoke from below, underarms grafted",
     R"(SLEEVES (make 2)
CO 20 sts.
Rnds 1-12: Knit. (20 sts)
Next rnd: Place first 4 sts on waste yarn for underarm, k to end. (16 sts)
Break yarn, place sts on a holder for sleeve.
BODY
CO 48 sts.
Rnds 1-20: Knit. (48 sts)
Next rnd: K20, place next 4 sts on waste yarn for underarm, k20, place next 4 sts on waste yarn for underarm. (40 sts)
YOKE
Joining rnd: Knit across 16 sts of sleeve, k20, knit across 16 sts of sleeve, k20. (72 sts)
Rnd 1: [K2tog, k4] 12 times. (60 sts)
Bind off all 60 sts.
Graft 4 sts at each underarm.
)",
     {{"K20, place next 4 sts on waste yarn for underarm, k20, place",
       "K21, place next 4 sts on waste yarn for underarm, k20, place", 9,
       "4 stitches are to go on a holder, and 3 stitches are left"},
      {"of sleeve, k20. (72 sts)", "of sleeve, k20. (71 sts)", 11, "makes 72 stitches, the line says 71"}}},
    {"vest with shoulders bound off together",
     R"(BACK
CO 30 sts.
Rows 1-20: Knit. (30 sts)
Row 21: K10, BO 10 sts, k10. (20 sts)
Place sts on a holder for back shoulders.
FRONT
CO 30 sts.
Rows 1-20: Knit. (30 sts)
Row 21: K10, BO 10 sts, k10. (20 sts)
Join shoulders to back sts with a three-needle bind off.
)",
     {{"FRONT\nCO 30 sts.\nRows 1-20: Knit. (30 sts)\nRow 21: K10, BO 10 sts, k10. (20 sts)",
       "FRONT\nCO 31 sts.\nRows 1-20: Knit. (31 sts)\nRow 21: K10, BO 10 sts, k11. (21 sts)", 10,
       "two live ends are joined, and they have 21 and 20 stitches"},
      {"Row 21: K10, BO 10 sts, k10. (20 sts)\nPlace", "Row 21: K10, BO 9 sts, k10. (20 sts)\nPlace", 4,
       "leaves 1 stitch"}}},
    {"raglan in rows, both sleeves alike",
     R"(Cardigan
Using 4mm circular needle cast on 80 sts.
Row 1: K16, pm, k10, pm, k28, pm, k10, pm, k16.
Row 2: Purl.
Row 3: [K to 1 st before marker, kfb, sm, kfb] 4 times, k to end. (88 sts)
Row 4: Purl.
Repeat rows 3 and 4 five more times. (128 sts)
Next row: K22, place next 22 sts on waste yarn for sleeve, CO 4 sts, k40, place next 22 sts on waste yarn for sleeve, CO 4 sts, k22. (92 sts)
Continue in stockinette for 30 rows.
Bind off loosely.
Sleeves
Place 22 sts from waste yarn onto needles, pick up and knit 4 sts at underarm. (26 sts)
Knit 30 rounds.
Bind off.
Work second sleeve the same.
)",
     {{"place next 22 sts on waste yarn for sleeve, CO 4 sts, k40",
       "place next 22 sts on waste yarn for sleeve, CO 3 sts, k40", 8, "makes 91 stitches, the line says 92"},
      {"Repeat rows 3 and 4 five", "Repeat rows 3 and 4 four", 7,
       "the repeat makes 120 stitches, the line says 128"}}},
};

const std::vector<PublishedText> toys{
    {"legs first, knitted up into the body",
     R"(MATERIALS
Worsted yarn, 4 mm dpns, 2 stitch holders, waste yarn
NOTES
Leg sts are held on a holder until the body begins.

RIGHT LEG
CO 6 sts. Join to work in the round.
Rnd 1: [Kfb] 6 times. (12 sts)
Rnds 2-9: Knit. (12 sts)
Cut yarn. Leave sts on a spare needle.
LEFT LEG
Work as for right leg but do not cut yarn.
BODY
Rnd 10: K12, CO 2 sts, knit across held 12 sts of right leg, CO 2 sts. (28 sts)
Rnds 11-20: Knit. (28 sts)
Rnd 21: [K2, k2tog] 7 times. (21 sts)
Rnd 22: [K1, k2tog] 7 times. (14 sts)
Stuff legs and body firmly.
Rnd 23: [K2tog] 7 times. (7 sts)
Cut yarn, thread through remaining 7 sts and pull tight.
)",
     {{"Rnd 10: K12", "Rnd 10: K11", 14, "leaves 1 stitch"},
      {"sts of right leg, CO 2", "sts of right arm, CO 2", 14,
       "there are no held stitches of the right arm; held are 12 of the right leg (line 10)"},
      {"[K2, k2tog] 7 times. (21", "[K2, k2tog] 7 times. (22", 16, "makes 21 stitches, the line says 22"}}},
    {"arms picked up, head from held sts",
     R"(BODY
Cast on 8 sts and join in the round.
Rnd 1: Kfb around. (16 sts)
Rnd 2: Knit.
Rnd 3: [K1, kfb] 8 times. (24 sts)
Rnds 4-12: Knit. (24 sts)
Rnd 13: K3, bind off 4 sts, k8, bind off 4 sts, k5. (16 sts)
Place the remaining 16 sts on a holder for head.
ARMS (make 2)
Pick up and knit 10 sts around the armhole.
Rnds 1-8: Knit. (10 sts)
Rnd 9: [K2tog] 5 times. (5 sts)
Break yarn and thread through remaining 5 sts.
HEAD
Place the 16 held sts of the head on needles. Rejoin yarn.
Rnd 1: [K1, m1] 16 times. (32 sts)
Rnds 2-9: Knit. (32 sts)
Rnd 10: [K2tog] 16 times. (16 sts)
Rnd 11: [K2tog] 8 times. (8 sts)
Break yarn and thread through remaining 8 sts.
)",
     {{"Place the 16 held sts of the head", "Place the 18 held sts of the head", 15,
       "has 16 stitches, the line says 18"},
      {"HEAD\nPlace the 16 held sts of the head on needles. Rejoin yarn.\nRnd 1: [K1, m1] 16 times. (32 "
       "sts)\nRnds 2-9: Knit. (32 "
       "sts)\nRnd 10: [K2tog] 16 times. (16 sts)\nRnd 11: [K2tog] 8 times. (8 sts)\nBreak yarn and thread "
       "through remaining 8 sts.\n",
       "", 8, "16 stitches are left on the holder of the head"},
      {"remaining 5 sts", "remaining 6 sts", 13, "closes 6 stitches, and 5 are on the needles"}}},
    {"octopus, legs made alike",
     R"(LEGS (make 4)
CO 6 sts.
Rnds 1-10: Knit. (6 sts)
Cut yarn and place sts on waste yarn.
HEAD
Rnd 1: Knit across 6 held sts, knit across 6 held sts, knit across 6 held sts, knit across 6 held sts. (24 sts)
Rnd 2: [K3, m1] 8 times. (32 sts)
Rnds 3-12: Knit. (32 sts)
Rnd 13: [K2tog] 16 times. (16 sts)
Rnd 14: [K2tog] 8 times. (8 sts)
Fasten off.
)",
     {{"LEGS (make 4)", "LEGS (make 5)", 4, "6 stitches are left on the holder of the legs"},
      {"LEGS (make 4)", "LEGS (make 3)", 6, "there are no held stitches"},
      {"[K3, m1] 8 times. (32", "[K3, m1] 8 times. (30", 7, "makes 32 stitches, the line says 30"}}},
    {"trousers divided at the crotch",
     R"(TROUSERS
CO 40 sts. Join to work in the round, being careful not to twist.
Rnds 1-10: Knit. (40 sts)
Dividing rnd: K20, place the remaining 20 sts on hold for left leg. (20 sts)
RIGHT LEG
Cast on 2 sts using the backward loop method, join in the round. (22 sts)
Rnds 1-12: Knit. (22 sts)
Bind off all 22 sts.
LEFT LEG
Transfer the 20 held sts to needles, rejoin yarn and pick up and knit 2 sts from the crotch. (22 sts)
Rnds 1-12: Knit. (22 sts)
Bind off.
)",
     {{"K20, place the remaining 20 sts", "K21, place the remaining 20 sts", 4,
       "20 stitches are to go on a holder, and 19 stitches are left"},
      {"Cast on 2 sts using", "Cast on 3 sts using", 6, "23 stitches are on the needle, the line says 22"},
      {"Transfer the 20 held", "Transfer the 19 held", 10, "has 20 stitches, the line says 19"}}},
    {"a tail with repeats of rounds",
     R"(BODY
CO 9 sts.
Rnd 1: [K3, m1] 3 times. (12 sts)
Rnd 2: Knit.
Rnd 3: [K4, m1] 3 times. (15 sts)
Place next 5 sts on a safety pin for tail. (10 sts)
Knit 4 rnds.
Rnd 8: [K2tog] 5 times. (5 sts)
Draw yarn through remaining 5 sts.
TAIL
Put the 5 tail sts back on the needles, pick up 5 sts in the gap. (10 sts)
Rnd 1: Knit. (10 sts)
Rnd 2: Ssk, k to end. (9 sts)
Rep rnds 1-2 four more times. (5 sts)
Work last 2 rnds until 3 sts remain.
Pull yarn through remaining 3 sts.
)",
     {{"Rep rnds 1-2 four", "Rep rnds 1-2 five", 14, "the repeat makes 4 stitches, the line says 5"},
      {"Place next 5 sts on a safety pin", "Place next 6 sts on a safety pin", 6,
       "9 stitches are on the needle, the line says 10"},
      {"Put the 5 tail sts", "Put the 5 wing sts", 11, "there are no held stitches of the wing"}}},
    {"hat with earflaps",
     R"(EARFLAPS (make 2)
CO 5 sts.
Row 1: Knit.
Row 2: K1, m1, k to last st, m1, k1. (7 sts)
Row 3: Knit. (7 sts)
Row 4: K1, m1, k5, m1, k1. (9 sts)
Break yarn and leave on a spare needle.
HAT
Cast on 6 sts, knit across the 9 held sts of one earflap, cast on 12 sts, knit across the 9 held sts of the other earflap, cast on 6 sts. (42 sts)
Rnds 1-12: Knit. (42 sts)
Rnd 13: [K5, k2tog] 6 times. (36 sts)
Break yarn and thread through all sts.
)",
     {{"cast on 12 sts", "cast on 13 sts", 9, "makes 43 stitches, the line says 42"},
      {"k5, m1, k1. (9 sts)", "k5, k1. (9 sts)", 6, "makes 8 stitches, the line says 9"},
      {"(make 2)", "(make 3)", 7, "9 stitches are left on the holder"}}},
    {"bear, arms and legs held and joined in one round",
     R"(ARMS (make 2)
CO 8 sts, join in the round.
Rnds 1-10: Knit. (8 sts)
Break yarn, place sts on a stitch holder.
LEGS (make 2)
CO 10 sts, join in the round.
Rnds 1-8: Knit. (10 sts)
Break yarn, leave sts on waste yarn.
BODY
Place the 10 held sts of one leg on the needles, cast on 3 sts, knit across the 10 held sts of the other leg, cast on 3 sts. (26 sts)
Rnds 1-10: Knit. (26 sts)
Rnd 11: Knit across 8 held arm sts, k13, knit across 8 held arm sts, k13. (42 sts)
Rnd 12: [K4, k2tog] 7 times. (35 sts)
Rnd 13: Knit, decreasing 5 sts evenly. (30 sts)
Rnd 14: *K1, k2tog; rep from * to end. (20 sts)
Rnd 15: K2tog around. Break yarn, thread through remaining 10 sts and fasten off.
)",
     {{"Knit across 8 held arm sts, k13, knit across 8", "Knit across 8 held wing sts, k13, knit across 8",
       12, "there are no held stitches of the wing"},
      {"decreasing 5 sts", "decreasing 6 sts", 14, "makes 29 stitches, the line says 30"},
      {"remaining 10 sts", "remaining 11 sts", 16, "closes 11 stitches, and 10 are on the needles"}}},
    {"bunny, the second leg stays on the needles",
     R"(Bunny

Legs
Cast on 6 stitches and divide over 3 double pointed needles.
Round 1: kfb in each stitch. (12 stitches)
Rounds 2-10: Knit.
Break yarn and slip stitches onto a piece of waste yarn. Make a second leg but leave the stitches on the needles and do not break the yarn.

Body
Joining round: Knit across the 12 stitches of the second leg, then knit across the 12 held stitches of the first leg. (24 stitches)
Round 1: Knit, picking up 1 stitch at each side. (26 stitches)
Rounds 2-12: Knit.
Round 13: k2tog, k9, k2tog, k2tog, k9, k2tog. (22 stitches)
Round 14: Knit.
Stuff the legs and body.
Round 15: (k2tog) 11 times. (11 stitches)
Cut the yarn, pull it through the remaining 11 stitches and fasten off.
)",
     {{"the 12 held stitches of the first", "the 11 held stitches of the first", 10,
       "has 12 stitches, the line says 11"},
      {"1 stitch at each side. (26", "1 stitch at each side. (25", 11,
       "makes 26 stitches, the line says 25"}}},
    {"a beak from held stitches, in short words",
     R"(HEAD
CO 8 sts
Rnd 1: k
Rnd 2: kfb all around (16)
Rnd 3: k
Rnd 4: *k1, kfb* around (24)
Rnd 5-10: k
Slip the first 8 sts to a holder for the beak, k to end. (16)
Rnd 11: k
Rnd 12: k2tog around (8)
Cut yarn and pull through.
BEAK
Slip the 8 held sts onto needle, CO 2 sts. (10)
Rnd 1-2: k
Rnd 3: *k2tog, k3* twice (8)
Rnd 4: k2tog 4 times (4)
Cut yarn, pull through.
)",
     {{"Slip the 8 held sts", "Slip the 9 held sts", 13, "has 8 stitches, the line says 9"},
      {"*k2tog, k3* twice (8)", "*k2tog, k3* twice (9)", 15, "makes 8 stitches, the line says 9"}}},
};
// NOLINTEND(cert-err58-cpp)

// The sentences of the lines that are wrong, or not understood.
std::vector<CheckedLine> complaints_in(const std::string& text) {
  std::vector<CheckedLine> found;
  const CheckedPattern checked = check_pattern(text);
  for (const CheckedLine& line : checked.sizes.front().lines) {
    if (!line.sentence.empty()) found.push_back(line);
  }
  return found;
}
std::string said_of(const std::string& text) {
  std::string said;
  for (const CheckedLine& line : complaints_in(text)) said += line.sentence + "\n";
  return said;
}

void check_published(const std::vector<PublishedText>& texts) {
  for (const PublishedText& one : texts) {
    CAPTURE(one.name);
    CHECK(said_of(one.text) == "");
    CHECK(check_pattern(one.text).verdict == PatternVerdict::holds);
    CHECK(one.mutants.size() >= 2);
    for (const PublishedMutant& mutant : one.mutants) {
      CAPTURE(mutant.from, mutant.to);
      const std::string text = changed(one.text, mutant);
      CHECK(check_pattern(text).verdict == PatternVerdict::does_not_add_up);
      const std::string said = said_of(text);
      CAPTURE(said);
      const std::vector<CheckedLine> wrong = complaints_in(text);
      CHECK(wrong.size() == 1);
      if (wrong.empty()) continue;
      CHECK(wrong.front().number == mutant.line);
      CHECK(said.find(mutant.says) != std::string::npos);
    }
  }
}

}  // namespace

TEST_CASE("published corpus: mittens") { check_published(mittens); }
TEST_CASE("published corpus: gloves") { check_published(gloves); }
TEST_CASE("published corpus: sweaters") { check_published(yokes); }
TEST_CASE("published corpus: toys and hats") { check_published(toys); }

TEST_CASE("published corpus: every line with a mistake is named once, and the reading goes on") {
  const std::string text = R"(FIRST LEG
CO 8 sts.
Rnds 1-4: Knit. (8 sts)
Rnd 5: K3, m1, k5. (10 sts)
Rnd 6: K5, m1, k5. (11 sts)
Break yarn, place sts on a holder.
SECOND LEG
CO 11 sts.
Rnd 1: K5, m1, k5. (12 sts)
Rnd 2: K2tog, k10. (11 sts)
BODY
Rnd 3: K11, k across held 11 sts of first leg, k across held 4 sts of third leg. (22 sts)
Rnd 4: K20. (22 sts)
Rnd 5: Knit. (22 sts)
Bind off 21 sts.
)";
  CHECK(said_of(text) ==
        "line 4: Rnd 5 makes 9 stitches, the line says 10.\n"
        "line 9: Rnd 1 leaves 1 stitch of the round before unworked.\n"
        "line 12: Rnd 3: there are no held stitches of the third leg.\n"
        "line 13: Rnd 4 leaves 2 stitches of the round before unworked.\n"
        "line 15: closes 21 stitches, and 22 are on the needles.\n");
}

TEST_CASE("published corpus: holders and needle are empty in the end") {
  const auto says = [](const std::string& text) {
    const std::vector<CheckedLine> wrong = complaints_in(text);
    return wrong.empty() ? "" : wrong.front().sentence;
  };
  const std::string hand =
      "HAND\nCO 12 sts.\nRnd 1: K4, place next 4 sts on a holder for thumb, CO 2 sts, k4. (10 sts)\n";
  CHECK(says(hand + "BO 10 sts.\n") ==
        "line 3: 4 stitches are left on the holder of the thumb, and no line takes them off.");
  const std::string joined = hand + "Rnd 2: K10, k across the held 4 sts of the thumb. (14 sts)\n";
  CHECK(says(joined) == "");
  CHECK(check_pattern(joined).remark == "14 stitches are on the needles at the end.");
  CHECK(check_pattern(joined + "BO.").remark == "");
  CHECK(says(hand + "Rnd 2: K10, k across the held 4 sts of the thumb. (14 sts)\n"
                    "Rnd 3: K14, k across the held 4 sts of the thumb. (18 sts)\nBO.\n") ==
        "line 5: Rnd 3: there are no held stitches of the thumb.");
  CHECK(says("LEG\nCO 12 sts.\nRnd 1: Knit. (12 sts)\nPlace sts on a holder.\nARM\nCO 6 sts.\n"
             "Rnd 1: Pick up and knit 2 sts in the gap, k6. (8 sts)\nBO 8 sts.\n") ==
        "line 4: 12 stitches are left on the holder of the leg, and no line takes them off.");
  CHECK(check_pattern(
            "LEG\nCO 12 sts.\nRnd 1: Knit. (12 sts)\nARM\nCO 6 sts.\nRnd 1: Knit. (6 sts)\nBO 6 sts.\n")
            .remark == "12 stitches are on the needles where line 5 casts on.");
}
