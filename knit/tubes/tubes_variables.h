// The variables of the pseudo-code that are first met in the stage tubes.
#pragma once

#include "knit/model/event.h"

namespace knit::var {

inline constexpr CodeVariable smoothing{"smoothing", "c h", "Over what length the field is smoothed."};
inline constexpr CodeVariable raw_tubes{"raw_tubes", "raw tubes",
                                        "Into how many tubes the level sets fell before."};
inline constexpr CodeVariable tubes{"tubes", "tubes", "How many tubes there are."};
inline constexpr CodeVariable nodes{"nodes", "nodes",
                                    "How many critical vertices there are, each splitting one thing."};
inline constexpr CodeVariable graph_loops{"graph_loops", "loops",
                                          "How many loops the graph has: the surface's genus."};
inline constexpr CodeVariable unfolded{"unfolded", "unfolded",
                                       "How many vertices were added to unfold multiple saddles."};
inline constexpr CodeVariable node{"node", "c", "The critical vertex that the sweep has come to."};
inline constexpr CodeVariable node_kind{"node_kind", "kind", "What happens to level sets there."};
inline constexpr CodeVariable field_value{"field_value", "f(c)", "The field's value there."};
inline constexpr CodeVariable closed{"closed", "closed", "How many tubes end there."};
inline constexpr CodeVariable opened{"opened", "opened", "How many tubes begin there."};
inline constexpr CodeVariable handle{"handle", "handle", "Whether it is a handle; else it is a limb."};
inline constexpr CodeVariable leaf_rows{"leaf_rows", "H / h",
                                        "How many rows high the tube is that is left out."};
inline constexpr CodeVariable leaf_girth{"leaf_girth", "L / w", "How many stitches round it is."};
inline constexpr CodeVariable keeps{"keeps", "w that keeps", "A stitch width that would keep it."};
inline constexpr CodeVariable together{"together", "together",
                                       "How many limbs lower than a twentieth of a round are left out."};
inline constexpr CodeVariable left_share{"left_share", "share",
                                         "How much of the surface they are at most, of 1."};
inline constexpr CodeVariable planned_rows{"planned_rows", "rows", "How many rows all tubes together get."};
inline constexpr CodeVariable events{"events", "events",
                                     "How many cast ons, splits, joins and bind offs there are."};
inline constexpr CodeVariable held{"held", "held", "How many loops wait on holders at once, at most."};
inline constexpr CodeVariable exact{"exact", "exact", "Whether no other order needs fewer holders."};
inline constexpr CodeVariable orders_tried{"orders_tried", "orders",
                                           "How many orders were tried, stitch by stitch."};
inline constexpr CodeVariable yarns{"yarns", "yarns", "How many yarns are begun."};

}  // namespace knit::var
