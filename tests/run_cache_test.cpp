// What the panels keep of a run, against a walk through all of it.
#include "app/panels/kit/run_cache.h"

#include <algorithm>

#include "app/explain/step_table.h"
#include "knit/model/stitch_size.h"
#include "tests/support/desk.h"

using namespace desk;

TEST_CASE("what is cached of a run equals what a walk through all steps finds") {
  const auto check = [](const RunCache& cache, const knit::Timeline& timeline) {
    std::vector<std::size_t> rows;
    std::vector<knit::Stage> stages;
    for (std::size_t i = 0; i < timeline.known(); ++i) {
      const knit::Place& place = timeline.step(i).place;
      if (place.item == 0) rows.push_back(i);
      if (stages.empty() || stages.back() != place.stage) stages.push_back(place.stage);
    }
    CHECK(cache.row_starts() == rows);
    REQUIRE(cache.stages().size() == stages.size());
    for (std::size_t i = 0; i < stages.size(); ++i) CHECK(cache.stages()[i].stage == stages[i]);
    CHECK(cache.stages().back().end == timeline.known());
  };
  RunCache cache;
  knit::Timeline timeline = small_run(wide_band());
  cache.refresh(timeline);
  CHECK(cache.stages().empty());
  while (timeline.extend(37)) cache.refresh(timeline);
  cache.refresh(timeline);
  check(cache, timeline);
  knit::Parameters narrow = wide_band();
  knit::give_epsilon(narrow, 0.001);
  timeline.tune(narrow);
  cache.refresh(timeline);
  timeline.extend_to_end();
  cache.refresh(timeline);
  check(cache, timeline);
  CHECK_FALSE(cache.problems().empty());
  timeline.seek(timeline.known() / 2);
  timeline.edit_from_here(wide_band());
  timeline.extend_to_end();
  cache.refresh(timeline);
  check(cache, timeline);
  CHECK(cache.edits() == std::vector<std::size_t>{timeline.position()});
}

TEST_CASE("labels are tallied as they are placed, forwards and back") {
  knit::Timeline timeline = small_run(wide_band());
  timeline.extend_to_end();
  LabelTally tally;
  for (const std::size_t position :
       {timeline.known(), timeline.known() * 3 / 4, std::size_t{0}, timeline.known()}) {
    timeline.seek(position);
    const LabelTally::Counts counts = tally.count(timeline.state());
    std::size_t shaping = 0, mains = 0;
    for (std::size_t i = 0; i < position; ++i) {
      shaping += knit::is<knit::ShapingPlaced>(timeline.step(i)) ? 1 : 0;
      mains += knit::is<knit::MainPlaced>(timeline.step(i)) ? 1 : 0;
    }
    CHECK(counts[1] + counts[2] + counts[3] + counts[4] == shaping);
    CHECK(counts[6] == mains);
  }
}

TEST_CASE("every step has numbers in words") {
  knit::Timeline timeline = small_run(wide_band());
  timeline.extend_to_end();
  for (const knit::Step& step : timeline.steps()) {
    const auto numbers = numbers_of(step);
    REQUIRE_FALSE(numbers.empty());
    for (const auto& [name, value] : numbers) {
      CHECK(name.find('_') == std::string::npos);
      CHECK_FALSE(value.empty());
    }
  }
  // Places have 0 first in the steps, and 1 for whoever reads.
  const auto placed = numbers_of({{}, knit::MainPlaced{0, 1}});
  CHECK(placed.front() == std::pair<std::string, std::string>{"cell", "1"});
  const auto grouped = numbers_of({{}, knit::LevelsGrouped{64, 0, -1, 0, 1e-5}});
  CHECK(std::any_of(grouped.begin(), grouped.end(), [](const auto& line) { return line.second == "none"; }));
}

TEST_CASE("the panels count problems as comparing and sweeps do", "[run-cache]") {
  knit::Parameters narrow = wide_band();
  knit::give_epsilon(narrow, 0.001);
  for (const knit::OnStall on_stall : {knit::OnStall::continue_, knit::OnStall::stop}) {
    narrow.rows.on_stall = on_stall;
    knit::Timeline timeline = small_run(narrow);
    timeline.extend_to_end();
    RunCache cache;
    cache.refresh(timeline);
    const knit::ProblemCounts counts = cache.problem_counts(timeline);
    CHECK(counts == tally_of(timeline).problems);
    CHECK(counts == whole_run(timeline.input(), knobs_of(timeline)).problems);
    CHECK(counts.of(knit::ProblemKind::band_missed) > 0);
  }
}
