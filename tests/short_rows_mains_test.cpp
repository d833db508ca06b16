// Mains, counts in rhythm and short rows together, as someone takes a pattern home: what is read is what was worked.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "app/session/presets.h"
#include "knit/import/obj.h"
#include "knit/model/settings_table.h"
#include "knit/model/stitch_size.h"
#include "knit/pattern/chart.h"
#include "knit/pattern/written_pattern.h"
#include "knit/quality/measures.h"
#include "knit/reader/checked_pattern.h"
#include "knit/reader/pattern_reader.h"
#include "knit/run/machine.h"
#include "tests/support/bent_tubes.h"
#include "tests/support/catch.h"
#include "tests/support/promises.h"
#include "tests/support/repeated.h"

using namespace knit;
using namespace test_support;

namespace {

struct Piece {
  std::string name;
  std::shared_ptr<const Input> input;
  VertexId start = no_vertex, end = no_vertex;
};

Piece piece_of(const BentTube& open) {
  const BentTube tube = lidded(open);
  const auto vertices = static_cast<VertexId>(tube.mesh.positions.size());
  return {open.name, make_input(tube.mesh), vertices - 2, vertices - 1};
}

std::vector<Piece> pieces() {
  std::vector<Piece> all{piece_of(heel({48, 90}))};
  if (whole()) all.push_back(piece_of(half_ring({48, 60})));
#ifdef KNIT_SHARED_MESHES
  const std::filesystem::path elbow = std::filesystem::path(KNIT_SHARED_MESHES) / "simple-elbow.obj";
  if (whole() && std::filesystem::exists(elbow))  // not part of the sources
    all.push_back({"elbow", make_input(std::get<Mesh>(read_obj_file(elbow)))});
#endif
  return all;
}

// For taking home, and short rows whether they pay or not.
State taken_home(const Piece& piece, FollowMains mains) {
  const app::Preset* hand = app::find_preset("hand");
  REQUIRE(hand != nullptr);
  Parameters parameters = app::with_preset(*hand, default_parameters(piece.input->bounds));
  parameters.timing.start = piece.start;
  parameters.timing.end = piece.end;
  parameters.short_rows.kept = KeptBeside::none;
  parameters.settle.settling = Settling::off;  // moves stitches, changes no word
  parameters.stitches.follow_mains = mains;
  if (mains == FollowMains::on) parameters.rhythm.counts = CountPlanning::whole;
  parameters = resolved(parameters, *piece.input);
  State state;
  while (!state.finished()) REQUIRE_FALSE(is_stop(advance(*piece.input, parameters, state)));
  return state;
}

struct Beside {
  std::size_t pairs = 0, mains = 0, turns_beside_mains = 0;
};

// Of each round with pairs: its pairs, and those whose turn is on a main stitch or next to one.
Beside beside_mains(const Rounds& rounds) {
  Beside beside;
  for (const Round& round : rounds.rounds) {
    std::vector<bool> main(static_cast<std::size_t>(round.before), false);
    std::size_t below = 0;
    for (const Operation& operation : round.operations) {
      if (operation.at_main && below < main.size()) main[below] = true;
      beside.mains += operation.at_main ? 1 : 0;
      below += static_cast<std::size_t>(consumed_by(operation.hand));
    }
    const auto is_main = [&](std::int32_t stitch) {
      return main[static_cast<std::size_t>((stitch + round.before) % round.before)];
    };
    for (const auto& [first, last] : round.pairs) {
      ++beside.pairs;
      if (is_main(first) || is_main(first - 1) || is_main(last) || is_main(last + 1))
        ++beside.turns_beside_mains;
    }
  }
  return beside;
}

}  // namespace

