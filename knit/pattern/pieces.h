// The pattern of a fabric with deals (knit/fabric/deal.h): pieces, one after the other, each worked in the round on stitches
// that are cast on or that earlier pieces left.
//
// A piece is a tube with rows. Tubes without a row use no yarn and no words, so deals are not told one by one: what a piece
// begins on is read from the stitches that its first round takes, from the marker on. They are stitches of last rounds, which
// lie on the needle or on a holder, and stitches of bridges. Of these, what lies side by side when it is first met is a gap:
// the piece that comes first casts it on, and it is picked up from its other side, by a later piece or on the way back.
//
// Yarn: what hangs at the beginning of a last round is used by the piece that begins with that very stitch, at once or later;
// if there is none, it is broken. So yarns are as few as the order of working allows.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "knit/pattern/rounds.h"

namespace knit {

// Whether loops part or meet, so that the rows are no single chain: then nothing of rounds.h is meant for it.
bool in_pieces(const State& state);

// keep: stitches that lie on the needle since the round before. set_aside: of these, put on a holder. take: from a holder.
// loops: of a provisional cast on, freed from the waste yarn; they run the other way.
enum class LayKind : std::uint8_t { keep, set_aside, take, cast_on, pick_up, loops };

struct Lay {
  LayKind kind = LayKind::keep;
  std::int32_t piece = 0;  // whose stitches they are; of those set aside, for whom
  // Stitches of the piece's last round, counted from its beginning on, round and round; loops: of its first round, backwards.
  // Picked up: of the gap as it was cast on, the first of them there.
  std::int32_t first = 0, count = 0;
  std::int32_t gap = 0;  // from 1; 0: none
  friend bool operator==(const Lay&, const Lay&) = default;
};

// divided: begins on the needle, where the piece before lies. rejoined: what it needs is on holders.
enum class PieceStart : std::uint8_t { cast_on, provisional, loops, divided, rejoined };
// What a piece begins with: a yarn of its own, that of the piece before, or one that hangs at its first stitch.
enum class PieceYarn : std::uint8_t { begun, goes_on, hangs };

enum class PieceEndKind : std::uint8_t { goes_on, held, closed, grafted };

// Stitches of the piece that are grafted to stitches of the other: 1 to 1, or 2 or more to 1 either way.
struct Grafted {
  std::int32_t own = 1, others = 1;
  friend bool operator==(const Grafted&, const Grafted&) = default;
};
struct PieceEnd {
  PieceEndKind kind = PieceEndKind::closed;
  std::vector<std::int32_t> to;  // pieces that begin on its stitches, or that it is grafted to, rising
  std::int32_t yarn_for = -1;    // the piece that goes on with its yarn; -1: it is broken
  std::vector<Grafted> grafts;
  std::int32_t own_first = 0,
               other_first = 0;  // stitches that the first graft begins with; the other's run backwards
  friend bool operator==(const PieceEnd&, const PieceEnd&) = default;
};

struct Piece {
  TubeId tube = 0;
  RowId first_row = 1, rows_before = 0;  // of the fabric
  bool inner = false;                    // its outside faces the middle of its rounds
  PieceStart start = PieceStart::cast_on;
  PieceYarn yarn = PieceYarn::begun;
  std::vector<Lay> laid;  // in working order from the marker on; none: cast on
  Rounds rounds;  // `cast_on`: on the needle before the first round; rounds from 1, or 2 after a cast on
  PieceEnd end;
  [[nodiscard]] bool is_cast_on() const {
    return start == PieceStart::cast_on || start == PieceStart::provisional;
  }
  [[nodiscard]] std::int32_t round_count() const {
    return static_cast<std::int32_t>(rounds.rounds.size()) + (is_cast_on() ? 1 : 0);
  }
};

struct Pieces {
  std::vector<Piece> pieces;       // in working order
  std::vector<std::int32_t> gaps;  // stitches of each
  std::int32_t held_most = 0;      // holders at once, while rounds are worked
  std::int32_t yarns = 0;          // that are begun
  [[nodiscard]] const Piece& piece(std::int32_t i) const { return pieces[static_cast<std::size_t>(i)]; }
  [[nodiscard]] std::int32_t gap(std::int32_t number) const {
    return gaps[static_cast<std::size_t>(number) - 1];
  }
};

// Requires in_pieces, and all rows and joins.
Pieces pieces_of(const State& state);
// Whether all joins are there.
bool pieces_are_known(const State& state);

// "Piece B", by its place in the working order.
std::string piece_name(std::int32_t piece);

}  // namespace knit
