// Stages 2 and 3 with contours: a round that begins where the round below begins, so that its beginning follows a wale.
//
// n stitches stand at equal arcs from some start; which start? The one whose wales are shortest: the stitches are matched
// to the live stitches as placement `nearest` does, but with the round turned by every q of a window, and of all the least
// sum of squares is taken; then the row slides by the mean sideways offset of its wales and is matched again, at most three
// times, while the sum falls. The stitch that hangs on the first live stitch begins the round. Right after a deal the loop has
// corners, and sliding ends in one of several places: eight are tried, and of them the one is taken whose wales are most nearly
// a row high, sum of (length - h)^2, where it is a twentieth better than the first.
// recurrence: cost(j, k) = |s_j - g_(j+k)|^2 + min(cost(j-1, k), cost(j-1, k-1) + |s_(j-1) - g_(j+k-1)|^2),
// s the smaller round, g the larger, k doublings so far. Cost: n x window x (change + 1) a pass.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "knit/fabric/stitch.h"
#include "knit/model/ring.h"
#include "knit/rows/frame.h"

namespace knit {

struct RoundMatch {
  std::int32_t turn = 0;  // the stitch of the row that hangs on the first live stitch
  double sum_of_squares = 0.0;
  std::vector<std::int32_t>
      link;  // a cell of the larger round each, cells of the row counted from `turn`: its stitch in the smaller
};
// `turns`: how far to either side the row may be turned; at least half its stitches: any way. Requires
// ceil(below / 2) <= above <= 2 * below.
RoundMatch match_round(std::span<const glm::dvec3> below, std::span<const glm::dvec3> above,
                       std::int32_t turns);

// Where a row of `count` stitches begins.
struct BegunRound {
  double arc = 0.0;   // along the curve
  double slid = 0.0;  // by which the row was moved from where it was first set down
  double sum_of_squares = 0.0;
  std::int32_t passes = 0;
};
// `free`: any turn, as after a deal, from several phases of a stitch: of where sliding ends the one whose wales come nearest to
// `height`; else a few stitches to either side of the nearest place.
BegunRound follow_wale(const Ring& curve, std::int32_t count, std::span<const Stitch> below, bool free,
                       double height);

// The same where it is known how the row will hang, `links` as RoundMatch has them with turn 0: the row slides to where the sum
// of the squares of these wales is least: where their mean offset is 0, by at most three secant steps. Requires links for max(count, below) cells.
BegunRound follow_links(const Ring& curve, std::int32_t count, std::span<const Stitch> below,
                        std::span<const std::int32_t> links);

// Where the curve, round its centre, crosses the half-plane towards frame.right: of several places the one nearest to
// `below`, or without that the outermost; where it does not go round its centre there, the point farthest on that side.
double arc_towards(const Ring& curve, const RowFrame& frame, const std::optional<glm::dvec3>& below);

// The same curve, its first point at `arc`.
Ring begun_at(const Ring& curve, double arc);

}  // namespace knit
