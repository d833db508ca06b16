// The fabric as hands meet it: for each tube the live loop that it begins on, its rows, what is done in each, and the deals
// between tubes.
//
// A place is a stitch as it lies on a needle, by number. A stitch of a row has one place, a stitch of a bridge two, one on
// each side: a loop may pass a bridge twice. Loops are lists of places in working order.
// Climbing: the gap before live stitch i leads to the gap before the first stitch of the next row that is worked from i; where
// that one is worked from i - 1 too, the last stitch is slipped back first. O(1) a row, from tables of O(stitches).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "knit/fabric/fabric.h"
#include "knit/stitches/operations.h"
#include "knit/tubes/plan.h"

namespace knit {

using Places = std::vector<std::int32_t>;
inline std::int32_t size_of(const Places& places) { return static_cast<std::int32_t>(places.size()); }

// How a row is worked on the loop below: operation k makes stitch k of the row.
struct HandsRow {
  std::vector<Operation> operations;
  std::vector<std::int32_t> up;  // of each gap below, before stitch i: the stitch of the row that follows it
  std::vector<std::uint8_t> crosses;     // whether a decrease takes the stitches on both sides of that gap
  bool possible = true;                  // no more than two are taken together
  std::vector<ShortRowPair> pairs = {};  // of short rows before it, from the first stitch below on
};

struct LimbTube {
  TubeId id = 0;
  std::vector<RowId> rows;
  std::vector<Places> places;          // of each row
  std::vector<HandsRow> hands;         // of each row; of a cast on empty
  Places base;                         // what it begins on; a cast on: nothing
  std::int32_t bottom = -1, top = -1;  // deals; -1: an end
  // From a gap in the base, or in the first row: the gap in the last row, and how often a stitch is slipped back.
  std::vector<std::int32_t> last_of_base, slips_of_base, last_of_first, slips_of_first;
  std::vector<std::int32_t> turns_of_first;  // and how often short rows turn at it, or could not be worked
  std::vector<std::int32_t>
      mains;  // stitches of the first row at which a rhythm's sections begin; empty: it has none
  std::vector<std::int32_t> twins;  // tubes here, itself too
  bool inner = false;
  [[nodiscard]] bool has_rows() const { return !rows.empty(); }
};

struct LimbFork {
  DealKind kind = DealKind::split;
  std::vector<std::int32_t> from, to;  // tubes here
  std::array<Places, 2> arcs;          // of a split: each child's, from the pinch on
  std::array<HandsRow, 2>
      on_loops;  // of a ring cast on: first rows of `from` worked on the other's loops, which run backwards
  // Of a graft: each stitch of last row 0 with the stitches of last row 1 that it is joined to.
  std::vector<std::vector<std::int32_t>> joined;
};

class LimbTubes {
 public:
  // Requires all rows, joins and deals. Twins and inner tubes as the plan says, if there is one.
  LimbTubes(const Fabric& fabric, const TubePlan* plan);
  [[nodiscard]] std::int32_t count() const { return static_cast<std::int32_t>(tubes_.size()); }
  [[nodiscard]] const LimbTube& tube(std::int32_t i) const { return tubes_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] const LimbFork& fork(std::int32_t i) const { return forks_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] std::int32_t place_count() const { return static_cast<std::int32_t>(stitch_of_.size()); }
  // The two places of a bridge's stitch have one number, others their own.
  [[nodiscard]] std::int32_t stitch_of(std::int32_t place) const {
    return stitch_of_[static_cast<std::size_t>(place)];
  }
  // The deal whose bridge it is of; -1: a row's.
  [[nodiscard]] std::int32_t bridge_of(std::int32_t place) const {
    return bridge_of_[static_cast<std::size_t>(place)];
  }
  [[nodiscard]] bool splits(std::int32_t deal) const { return is_kind(deal, DealKind::split); }
  [[nodiscard]] bool joins(std::int32_t deal) const { return is_kind(deal, DealKind::join); }
  [[nodiscard]] bool casts_on_ring(std::int32_t deal) const { return is_kind(deal, DealKind::ring_cast_on); }
  [[nodiscard]] bool grafts(std::int32_t deal) const { return is_kind(deal, DealKind::ring_bind_off); }
  // Of a split's two children the other one, of a ring's two tubes too.
  [[nodiscard]] std::int32_t sibling(std::int32_t tube) const;
  [[nodiscard]] std::int32_t other_of_ring(std::int32_t deal, std::int32_t tube) const;
  // Which of the two a tube is.
  [[nodiscard]] std::size_t side(std::int32_t deal, std::int32_t tube) const;

 private:
  [[nodiscard]] bool is_kind(std::int32_t deal, DealKind kind) const {
    return deal >= 0 && fork(deal).kind == kind;
  }
  [[nodiscard]] LimbTube& tube_of(TubeId id);
  [[nodiscard]] std::int32_t index_of(TubeId id);
  void add_row(const Fabric& fabric, const Row& row);
  void add_deal(const Fabric& fabric, const Deal& deal, std::int32_t number);
  void add_ring(const Fabric& fabric, const Deal& deal, LimbFork& fork);
  [[nodiscard]] std::vector<std::int32_t> stitches_of(const Places& places) const;
  [[nodiscard]] std::vector<Places> split_places(LimbFork& fork,
                                                 const std::vector<std::vector<std::int32_t>>& given,
                                                 const Places& there, const Places& back) const;
  [[nodiscard]] Places joined_places(const LimbFork& fork, const std::vector<std::int32_t>& given,
                                     const Places& there, const Places& back) const;
  std::int32_t add_places(std::int32_t count, std::int32_t bridge, bool two_sides);
  void add_twins(const TubePlan* plan);
  std::vector<LimbTube> tubes_;
  std::vector<LimbFork> forks_;
  std::vector<Places> live_;  // of each tube, now
  std::vector<std::int32_t> stitch_of_, bridge_of_;
};

// The gap before place i of one loop, found in another that holds some of its places; -1: nothing is left of it.
std::int32_t same_gap(const Places& from, std::int32_t i, const Places& to);
Places turned_to(const Places& loop, std::int32_t first);

}  // namespace knit
