// Break conditions: as text, and where they hold in whole runs, against plain walks.
#include "knit/insight/breaks.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "knit/model/settings_table.h"
#include "knit/model/stitch_size.h"
#include "tests/support/catch.h"
#include "tests/support/run.h"
#include "tests/support/session.h"

using namespace knit;

namespace {

BreakCondition condition(const std::string& text) {
  const auto parsed = parse_break(text);
  INFO(text);
  REQUIRE(std::holds_alternative<BreakCondition>(parsed));
  return std::get<BreakCondition>(parsed);
}

Timeline whole_run(const Parameters& parameters) {
  Timeline timeline(test_support::small_sphere(), parameters);
  timeline.extend_to_end();
  return timeline;
}

Parameters contour_parameters() {
  Parameters parameters = test_support::small_parameters();
  parameters.rows.source = RowSource::contours;
  return parameters;
}

std::vector<std::size_t> hits_of(const Timeline& timeline, const std::string& text) {
  BreakScanner scanner({condition(text)});
  for (std::size_t i = 0; i < timeline.known(); ++i)
    scanner.take(timeline.step(i), timeline.parameters_of_step(i), timeline.furthest().fabric);
  if (timeline.stop() != nullptr) scanner.take_stop(*timeline.stop());
  std::vector<std::size_t> steps;
  for (const BreakHit& hit : scanner.hits()) steps.push_back(hit.step);
  CHECK(scanner.count(0) == steps.size());
  return steps;
}

// The last step of each row made, in order.
std::vector<std::size_t> ends_of_rows(const Timeline& timeline) {
  std::vector<std::size_t> ends;
  for (std::size_t i = 0; i < timeline.known(); ++i) {
    const Place& place = timeline.step(i).place;
    const bool makes_rows = place.stage == Stage::cast_on || place.stage == Stage::rows;
    const bool last = i + 1 == timeline.known() || timeline.step(i + 1).place.stage != place.stage ||
                      timeline.step(i + 1).place.row != place.row;
    if (makes_rows && last && place.row > 0) ends.push_back(i);
  }
  return ends;
}

template <class Test>
std::vector<std::size_t> rows_where(const Timeline& timeline, Test test) {
  const auto ends = ends_of_rows(timeline);
  const auto& rows = timeline.furthest().fabric.rows();
  REQUIRE(ends.size() == rows.size());
  std::vector<std::size_t> steps;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (test(rows, i)) steps.push_back(ends[i]);
  }
  return steps;
}

using Rows = std::vector<Shared<Row>>;

int change(const Rows& rows, std::size_t i) {
  if (i == 0) return 0;
  return static_cast<int>(rows[i]->stitches.size()) - static_cast<int>(rows[i - 1]->stitches.size());
}

