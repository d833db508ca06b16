// Knitting along through pieces: every round and every deal once, in words that add up, with what is on which holder.
#include "app/panels/pattern/piece_stops.h"

#include <set>

#include "app/panels/pattern/chart_cache.h"
#include "knit/mesh/shapes.h"
#include "knit/model/stitch_size.h"
#include "knit/pattern/written_pattern.h"
#include "tests/support/catch.h"
#include "tests/support/desk.h"
#include "tests/support/random_fabric.h"
#include "tests/support/ringed_fabric.h"
#include "tests/support/session.h"

using namespace app;

namespace {

PlannedPieces planned(const std::string& example) {
  Session session = test_support::example_session(example);
  apply(session, ToLast{});
  return planned_pieces(session);
}

// "(38 sts; Branch C 7 sts)": the first number of the last bracket that counts.
std::int32_t told(const std::string& words) {
  const std::size_t bracket = words.rfind('(');
  REQUIRE(bracket != std::string::npos);
  return std::stoi(words.substr(bracket + 1));
}

}  // namespace

TEST_CASE("stops are all rounds and deals in working order, and a stop is found again") {
  for (const char* example : {"y", "trousers", "mug", "octopus", "torus", "double-torus"}) {
    INFO(example);
    const PlannedPieces pieces = planned(example);
    const std::vector<PieceStop> stops = stops_of(pieces.plan);
    std::size_t rounds = 0, deals = 0;
    for (const knit::LimbPiece& piece : pieces.plan.pieces) {
      rounds += piece.rows.size();
      deals += piece.deals.size() - (piece.is_cast_on() ? 1 : 0);
    }
    CHECK(stops.size() == rounds + deals);
    for (std::size_t i = 0; i < stops.size(); ++i) {
      CHECK(stop_at(stops, stops[i].row, stops[i].deal) == i);
      if (i > 0) CHECK(stops[i].piece >= stops[i - 1].piece);
    }
    CHECK(stop_at(stops, 0, 0) == 0);
    CHECK(stop_at(stops, 1000000, 0) == stops.size() - 1);
    CHECK(stops[stop_at(stops, stops.back().row, 99)] == stops.back());
  }
}

TEST_CASE("what is on the needle is what the words say, and holders are emptied in the end") {
  for (const char* example : {"y", "trousers", "mug", "octopus", "double-torus", "chain-of-three"}) {
    INFO(example);
    const PlannedPieces pieces = planned(example);
    std::size_t most = 0;
    for (const PieceStop& stop : stops_of(pieces.plan)) {
      const std::string words = words_of(pieces, stop);
      INFO(words);
      const Holding holding = holding_after(pieces, stop);
      CHECK(told(words) == holding.needle);
      for (const HeldPiece& held : holding.holders) CHECK(held.stitches > 0);
      if (stop.deal == 0) most = std::max(most, holding.holders.size());
    }
    CHECK(static_cast<std::int32_t>(most) == pieces.plan.held_most);
    const PieceStop last = stops_of(pieces.plan).back();
    const Holding end = holding_after(pieces, last);
    // A graft empties the last holder.
    CHECK(end.holders.size() == (pieces.plan.pieces.back().end.kind == knit::LimbEndKind::grafted ? 1U : 0U));
    CHECK(!end_words(pieces, last).empty());
  }
}

TEST_CASE("the words are those of the written pattern, twins' rounds written out") {
  const PlannedPieces pieces = planned("mug");
  const knit::WrittenPattern written = knit::write_pattern(pieces.plan, {22.0, 32.0}, pieces.options, "mug");
  std::set<std::string> lines;
  for (const auto& instruction : written.instructions)
    lines.insert(instruction.round ? instruction.round->text() : instruction.remark);
  std::size_t found = 0, stops = 0;
  for (const PieceStop& stop : stops_of(pieces.plan)) {
    const std::string words = words_of(pieces, stop);
    CHECK(words.find("Work as for") == std::string::npos);
    ++stops;
    found += lines.count(words);
    if (stop.deal != 0) CHECK(lines.count(words) == 1);
  }
  CHECK(3 * found > stops);  // the others are rounds joined on one line
}

