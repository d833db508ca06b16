// The pieces of a run as they are going to be knitted: in the order that a person chose or else the cheapest, and by the
// names that she gave them; what her order takes more than the cheapest, and why an order cannot be worked.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/session/pattern_pieces.h"
#include "app/session/session.h"
#include "knit/limbs/limb_plan.h"
#include "knit/pattern/written_pattern.h"

namespace app {

struct PlannedPieces {
  knit::LimbPlan plan;
  knit::PatternOptions options;      // names by the plan's letters
  std::vector<std::string> letters;  // of each piece of the plan the one that it goes by in PatternPieces
  std::vector<std::vector<std::int32_t>> stands_on;  // of each: those that must be worked before it
  std::int32_t cheapest_yarns = 0, cheapest_held = 0;
  bool chosen = false;  // it is the order that a person chose
  std::string refused;  // why that one is not taken; empty: it is, or none was chosen

  [[nodiscard]] std::string name_of(std::int32_t piece) const;  // "Leg B"
};

// Requires limbs, and that they are known (limb_plan.h).
PlannedPieces planned_pieces(const knit::State& state, const PatternPieces& pieces,
                             const knit::PatternOptions& options,
                             knit::GraftBy graft = knit::GraftBy::kitchener);
// Of the state that is shown. Requires something open, too.
PlannedPieces planned_pieces(const Session& session);

// Other names, or other options, in the same order.
void name_pieces(PlannedPieces& planned, const PatternPieces& pieces, const knit::PatternOptions& options);

// By letters as in PatternPieces. Nothing: it can be worked, as far as is seen without working it.
std::optional<std::string> why_not_in_order(const PlannedPieces& planned,
                                            const std::vector<std::string>& order);
// Looks at holders and markers too.
std::optional<std::string> why_not_in_order(const knit::State& state, const PlannedPieces& planned,
                                            const std::vector<std::string>& order);

// "2 yarns and 1 holder more than the cheapest order."
std::string order_price(const PlannedPieces& planned);

}  // namespace app
