// From a bent piece to its written pattern with short rows and back; its map; and what a chart's squares are.
#include <algorithm>
#include <cmath>
#include <set>

#include "app/files/pattern_export.h"
#include "knit/fabric/fabric.h"
#include "knit/model/settings_table.h"
#include "knit/model/stitch_size.h"
#include "knit/pattern/passes.h"
#include "knit/pattern/written_pattern.h"
#include "knit/pattern/written_rows.h"
#include "knit/reader/pattern_reader.h"
#include "knit/run/machine.h"
#include "knit/stitches/appendix.h"
#include "tests/support/catch.h"
#include "tests/support/run.h"

using namespace knit;

namespace {

// A long ellipsoid, bent over its length by 1.8 radians.
std::shared_ptr<const Input> bent() {
  Mesh mesh = sphere(24, 32, false);
  const double half = 4.0, turn = 1.8, radius = 2.0 * half / turn;
  for (glm::dvec3& p : mesh.positions) {
    const double angle = half * p.y / radius, out = radius - p.x;
    p = {radius - out * std::cos(angle), out * std::sin(angle), p.z};
  }
  return make_input(std::move(mesh));
}

const State& piece() {
  static const State made = [] {
    const auto input = bent();
    Parameters parameters = default_parameters(input->bounds);
    give_width(parameters, 0.4);
    give_height(parameters, 0.4);
    parameters.timing.kind = TimingKind::harmonic;
    parameters.rows.source = RowSource::contours;
    parameters.stitches.placement = PlacementPolicy::nearest;
    parameters.short_rows.rows = ShortRows::automatic;
    parameters.short_rows.kept = KeptBeside::none;
    parameters = resolved(parameters, *input);
    State state;
    while (!state.finished()) {
      const Step step = advance(*input, parameters, state);
      REQUIRE_FALSE(is_stop(step));
    }
    return state;
  }();
  return made;
}

std::size_t pairs_in(const Rounds& rounds) {
  std::size_t pairs = 0;
  for (const Round& round : rounds.rounds) pairs += round.pairs.size();
  return pairs;
}

}  // namespace

TEST_CASE("the pattern of a bent piece tells its short rows and reads back as its fabric", "[short-rows]") {
  const State& state = piece();
  const Rounds rounds = rounds_of(state);
  const auto shorts = std::count_if(state.fabric.rows().begin(), state.fabric.rows().end(),
                                    [](const auto& row) { return is_short(*row); });
  REQUIRE(shorts >= 4);
  CHECK(2 * static_cast<std::ptrdiff_t>(pairs_in(rounds)) == shorts);
  CHECK(static_cast<std::ptrdiff_t>(rounds.rounds.size()) + 1 + shorts == state.fabric.row_count());
  for (std::size_t i = 0; i < rounds.rounds.size(); ++i) {
    CHECK(rounds.rounds[i].number == static_cast<std::int32_t>(i) + 2);
    CHECK(can_be_worked(rounds.rounds[i]));
  }
  const KnitGraph graph = graph_of(state);
  CHECK(graph_of(rounds) == graph);
  const Chart chart = chart_of(rounds);
  for (const ShortRowTurns turns : {ShortRowTurns::german, ShortRowTurns::wrap}) {
    PatternOptions options;
    options.turns = turns;
    const WrittenPattern pattern = write_pattern(rounds, {22.0, 30.0}, options, "piece");
    for (const std::string& text :
         {pattern_as_text(pattern) + chart_as_text(chart),
          pattern_as_markdown(pattern) + chart_as_markdown(chart), app::pattern_html(pattern, chart)}) {
      const ReadPattern read = read_pattern(text);
      CAPTURE(text, read.mistakes.empty() ? "" : read.mistakes.front().sentence);
      REQUIRE(read.mistakes.empty());
      CHECK(graph_of(read.rounds) == graph);
    }
  }
}

TEST_CASE("every stitch of the fabric is one square of the chart and no square is two", "[short-rows]") {
  const Fabric& fabric = piece().fabric;
  const Chart chart = chart_of(rounds_of(piece()));
  const ChartStitches stitches(fabric, chart);
  std::set<StitchRef> seen;
  for (std::size_t row = 0; row + 1 < chart.rows.size(); ++row) {
    for (const ChartSquare& square : chart.rows[row].squares) {
      if (square.stitch < 0) continue;
      const auto found = stitches.stitch(row, square);
      REQUIRE(found);
      CHECK(seen.insert(*found).second);
    }
  }
  CHECK(seen.size() == fabric.stitch_count());
}

TEST_CASE("rows of the fabric are named as the pattern names them", "[short-rows]") {
  const Fabric& fabric = piece().fabric;
  const std::vector<WrittenRow> written = written_rows(fabric);
  REQUIRE(std::ssize(written) == fabric.row_count());
  std::int32_t round = 1;
  for (RowId id = 1; id <= fabric.row_count(); ++id) {
    const WrittenRow& row = written[static_cast<std::size_t>(id - 1)];
    CHECK((row.short_row > 0) == is_short(fabric.row(id)));
    CHECK(row.round == round);
    if (row.short_row > 0) continue;
    CHECK(row_of_round(fabric, round) == id);
    ++round;
  }
  CHECK(row_of_round(fabric, round) == 0);
}

TEST_CASE("the map has a line for each short row behind the row that it stands on", "[short-rows]") {
  const Fabric& fabric = piece().fabric;
  std::vector<const Join*> joins;
  for (const auto& join : fabric.joins()) {
    if (!is_short(fabric.row(join->to))) joins.push_back(&*join);
  }
  std::vector<LabelRow> view = appendix_view(size_of(fabric.row(1)), joins);
  add_short_rows(fabric, fabric.row(1).tube, view);
  std::size_t lines = 0, turned = 0;
  std::int32_t before = 0;
  for (const LabelRow& row : view) {
    CHECK(row.row >= before);
    before = row.row;
    if (row.short_row == 0) continue;
    ++lines;
    const Label turn = row.short_row % 2 == 1 ? Label::turn_left : Label::turn_right;
    // A main keeps its label where it is turned at.
    turned += row.labels.back() == turn ? 1 : 0;
    CHECK(text_of(row).starts_with(std::to_string(row.row) + "." + std::to_string(row.short_row) + " @" +
                                   std::to_string(row.at) + ": ["));
  }
  CHECK(lines == 2 * pairs_in(rounds_of(piece())));
  CHECK(2 * turned > lines);
  CHECK(before == static_cast<std::int32_t>(rounds_of(piece()).rounds.size()) + 1);
}
