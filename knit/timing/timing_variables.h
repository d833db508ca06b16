// The variables of the pseudo-code that are first met in the stage timing: what they are called, their symbols (as in
// the thesis where it has one) and their meaning.
#pragma once

#include "knit/model/event.h"

namespace knit::var {

inline constexpr CodeVariable start{"start", "v_start", "The vertex where knitting begins; its time is 0."};
inline constexpr CodeVariable end{"end", "v_end", "The vertex where knitting ends; its time is 1."};
inline constexpr CodeVariable direction{"direction", "d",
                                        "The way from start to end, along which time rises."};
inline constexpr CodeVariable mag{"mag", "mag", "The length of the way from start to end, in mesh units."};
inline constexpr CodeVariable vertex{"vertex", "vi", "The vertex that gets its time."};
inline constexpr CodeVariable diff{"diff", "diff", "The way from the start to the vertex."};
inline constexpr CodeVariable time{
    "time", "t", "The time, from 0 at the start to 1 at the end: what orders the knitting."};
inline constexpr CodeVariable clamped{"clamped", "clamped",
                                      "Whether the vertex lies beyond the start or the end."};
inline constexpr CodeVariable minima{"minima", "min", "How many places of the surface are lowest in time."};
inline constexpr CodeVariable saddles{"saddles", "saddles",
                                      "How many places there are where level sets part or join."};
inline constexpr CodeVariable maxima{"maxima", "max", "How many places of the surface are highest in time."};
inline constexpr CodeVariable euler{
    "euler", "\xCF\x87", "The surface's Euler characteristic: vertices less edges plus triangles."};
inline constexpr CodeVariable levels{"levels", "levels", "How many levels of equal time there are."};
inline constexpr CodeVariable tolerance{"tolerance", "tolerance",
                                        "By how much times of one level may differ from the next."};
inline constexpr CodeVariable outside{"outside", "outside", "How many vertices lie beyond start or end."};
inline constexpr CodeVariable split_level{"split_level", "split at",
                                          "The first level of several loops, if there is one."};
inline constexpr CodeVariable split_loops{"split_loops", "loops there", "How many loops that level has."};
inline constexpr CodeVariable height{"height", "H", "The height of the surface from start to end, along it."};
inline constexpr CodeVariable bands{"bands", "bands",
                                    "How many bands between two level sets the height was summed over."};
inline constexpr CodeVariable net{"net", "net", "How many triangles the net of edge lengths has."};
inline constexpr CodeVariable unknowns{"unknowns", "unknowns",
                                       "How many unknowns the linear system has: one a vertex."};
inline constexpr CodeVariable slopes{"slopes", "X", "In how many triangles the slope was turned and made 1."};
inline constexpr CodeVariable far{"far", "\xCF\x86(v_end)",
                                  "How far the end is from the start along the surface."};

inline constexpr CodeVariable timing_kind{"timing_kind", "timing", "How the time shall rise."};
inline constexpr CodeVariable worst{"worst", "worst at", "The vertex where linear timing serves least."};
inline constexpr CodeVariable flat{"flat", "flat",
                                   "The share of the surface that lies flat across the axis."};
inline constexpr CodeVariable unevenness{
    "unevenness", "uneven", "By how much the distance between rows would vary, as a share of its mean."};

}  // namespace knit::var
