// Short rows in a whole run: planned tube by tube, worked between rounds, and settled.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "knit/insight/as_asked.h"
#include "knit/model/settings_table.h"
#include "knit/model/stitch_size.h"
#include "knit/pattern/passes.h"
#include "knit/pattern/rounds.h"
#include "knit/quality/measures.h"
#include "knit/quality/quality.h"
#include "knit/run/machine.h"
#include "knit/run/short_rows_due.h"
#include "knit/run/timeline.h"
#include "knit/stitches/short_join.h"
#include "tests/support/bent_ellipsoid.h"
#include "tests/support/catch.h"
#include "tests/support/repeated.h"
#include "tests/support/run.h"
#include "tests/support/scrub.h"

using namespace knit;
using test_support::bent_ellipsoid;
using test_support::parameters_of;

namespace {

struct Ran {
  State state;
  std::vector<Step> steps;
  Parameters parameters;
};

Ran run(const Input& input, ShortRows rows) {
  Ran ran{{}, {}, parameters_of(input, rows)};
  while (!ran.state.finished()) {
    ran.steps.push_back(advance(input, ran.parameters, ran.state));
    REQUIRE_FALSE(is_stop(ran.steps.back()));
  }
  return ran;
}

std::int32_t short_rows_in(const State& state) {
  return static_cast<std::int32_t>(std::count_if(state.fabric.rows().begin(), state.fabric.rows().end(),
                                                 [](const auto& row) { return is_short(*row); }));
}

template <class Kind>
std::vector<Kind> all(const Ran& ran) {
  std::vector<Kind> found;
  for (const Step& step : ran.steps) {
    if (const auto* what = get_if<Kind>(step)) found.push_back(*what);
  }
  return found;
}

}  // namespace

TEST_CASE("a bent piece gets short rows and settles more evenly with them", "[short-rows]") {
  const auto input = bent_ellipsoid(1.8);
  const Ran without = run(*input, ShortRows::off), with = run(*input, ShortRows::automatic);
  CHECK(short_rows_in(without.state) == 0);
  const std::int32_t rows = short_rows_in(with.state);
  CHECK(rows >= 4);
  CHECK(rows % 2 == 0);
  const LengthFigures plain = wale_figures(without.state), wales = wale_figures(with.state);
  CAPTURE(plain.cv, wales.cv, rows);
  CHECK(wales.cv < 0.8 * plain.cv);
  CHECK(wales.cv < 0.09);
  CHECK(euler_characteristic(with.state) == 0);
  // The report's figures are of the same wales, which count along the path.
  const StitchSize& stitch = with.parameters.stitch;
  const Quality quality = measure_quality(*input, with.state, stitch.width, stitch.height);
  CHECK(quality.wale.count == wales.count);
  CHECK(quality.wale.high * stitch.height == Approx(wales.high));
  CHECK(quality.wale.cv == Approx(wales.cv));
  // The steps tell of all that is there.
  const auto chosen = all<PairsChosen>(with);
  REQUIRE(chosen.size() == 1);
  const auto placed = all<PairPlaced>(with);
  CHECK(chosen.front().pairs == static_cast<std::int32_t>(placed.size() + all<PairDropped>(with).size()));
  CHECK(static_cast<std::int32_t>(all<ShortRowWorked>(with).size()) == rows);
  CHECK(2 * static_cast<std::int32_t>(placed.size()) == rows);
  CHECK(all<TurnPlaced>(with).size() >= static_cast<std::size_t>(rows));
}

TEST_CASE("the report measures the wales of short rows that are worked back", "[short-rows]") {
  const auto input = bent_ellipsoid(1.8);
  const Ran ran = run(*input, ShortRows::automatic);
  const double width = ran.parameters.stitch.width, height = ran.parameters.stitch.height;
  const Quality quality = measure_quality(*input, ran.state, width, height);
  const LengthFigures wales = wale_figures(ran.state);
  CHECK(quality.wale.cv == Approx(wales.cv));
  CHECK(quality.wale.high == Approx(wales.high / height));
  CHECK(quality.offset < 2.0);
  REQUIRE(quality.tubes.size() == 1);
  CHECK(quality.tubes.front().wale_cv < 0.1);
}

