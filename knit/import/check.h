// What is wrong with a mesh, said before anything runs. Each finding says what, how many and where.
//
// Topology is judged by position (see mesh.h), so a seam of coincident vertices counts as closed.
// Error: the method cannot run. Warning: it can, and the person should know.
#pragma once

#include <string>
#include <vector>

#include "knit/import/progress.h"
#include "knit/mesh/mesh.h"

namespace knit {

enum class Severity { warning, error };

enum class FindingKind {
  no_triangles,
  not_finite,          // error
  index_out_of_range,  // error
  several_pieces,      // error
  open_edges,  // says how many boundary loops and where. Warning: one or two long ones, to knit from; else error
  edge_not_manifold,    // error: an edge of three or more triangles
  vertex_not_manifold,  // error: a bow-tie
  not_orientable,       // error: a Moebius strip
  flipped_faces,        // warning: orientable, yet neighbours disagree
  inside_out,           // warning: closed and consistent, but of negative volume
  zero_area,            // warning
  no_extent,            // error: all vertices at one place or in one plane, or no face has three places
  unreferenced,         // warning
  coincident,           // warning: vertices at the same place; welding merges them
  loose_edges,          // warning: faces of two corners in the file, which are left out (obj.h)
  cut_off,              // warning: what lies beyond the curves that knitting begins and ends at (knit/curves)
};

struct Finding {
  FindingKind kind{};
  Severity severity{};
  std::size_t count = 0;
  std::vector<VertexId> where;  // the first few vertices concerned, ascending
  std::string
      sentence;  // "2 holes; the first at vertex 17 (0.1, 0.2, 0.3). Close them and open the mesh again."
};

struct CheckResult {
  std::vector<Finding> findings;   // errors first
  [[nodiscard]] bool fit() const;  // no error
};

// `progress`: told how far it has come; checking stops with Cancelled when that is wished.
CheckResult check(const Mesh& mesh, Progress* progress = nullptr);

}  // namespace knit
