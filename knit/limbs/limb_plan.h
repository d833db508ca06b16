// The pieces of a run, from its rows, joins and deals: in the fabric's order, or in another that a person chose.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "knit/order/limb_pieces.h"
#include "knit/run/state.h"

namespace knit {

struct LimbOptions {
  // The second of twins is shaped like the first, so that they are written once: its counts are its own, its increases and
  // decreases may then stand a little beside the fabric's.
  bool twins_alike = true;
  std::vector<TubeId>
      order;  // that a person chose, of tubes with rows; empty, or no legal order: the fabric's
  bool three_needle = false;  // instead of grafts, where stitches pair one by one
  friend bool operator==(const LimbOptions&, const LimbOptions&) = default;
};

// Whether loops part or meet, so that the rows are no single chain.
bool has_limbs(const State& state);
// Whether all rows and joins are there.
bool limbs_are_known(const State& state);
// Requires both.
LimbPlan plan_limbs(const State& state, const LimbOptions& options = {});

// What an order that a person thinks of would take; nothing where it cannot be worked.
struct LimbOrderCost {
  double cost = 0.0;
  std::int32_t held_most = 0, yarns = 0;
};
std::optional<LimbOrderCost> cost_of_order(const State& state, const std::vector<TubeId>& order);

}  // namespace knit
