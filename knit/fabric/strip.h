// The faces between a row and what it is worked on. Those of a short row end on either side with a triangle, whose apex is
// the stitch beside the stretch: so each turn has two, one of the row that comes to it and one of the row that leaves it.
#pragma once

#include <array>
#include <vector>

#include "knit/fabric/stitch.h"
#include "knit/model/label.h"

namespace knit {

// Corners are stitches counted through all rows (the knitting path), counter-clockwise seen from outside.
struct Face {
  std::array<std::uint32_t, 4> corners{};
  std::int32_t corner_count = 4;  // 3: the last corner is unused and 0
  std::int32_t cell = 0;          // of the join
  Label label = Label::knit;
  [[nodiscard]] auto fields() const { return std::tie(corners, corner_count, cell, label); }
  friend bool operator==(const Face&, const Face&) = default;
};

struct Strip {
  RowId to = 2;  // the row above
  std::vector<Face> faces;
  std::vector<std::array<std::uint32_t, 2>> column_edges;  // lower stitch, upper stitch; one a cell
  [[nodiscard]] auto fields() const { return std::tie(to, faces, column_edges); }
  friend bool operator==(const Strip&, const Strip&) = default;
};

}  // namespace knit
