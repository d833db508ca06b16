// A knitter's gauge and a finished height against mesh units: two views of one stitch size.
//
// Centimetres a mesh unit = finished height / the mesh's height along the direction of knitting. Then
// w = (10 cm / stitches) and h = (10 cm / rounds) in mesh units, and back.
#pragma once

#include "knit/mesh/mesh.h"
#include "knit/model/parameters.h"

namespace knit {

// Unit length: the axis, or the line between vertices that were picked, where both are of this mesh.
glm::dvec3 knitting_direction(const Parameters& parameters, const Mesh& mesh);

double centimetres_per_unit(const Parameters& parameters, const Input& input);

// The parameters with both views equal: the view that `sizes` does not name follows the one that it names.
Parameters agreed(const Parameters& parameters, const Input& input);

// Setting a stitch size in one view makes that view the given one. Other keys change nothing.
void give_size_by(std::string_view key, Parameters& parameters);

}  // namespace knit
