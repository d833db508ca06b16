// Where the wales of rows are how long: from a stitch that a row is worked on to the stitch made of it.
#pragma once

#include <optional>

#include "knit/run/state.h"

namespace knit {

struct WaleLength {
  RowId row = 2;  // that it ends in
  std::int32_t cell = 0;
  StitchRef below, above;
  double length = 0.0;  // mesh units
};

// Of a cell of the join that makes this row; none where there is no such thing.
std::optional<WaleLength> wale_at(const Fabric& fabric, RowId row, std::int32_t cell);
// Of equally long ones the first in working order; none before two rows are joined. Cost: the stitches.
std::optional<WaleLength> longest_wale(const Fabric& fabric);

}  // namespace knit
