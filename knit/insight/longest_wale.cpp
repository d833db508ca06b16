#include "knit/insight/longest_wale.h"

#include <glm/geometric.hpp>

#include "knit/model/ties.h"

namespace knit {

namespace {

WaleLength wale_of(const Fabric& fabric, const Join& join, std::int32_t cell) {
  const CellEnds ends = ends_of(join, cell);
  WaleLength wale{join.to, cell, join.from.at(ends.below), {join.to, ends.above}, 0.0};
  wale.length = glm::distance(fabric.position(wale.below), fabric.position(wale.above));
  return wale;
}

std::int32_t cell_count(const Join& join) { return static_cast<std::int32_t>(join.link.size()); }

}  // namespace

std::optional<WaleLength> wale_at(const Fabric& fabric, RowId row, std::int32_t cell) {
  const Join* join = fabric.join_into(row);
  if (join == nullptr || join->from.empty() || cell < 0 || cell >= cell_count(*join)) return std::nullopt;
  return wale_of(fabric, *join, cell);
}

std::optional<WaleLength> longest_wale(const Fabric& fabric) {
  std::optional<WaleLength> longest;
  for (const auto& join : fabric.joins()) {
    for (std::int32_t cell = 0; !join->from.empty() && cell < cell_count(*join); ++cell) {
      const WaleLength wale = wale_of(fabric, *join, cell);
      if (!longest || clearly_less(longest->length, wale.length, wale.length)) longest = wale;
    }
  }
  return longest;
}

}  // namespace knit
