// Stages 2 and 3 with contours, one smallest step at a time: rows from cuts through the surface.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <tuple>
#include <vector>

#include "knit/fabric/row.h"
#include "knit/mesh/mesh.h"
#include "knit/model/event.h"
#include "knit/model/products.h"
#include "knit/rows/contour_events.h"

namespace knit {

enum class ContourPhase : std::uint8_t { plan, cut, loop, measure, count, place };
struct ContourWork {
  ContourPhase phase = ContourPhase::plan;
  Shared<CutPlan> plan;
  std::int32_t cut = 0;    // of plan->cuts: the current one
  std::int32_t count = 0;  // of stitches, once chosen
  std::vector<Stitch> stitches;
  // Roughly, beside its own size.
  [[nodiscard]] std::size_t copy_bytes() const { return stitches.size() * sizeof(Stitch); }
  [[nodiscard]] auto fields() const { return std::tie(phase, plan, cut, count, stitches); }
  friend bool operator==(const ContourWork&, const ContourWork&) = default;
};

// Where a row is worked.
struct ContourRow {
  const Timing& timing;
  RowId number;            // the row's
  const LiveStitches& on;  // what it is worked on; none: it is cast on
  double from;             // the time of the row below, or 0
};
// `row`: the product, once the row has ended; then `work` is that of the next row.
Advanced<ContourEvent> advance_contours(const Input& input, const RowsSettings& rows,
                                        const StitchSize& stitch, const ContourRow& at, ContourWork& work,
                                        std::optional<Row>& row);

// Whether the step to come plans cuts.
bool next_plans_cuts(const StitchSize& stitch, const ContourWork& work);

}  // namespace knit
