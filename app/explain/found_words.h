// What was found when a mesh was opened, in one line: its size, along which axes it has rings, its handles, and how it is
// knitted.
#pragma once

#include <string>

#include "app/session/session.h"
#include "knit/mesh/mesh.h"

namespace app {

// "Closed, 1,922 triangles, 2 x 2 x 2 units; rings along x, y and z; no handle." Larger meshes than
// `most_searched_triangles` are not searched for rings. Some milliseconds: to be kept.
inline constexpr std::size_t most_searched_triangles = 20000;
std::string shape_words(const knit::Input& input);

// "Knitted along y from contours, as 5 tubes with 4 limbs."; of the run as far as it has come. Requires something open.
std::string knitted_words(const Session& session);

// Why a finished run did not stop: how it is knitted, and, where its rows come from contours, why rings would have stopped.
// The run with rings is worked out for it, of no larger meshes than `most_searched_triangles`: to be kept.
std::string finished_words(const Session& session);

}  // namespace app
