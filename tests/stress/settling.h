// What settling may not change, for a run and the same run without it: the fabric as placed, its lines, its shape as a
// surface, its pattern in words; and that every stitch lies on the mesh. The first that fails as a sentence, empty: all hold.
#pragma once

#include <cmath>
#include <string>

#include "knit/limbs/limb_plan.h"
#include "knit/mesh/triangle_tree.h"
#include "knit/pattern/rounds.h"
#include "knit/pattern/written_pattern.h"
#include "knit/quality/measures.h"
#include "knit/run/state.h"

namespace test_support {

// As it is saved.
inline std::string pattern_text_of(const knit::State& state) {
  if (state.fabric.empty()) return {};
  const knit::Gauge gauge{22.0, 32.0};
  const bool chain = state.fabric.deals().empty();
  if (chain && state.fabric.joins().size() + 1 == state.fabric.rows().size())
    return pattern_as_text(write_pattern(knit::rounds_of(state), gauge, {}, "shape"));
  return pattern_as_text(write_pattern(knit::plan_limbs(state), gauge, {}, "shape"));
}

inline std::string broken_places(const knit::Input& input, const knit::State& settled) {
  const knit::TriangleTree tree(input.mesh.positions, input.mesh.triangles);
  const double reach = 1e-9 * input.bounds.diagonal();
  for (const glm::dvec3& p : knitting_path(settled.fabric)) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      return "a settled stitch has a place";
    if (tree.distance(p) > reach) return "a settled stitch lies on the mesh";
  }
  return {};
}

// Both are finished.
inline std::string broken_settling(const knit::Input& input, const knit::State& settled,
                                   const knit::State& unsettled) {
  if (unsettled.placed) return "without settling nothing is kept apart as placed";
  if (settled.fabric.strips().empty())
    return settled.fabric == unsettled.fabric ? "" : "nothing settles without faces";
  if (!settled.placed) return "what settled keeps where it was placed";
  if (placed_fabric(settled) != unsettled.fabric) return "settling moves stitches and nothing else";
  if (settled.lines != unsettled.lines) return "settling changes no line";
  if (euler_characteristic(settled) != euler_characteristic(unsettled)) return "settling keeps V - E + F";
  if (pattern_text_of(settled) != pattern_text_of(unsettled))
    return "settling changes no word of the pattern";
  return broken_places(input, settled);
}

}  // namespace test_support
