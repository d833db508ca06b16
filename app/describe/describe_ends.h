// Where the surface goes on beyond the first and the last row of a limb, so that it is drawn there though the limbs' ends
// lie at times of their own.
#pragma once

#include <vector>

#include "knit/mesh/mesh.h"
#include "knit/tubes/plan.h"

namespace app {

// What is told of a vertex, and so what of the surface is covered by faces: a triangle is not where one of its corners is
// beyond an end.
inline constexpr float beyond_an_end = 0.0F;
inline constexpr float between_ends = 1.0F;

// One a vertex of the mesh. From each place where a tube is cast on or bound off the vertices are walked that lie before its
// first row or after its last: as many steps as there are such vertices.
std::vector<float> ends_of(const knit::Input& input, const knit::TubeGraph& graph,
                           const knit::TubePlan& plan);

}  // namespace app
