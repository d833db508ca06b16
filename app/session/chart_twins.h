// A chart stands for pieces that are made together: a stitch of one of them as each has it, and back to the first, whose
// rows the chart has; and which chart is whose.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/session/planned_pieces.h"
#include "app/session/view.h"
#include "knit/pattern/limb_chart.h"

namespace app {

// In the order of `pieces`, of the plan. Empty: it is a stitch of none of them.
std::vector<StitchAt> stitch_in_each(const knit::LimbPlan& plan, const std::vector<std::int32_t>& pieces,
                                     const StitchAt& at);
// The row of the first of them that is the same round; the row itself where it is of none.
std::int32_t row_in_first(const knit::LimbPlan& plan, const std::vector<std::int32_t>& pieces,
                          std::int32_t row);

// Which of the charts is that of a piece, or has a row of the fabric; nothing: none.
std::optional<std::size_t> chart_of_piece(const std::vector<knit::PieceChart>& charts,
                                          const PlannedPieces& planned, const std::string& letters);
std::optional<std::size_t> chart_with_row(const std::vector<knit::PieceChart>& charts,
                                          const knit::LimbPlan& plan, std::int32_t row);

}  // namespace app