TEST_CASE("turns stand beside stitches that the round over them works one to one", "[short-rows]") {
  const auto input = bent_ellipsoid(1.8);
  const State state = run(*input, ShortRows::automatic).state;
  const Fabric& fabric = state.fabric;
  for (const auto& join : fabric.joins()) {
    if (is_short(fabric.row(join->to))) continue;
    const std::vector<std::uint8_t> plain = plain_below(*join);
    for (const std::int32_t place : fabric.marked_below(join->to)) {
      CAPTURE(join->to, place);
      CHECK(plain[static_cast<std::size_t>(place)] == 1);
    }
  }
}

TEST_CASE("a straight piece gets no short rows and keeps its rows", "[short-rows]") {
  const auto input = bent_ellipsoid(0.0);
  const Ran without = run(*input, ShortRows::off), with = run(*input, ShortRows::automatic);
  CHECK(short_rows_in(with.state) == 0);
  CHECK(with.state.fabric == without.state.fabric);
  REQUIRE(all<KeptChosen>(with).size() == 1);
  CHECK(all<KeptChosen>(with).front().kept == no_short_rows);
  CHECK(all<KeptTried>(with).empty());  // nothing had to settle
}

TEST_CASE("a steep price leaves short rows out", "[short-rows]") {
  const auto input = bent_ellipsoid(1.8);
  Parameters parameters = parameters_of(*input, ShortRows::automatic);
  parameters.short_rows.turn_cost = 100.0;
  State state;
  while (state.stage() <= Stage::rows) advance(*input, parameters, state);
  CHECK(short_rows_in(state) == 0);
}

TEST_CASE("a run with short rows is the same from any of its states on", "[short-rows]") {
  const auto input = bent_ellipsoid(1.8);
  const Parameters parameters = parameters_of(*input, ShortRows::automatic);
  std::vector<State> kept;
  State state;
  while (state.stage() < Stage::settle) {
    if (std::size_t{state.short_rows.tubes.size()} > 0 && state.next.item % 37 == 0) kept.push_back(state);
    advance(*input, parameters, state);
  }
  REQUIRE(kept.size() > 10);
  for (std::size_t i = 0; i < kept.size(); i += kept.size() / 5) {
    State again = kept[i];
    CHECK(hash_of(again) == hash_of(kept[i]));
    while (again.stage() < Stage::settle) advance(*input, parameters, again);
    CHECK(hash_of(again) == hash_of(state));
  }
}

TEST_CASE("a choice of short rows that was made for another stitch is made anew", "[short-rows]") {
  const auto input = bent_ellipsoid(1.8);
  Parameters parameters = parameters_of(*input, ShortRows::automatic);
  State state;
  while (!state.short_rows.kept) advance(*input, parameters, state);
  CHECK(*state.short_rows.kept == 0);
  const double width = parameters.stitch.width;
  give_width(parameters, 1.2 * width);
  parameters = resolved(parameters, *input);
  CHECK(get_if<KeptTried>(advance(*input, parameters, state)) != nullptr);
  CHECK(state.short_rows.tries.size() == 1);
  while (state.fabric.empty()) advance(*input, parameters, state);
  CHECK(rows_beside_events(parameters, state) == 0);
  // Once there is fabric it stays as it was, for tubes to come too.
  give_width(parameters, width);
  parameters = resolved(parameters, *input);
  CHECK(rows_beside_events(parameters, state) == 0);
  CHECK(get_if<KeptTried>(advance(*input, parameters, state)) == nullptr);
}

TEST_CASE("short rows are chosen without settling where stitches are not to settle", "[short-rows]") {
  const auto input = bent_ellipsoid(1.8);
  Parameters parameters = parameters_of(*input, ShortRows::automatic);
  parameters.settle.settling = Settling::off;
  State state;
  while (state.stage() < Stage::cast_on) advance(*input, parameters, state);
  const Step step = advance(*input, parameters, state);
  const auto* chosen = get_if<KeptChosen>(step);
  REQUIRE(chosen != nullptr);
  CHECK(chosen->by == ChosenBy::unsettled);
  CHECK(chosen->kept == 0);
  CHECK(chosen->pairs >= 2);
  CHECK(state.short_rows.tries.empty());
  CHECK(chosen->sentence({state.next, parameters}).find("because stitches are not to settle") !=
        std::string::npos);
  while (state.stage() <= Stage::rows) advance(*input, parameters, state);
  CHECK(short_rows_in(state) == 2 * chosen->pairs);
}

