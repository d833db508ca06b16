// The rhythm in the window: the slider of simplicity and what stands beside it, knitting along, chart, short form.
#include <algorithm>
#include <cmath>
#include <set>

#include "app/explain/rhythm_figures.h"
#include "app/panels/parameters/rhythm_dial.h"
#include "app/panels/pattern/chart_cache.h"
#include "app/panels/pattern/pattern_parts.h"
#include "app/session/document.h"
#include "app/session/view.h"
#include "knit/rhythm/rhythm_plan.h"
#include "knit/rhythm/segments.h"
#include "tests/support/desk.h"
#include "tests/support/session.h"

using namespace desk;

namespace {

knit::Parameters in_rhythm(double dial = 0.0) {
  knit::Parameters parameters = wide_band();
  parameters.timing.kind = knit::TimingKind::arc_length;
  parameters.rows.source = knit::RowSource::contours;
  parameters.stitches.placement = knit::PlacementPolicy::nearest;
  parameters.settle.settling = knit::Settling::off;
  parameters.rhythm.counts = knit::CountPlanning::rhythm;
  parameters.rhythm.dial = dial;
  knit::give_width(parameters, 0.12);
  knit::give_height(parameters, 0.08);
  return parameters;
}

const knit::RhythmPlan& plan_of(const Desk& desk) {
  const auto& rhythms = desk.session.document->timeline.furthest().rhythms;
  REQUIRE(rhythms.size() == 1);
  return rhythms.front()->plan;
}

// So high that all knobs are seen.
struct HighDesk : Desk {
  HighDesk() : Desk(1280, 2400) {}
};

knit::RhythmPlan a_plan() {
  knit::RhythmPlan plan;
  plan.segments = {{knit::SegmentKind::pre, 3, 8, 3},
                   {knit::SegmentKind::plain, 4, 0, 1},
                   {knit::SegmentKind::post, 2, -8, 2}};
  plan.counts = knit::counts_of(8, plan.segments);
  plan.roles = knit::roles_of(plan.segments);
  return plan;
}

}  // namespace

TEST_CASE("a row knows where it stands in its rhythm") {
  const knit::RhythmPlan plan = a_plan();
  REQUIRE(plan.counts.size() == 18);
  const RhythmPlace change = place_in_rhythm(plan, 6);
  CHECK(change.change == 8);
  CHECK(change.turn == 2);
  CHECK(change.turns == 3);
  CHECK(change.to_next == 2);
  CHECK(change.next_grows);
  const RhythmPlace plain = place_in_rhythm(plan, 11);
  CHECK(plain.change == 0);
  CHECK(plain.rest == 2);
  CHECK(plain.rests == 4);
  CHECK(plain.to_next == 2);
  CHECK_FALSE(plain.next_grows);
  CHECK(place_in_rhythm(plan, 0).to_next == 2);
  CHECK(place_in_rhythm(plan, 14).turn == 1);
  CHECK(place_in_rhythm(plan, 16).turn == 2);
  CHECK_FALSE(place_in_rhythm(plan, 16).to_next);
}

TEST_CASE("the place of a row and its deviation are said in words") {
  RhythmFigures figures;
  knit::TubeRhythm rhythm;
  rhythm.plan = a_plan();
  figures.rhythm = knit::Shared(rhythm);
  figures.first_row = 1;
  for (const std::int32_t count : rhythm.plan.counts) {
    figures.planned.push_back(count);
    figures.ideal.push_back(count + 2.0);
    figures.seen.push_back(-2.0);
  }
  const auto words = [&](std::int32_t row) { return rhythm_place_words({figures}, row); };
  CHECK(words(1) == "The rhythm begins; 2 knit rounds until the next increase round.");
  CHECK(words(2) == "Knit round 1 of 2; 1 knit round until the next increase round.");
  CHECK(words(3) == "Knit round 2 of 2; the next round is an increase round.");
  CHECK(words(7) == "Increase round 2 of 3, 8 more stitches; 2 knit rounds until the next increase round.");
  CHECK(words(14) == "Knit round 4 of 4; the next round is a decrease round.");
  CHECK(words(17) == "Decrease round 2 of 2, 8 fewer stitches; nothing is shaped any more.");
  CHECK(words(19).empty());
  CHECK(deviation_words(figures, 11) ==
        "Row 11: 32 planned, 34.0 ideal: 2.0 fewer (5.9 %). Seen over six rows: 5.9 % too narrow.");
}

