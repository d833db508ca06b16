#include "knit/stitches/placement.h"

#include <array>

namespace knit {

namespace {

template <PlacementPolicy policy>
Join plan_by_sections(const PlacementRows& rows) {
  return plan_join(rows.below, rows.above, rows.row, policy);
}

Join plan_by_place(const PlacementRows& rows) {
  return plan_nearest(
      {rows.stitches_below, rows.stitches_above, rows.below.mains, rows.shaped_below, rows.follows},
      rows.penalties, rows.row);
}

using Policy = PlacementPolicy;

constexpr std::array table{
    Placement{Policy::thesis, false, plan_by_sections<Policy::thesis>, Policy::thesis},
    Placement{Policy::even, false, plan_by_sections<Policy::even>, Policy::even},
    Placement{Policy::nearest, true, plan_by_place, Policy::nearest},
};
constexpr bool in_order() {
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (static_cast<std::size_t>(table[i].policy) != i || placement_names[i].empty()) return false;
  }
  return true;
}
static_assert(table.size() + 1 == placement_names.size() && in_order());  // and by_itself

}  // namespace

std::span<const Placement> placements() { return table; }

const Placement& placement_of(PlacementPolicy policy) { return table.at(static_cast<std::size_t>(policy)); }

std::vector<Join> plan_joins(std::span<const std::int32_t> sizes, PlacementPolicy policy) {
  std::vector<Join> joins;
  for (std::size_t i = 1; i < sizes.size(); ++i) {
    const bool from_cast_on = i == 1;
    const std::vector<std::int32_t> mains = from_cast_on ? std::vector<std::int32_t>{} : joins.back().mains;
    joins.push_back(placement_of(policy).plan(
        {{sizes[i - 1], mains, from_cast_on}, sizes[i], static_cast<std::int32_t>(i) + 1}));
  }
  return joins;
}

}  // namespace knit
