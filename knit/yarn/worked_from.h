// What each loop is pulled through, and the order in which hands make the loops: a fabric as its yarn knows it.
//
// Rows are rounds, and each of them is one way of the yarn; but short rows are worked within the round over them. So the round
// is worked as far as the stretch begins, then the row there and the row back, then the rest. Where the stretch runs over the
// beginning of the round, the yarn comes to it in the middle: there to the stretch's end, back over all of it, there again from
// its first stitch to the beginning of the round. Of the two loops of such a wale before the beginning of the round the lower is
// then worked back.
// A new yarn begins with each row that is not worked on the row before, and with what was dealt after that.
// Cost: stitches and, for each stretch of live stitches, rows.
#pragma once

#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

#include "knit/fabric/fabric.h"

namespace knit {

// bridge: cast on across a gap, or the edge that two tubes share; used from both sides. picked_up: worked into such an edge from
// its lower side.
enum class LoopKind : std::uint8_t { cast_on, bridge, picked_up, knit, k2tog, ssk, m1l, m1r };
inline bool is_increase(LoopKind kind) { return kind == LoopKind::m1l || kind == LoopKind::m1r; }

inline constexpr std::uint32_t no_stitch = ~std::uint32_t{0};

// Stitches by number along the knitting path.
struct WorkedFrom {
  LoopKind kind = LoopKind::cast_on;
  std::array<std::uint32_t, 2> parents{no_stitch, no_stitch};  // in working order; a knit stitch has one
  // An increase: the two stitches beside the bar that it is made of, and those beside them.
  std::array<std::uint32_t, 4> beside{no_stitch, no_stitch, no_stitch, no_stitch};
  [[nodiscard]] auto fields() const { return std::tie(kind, parents, beside); }
  friend bool operator==(const WorkedFrom&, const WorkedFrom&) = default;
};

// Of all stitches along the knitting path. Requires a fabric whose rows have their joins.
std::vector<WorkedFrom> worked_from(const Fabric& fabric);

struct YarnStep {
  std::uint32_t stitch = 0;
  bool back = false;  // worked against the order of its row
  friend bool operator==(const YarnStep&, const YarnStep&) = default;
};
struct YarnPath {
  std::vector<YarnStep> steps;
  RowId last = 0;  // the last row that it works; 0: it has none
};
// In working order. Every stitch once.
std::vector<YarnPath> yarn_paths(const Fabric& fabric);

}  // namespace knit
