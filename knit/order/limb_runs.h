// Which deals a piece begins with, in an order of pieces, and so which pieces are worked with one yarn.
//
// On the needle hangs one loop with its yarn, all other live loops wait on holders. A piece that begins on a split goes on with
// what is on the needle if that is the loop that is split; on a join, if the needle has one of the loops joined. Else the needle
// is put on a holder, and a holder's stitches with a new yarn on the needle. Tubes without rows are dealt when a piece needs
// them, not before: a join of many limbs is one line. O(tubes) an order.
#pragma once

#include <optional>
#include <vector>

#include "knit/order/limb_tubes.h"

namespace knit {

enum class LimbStepKind : std::uint8_t { cast_on, provisional, loops, rejoin, set_aside, divide, join };

constexpr bool begins_yarn(LimbStepKind kind) {
  return kind == LimbStepKind::cast_on || kind == LimbStepKind::provisional || kind == LimbStepKind::loops ||
         kind == LimbStepKind::rejoin;
}

struct LimbStep {
  LimbStepKind kind = LimbStepKind::cast_on;
  std::int32_t tube = 0;  // whose loop comes of it; set aside: whose goes
  std::int32_t other =
      -1;  // loops: whose they are. divide: the child that is held. join: the tube that brings the yarn
  friend bool operator==(const LimbStep&, const LimbStep&) = default;
};

struct LimbRuns {
  std::vector<std::int32_t> order;           // tubes with rows
  std::vector<std::vector<LimbStep>> steps;  // of each of them
  std::vector<std::uint8_t> goes_on;         // of each of them: the next one goes on with its yarn
  std::vector<std::uint8_t> grafted;         // of each: to a loop on a holder
  std::int32_t held_most = 0;                // holders while rounds are worked
  // Whether a piece begins a yarn.
  [[nodiscard]] bool begins_yarn(std::size_t piece) const;
};

// Nothing where a tube comes before one that it stands on.
std::optional<LimbRuns> runs_of(const LimbTubes& tubes, const std::vector<std::int32_t>& order);

// The tubes with rows that must be there before this one. Of a ring cast on either may be first, unless its loops are more than
// twice as many as the other begins with: no more than two are taken together.
std::vector<std::int32_t> tubes_below(const LimbTubes& tubes, std::int32_t tube);

}  // namespace knit
