// The knit mesh as a stitch mesh of typed edges, `.smobj` (Textiles Lab, Carnegie Mellon).
//
// Text like OBJ: L lines name kinds of faces with their edges, counter-clockwise from the bottom left: l1 where a loop goes
// through, y1 where the yarn does, - into the face and + out of it; then v lines, an f and a T (kind) line a face, and e lines
// that say which edges are one: face/edge, counted from 1, - where the second runs the other way.
//   knit       -l1 -y1 +l1 +y1     a quad, worked to the left as it is seen from outside; a row worked back goes to the right
//   increase   -y1 +l1 +y1         two of a row above one stitch
//   decrease   -l1 -y1 +y1         two stitches below one
//   turn       a short row's end: its edge beside the row belongs to the row that is worked on it later
//   bridge     x x x               where loops part or meet; joined to nothing
// The library that comes with the format has names for the first alone.
#pragma once

#include <string>

#include "knit/fabric/fabric.h"

namespace app {

// Requires faces.
std::string smobj_text(const knit::Fabric& fabric);

}  // namespace app
