// What is said of a rhythm: in words, and what it costs.
#include "knit/rhythm/rhythm_words.h"

#include "tests/support/catch.h"

using namespace knit;

namespace {

// The ball of 12 cm at 22 x 32.
TubeRhythm ball() {
  TubeRhythm rhythm;
  rhythm.plan.segments = {{SegmentKind::pre, 2, 8, 6},
                          {SegmentKind::pre, 3, 8, 3},
                          {SegmentKind::plain, 16, 0, 1},
                          {SegmentKind::post, 3, -8, 3},
                          {SegmentKind::post, 2, -8, 6}};
  rhythm.plan.counts = counts_of(8, rhythm.plan.segments);
  rhythm.plan.seen.local = 3.07;
  rhythm.plan.seen.row = 30;
  rhythm.plan.within = true;
  return rhythm;
}

}  // namespace

TEST_CASE("a rhythm is one sentence, its cost and its width are two more") {
  CHECK(rhythm_sentences(ball(), 82.94, 22.0) ==
        std::vector<std::string>{
            "Shaped in a rhythm: 8 increases every 2nd round 6 times, every 3rd round 3 times, then 8 "
            "decreases "
            "every 3rd round 3 times, every 2nd round 6 times.",
            "The circumference is never seen more than 3.1 % off the shape's.",
            "The widest round has 80 stitches, so the piece is 36.4 cm around; the shape has 37.7 cm."});
  CHECK(rhythm_sentences(ball(), 80.01, 22.0).back().ends_with("36.4 cm around, just as the shape has it."));
}

TEST_CASE("a rhythm outside the tolerance says by how much, where, and what comes nearer") {
  TubeRhythm rhythm = ball();
  rhythm.plan.within = false;
  rhythm.plan.seen.belt = 4.15;
  CHECK(rhythm_sentences(rhythm, 80.0, 22.0).at(1) ==
        "No rhythm stays within 3.5 %: this one is off by 4.2 % at round 31. Smaller stitches come nearer; a "
        "tolerance of 4.2 % accepts it.");
  rhythm.from = 12;
  CHECK(rhythm_sentences(rhythm, 80.0, 22.0).front().starts_with("From round 13 on shaped in a rhythm: "));
  rhythm.none = NoRhythm::few_rows;
  CHECK(rhythm_sentences(rhythm, 80.0, 22.0).empty());
}

TEST_CASE("a rhythm's turns that come once, every round, or again after another rest") {
  CHECK(segments_sentence(std::vector<RhythmSegment>{{SegmentKind::pre, 1, 6, 3},
                                                     {SegmentKind::pre, 2, 6, 2},
                                                     {SegmentKind::post, 2, 6, 4},
                                                     {SegmentKind::pre, 11, 6, 2},
                                                     {SegmentKind::post, 3, 6, 1},
                                                     {SegmentKind::plain, 4, 0, 1},
                                                     {SegmentKind::post, 5, -1, 1}}) ==
        "6 increases every round 3 times, every 2nd round twice and again 4 times, every 11th round twice, "
        "once more, then 1 decrease once");
  CHECK(segments_sentence(std::vector<RhythmSegment>{{SegmentKind::plain, 40, 0, 1}}).empty());
}

TEST_CASE("of more than six rhythms only how many rounds shape and how far apart they are is said") {
  CHECK(segments_sentence(std::vector<RhythmSegment>{{SegmentKind::pre, 2, 6, 2},
                                                     {SegmentKind::post, 2, 6, 1},
                                                     {SegmentKind::pre, 1, 6, 2},
                                                     {SegmentKind::pre, 2, 12, 2},
                                                     {SegmentKind::plain, 2, 0, 1},
                                                     {SegmentKind::post, 4, 6, 2},
                                                     {SegmentKind::pre, 7, -6, 1},
                                                     {SegmentKind::post, 1, -6, 3}}) ==
        "9 rounds of 6 to 12 increases, 1 to 4 rounds apart, then 4 rounds of 6 decreases, one after the "
        "other");
}

TEST_CASE("the words of halves that are shaped apart say which half and how far each is off") {
  TubeRhythm rhythm;
  rhythm.plan.counts = {8, 12, 14, 14, 12};
  rhythm.plan.fronts = {4, 6, 8, 8, 8};
  rhythm.plan.segments = {
      {SegmentKind::pre, 1, 4, 1, 2}, {SegmentKind::pre, 1, 2, 1, 2}, {SegmentKind::pre, 2, -2, 1, 0}};
  rhythm.plan.front_off = 2.85;
  rhythm.plan.back_off = 7.25;
  rhythm.plan.within = true;
  const std::vector<std::string> told = rhythm_sentences(rhythm, 14.0, 22.0);
  REQUIRE(told.size() == 4);
  CHECK(
      told[0] ==
      "Shaped in a rhythm: 4 increases in front and back alike once, then 2 increases in front once, then 2 "
      "decreases at the back once.");
  CHECK(
      told[1] ==
      "Front and back halves differ: the front has 8 stitches at its widest, the back 6; they are never seen "
      "more than 2.9 % and 7.3 % off. The round begins at the middle of the back.");
}
