// Stage 2, cast on, one smallest step at a time, where rows are rings of vertices.
#pragma once

#include <cstdint>
#include <optional>
#include <tuple>
#include <vector>

#include "knit/fabric/row.h"
#include "knit/mesh/mesh.h"
#include "knit/model/event.h"
#include "knit/model/products.h"
#include "knit/rows/cast_on_events.h"

namespace knit {

struct CastOnWork {
  std::int32_t level = -1;
  Shared<Ring> ring;
  std::vector<Stitch> stitches;
  // Roughly, beside its own size.
  [[nodiscard]] std::size_t copy_bytes() const { return stitches.size() * sizeof(Stitch); }
  [[nodiscard]] auto fields() const { return std::tie(level, ring, stitches); }
  friend bool operator==(const CastOnWork&, const CastOnWork&) = default;
};

// What the stage makes: the last level that makes a row, once it is known, and the row, once it has ended.
struct CastOnMade {
  std::int32_t& last_level;
  std::optional<Row>& row;
};
Advanced<CastOnEvent> advance_cast_on(const Input& input, const RowsSettings& rows, const StitchSize& stitch,
                                      const Timing& timing, CastOnWork& work, CastOnMade made);

}  // namespace knit