TEST_CASE("short rows and mains: what is written for taking home reads back as what was worked",
          "[short-rows]") {
  std::size_t beside = 0;
  for (const Piece& piece : pieces()) {
    for (const FollowMains mains : {FollowMains::off, FollowMains::on}) {
      CAPTURE(piece.name, static_cast<int>(mains));
      const State state = taken_home(piece, mains);
      CHECK(broken_rows(state).empty());
      CHECK(broken_live(state).empty());
      CHECK(broken_joins(state).empty());
      const Rounds rounds = rounds_of(state);
      const Beside found = beside_mains(rounds);
      CHECK(found.pairs >= 4);
      CHECK(found.mains > 20);
      beside += found.turns_beside_mains;
      const KnitGraph graph = graph_of(state);
      REQUIRE(graph_of(rounds) == graph);
      const Chart chart = chart_of(rounds);
      for (const ShortRowTurns turns : {ShortRowTurns::german, ShortRowTurns::wrap}) {
        PatternOptions options;
        options.turns = turns;
        const std::string text =
            pattern_as_text(write_pattern(rounds, {22.0, 32.0}, options, piece.name)) + chart_as_text(chart);
        const ReadPattern read = read_pattern(text);
        CAPTURE(text, read.mistakes.empty() ? "" : read.mistakes.front().sentence);
        REQUIRE(read.mistakes.empty());
        CHECK(graph_of(read.rounds) == graph);
      }
    }
  }
  CHECK(beside > 0);
}

namespace {

struct SettledPiece {
  State state;
  LengthFigures wales;
  std::size_t pairs = 0;
  double longest = 0.0;  // in h
};

// The preset as it is, but for what decides.
SettledPiece taken_home_settled(const Piece& piece, ShortRows rows, FollowMains mains) {
  Parameters parameters =
      app::with_preset(*app::find_preset("hand"), default_parameters(piece.input->bounds));
  parameters.timing.kind = TimingKind::harmonic;
  parameters.timing.start = piece.start;
  parameters.timing.end = piece.end;
  parameters.short_rows.rows = rows;
  parameters.settle.settling = Settling::on;
  parameters.stitches.follow_mains = mains;
  if (mains == FollowMains::on) parameters.rhythm.counts = CountPlanning::whole;
  parameters = resolved(parameters, *piece.input);
  SettledPiece made;
  while (!made.state.finished()) REQUIRE_FALSE(is_stop(advance(*piece.input, parameters, made.state)));
  made.wales = wale_figures(made.state);
  made.longest = made.wales.high / parameters.stitch.height;
  for (const Round& round : rounds_of(made.state).rounds) made.pairs += round.pairs.size();
  return made;
}

}  // namespace

TEST_CASE("short rows and mains: for taking home they settle more evenly than without, and read back",
          "[short-rows]") {
  for (const Piece& piece : pieces()) {
    for (const FollowMains mains : {FollowMains::off, FollowMains::on}) {
      const SettledPiece with = taken_home_settled(piece, ShortRows::automatic, mains),
                         without = taken_home_settled(piece, ShortRows::off, mains);
      CAPTURE(piece.name, static_cast<int>(mains), with.pairs, with.wales.cv, without.wales.cv, with.longest,
              without.longest);
      CHECK(with.pairs >= 4);
      CHECK(with.wales.cv < 0.8 * without.wales.cv);
      CHECK(with.wales.cv <= 0.07);
      CHECK(with.longest <= std::max(1.4, without.longest));
      if (std::getenv("KNIT_SHOW") != nullptr)
        std::printf("%s mains %d: pairs %zu wale CV %.3f -> %.3f longest %.2f -> %.2f\n", piece.name.c_str(),
                    static_cast<int>(mains), with.pairs, without.wales.cv, with.wales.cv, without.longest,
                    with.longest);
      const Rounds rounds = rounds_of(with.state);
      const KnitGraph graph = graph_of(with.state);
      for (const ShortRowTurns turns : {ShortRowTurns::german, ShortRowTurns::wrap}) {
        PatternOptions options;
        options.turns = turns;
        const std::string text = pattern_as_text(write_pattern(rounds, {22.0, 32.0}, options, piece.name));
        const ReadPattern read = read_pattern(text);
        CAPTURE(text, read.mistakes.empty() ? "" : read.mistakes.front().sentence);
        REQUIRE(read.mistakes.empty());
        CHECK(graph_of(read.rounds) == graph);
        CHECK(check_pattern(text).verdict == PatternVerdict::holds);
      }
    }
  }
}