TEST_CASE("a change of how stitches settle chooses short rows anew", "[short-rows]") {
  const auto input = bent_ellipsoid(1.8);
  Parameters before = parameters_of(*input, ShortRows::automatic), after = before;
  after.settle.wale = 0.5;
  CHECK(first_reader_of_change(before, after) == Stage::tubes);
  before.short_rows.kept = after.short_rows.kept = KeptBeside::none;  // nothing is left to choose
  CHECK(first_reader_of_change(before, after) == Stage::settle);
  before.short_rows = after.short_rows = {};
  CHECK(first_reader_of_change(before, after) == Stage::settle);
}

TEST_CASE("a chart that the choice was made by is not made again", "[short-rows]") {
  const auto input = bent_ellipsoid(1.8);
  const Parameters parameters = parameters_of(*input, ShortRows::automatic);
  State state;
  while (!state.short_rows.kept) advance(*input, parameters, state);
  REQUIRE(state.short_rows.ahead.size() == 1);
  while (state.short_rows.tubes.empty()) advance(*input, parameters, state);
  const PlannedPairs &ahead = *state.short_rows.ahead.front(), &planned = *state.short_rows.tubes.front();
  CHECK(planned.chart.pointer() == ahead.chart.pointer());
  CHECK(planned.search == ahead.search);
}

TEST_CASE("a run with short rows is gone through in every way", "[short-rows]") {
  const auto input = bent_ellipsoid(1.8);
  Parameters parameters = parameters_of(*input, ShortRows::automatic);
  give_width(parameters, 0.55);
  give_height(parameters, 0.55);
  Timeline timeline(input, resolved(parameters, *input));
  timeline.extend_to_end();
  REQUIRE(timeline.furthest().short_rows.kept == 0);
  const std::vector<std::uint64_t> hashes = test_support::hashes_forward(timeline);
  test_support::check_backward(timeline, hashes);
  test_support::check_at_random(timeline, hashes, test_support::repeated(40));
}

// The rounds above a pair are shaped where the pair was told they would be: else its turns stand beside a decrease.
TEST_CASE("short rows: an edit of how stitches are placed leaves their turns plain", "[short-rows]") {
  const auto input = bent_ellipsoid(1.8);
  Timeline timeline(input, parameters_of(*input, ShortRows::automatic));
  timeline.extend_to_end();
  REQUIRE(short_rows_in(timeline.furthest()) > 0);
  const std::vector<Step> steps(timeline.steps().begin(), timeline.steps().end());
  const auto first_in = [&](Stage stage) {
    return static_cast<std::size_t>(
        std::find_if(steps.begin(), steps.end(),
                     [&](const Step& step) { return step.place.stage == stage; }) -
        steps.begin());
  };
  const auto worked = std::find_if(steps.begin(), steps.end(),
                                   [](const Step& step) { return get_if<ShortRowWorked>(step) != nullptr; });
  const auto first_pair = static_cast<std::size_t>(worked - steps.begin());
  for (const std::size_t at :
       {first_in(Stage::rows), first_pair, first_pair + 1, first_in(Stage::stitches)}) {
    for (const PlacementPolicy placement :
         {PlacementPolicy::thesis, PlacementPolicy::even, PlacementPolicy::nearest}) {
      Timeline edited = timeline;
      edited.seek(at);
      Parameters changed = timeline.parameters();
      changed.stitches.placement = placement;
      edited.edit_from_here(changed);
      edited.extend_to_end();
      CAPTURE(at, static_cast<int>(placement));
      const State& state = edited.furthest();
      REQUIRE(state.finished());
      for (const Round& round : rounds_of(state).rounds) CHECK(can_be_worked(round));
      const bool late = at >= first_pair && placement != timeline.parameters().stitches.placement;
      CHECK(remark_on_placement(state, edited.parameters_of_stop()).has_value() == late);
    }
  }
}
