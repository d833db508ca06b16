// Stage 1, heights: how far up the surface each level of a field lies.
//
// Between two levels lies a band of the surface; its area divided by the mean length of its two edges is its
// mean slant height (exact for cones and cylinders). Summed from the start they give the height along the
// surface, by which a field can be re-timed so that equal steps are equally high. Mesh units.
#pragma once

#include <vector>

#include "knit/mesh/mesh.h"
#include "knit/model/heard.h"
#include "knit/model/products.h"

namespace knit {

// `field`: per vertex, within [0, 1] where referenced. The bands are made about equally high.
HeightScale measure_heights(const Input& input, const std::vector<double>& field, const Heard& heard = {});

double height_at(const HeightScale& scale, double value);
double value_at(const HeightScale& scale, double height);  // the inverse

}  // namespace knit
