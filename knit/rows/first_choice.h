// The settings of a first run on a mesh of which nobody has said anything: one that works.
#pragma once

#include "knit/mesh/mesh.h"
#include "knit/model/settings.h"

namespace knit {

// Whether the mesh has rings all the way along its time, and is one tube: every level of two or more is a ring, none parts.
// Linear time alone; larger meshes than `most_ringed_triangles` are not looked at and have none.
inline constexpr std::size_t most_ringed_triangles = 200000;
bool has_rings(const Input& input, const TimingSettings& timing);

// default_parameters() with rows from rings where there are such, as in the thesis, else from contours with stitches placed
// by nearness: any shape. Resolved on the mesh.
Parameters first_parameters(const Input& input);

}  // namespace knit
