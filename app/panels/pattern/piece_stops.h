// Knitting along through pieces: what is done one after the other, in words, and what waits on which holder then.
//
// A stop is a deal before a piece's first round, a round, or a short row before one. Stops stand in working order; a stop is found again by the
// fabric's row and the deal's number, which is what a session keeps.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "app/session/planned_pieces.h"

namespace app {

struct PieceStop {
  std::int32_t piece = 0;      // of the plan
  std::int32_t row = 1;        // of the fabric; of a deal: of the first round after it
  std::int16_t deal = 0;       // of the piece's, from 1; 0: it is a round
  std::int32_t number = 0;     // of the round in its piece; of a deal: 0
  std::int32_t short_row = 0;  // its number before that round; 0: it is the round
  friend bool operator==(const PieceStop&, const PieceStop&) = default;
};

// A cast on is the first round, no deal.
std::vector<PieceStop> stops_of(const knit::LimbPlan& plan);
// The stop of a row and a deal; where there is no such deal that of the row, else the first, or the last after all rows.
// Requires one at least.
std::size_t stop_at(const std::vector<PieceStop>& stops, std::int32_t row, std::int16_t deal);
// The first stop of the next piece, or back: of this piece, or of the one before if this is its first.
std::size_t stop_a_piece_on(const std::vector<PieceStop>& stops, std::size_t from, int direction);

// "Rnd 4: K7, k2tog. (8 sts)", with its repeats written out from a twin; "Divide: keep 10 sts, ..."
std::string words_of(const PlannedPieces& pieces, const PieceStop& stop);
// After a piece's last round: "Break yarn. Place 26 sts on a holder."; else empty.
std::string end_words(const PlannedPieces& pieces, const PieceStop& stop);
// How it is joined to another there; empty where it is not.
std::string seam_words(const PlannedPieces& pieces, const PieceStop& stop);
// "Body D, round 3 of 30"; "Body D, short row 2 before round 3 of 30"; "Body D, before round 1"
std::string place_words(const PlannedPieces& pieces, const PieceStop& stop);

struct HeldPiece {
  std::string name;  // "Limb B", "Limb B (holder 2)", "Body A (waste yarn)"
  std::int32_t stitches = 0;
  friend bool operator==(const HeldPiece&, const HeldPiece&) = default;
};
struct Holding {
  std::int32_t needle = 0;         // stitches
  std::vector<HeldPiece> holders;  // in the order of their pieces
  friend bool operator==(const Holding&, const Holding&) = default;
};
// When a stop is done; what comes after a piece's last round is not.
Holding holding_after(const PlannedPieces& pieces, const PieceStop& stop);

}  // namespace app
