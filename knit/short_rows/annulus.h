// The two fields that a tube's chart is made of, solved on its part of the mesh: a harmonic time and the angle round it.
//
// With u(e) the change of u along a side e, a triangle's share of the scalar product of two slopes is the sum over its sides of
// cot / 2 u(e) v(e), cot that of the angle opposite; so no coordinates are needed.
//   time    L t = 0, t = 0 on the low rim, 1 on the high one; L by exact cotangents: some weights may be negative
//   flux    G = t' L t, what flows from rim to rim
//   target  q(e) = (cot_i (t_k - t_j) + cot_j (t_k - t_i)) / G, e from corner i to j, k opposite: slope t turned by a quarter
//   period  n(e) = 1 or -1 on sides that a path of triangles from rim to rim crosses, 0 on all others
//   angle   least squares of s(e) + n(e) - q(e): L s = divergence of q - n, one place given
// Cost: two sparse factorisations (nested dissection) and solves.
// U. Pinkall, K. Polthier, "Computing discrete minimal surfaces and their conjugates", 1993.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "knit/model/heard.h"
#include "knit/short_rows/tube_part.h"

namespace knit {

struct AnnulusFields {
  std::vector<double> time;  // per point
  std::vector<std::array<double, 3>>
      angle;              // per corner; runs straight in each triangle, neighbours differ by whole turns
  double residual = 0.0;  // least squares over the target's
};

// The angle rises in working order, and is 0 on the low rim nearest to the part's beginning. None where the equations cannot
// be solved.
std::optional<AnnulusFields> solve_annulus(const TubePart& part, const Heard& heard = {});

}  // namespace knit
