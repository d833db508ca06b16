// Stage 3, rows, one smallest step at a time, where rows are rings of vertices: Algorithm 2.
#pragma once

#include <cstdint>
#include <optional>
#include <tuple>

#include "knit/fabric/fabric.h"
#include "knit/fabric/row.h"
#include "knit/mesh/mesh.h"
#include "knit/model/event.h"
#include "knit/model/products.h"
#include "knit/rows/ring_events.h"
#include "knit/rows/rows.h"

namespace knit {

enum class RowPhase : std::uint8_t { gather, order, measure, missed, resample, share };
struct RowWork {
  RowPhase phase = RowPhase::gather;
  std::int32_t level = 0;
  Shared<Ring> ring;
  Walk walk;
  ClosedRow closed;
  // Roughly, beside its own size.
  [[nodiscard]] std::size_t copy_bytes() const {
    return (walk.kept.size() + closed.orders.size()) * sizeof(std::int32_t) +
           closed.stitches.size() * sizeof(Stitch);
  }
  [[nodiscard]] auto fields() const { return std::tie(phase, level, ring, walk, closed); }
  friend bool operator==(const RowWork&, const RowWork&) = default;
};

inline RowWork row_work_at(std::int32_t level) {
  RowWork work;
  work.level = level;
  return work;
}

// Where a row is worked.
struct RingRow {
  const Timing& timing;
  std::int32_t last_level;  // that makes a row
  RowId number;             // the row's
  const Fabric& fabric;     // whose live stitches it is worked on, at its end
};
// `row`: the product, once the row has ended; then `work` is that of the next row.
Advanced<RingEvent> advance_rings(const Input& input, const RowsSettings& rows, const StitchSize& stitch,
                                  const RingRow& at, RowWork& work, std::optional<Row>& row);

}  // namespace knit
