// Wavefront OBJ to Mesh, through tinyobjloader: triangles, quads and polygons (triangulated), free of NaN
// surprises.
//
// Never throws on bad data: the error is one sentence that says what, where and what to do. Sizes and indices
// are not trusted; index range and finiteness are check.h's to judge, except where the file cannot be read at
// all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <istream>
#include <string>
#include <variant>

#include "knit/import/progress.h"
#include "knit/mesh/mesh.h"

namespace knit {

struct ObjError {
  std::string sentence;
};

// What the file has and the mesh has not.
struct ObjNotes {
  std::size_t loose_edges = 0;  // faces of two corners
  std::size_t loose_line = 0;   // where the first of them stands, from 1
};

// `progress`: told how far it has come; reading stops with Cancelled when that is wished.
// `notes`: filled where the file could be read.
std::variant<Mesh, ObjError> read_obj(std::istream& in, const std::string& name, Progress* progress = nullptr,
                                      ObjNotes* notes = nullptr);
std::variant<Mesh, ObjError> read_obj_file(const std::filesystem::path& path, Progress* progress = nullptr,
                                           ObjNotes* notes = nullptr);

}  // namespace knit
