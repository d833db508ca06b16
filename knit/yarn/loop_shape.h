// The shape of a loop between two frames: its base, where it comes out of the fabric below, and its head, where the next loop
// comes out of it.
//
// In a frame u runs along the course in stitch widths from the middle, v up the wale from 0 at the base to 1 at the head, n
// outwards in stitch widths. The plain loop, t from 0 to 1 along the yarn:
//   u = t - 1/2 + a2 sin 4 pi t + a4 sin 8 pi t
//   v = 1/2 - (A1 cos 2 pi t + A3 cos 6 pi t) / 0.72
//   n = - d2 cos 4 pi t - d4 cos 8 pi t + d1 cos 2 pi t
// It is of Munden's length sqrt(21 h w) [knit/pattern/yarn.h] and, of such curves, the one that overlaps its neighbours least:
// with a radius of w/8 not at all, from h = 0.6 w up. Only v depends on h, so one shape does for all.
// The twisted loop has its head mirrored: its legs cross above the foot, the arriving one in front or behind.
#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "knit/yarn/yarn_curve.h"

namespace knit {

// At t = i / 12; the last is the first of the next loop.
struct LoopPoint {
  double u = 0.0, v = 0.0, n = 0.0;
};
using LoopShape = std::array<LoopPoint, points_a_stitch + 1>;
LoopShape plain_loop();
LoopShape twisted_loop(bool arrives_in_front);

struct LoopFrame {
  glm::dvec3 place{0.0};
  glm::dvec3 course{1.0, 0.0, 0.0};  // a stitch's width along the row, in working order
  glm::dvec3 wale{0.0, 1.0, 0.0};    // a stitch's height upwards
  glm::dvec3 out{0.0, 0.0, 1.0};     // of length 1
  double raised = 0.0;               // along `out`
};

// The mean of both, `out` of length 1.
LoopFrame between(const LoopFrame& a, const LoopFrame& b);

// The middle line is the Hermite cubic from base to head along their wales, straight beyond them; course, out and raised go
// from one frame to the other with v^2 (3 - 2 v).
glm::dvec3 placed(const LoopPoint& point, const LoopFrame& base, const LoopFrame& head, double stitch_width);

}  // namespace knit
