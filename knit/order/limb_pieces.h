// Pieces with holders and joins as hands do them: what knit/pattern writes in words, and nothing that is a word itself.
//
// A piece is a tube with rows, worked in the round with one yarn in hand. What it begins on is told by deals: each says, from
// the marker on, what lies on the needle when its first round begins, and knits nothing. Stitches cast on across a gap are a
// numbered gap, cast on once and picked up once. Holders go by the piece whose stitches they hold, or, of a loop that is
// divided, by the piece that is worked first from it.
// Rounds begin at the marker, which is where the yarn hangs; deals do not move it (limb_markers.h). So the rounds here are the
// fabric's rows, turned to their beginnings; positions and links are the fabric's.
#pragma once

#include <cstdint>
#include <vector>

#include "knit/fabric/stitch.h"
#include "knit/stitches/operations.h"

namespace knit {

enum class LimbRole : std::uint8_t { limb, body, branch, part, lining };

enum class LimbItemKind : std::uint8_t { keep, take, cast_on, pick_up };

// A stretch of what lies on the needle, in working order.
struct LimbItem {
  LimbItemKind kind = LimbItemKind::keep;
  std::int32_t count = 0;
  std::int32_t gap = 0;     // cast on, picked up: from 1
  std::int32_t piece = -1;  // taken: by which the holder goes
  std::int32_t holder = 0;  // taken: 0, or of further holders that go by that piece the number from 1
  // Taken: of the stitches on that holder the first, from 0, round and round. Picked up: of the gap's stitches the first, from
  // there backwards.
  std::int32_t first = 0;
  std::int32_t held = 0;  // taken: all that are on that holder
  friend bool operator==(const LimbItem&, const LimbItem&) = default;
};

enum class LimbDealKind : std::uint8_t {
  cast_on,
  provisional,  // over waste yarn
  loops,        // of a provisional cast on, freed; they run the other way
  rejoin,       // a holder onto the needle
  set_aside,    // all of the needle onto a holder
  move,         // the yarn to another place of the needle
  divide,       // a stretch of the needle onto a holder
  join          // holders onto the needle beside what is there
};

struct LimbDeal {
  LimbDealKind kind = LimbDealKind::cast_on;
  // loops: whose they are. rejoin: whose holder. set_aside, divide: by which the holder goes.
  std::int32_t piece = -1;
  std::int32_t holder = 0;      // 0, or of further holders that go by that piece the number from 1
  std::vector<LimbItem> items;  // rejoin, join
  std::int32_t before = 0, held = 0,
               rest = 0;             // divide: kept, held, kept. move: slipped is `before`, the other `rest`
  std::int32_t gap = 0, bridge = 0;  // divide: cast on across; 0: the gap is drawn close
  std::int32_t after = 0;            // on the needle
  friend bool operator==(const LimbDeal&, const LimbDeal&) = default;
};

struct LimbRound {
  std::vector<Operation> operations;   // from the marker on
  std::int32_t before = 0, after = 0;  // stitches
  bool slips_back = false;             // the last stitch is put back before it: a decrease across the marker
  bool copied = false;                 // of a twin: not as the fabric's row is worked
  // Of short rows, worked before the round or within it; none where the last stitch is slipped back.
  std::vector<ShortRowPair> pairs = {};
  friend bool operator==(const LimbRound&, const LimbRound&) = default;
};

// Stitches of the needle that are grafted to stitches of the holder: 1 to 1, or several to 1 either way.
struct LimbGraft {
  std::int32_t own = 1, others = 1;
  friend bool operator==(const LimbGraft&, const LimbGraft&) = default;
};

enum class LimbEndKind : std::uint8_t { held, goes_on, closed, grafted };

struct LimbEnd {
  LimbEndKind kind = LimbEndKind::closed;
  std::int32_t piece = -1;        // goes on with, grafted to
  std::vector<LimbGraft> grafts;  // in working order of the needle
  std::int32_t slips_back = 0;    // stitches put back before grafting
  std::int32_t other_first = 0;   // grafted: the first of the holder's stitches, which come backwards
  bool three_needle = false;      // grafted: bound off together, the stitches pair one by one
  friend bool operator==(const LimbEnd&, const LimbEnd&) = default;
};

struct LimbPiece {
  TubeId tube = 0;
  LimbRole role = LimbRole::limb;
  bool inner = false;               // its outside faces the middle of its rounds
  std::vector<std::int32_t> twins;  // pieces, itself too; else itself alone
  std::vector<LimbDeal> deals;
  // The rounds worked, the second on after a cast on. starts: of each row, the fabric's stitch that the marker stands before.
  std::vector<LimbRound> rounds;
  std::vector<RowId> rows;  // of the fabric, the cast on too
  std::vector<std::int32_t> starts;
  LimbEnd end;
  [[nodiscard]] bool is_cast_on() const {
    return deals.front().kind == LimbDealKind::cast_on || deals.front().kind == LimbDealKind::provisional;
  }
  [[nodiscard]] std::int32_t first_count() const { return deals.back().after; }
  [[nodiscard]] std::int32_t last_count() const {
    return rounds.empty() ? first_count() : rounds.back().after;
  }
  [[nodiscard]] std::int32_t round_count() const { return static_cast<std::int32_t>(rows.size()); }
  friend bool operator==(const LimbPiece&, const LimbPiece&) = default;
};

struct LimbPlan {
  std::vector<LimbPiece> pieces;   // in working order
  std::vector<std::int32_t> gaps;  // stitches of each
  std::int32_t held_most = 0;      // holders at once, while rounds are worked
  std::int32_t yarns = 0;          // that are begun
  double cost = 0.0;               // of the order (limb_order.h)
  bool three_needle = false;       // is requested; an end says whether it is
  [[nodiscard]] const LimbPiece& piece(std::int32_t i) const { return pieces[static_cast<std::size_t>(i)]; }
  [[nodiscard]] std::int32_t count() const { return static_cast<std::int32_t>(pieces.size()); }
  friend bool operator==(const LimbPlan&, const LimbPlan&) = default;
};

}  // namespace knit
