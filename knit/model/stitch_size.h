// A knitter's gauge and a finished height against mesh units: two views of one stitch size.
//
// Centimetres a mesh unit = finished height / the mesh's height along the direction of knitting. Then
// w = (10 cm / stitches) and h = (10 cm / rounds) in mesh units, and back.
#pragma once

#include "knit/mesh/mesh.h"
#include "knit/model/settings.h"

namespace knit {

// Unit length: the axis, or the line between vertices that were picked, where both are of this mesh.
glm::dvec3 knitting_direction(const TimingSettings& timing, const Mesh& mesh);

// The parameters with the stitch's size worked out from the given view. What the other view said stays to the bit where
// it says the same but for rounding, so that turning the switch to and fro changes nothing.
Parameters resolved(const Parameters& parameters, const Input& input);

// One rule for whoever sets a size: a size in one view makes that view the given one, and epsilon goes with the width
// unless it is set too, before or after.
void give_width(Parameters& parameters, double width);
void give_height(Parameters& parameters, double height);  // 0: as the width says
void give_gauge(Parameters& parameters, Gauge gauge);
void give_sizes(Parameters& parameters, SizesFrom view);  // as the other view has it now
// The finished piece so many times as large, in as large stitches: in the gauge's view another height, to a tenth of a
// millimetre as a person would set it, in the mesh's other stitches on the same mesh.
void give_size(Parameters& parameters, double times);
void give_epsilon(Parameters& parameters, double epsilon);

}  // namespace knit
