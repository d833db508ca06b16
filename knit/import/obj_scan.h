// What tinyobjloader reads over in silence, found beforehand in one pass over the text.
//
// tinyobjloader takes "nan", "1,5" and missing coordinates as 0 or cuts them short, wraps huge indices round
// and skips lines that it does not know. After a scan without an error it reads exactly what the file says.
#pragma once

#include <cstddef>
#include <string>

#include "knit/import/progress.h"

namespace knit {

struct ObjScan {
  std::size_t vertices = 0;
  std::size_t faces = 0;
  std::size_t corners = 0;  // of all faces
  std::size_t skip = 0;     // bytes of a byte order mark
  std::size_t loose_edges = 0,
              loose_line = 0;  // faces of two corners, which are left out; the first one's line
  std::string error;  // empty, or: ", line 12: what is wrong and what to do." to follow the file's name
};

// Joins lines that a backslash continues, blanks comments behind faces, faces of two corners, form feeds, vertical
// tabs and what ZBrush and DOS end a file with, and makes "fo" an "f"; in place (the length stays).
ObjScan scan_obj(std::string& text, PartProgress progress = {nullptr, 0.0, 1.0});

}  // namespace knit
