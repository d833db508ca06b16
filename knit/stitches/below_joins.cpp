#include "knit/stitches/below_joins.h"

#include <algorithm>

#include "knit/stitches/nearest.h"

namespace knit {

BelowJoins joins_below(const Fabric& fabric, const LiveStitches& live) {
  BelowJoins below;
  std::int32_t place = 0;
  for (const StitchSpan& span : live.spans) {
    const Join* join = fabric.join_into(span.row);
    if (join != nullptr) below.cast_on = false;
    const std::vector<std::uint8_t> shaped = join != nullptr ? shaped_by(*join) : std::vector<std::uint8_t>{};
    for (std::int32_t i = 0; i < span.count; ++i, ++place) {
      const std::int32_t stitch = span.first + i;
      below.shaped.push_back(join != nullptr ? shaped[static_cast<std::size_t>(stitch)] : 0);
      const bool main = join != nullptr && std::binary_search(join->mains.begin(), join->mains.end(), stitch);
      if (main) below.mains.push_back(place);
    }
  }
  // Loops that met have brought theirs together.
  if (live.closed && live.spans.size() > 1) below.mains = thinned_mains(below.mains, live.size());
  return below;
}

JoinGround ground_of(const Fabric& fabric, const Row& row) {
  const LiveStitches under = is_short(row) ? row.on : fabric.under_short_rows(row.on);
  JoinGround ground{row.on, fabric.stitches_of(under), joins_below(fabric, under), {}};
  if (fabric.has_row(row.id)) ground.marked = fabric.marked_below(row.id);
  return ground;
}

}  // namespace knit