TEST_CASE("the figures of a run's rhythm are its plan and what its rows hold") {
  Desk desk;
  desk.open(in_rhythm());
  const knit::State& state = desk.session.document->timeline.furthest();
  const auto all = rhythm_figures_of(state);
  REQUIRE(all.size() == 1);
  REQUIRE(all[0].planned.size() == state.fabric.rows().size());
  CHECK(all[0].first_row == 1);
  for (std::size_t i = 0; i < all[0].planned.size(); ++i)
    CHECK(all[0].planned[i] == static_cast<double>(state.fabric.rows()[i]->stitches.size()));
  double worst = 0.0;
  for (std::size_t i = 0; i < all[0].planned.size(); ++i) {
    if (all[0].ideal[i] >= 24.0) worst = std::max(worst, 100.0 * std::abs(all[0].seen[i]) / all[0].ideal[i]);
  }
  CHECK_THAT(worst, Catch::Matchers::WithinAbs(plan_of(desk).seen.local, 1e-9));
}

TEST_CASE("the rhythm's knobs and its slider are there where they are read") {
  HighDesk desk;
  desk.open();
  CHECK(desk.ui.controls.count("knob/counts") == 0);
  knit::Parameters whole = in_rhythm();
  whole.rhythm.counts = knit::CountPlanning::whole;
  desk.open(whole);
  CHECK(desk.ui.controls.count("knob/counts") == 1);
  CHECK(desk.ui.controls.count("knob/rhythm-tolerance") == 0);
  CHECK(desk.ui.controls.count("rhythm/dial") == 0);
  desk.open(in_rhythm());
  for (const char* control : {"knob/counts", "knob/rhythm-tolerance", "knob/rhythm-changes",
                              "knob/rhythm-style", "knob/rhythm-simplicity", "rhythm/dial", "rhythm/length",
                              "rhythm/deviation", "rhythm/fit-size", "plot/rhythm", "plot/rhythm-seen"})
    CHECK(desk.ui.controls.count(control) == 1);
}

TEST_CASE("the slider plans anew while it is held: few rhythms to the right, the shape to the left") {
  HighDesk desk;
  desk.open(in_rhythm());
  const auto drag_to = [&](float share) {
    desk.act(desk.frames({desk.over("rhythm/dial", 0.5f), MouseClick{MouseButton::Left, true}}));
    const Actions wishes = desk.frames({desk.over("rhythm/dial", share)});
    REQUIRE(count_of<Tune>(wishes) == 1);
    CHECK(wishes.front().get<Tune>().held);
    desk.act(wishes);
    desk.session.document->timeline.extend_to_end();
    desk.frame();
    const knit::RhythmPlan plan = plan_of(desk);
    desk.act(desk.frames({MouseClick{MouseButton::Left, false}, MouseLeave{}}));
    return plan;
  };
  const knit::RhythmPlan simple = drag_to(1.0f);
  const auto length = desk.ui.own<RhythmCache>().length();
  const knit::RhythmPlan true_shape = drag_to(0.0f);
  const auto long_length = desk.ui.own<RhythmCache>().length();
  CHECK_THAT(desk.session.document->timeline.parameters().rhythm.dial,
             Catch::Matchers::WithinRel(knit::rhythm_dials().back(), 0.01));
  CHECK(simple.segments.size() < true_shape.segments.size());
  CHECK(simple.seen.rms > true_shape.seen.rms);
  INFO(knit::segments_text(simple.segments) << " | " << knit::segments_text(true_shape.segments));
  REQUIRE(length);
  REQUIRE(long_length);
  CHECK(length->lines < long_length->lines);
}

TEST_CASE("the plots of the plan light the row under the pointer and lead there") {
  HighDesk desk;
  desk.open(in_rhythm());
  for (const char* plot : {"plot/rhythm", "plot/rhythm-seen"}) {
    const Actions clicked = desk.click(plot, 0.6f);
    CHECK(count_of<SeekPlace>(clicked) + count_of<SeekTo>(clicked) == 1);
    REQUIRE(count_of<HoverRounds>(clicked) >= 1);
    for (const Action& wish : clicked) {
      if (const auto* hover = wish.get_if<HoverRounds>(); hover != nullptr && hover->rounds)
        CHECK(hover->rounds->first > static_cast<std::int32_t>(plan_of(desk).counts.size()) / 3);
    }
  }
}