TEST_CASE("from piece to piece goes to their beginnings") {
  const PlannedPieces pieces = planned("trousers");
  const std::vector<PieceStop> stops = stops_of(pieces.plan);
  CHECK(stop_a_piece_on(stops, 0, -1) == 0);
  CHECK(stop_a_piece_on(stops, 3, -1) == 0);
  const std::size_t second = stop_a_piece_on(stops, 3, 1);
  CHECK(stops[second].piece == 1);
  CHECK(stops[second].number == 1);
  const std::size_t third = stop_a_piece_on(stops, second, 1);
  CHECK(stops[third].deal == 1);  // the join
  CHECK(place_words(pieces, stops[third]) == "Body C, before round 1");
  CHECK(place_words(pieces, stops[second]) == "Limb B, round 1 of 15");
  CHECK(stop_a_piece_on(stops, third, -1) == second);
  CHECK(stop_a_piece_on(stops, third, 1) == stops.size() - 1);
}

TEST_CASE(
    "at a three-needle bind off the last round says what to bind off, with whom and how, and a holder is "
    "emptied") {
  int seams = 0;
  for (unsigned seed = 0; seed < 60 && seams < 4; ++seed) {
    CAPTURE(seed);
    knit::State state = test_support::RingedFabric(seed).of(test_support::RandomFabric(seed).run(2));
    if (!knit::has_limbs(state)) continue;
    state.work = knit::Finished{};
    const PlannedPieces pieces = planned_pieces(state, {}, {}, knit::GraftBy::three_needle);
    for (const PieceStop& stop : stops_of(pieces.plan)) {
      const knit::LimbPiece& piece = pieces.plan.piece(stop.piece);
      const bool last = stop.deal == 0 && stop.number == piece.round_count();
      if (!last || !piece.end.three_needle) {
        CHECK(seam_words(pieces, stop).find("third needle") == std::string::npos);
        continue;
      }
      ++seams;
      const Holding holding = holding_after(pieces, stop);
      const std::string other = pieces.name_of(piece.end.piece), pairs = std::to_string(holding.needle);
      const std::string words = end_words(pieces, stop);
      INFO(words);
      CHECK(words.find("Three-needle bind off with " + other + " (" + pairs + " st") == 0);
      CHECK(words.find(": bind off " + pairs + " pair") + words.find("slip last") != std::string::npos);
      CHECK(seam_words(pieces, stop).find("With a third needle knit the first st of the front one") !=
            std::string::npos);
      const auto held = std::find_if(holding.holders.begin(), holding.holders.end(),
                                     [&](const HeldPiece& h) { return h.name == other; });
      REQUIRE(held != holding.holders.end());  // the other's stitches wait until then
      CHECK(held->stitches == holding.needle);
      if (stop.piece + 1 == pieces.plan.count()) continue;
      const PieceStop next = stops_of(pieces.plan)[stop_a_piece_on(
          stops_of(pieces.plan), stop_at(stops_of(pieces.plan), stop.row, 0), 1)];
      for (const HeldPiece& h : holding_after(pieces, next).holders) CHECK(h.name != other);
    }
  }
  CHECK(seams >= 4);
}

// Of a mesh the rims of a seam differ by what the ridge is round: their stitches do not pair, and that is said.
TEST_CASE("in the window the seam's step says what to do and how") {
  desk::Desk desk;
  const auto input = knit::make_input(knit::torus(48, 24, 1.0, 0.4));
  knit::Parameters parameters = knit::default_parameters(input->bounds);
  knit::give_width(parameters, 0.08 * input->bounds.diagonal());
  parameters = knit::resolved(parameters, *input);
  parameters.timing.axis.kind = knit::AxisKind::y;
  parameters.rows.source = knit::RowSource::contours;
  parameters.stitches.placement = knit::PlacementPolicy::nearest;
  parameters.pattern.graft = knit::GraftBy::three_needle;
  Document document{knit::Timeline(input, parameters)};
  document.original = std::make_shared<const knit::Mesh>(input->mesh);
  document.defaults = parameters;
  document.timeline.extend_to_end();
  desk.session.document = std::move(document);
  desk.act({ToLast{}, KnitAlong{3}});
  desk.settle();
  CHECK(desk.ui.controls.count("knit-along/seam") == 0);
  desk.act({KnitAlong{100000}});
  desk.settle();
  CHECK(desk.ui.controls.count("knit-along/end") == 1);
  CHECK(desk.ui.controls.count("knit-along/seam") == 1);
  const PlannedPieces& pieces = desk.ui.own<ChartCache>().pieces();
  const std::string how = seam_words(pieces, stops_of(pieces.plan).back());
  CHECK(how.find("to the inside, wrong sides together") != std::string::npos);
  CHECK(how.find("so they are grafted: a three-needle bind off would pucker.") != std::string::npos);
}
