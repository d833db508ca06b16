// The variables of the pseudo-code of short rows.
#pragma once

#include "knit/model/event.h"

namespace knit::var {

inline constexpr CodeVariable rows_kept{"rows_kept", "m",
                                        "Rows that tubes keep beside events; none: no short rows at all."};
inline constexpr CodeVariable settled_sum{"settled_sum", "sum",
                                          "What is left in the settled fabric, a thousandth a stitch."};
inline constexpr CodeVariable sum_without{"sum_without", "sum without", "The same without short rows."};
inline constexpr CodeVariable chart_levels{"chart_levels", "levels", "How many levels the tube's chart has."};
inline constexpr CodeVariable residual{
    "residual", "residual", "By how much the chart's angle is not square to its time, as a share."};
inline constexpr CodeVariable near_spacing{"near_spacing", "h'",
                                           "How far the full rounds lie apart where the tube is shortest."};
inline constexpr CodeVariable full_rounds{"full_rounds", "rounds", "How many full rounds the tube gets."};
inline constexpr CodeVariable no_chart{"no_chart", "none", "Why the tube keeps its level rows."};
inline constexpr CodeVariable short_gap{"short_gap", "k",
                                        "The gap between a full round and the next, from 1."};
inline constexpr CodeVariable lag{"lag", "lag", "How many rows are missing in the gap where most are."};
inline constexpr CodeVariable least_lag{"least_lag", "least lag", "How many are missing where fewest are."};
inline constexpr CodeVariable lag_column{"lag_column", "c",
                                         "The column of the chart where most are missing."};
inline constexpr CodeVariable arc_from{"arc_from", "b", "The column where the arc begins."};
inline constexpr CodeVariable arc_to{"arc_to", "a", "The column where the arc ends."};
inline constexpr CodeVariable gain{"gain", "gain", "What a pair there gains of squared lag, in stitches."};
inline constexpr CodeVariable price{"price", "price", "What its two turns cost, in stitches."};
inline constexpr CodeVariable arc_taken{"arc_taken", "taken", "Whether the arc gets a pair."};
inline constexpr CodeVariable pairs{"pairs", "pairs", "How many pairs of short rows the tube gets."};
inline constexpr CodeVariable lag_left{"lag_left", "lag left", "The greatest lag that is left in any gap."};
inline constexpr CodeVariable first_stitch{
    "first_stitch", "B", "The pair's first stitch, counted from the beginning of the round."};
inline constexpr CodeVariable last_stitch{"last_stitch", "A", "The pair's last stitch."};
inline constexpr CodeVariable turn_moved{"turn_moved", "moved",
                                         "How far a turn was moved to a plain stitch."};
inline constexpr CodeVariable drop_reason{"drop_reason", "left out", "Why a pair is not worked."};
inline constexpr CodeVariable short_stitches{"short_stitches", "stitches", "How many the short row has."};
inline constexpr CodeVariable wrong_side{"wrong_side", "wrong side", "Whether the short row is worked back."};

}  // namespace knit::var
