// Knitting along through pieces: every round and every deal once, in words that add up, with what is on which holder.
#include "app/panels/pattern/piece_stops.h"

#include <set>

#include "knit/pattern/written_pattern.h"
#include "tests/support/catch.h"
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
