// Short rows in the tubes of any shape: of each tube its chart, its full rounds and the arcs that pay.
//
// A tube keeps its first rows above an event and its last below one as they are, because near a saddle a level has a corner,
// where lag is partly a phantom; none at a cast on or a bind off. Between the last that it keeps below and the first above it
// is charted. How many to keep is for who settles all of 0, 1, 2 and no pairs at all to choose: no number is best everywhere.
// Tubes stay as they are that have fewer than four rows there, no annulus, a chart that is refused, or no arc that pays.
// Cost: a cut through the mesh a loop, a chart a tube.
#pragma once

#include <cstdint>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "knit/model/heard.h"
#include "knit/model/shared.h"
#include "knit/short_rows/arcs.h"
#include "knit/tubes/plan.h"

namespace knit {

struct BranchPairs {
  TubeId tube = 0;
  std::int32_t below = 0, above = 0;  // rows of the tube that are kept, before and after its rounds
  Shared<TubeChart> chart;
  FullRounds rounds;     // take the place of the rows between, both rims included
  ArcSearch search;      // done
  double beginning = 0;  // the column where rounds best begin
  [[nodiscard]] bool none_pays() const { return search.arcs.empty(); }
  [[nodiscard]] auto fields() const { return std::tie(tube, below, above, chart, rounds, search, beginning); }
  friend bool operator==(const BranchPairs&, const BranchPairs&) = default;
};

struct TooFewRows {
  std::int32_t rows = 0;  // between those that are kept
  friend bool operator==(const TooFewRows&, const TooFewRows&) = default;
};
using BranchPairsOrNot = std::variant<BranchPairs, TooFewRows, NoPart, ChartRefusal>;
// Why a tube has no chart; empty where it has one.
std::string sentence_of(const BranchPairsOrNot& pairs);

// One entry a tube of the plan. `kept`: rows beside an event.
std::vector<BranchPairsOrNot> plan_branch_pairs(const Input& input, const TubeGraph& graph,
                                                const TubePlan& plan, std::int32_t kept,
                                                const PairSettings& settings, const Heard& heard = {});

}  // namespace knit
