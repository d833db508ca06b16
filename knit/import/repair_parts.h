// Parts of repair.h that stand in files of their own.
#pragma once

#include <string>
#include <vector>

#include "knit/import/repair.h"

namespace knit {

// A repair and its effect: what it is about, and the words with the verb as it would be and as it was.
struct Effect {
  Mesh mesh;
  std::size_t count = 0;         // 0: nothing to do, and the rest means nothing
  std::string verb, past, what;  // "drops", "dropped", "2 pieces of 40 triangles"
};

// The mesh with these triangles instead. Vertices that only the old ones used go, as do edges (Mesh::edges) that no
// triangle has any more.
Mesh with_triangles(const Mesh& mesh, std::vector<Triangle> triangles);

Effect weld_near(const Mesh& mesh);
Effect fill_holes(const Mesh& mesh);
Effect close_openings(const Mesh& mesh);

}  // namespace knit
