// Which arcs of the gaps get a pair of short rows: those of the least squared lag, if that pays for two turns.
//
//   for each gap k, at most 8 times:
//     lag[c]  = Y[l_(k+1)][c] / h - (k + 1) h'/h - 2 P[c]              rows that are missing at cell c, P: pairs so far
//     gain    = sum over the arc's cells of (lag - 1) width / w        (lag^2 - (lag - 2)^2) / 4, in stitches
//     price   = turn cost + the penalties of its two turns
//     penalty = 2 x sum over the turns of this gap and the four before of exp(-(d / turn step)^2) (1 - age / 5)
//     the best of all arcs that are long enough, and three stitches shorter than the round; P += 1 on it if it pays
// A cell lies between a column and the next, so that an arc and its mirror image have one gain. All columns (columns - 1)
// arcs are tried with running sums. Where the tube is its own mirror image, lags and widths are the mean of both sides, and so
// are pairs: an arc either lies across the mirror, as far to both sides, or comes with its image as the next arc, clear of it; then
// half of what their turns cost each other is in the price of each. Ties: the arc whose middle is nearest to column 0, where rounds begin; then the shorter;
// then the one whose middle comes first in working order.
#pragma once

#include <cstdint>
#include <optional>
#include <tuple>
#include <variant>
#include <vector>

#include "knit/short_rows/full_rounds.h"
#include "knit/short_rows/pair_plan.h"
#include "knit/short_rows/tube_chart.h"

namespace knit {

// One small step after another: the lag of a gap, then its arcs.
struct ArcSearch {
  std::int32_t gap = 0;
  bool measured = false;              // the lag of this gap
  std::vector<std::int32_t> covered;  // P: pairs over each cell so far; empty before the first step
  std::vector<PairArc> arcs;          // that were taken, by gap
  double greatest_lag = 0.0;          // that is left at the end of any gap, in either direction
  bool done = false;
  [[nodiscard]] auto fields() const { return std::tie(gap, measured, covered, arcs, greatest_lag, done); }
  friend bool operator==(const ArcSearch&, const ArcSearch&) = default;
};

using ArcStep = std::variant<LagMeasured, ArcConsidered>;

// Requires that it is not done.
ArcStep advance_arcs(const TubeChart& chart, const FullRounds& rounds, double stitch_width,
                     const PairSettings& settings, ArcSearch& search);

// All steps.
ArcSearch choose_arcs(const TubeChart& chart, const FullRounds& rounds, double stitch_width,
                      const PairSettings& settings);

// Where rounds best begin: in the middle of what the pairs cover (circular mean), so that most pairs run over the beginning,
// as far to one side as to the other. From -columns / 2 to columns / 2; 0 without a pair.
// Of a tube that is its own mirror image one of the two columns on the mirror.
double middle_of_arcs(const ArcSearch& search, std::optional<std::int32_t> mirror = std::nullopt);

}  // namespace knit
