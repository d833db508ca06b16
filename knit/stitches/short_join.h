// Stage 4 for short rows: one stitch on one, whatever the placement; and the marks that turns leave for the row over them.
//
// A short row ends with a turn, labelled at the last cell that is worked: the last of the stretch on the right side, the first on
// the wrong side. The stitch beside it is marked: the row that works it next has the label there, where it would else be plain.
// A main's label stays; that it is marked the turn itself says.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "knit/fabric/fabric.h"

namespace knit {

// `mains`: places in what the row is worked on, rising. `from` is left to the caller. Requires is_short(row).
Join plan_short_join(std::span<const std::int32_t> mains, const Row& row);

// `marked`: places in what the join takes.
void mark_turns(Join& join, std::span<const std::int32_t> marked);

// Stitches below that a join works by themselves, as they are: one stitch on one, with no increase beside. A turn may stand beside these only.
std::vector<std::uint8_t> plain_below(const Join& join);

// The pairs of short rows that a round is worked over, in working order: the first and the last stitch of the round under them,
// the first below 0 where the arc runs over the beginning of the round.
std::vector<std::array<std::int32_t, 2>> short_arcs_below(const Fabric& fabric, RowId round);

}  // namespace knit
