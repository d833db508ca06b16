// A shape that bends, so that short rows pay, and settings for it.
#pragma once

#include <cmath>
#include <glm/vec3.hpp>
#include <memory>

#include "knit/mesh/shapes.h"
#include "knit/model/settings_table.h"
#include "knit/model/stitch_size.h"

namespace test_support {

// A long ellipsoid, bent over its length by `turn` radians about z.
inline std::shared_ptr<const knit::Input> bent_ellipsoid(double turn) {
  using namespace knit;
  Mesh mesh = sphere(28, 40, false);
  const double half = 4.0;
  for (glm::dvec3& p : mesh.positions) {
    const double along = half * p.y;
    if (turn == 0.0) {
      p.y = along;
      continue;
    }
    const double radius = 2.0 * half / turn, angle = along / radius;
    p = {radius - (radius - p.x) * std::cos(angle), (radius - p.x) * std::sin(angle), p.z};
  }
  return make_input(std::move(mesh));
}

inline knit::Parameters parameters_of(const knit::Input& input, knit::ShortRows rows) {
  using namespace knit;
  Parameters parameters = default_parameters(input.bounds);
  give_width(parameters, 0.36);
  give_height(parameters, 0.36);
  parameters.timing.kind = TimingKind::harmonic;
  parameters.rows.source = RowSource::contours;
  parameters.stitches.placement = PlacementPolicy::nearest;
  parameters.settle.settling = Settling::on;
  parameters.short_rows.rows = rows;
  return resolved(parameters, input);
}

}  // namespace test_support
