#include "knit/fabric/fabric.h"

#include <algorithm>

#include "knit/model/bug.h"

namespace knit {

namespace {

// Both lists rise by the row they lead to, which leaves out only cast ons.
template <class Product>
const Shared<Product>* leading_to(const std::vector<Shared<Product>>& products, RowId id) {
  const auto found = std::lower_bound(products.begin(), products.end(), id,
                                      [](const auto& product, RowId to) { return product->to < to; });
  return found != products.end() && (*found)->to == id ? &*found : nullptr;
}

bool has_stitches_of(const LiveStitches& live, RowId id) {
  return std::any_of(live.spans.begin(), live.spans.end(),
                     [&](const StitchSpan& span) { return span.row == id; });
}

}  // namespace

const Join* Fabric::join_into(RowId id) const {
  const auto* join = leading_to(joins_, id);
  return join != nullptr ? &**join : nullptr;
}

const Strip* Fabric::strip_into(RowId id) const {
  const auto* strip = leading_to(strips_, id);
  return strip != nullptr ? &**strip : nullptr;
}

const Shared<Strip>& Fabric::shared_strip(RowId id) const { return *leading_to(strips_, id); }

const Row* Fabric::row_below(RowId id) const {
  if (id < 1 || id > next_row()) return nullptr;
  const LiveStitches& below = live_below(id);
  const bool one = below.spans.size() == 1 && below.size() == size_of(row(below.spans.front().row));
  return one ? &row(below.spans.front().row) : nullptr;
}

std::vector<std::shared_ptr<const Row>> Fabric::rows_about(RowId id) const {
  std::vector<std::shared_ptr<const Row>> rows;
  for (const StitchSpan& span : row(id).on.spans) rows.push_back(shared_row(span.row).pointer());
  rows.push_back(shared_row(id).pointer());
  return rows;
}

std::vector<RowId> Fabric::rows_on(RowId id) const {
  std::vector<RowId> above;
  for (const auto& row : rows_) {
    if (has_stitches_of(row->on, id)) above.push_back(row->id);
  }
  return above;
}

bool Fabric::is_live(RowId id) const { return has_stitches_of(live_, id); }

LiveStitches Fabric::larger(const Join& join) const {
  return cells_above(join) ? all_of(row(join.to)) : join.from;
}

LiveStitches Fabric::smaller(const Join& join) const {
  return cells_above(join) ? join.from : all_of(row(join.to));
}

std::uint32_t Fabric::first_on_path(RowId id) const {
  std::size_t first = 0;
  for (RowId before = 1; before < id; ++before) first += row(before).stitches.size();
  return static_cast<std::uint32_t>(first);
}

std::vector<std::uint32_t> Fabric::path_indices(const LiveStitches& live) const {
  std::vector<std::uint32_t> indices;
  for (const StitchSpan& span : live.spans) {
    const std::uint32_t first = first_on_path(span.row) + static_cast<std::uint32_t>(span.first);
    for (std::int32_t i = 0; i < span.count; ++i) indices.push_back(first + static_cast<std::uint32_t>(i));
  }
  return indices;
}

std::size_t Fabric::stitch_count() const { return first_on_path(next_row()); }

void Fabric::add(Row row) {
  if (row.id != next_row() || row.on != live_) throw Bug("a row takes all that hangs on the needle");
  live_ = all_of(row);
  rows_.emplace_back(std::move(row));
}

void Fabric::add(Shared<Join> join) { joins_.push_back(std::move(join)); }
void Fabric::add(Shared<Strip> strip) { strips_.push_back(std::move(strip)); }

std::size_t Fabric::copy_bytes() const {
  return sizeof(void*) * 2 * (rows_.size() + joins_.size() + strips_.size()) +
         sizeof(StitchSpan) * live_.spans.size();
}

KnittingPath::KnittingPath(const Fabric& fabric) : fabric_(&fabric) {
  std::uint32_t first = 0;
  for (const auto& row : fabric.rows()) {
    first_.push_back(first);
    first += static_cast<std::uint32_t>(row->stitches.size());
  }
}

StitchRef KnittingPath::at(std::uint32_t number) const {
  const auto next = std::upper_bound(first_.begin(), first_.end(), number);
  return {static_cast<RowId>(next - first_.begin()), static_cast<std::int32_t>(number - *std::prev(next))};
}

std::vector<glm::dvec3> knitting_path(const Fabric& fabric) {
  std::vector<glm::dvec3> path;
  path.reserve(fabric.stitch_count());
  for (const auto& row : fabric.rows()) {
    for (const Stitch& stitch : row->stitches) path.push_back(stitch.position);
  }
  return path;
}

}  // namespace knit