bool any_width(const Row& row, double width, double bound, bool wider) {
  for (std::size_t i = 0; i < row.stitches.size(); ++i) {
    const Stitch& next = row.stitches[(i + 1) % row.stitches.size()];
    const double widths = glm::distance(row.stitches[i].position, next.position) / width;
    if (wider ? widths > bound : widths < bound) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("break conditions read back equal, however they are spelt", "[breaks]") {
  for (const char* text :
       {"stage=rows", "stage=cast-on", "row=14", "label=m1l", "label=main", "grows>4", "shrinks>0", "gap",
        "stall", "over-double", "wider>1.3", "narrower<0.7", "split", "join", "hold"}) {
    CHECK(text_of(condition(text)) == text);
    CHECK(condition(text_of(condition(text))) == condition(text));
    CHECK_FALSE(words_of(condition(text)).empty());
  }
  CHECK(condition(" Row = 14 ") == condition("row=14"));
  CHECK(condition("LABEL=M1L") == condition("label=m1l"));
  CHECK(condition("wider>1.30") == condition("wider>1.3"));
  CHECK(condition("row=14") != condition("row=15"));
}

TEST_CASE("what is no break condition gets one sentence", "[breaks]") {
  for (const char* text :
       {"",         "rows",      "row",           "row=",         "row=0",          "row=1.5",
        "row=14x",  "row>3",     "stage=nowhere", "stage=done",   "stage=import",   "label=knit",
        "label=",   "grows=4",   "grows>-1",      "gap=1",        "stalls",         "wider>",
        "wider>-1", "wider>nan", "wider>inf",     "narrower>0.7", "row=99999999999"}) {
    INFO(text);
    const auto parsed = parse_break(text);
    REQUIRE(std::holds_alternative<std::string>(parsed));
    CHECK(test_support::is_one_sentence(std::get<std::string>(parsed)));
  }
}

TEST_CASE("stages, rows and labels break where they begin and where they are placed", "[breaks]") {
  const Timeline timeline = whole_run(test_support::small_parameters());
  const auto& steps = timeline.steps();
  for (const Stage stage : machine_stages) {
    if (stage == Stage::tubes || stage == Stage::settle || stage == Stage::relax)
      continue;  // rings make none, and stay
    const auto first =
        std::find_if(steps.begin(), steps.end(), [&](const Step& step) { return step.place.stage == stage; });
    CHECK(hits_of(timeline, "stage=" + std::string(name_of(stage))) ==
          std::vector{static_cast<std::size_t>(first - steps.begin())});
  }
  const auto row = hits_of(timeline, "row=4");
  CHECK(row.size() == 4);  // rows, stitches, faces, pattern
  for (const std::size_t i : row) {
    CHECK(steps[i].place.row == 4);
    CHECK(steps[i - 1].place.row == 3);
  }
  std::vector<std::size_t> increases, mains;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const auto* shaping = knit::get_if<ShapingPlaced>(steps[i]);
    if (shaping != nullptr && shaping->label == Label::m1l) increases.push_back(i);
    if (knit::is<MainPlaced>(steps[i])) mains.push_back(i);
  }
  REQUIRE_FALSE(increases.empty());
  CHECK(hits_of(timeline, "label=m1l") == increases);
  CHECK(hits_of(timeline, "label=main") == mains);
  CHECK(hits_of(timeline, "label=cast").size() == timeline.furthest().fabric.rows().front()->stitches.size());
}

TEST_CASE("rows that grow, shrink, or have a wide or a narrow stitch break where they are finished",
          "[breaks]") {
  for (const Parameters& parameters : {test_support::small_parameters(), contour_parameters()}) {
    const Timeline timeline = whole_run(parameters);
    const double w = parameters.stitch.width;
    for (const int n : {0, 2, 4}) {
      CHECK(hits_of(timeline, "grows>" + std::to_string(n)) ==
            rows_where(timeline, [&](const Rows& rows, std::size_t i) { return change(rows, i) > n; }));
      CHECK(hits_of(timeline, "shrinks>" + std::to_string(n)) ==
            rows_where(timeline, [&](const Rows& rows, std::size_t i) { return change(rows, i) < -n; }));
    }
    bool parted = false;  // some rows are wider than a bound, others not
    for (const double bound : {0.7, 0.9, 0.95, 0.98, 1.02, 1.1}) {
      const auto wide = hits_of(timeline, "wider>" + number_text(bound));
      CHECK(wide == rows_where(timeline, [&](const Rows& rows, std::size_t i) {
              return any_width(*rows[i], w, bound, true);
            }));
      CHECK(hits_of(timeline, "narrower<" + number_text(bound)) ==
            rows_where(timeline, [&](const Rows& rows, std::size_t i) {
              return any_width(*rows[i], w, bound, false);
            }));
      parted = parted || (!wide.empty() && wide.size() < timeline.furthest().fabric.rows().size());
    }
    CHECK(parted);
    CHECK_FALSE(hits_of(timeline, "grows>0").empty());
    CHECK_FALSE(hits_of(timeline, "shrinks>0").empty());
    CHECK(hits_of(timeline, "wider>50").empty());
  }
}

TEST_CASE("gaps, stalls and more than twice the row before break at the step that says so", "[breaks]") {
  Parameters narrow = test_support::small_parameters();
  give_epsilon(narrow, 0.01);
  const Timeline timeline = whole_run(narrow);
  std::vector<std::size_t> gaps, stalls, doubles;
  for (std::size_t i = 0; i < timeline.known(); ++i) {
    const auto& what = timeline.step(i).what;
    if (const auto* closed = knit::get_if<RowClosed>(what); closed != nullptr && !closed->in_band)
      gaps.push_back(i);
    if (knit::is<BandMissed>(what)) stalls.push_back(i);
    const auto* resampled = knit::get_if<RowResampled>(what);
    if (resampled != nullptr && resampled->from > 2 * resampled->below &&
        resampled->reason == ResampleReason::more_than_double)
      doubles.push_back(i);
  }
  REQUIRE_FALSE(gaps.empty());
  REQUIRE_FALSE(stalls.empty());
  CHECK(hits_of(timeline, "gap") == gaps);
  CHECK(hits_of(timeline, "stall") == stalls);
  CHECK(hits_of(timeline, "over-double") == doubles);
}

TEST_CASE("a run that stops for it breaks at its stop, after the last step", "[breaks]") {
  Parameters strict = test_support::small_parameters();
  give_epsilon(strict, 0.01);
  strict.rows.on_stall = OnStall::stop;
  const Timeline stalled = whole_run(strict);
  REQUIRE(stalled.stop() != nullptr);
  CHECK(hits_of(stalled, "stall") == std::vector{stalled.known()});
  CHECK(hits_of(stalled, "over-double").empty());

  Parameters fine = test_support::small_parameters();
  give_width(fine, 0.1);
  give_epsilon(fine, 0.08);
  fine.rows.resample = Resample::off;
  const Timeline stopped = whole_run(fine);
  REQUIRE(stopped.stop() != nullptr);
  CHECK(knit::get_if<Stopped>(*stopped.stop())->reason == StopReason::changes_too_much);
  CHECK(hits_of(stopped, "over-double") == std::vector{stopped.known()});
}

TEST_CASE(
    "a ring knitted from side to side breaks where its loop is cut, where two become one, and on a holder",
    "[breaks]") {
  Parameters parameters = contour_parameters();
  parameters.timing.axis.kind = AxisKind::x;
  Timeline timeline(make_input(torus(48, 24, 1.0, 0.4)), parameters);
  timeline.extend_to_end();
  REQUIRE(timeline.stop() == nullptr);
  const auto split = hits_of(timeline, "split"), join = hits_of(timeline, "join"),
             hold = hits_of(timeline, "hold");
  REQUIRE(split.size() == 1);
  REQUIRE(join.size() == 1);
  // The second half after the split, and the first once it is as high.
  REQUIRE(hold.size() == 2);
  CHECK(knit::is<LoopsDealt>(timeline.step(hold.front())));
  CHECK(knit::is<TubeTaken>(timeline.step(hold.back())));
  CHECK(split.front() < hold.front());
  CHECK(hold.back() < join.front());
  // What a tube begins on is no change of the tube before.
  for (const std::size_t step : hits_of(timeline, "grows>0")) {
    const Row& row = timeline.furthest().fabric.row(timeline.step(step).place.row);
    CHECK(size_of(row) > row.on.size());
  }
}

TEST_CASE("several conditions hit in the order of steps, and each is counted", "[breaks]") {
  const Timeline timeline = whole_run(test_support::small_parameters());
  BreakScanner scanner({condition("row=3"), condition("stage=rows"), condition("label=k2tog")});
  for (std::size_t i = 0; i < timeline.known(); ++i)
    scanner.take(timeline.step(i), timeline.parameters_of_step(i), timeline.furthest().fabric);
  const auto& hits = scanner.hits();
  CHECK(std::is_sorted(hits.begin(), hits.end(), [](const BreakHit& a, const BreakHit& b) {
    return std::pair(a.step, a.condition) < std::pair(b.step, b.condition);
  }));
  CHECK(scanner.count(0) == 4);
  CHECK(scanner.count(1) == 1);
  CHECK(scanner.count(2) == hits_of(timeline, "label=k2tog").size());
  CHECK(scanner.taken() == timeline.known());
}
