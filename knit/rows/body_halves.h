// The front and the back of a tube that lies in a mesh's mirror plane: what each half of its rows holds.
//
// A row's curve crosses the plane at the back and at the front; of several crossings the outermost count. From its first row on
// that is longer than 0.15 of the longest, where the side mains stand half way between, they are carried as wales over
// the rows: from a place on one curve to the nearest place on the next, which stands at right angles to it. A side main keeps
// between 0.06 and 0.94 of its way from back to front, and no half changes by more than 4 stitches from row to row: where a body bends
// sharply the nearest place runs along the curve, and all shaping would crowd at one main. Rows before that are parted like it. What
// stands in front of the side mains is the front half. Cost: the points of all curves.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "knit/mesh/mirror_plane.h"
#include "knit/model/ring.h"
#include "knit/rhythm/joint_plan.h"
#include "knit/tubes/plan.h"

namespace knit {

inline constexpr double most_a_half_changes =
    4.0;  // stitches, of a row: what its mains give or take (joint_search.h)

// Along the curve to where it crosses the plane farthest at the back. None: it does not cross it.
std::optional<double> back_arc(const Ring& curve, const MirrorPlane& plane);

// Of a loop that a tube begins on the stitch that is nearest to where its first row crosses the plane farthest at the back. `loop`:
// places of the stitches, in working order. None: the row does not cross it.
std::optional<std::int32_t> back_stitch(std::span<const glm::dvec3> loop, const Ring& curve,
                                        const MirrorPlane& plane);

// In stitches. None: some row does not cross the plane, or is not its own mirror image in it to a tenth.
std::optional<HalfIdeals> half_ideals(const Tube& tube, const MirrorPlane& plane, double stitch_width);

}  // namespace knit
