// A run from contours of a shape that stands upright, to its end, as tests of what branches want it.
#pragma once

#include "knit/model/stitch_size.h"
#include "knit/run/timeline.h"
#include "tests/support/catch.h"

namespace test_support {

// `width_share`: of the bounds' diagonal.
inline knit::State standing_run(const knit::Mesh& mesh, double width_share) {
  const auto input = knit::make_input(mesh);
  knit::Parameters parameters = knit::default_parameters(input->bounds);
  knit::give_width(parameters, width_share * input->bounds.diagonal());
  parameters.rows.source = knit::RowSource::contours;
  parameters.stitches.placement = knit::PlacementPolicy::nearest;
  parameters = knit::resolved(parameters, *input);
  parameters.timing.axis.kind = knit::AxisKind::y;
  knit::Timeline run(input, parameters);
  run.extend_to_end();
  REQUIRE(run.complete());
  return run.furthest();
}

}  // namespace test_support
