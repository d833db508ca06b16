// The variables of the pseudo-code of the stage settle.
#pragma once

#include "knit/model/event.h"

namespace knit::var {

inline constexpr CodeVariable moved{"moved", "x", "How many stitches are moved."};
inline constexpr CodeVariable wale_edges{"wale_edges", "wales",
                                         "How many edges between rows shall be h long."};
inline constexpr CodeVariable course_edges{"course_edges", "courses",
                                           "How many edges along rows shall be w long."};
inline constexpr CodeVariable settle_sum{"settle_sum", "E",
                                         "The sum of the weighted squares, which is made small."};
inline constexpr CodeVariable sum_before{"sum_before", "E before", "The sum before the iteration."};
inline constexpr CodeVariable taken{"taken", "taken",
                                    "Whether the step was taken; else none made it better."};
inline constexpr CodeVariable iteration{"iteration", "k", "The number of the iteration, from 1."};
inline constexpr CodeVariable tries{"tries", "tries", "How many shifts were tried in it."};
inline constexpr CodeVariable shift{"shift", "\xCE\xBC",
                                    "The shift: how carefully the step goes; more is shorter."};
inline constexpr CodeVariable mean_move{"mean_move", "mean move", "How far a stitch moved on average, in w."};
inline constexpr CodeVariable greatest_move{"greatest_move", "greatest move",
                                            "How far the one moved that moved most, in w."};

}  // namespace knit::var