TEST_CASE("knitting along says where the round stands, and writes out what the short form names") {
  Desk desk;
  desk.open(in_rhythm());
  desk.act({ShowSide{SidePanel::pattern}});
  knit::PatternOptions options;
  options.form = knit::PatternForm::short_form;
  desk.act({SetPatternOptions{options}});
  const auto& roles = plan_of(desk).roles;
  const auto shaping = static_cast<std::int32_t>(
                           std::find(roles.begin(), roles.end(), knit::RowRole::change) - roles.begin()) +
                       1;
  desk.act({KnitAlong{shaping}});
  desk.settle();
  CHECK(desk.ui.controls.count("knit-along/rhythm") == 1);
  CHECK(desk.ui.controls.count("knit-along/short-line") == 1);
  const ChartCache& cache = desk.ui.own<ChartCache>();
  CHECK(test_support::contains(cache.rhythm_of(shaping), "Increase round 1 of "));
  CHECK(test_support::contains(cache.line_of(shaping), "m1l"));
  CHECK(test_support::contains(cache.short_line_of(shaping), "nc rnd"));
  CHECK_FALSE(test_support::contains(cache.line_of(shaping), "nc rnd"));
  options.form = knit::PatternForm::full;
  desk.act({SetPatternOptions{options}});
  desk.settle();
  CHECK(desk.ui.controls.count("knit-along/short-line") == 0);
}

TEST_CASE("lines of the short form light their rounds, and a named round all that are worked so") {
  HighDesk desk;
  desk.open(in_rhythm());
  desk.act({ShowSide{SidePanel::pattern}});
  knit::PatternOptions options;
  options.form = knit::PatternForm::short_form;
  desk.act({SetPatternOptions{options}});
  desk.settle();
  const std::vector<PatternLine> lines = lines_of(desk.ui.own<ChartCache>().pattern());
  std::set<std::int32_t> named, shaping;
  for (const PatternLine& line : lines) {
    if (line.kind != PatternLine::Kind::named) continue;
    REQUIRE(line.rounds);
    CHECK(line.label.back() == ':');
    named.insert(line.rounds->first);
    for (const RoundSpan& span : line.twins) named.insert(span.first);
  }
  const auto& roles = plan_of(desk).roles;
  for (std::size_t i = 0; i < roles.size(); ++i) {
    if (roles[i] == knit::RowRole::change) shaping.insert(static_cast<std::int32_t>(i) + 1);
  }
  for (const std::int32_t round : named) CHECK(shaping.count(round) == 1);
  CHECK(named.size() + 2 >= shaping.size());  // one that no name fits is written out
  const std::string mark = "pattern/named/" + std::to_string(*named.begin());
  desk.act({KnitAlong{}});
  desk.settle();
  REQUIRE(desk.ui.controls.count(mark) == 1);
  const Actions hovered = desk.frames({desk.over(mark)});
  REQUIRE(count_of<HoverRounds>(hovered) == 1);
  desk.act(hovered);
  CHECK(desk.session.view->gaze.hovered_twins.size() > 1);
}

TEST_CASE("of a named round the rounds are found in lines of any form") {
  knit::WrittenPattern pattern;
  using Kind = knit::WrittenPattern::Instruction::Kind;
  pattern.instructions.push_back(
      {std::nullopt, "Inc rnd B: [K1, m1l, k to next m] 4 times. (+4 sts)", Kind::step, 0});
  const auto add = [&](std::int32_t first, std::int32_t last, const char* words) {
    knit::RoundLine line;
    line.first = first;
    line.last = last;
    line.words = words;
    line.counts = {8};
    pattern.instructions.push_back({line, {}});
  };
  add(2, 9, "[Inc rnd A, knit 1 rnd, inc rnd B, knit 1 rnd] 2 times");
  add(10, 12, "[Inc rnd B] 3 times");
  add(13, 15, "Knit 2 rnds, inc rnd B");
  add(16, 16, "Inc rnd A");
  const std::vector<PatternLine> lines = lines_of(pattern);
  const auto named = std::find_if(lines.begin(), lines.end(), [](const PatternLine& line) {
    return line.kind == PatternLine::Kind::named;
  });
  REQUIRE(named != lines.end());
  CHECK(named->label == "Inc rnd B:");
  std::vector<std::int32_t> rounds{named->rounds->first};
  for (const RoundSpan& span : named->twins) rounds.push_back(span.first);
  CHECK(rounds == std::vector<std::int32_t>{4, 8, 10, 11, 12, 15});
}
