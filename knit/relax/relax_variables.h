// The variables of the pseudo-code of the stage relax.
#pragma once

#include "knit/model/event.h"

namespace knit::var {

inline constexpr CodeVariable hung{"hung", "x",
                                   "How many stitches are moved, where their springs pull them."};
inline constexpr CodeVariable springs{"springs", "springs",
                                      "How many springs there are: courses, wales and diagonals."};
inline constexpr CodeVariable lidded{"lidded", "lidded",
                                     "How many inner rows, as of a mug's hollow, are not stuffed."};
inline constexpr CodeVariable stuffing{"stuffing", "stuffing",
                                       "How firmly it is stuffed: about the share by which it stretches."};
inline constexpr CodeVariable pressure{"pressure", "p", "What the stuffing presses with."};
inline constexpr CodeVariable ball_radius{"ball_radius", "R",
                                          "The radius of the ball with the fabric's area."};
inline constexpr CodeVariable relax_iteration{"relax_iteration", "k", "The number of the iteration, from 1."};
inline constexpr CodeVariable touching{"touching", "pairs",
                                       "How many pairs of stitches keep each other from passing through."};
inline constexpr CodeVariable volume{"volume", "V", "The room inside, in cubic mesh units."};
inline constexpr CodeVariable restarted{"restarted", "restart",
                                        "Whether the momentum led uphill, so that it starts again."};
inline constexpr CodeVariable relax_move{"relax_move", "move",
                                         "How far the stitch moved that moved most, in w."};
inline constexpr CodeVariable knitted_height{"knitted_height", "height", "How high it comes out."};
inline constexpr CodeVariable knitted_width{"knitted_width", "width", "How wide it comes out."};
inline constexpr CodeVariable asked_height{"asked_height", "asked height",
                                           "How high the mesh asks it to be."};
inline constexpr CodeVariable asked_width{"asked_width", "asked width", "How wide the mesh asks it to be."};
inline constexpr CodeVariable sunk_first{"sunk_first", "first end",
                                         "How far the first row lies below the piece's extreme."};
inline constexpr CodeVariable sunk_last{"sunk_last", "last end",
                                        "How far the last row lies below the piece's extreme."};
inline constexpr CodeVariable came_to_rest{"came_to_rest", "rest",
                                           "Whether it came to rest; else the iterations ran out."};

}  // namespace knit::var
