// Meshes and runs that many tests need.
#pragma once

#include <memory>
#include <vector>

#include "knit/mesh/shapes.h"
#include "knit/model/stitch_size.h"
#include "knit/run/timeline.h"

namespace test_support {

inline std::shared_ptr<const knit::Input> thesis_sphere() {
  return knit::make_input(knit::sphere(128, 65, true));
}

// A sphere whose rows need increases, plain rows and decreases, in about two thousand steps.
inline std::shared_ptr<const knit::Input> small_sphere() {
  return knit::make_input(knit::sphere(40, 16, false));
}

inline knit::Parameters thesis_parameters() {
  knit::Parameters parameters;
  parameters.rows.close = knit::Closing::thesis;
  return parameters;
}

// For the small sphere: no stall.
inline knit::Parameters small_parameters() {
  knit::Parameters parameters;
  knit::give_width(parameters, 0.3);
  parameters.rows.epsilon = {0.15, 0.3};
  return parameters;
}

inline std::vector<int> row_sizes(const knit::State& state) {
  std::vector<int> sizes;
  for (const auto& row : state.fabric.rows()) sizes.push_back(static_cast<int>(row->stitches.size()));
  return sizes;
}

}  // namespace test_support
