// What a tube is worked by once it has a chart of its own: its full rounds, the arcs that get pairs of short rows, and where
// rounds begin.
#pragma once

#include <cstdint>
#include <tuple>

#include "knit/model/shared.h"
#include "knit/short_rows/arcs.h"
#include "knit/short_rows/full_rounds.h"
#include "knit/short_rows/tube_chart.h"

namespace knit {

// Why a tube keeps its level rows.
enum class NoChart : std::uint8_t { no, no_loop, apart, no_annulus, residual, not_solved, crowded, no_pair };

struct PlannedPairs {
  std::int32_t tube = 0;
  double stitch_width = 0.0, stitch_height = 0.0;  // that it was planned for
  PairSettings settings;
  std::int32_t low_row = 0, high_row = 0;  // of the tube: those on the chart's rims
  Shared<Ring> low_curve, high_curve;      // of those rows
  NoChart none = NoChart::no;
  double residual = 0.0;    // of the chart, or of the one that was refused
  Shared<TubeChart> chart;  // empty where there is none
  FullRounds rounds;
  ArcSearch search;
  double first_column = 0.0;  // where rounds begin
  // The arcs of the gap over a row of the tube; none where the tube keeps its rows.
  [[nodiscard]] std::vector<PairArc> arcs_over(std::int32_t row) const {
    std::vector<PairArc> arcs;
    if (none != NoChart::no) return arcs;
    for (const PairArc& arc : search.arcs) {
      if (arc.gap == row - low_row) arcs.push_back(arc);
    }
    return arcs;
  }
  [[nodiscard]] auto fields() const {
    return std::tie(tube, stitch_width, stitch_height, settings.turn_cost, settings.turn_step,
                    settings.shortest, low_row, high_row, low_curve, high_curve, none, residual, chart,
                    rounds, search, first_column);
  }
  friend bool operator==(const PlannedPairs&, const PlannedPairs&) = default;
};

}  // namespace knit
