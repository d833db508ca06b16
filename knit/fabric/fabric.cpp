#include "knit/fabric/fabric.h"

#include <algorithm>

#include "knit/model/bug.h"

namespace knit {

namespace {

const LiveLoop* loop_of(const std::vector<LiveLoop>& live, TubeId tube) {
  const auto found =
      std::find_if(live.begin(), live.end(), [&](const LiveLoop& loop) { return loop.tube == tube; });
  return found != live.end() ? &*found : nullptr;
}

// Both lists rise by the row they lead to, which leaves out only cast ons.
template <class Product>
const Shared<Product>* leading_to(const std::vector<Shared<Product>>& products, RowId id) {
  const auto found = std::lower_bound(products.begin(), products.end(), id,
                                      [](const auto& product, RowId to) { return product->to < to; });
  return found != products.end() && (*found)->to == id ? &*found : nullptr;
}

void reverse_places(std::vector<Stitch>& stitches) {
  for (std::size_t i = 0, j = stitches.size(); i + 1 < j; ++i)
    std::swap(stitches[i].position, stitches[--j].position);
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

RowId Fabric::next_worked(RowId id) const {
  for (RowId next = id + 1; next <= row_count(); ++next) {
    if (!row(next).on.empty()) return next;
  }
  return 0;
}

LiveStitches Fabric::live(TubeId tube) const {
  const auto* loop = loop_of(live_, tube);
  return loop != nullptr ? loop->stitches : LiveStitches{};
}

std::int32_t Fabric::live_count() const {
  std::int32_t count = 0;
  for (const LiveLoop& loop : live_) count += loop.stitches.size();
  return count;
}

LiveStitches Fabric::live_below(RowId id) const {
  if (has_row(id)) return row(id).on;
  return rows_.empty() ? LiveStitches{} : live(rows_.back()->tube);
}

const Row* Fabric::row_below(RowId id) const {
  if (id < 1 || id > next_row()) return nullptr;
  const LiveStitches below = under_short_rows(live_below(id));
  if (below.empty() || !has_row(below.spans.front().row)) return nullptr;
  const Row& under = row(below.spans.front().row);
  const bool alone = std::all_of(below.spans.begin(), below.spans.end(),
                                 [&](const StitchSpan& span) { return span.row == under.id; });
  const bool arc = has_row(id) && is_short(row(id));
  return alone && (arc || below.size() == size_of(under)) ? &under : nullptr;
}

bool Fabric::continues(RowId id) const { return id > 1 && has_row(id) && row(id).on == all_of(row(id - 1)); }

LiveStitches Fabric::under_short_rows(const LiveStitches& live) const {
  LiveStitches under{{}, live.closed};
  for (std::int32_t i = 0; i < live.size(); ++i) {
    StitchRef ref = live.at(i);
    while (has_row(ref.row) && is_short(row(ref.row))) ref = row(ref.row).on.at(ref.stitch);
    under.append({ref.row, ref.stitch, 1});
  }
  return under;
}

std::vector<std::int32_t> Fabric::marked_below(RowId id) const {
  std::vector<std::int32_t> marked;
  const LiveStitches& on = row(id).on;
  const TubeId tube = row(id).tube;
  for (RowId before = id - 1; before > 0; --before) {
    if (row(before).tube != tube) continue;
    if (!is_short(row(before))) break;
    if (const std::int32_t place = place_in(on, row(before).turned->marked()); place >= 0)
      marked.push_back(place);
  }
  std::sort(marked.begin(), marked.end());
  marked.erase(std::unique(marked.begin(), marked.end()), marked.end());
  return marked;
}

std::vector<std::shared_ptr<const void>> Fabric::products_about(RowId id) const {
  std::vector<std::shared_ptr<const void>> products;
  for (const StitchSpan& span : row(id).on.spans) {
    if (span.row > 0) {
      products.push_back(shared_row(span.row).pointer());
    } else {
      products.push_back(deals_[static_cast<std::size_t>(-span.row) - 1].pointer());
    }
  }
  products.push_back(shared_row(id).pointer());
  return products;
}

std::vector<RowId> Fabric::rows_on(RowId id) const {
  std::vector<RowId> above;
  for (const auto& row : rows_) {
    if (has_stitches_of(row->on, id)) above.push_back(row->id);
  }
  return above;
}

bool Fabric::is_live(RowId id) const {
  return std::any_of(live_.begin(), live_.end(),
                     [&](const LiveLoop& loop) { return has_stitches_of(loop.stitches, id); });
}

const Stitch& Fabric::stitch(const StitchRef& ref) const {
  const auto i = static_cast<std::size_t>(ref.stitch);
  if (is_bridge(ref)) return deals_[static_cast<std::size_t>(deal_of(ref)) - 1]->bridge[i];
  return row(ref.row).stitches[i];
}

std::vector<Stitch> Fabric::stitches_of(const LiveStitches& live) const {
  std::vector<Stitch> stitches;
  stitches.reserve(static_cast<std::size_t>(live.size()));
  for (const StitchSpan& span : live.spans) {
    for (std::int32_t i = 0; i < span.count; ++i) stitches.push_back(stitch({span.row, span.first + i}));
  }
  return stitches;
}

LiveStitches Fabric::larger(const Join& join) const {
  return cells_above(join) ? all_of(row(join.to)) : join.from;
}

LiveStitches Fabric::smaller(const Join& join) const {
  return cells_above(join) ? join.from : all_of(row(join.to));
}

// A bridge lies behind the last row made before it, and behind the bridges dealt before.
std::uint32_t Fabric::first_on_path(RowId id) const {
  std::size_t first = 0;
  const bool bridge = id < 0;
  const RowId end = bridge ? deals_[static_cast<std::size_t>(-id) - 1]->after + 1 : id;
  for (RowId before = 1; before < end; ++before) first += row(before).stitches.size();
  for (std::size_t deal = 0; deal < deals_.size(); ++deal) {
    const bool earlier = bridge ? deal + 1 < static_cast<std::size_t>(-id) : deals_[deal]->after < id;
    if (earlier) first += deals_[deal]->bridge.size();
  }
  return static_cast<std::uint32_t>(first);
}

std::uint32_t Fabric::path_index(const StitchRef& ref) const {
  const bool back = has_row(ref.row) && works_back(row(ref.row));
  const std::int32_t along = back ? size_of(row(ref.row)) - 1 - ref.stitch : ref.stitch;
  return first_on_path(ref.row) + static_cast<std::uint32_t>(along);
}

std::vector<std::uint32_t> Fabric::path_indices(const LiveStitches& live) const {
  std::vector<std::uint32_t> indices;
  for (const StitchSpan& span : live.spans) {
    std::uint32_t index = path_index({span.row, span.first});
    const bool back = has_row(span.row) && works_back(row(span.row));
    for (std::int32_t i = 0; i < span.count; ++i) indices.push_back(back ? index-- : index++);
  }
  return indices;
}

std::size_t Fabric::stitch_count() const { return first_on_path(next_row()); }

void Fabric::add_short(Row row) {
  const auto loop =
      std::find_if(live_.begin(), live_.end(), [&](const LiveLoop& live) { return live.tube == row.tube; });
  const std::int32_t first =
      loop != live_.end() && !row.on.empty() ? place_in(loop->stitches, row.on.at(0)) : -1;
  const std::int32_t size = size_of(row), all = first >= 0 ? loop->stitches.size() : 0;
  if (row.id != next_row() || first < 0 || size + 2 > all || row.closed ||
      row.on != arc_of(loop->stitches, first, row.on.size()) || row.on.size() != size ||
      row.turned->before != loop->stitches.at((first + all - 1) % all) ||
      row.turned->after != loop->stitches.at((first + size) % all))
    throw Bug("a short row takes a stretch of what hangs on its needle and leaves a stitch on either side");
  // Begun where the stretch begins, the loop is the stretch and the rest; turned back, it begins where it began.
  LiveStitches taken = all_of(row);
  taken.append(stretch_of(loop->stitches, first + size, all - size));
  taken.closed = loop->stitches.closed;
  loop->stitches = begun_at(taken, (all - first) % all);
  rows_.emplace_back(std::move(row));
}

void Fabric::add(Row row) {
  if (is_short(row)) return add_short(std::move(row));
  if (row.id != next_row() || row.on != live(row.tube)) throw Bug("a row takes all that hangs on its needle");
  std::erase_if(live_, [&](const LiveLoop& loop) { return loop.tube == row.tube; });
  live_.push_back({row.tube, all_of(row)});
  rows_.emplace_back(std::move(row));
}

void Fabric::add(Deal deal) {
  if (deal.kind != DealKind::ring_cast_on) {
    for (std::size_t i = 0; i < deal.from.size(); ++i) {
      if (deal.taken[i] != live(deal.from[i])) throw Bug("a deal takes all that hangs on its needles");
    }
    std::erase_if(live_, [&](const LiveLoop& loop) {
      return std::find(deal.from.begin(), deal.from.end(), loop.tube) != deal.from.end();
    });
  }
  for (std::size_t i = 0; i < deal.to.size(); ++i) live_.push_back({deal.to[i], deal.given[i]});
  deals_.emplace_back(std::move(deal));
}

void Fabric::add(Shared<Join> join) { joins_.push_back(std::move(join)); }
void Fabric::add(Shared<Strip> strip) { strips_.push_back(std::move(strip)); }

Fabric Fabric::moved_to(std::span<const glm::dvec3> positions) const {
  Fabric moved = *this;
  const auto move = [&](std::vector<Stitch>& stitches, RowId id) {
    std::size_t number = first_on_path(id);
    for (Stitch& stitch : stitches) stitch.position = positions[number++];
  };
  for (Shared<Row>& row : moved.rows_) {
    Row copy = *row;
    move(copy.stitches, copy.id);
    if (works_back(copy)) reverse_places(copy.stitches);
    row = Shared(std::move(copy));
  }
  for (std::size_t i = 0; i < moved.deals_.size(); ++i) {
    if (moved.deals_[i]->bridge.empty()) continue;
    Deal copy = *moved.deals_[i];
    move(copy.bridge, bridge_row(static_cast<std::int32_t>(i) + 1));
    moved.deals_[i] = Shared(std::move(copy));
  }
  return moved;
}

std::size_t Fabric::copy_bytes() const {
  std::size_t bytes = sizeof(void*) * 2 * (rows_.size() + deals_.size() + joins_.size() + strips_.size());
  for (const LiveLoop& loop : live_)
    bytes += sizeof(LiveLoop) + sizeof(StitchSpan) * loop.stitches.spans.size();
  return bytes;
}

KnittingPath::KnittingPath(const Fabric& fabric) : fabric_(&fabric) {
  std::uint32_t first = 0;
  std::size_t deal = 0;
  const auto add = [&](RowId row, std::size_t stitches) {
    if (stitches == 0) return;
    const Row* made = fabric.find_row(row);
    const bool back = made != nullptr && works_back(*made);
    stretches_.push_back({first, row, back ? static_cast<std::int32_t>(stitches) - 1 : -1});
    first += static_cast<std::uint32_t>(stitches);
  };
  for (const auto& row : fabric.rows()) {
    add(row->id, row->stitches.size());
    for (; deal < fabric.deals().size() && fabric.deals()[deal]->after == row->id; ++deal)
      add(bridge_row(static_cast<std::int32_t>(deal) + 1), fabric.deals()[deal]->bridge.size());
  }
}

StitchRef KnittingPath::at(std::uint32_t number) const {
  const auto next =
      std::upper_bound(stretches_.begin(), stretches_.end(), number,
                       [](std::uint32_t n, const Stretch& stretch) { return n < stretch.first; });
  const Stretch& stretch = *std::prev(next);
  const auto along = static_cast<std::int32_t>(number - stretch.first);
  return {stretch.row, stretch.last >= 0 ? stretch.last - along : along};
}

std::vector<glm::dvec3> knitting_path(const Fabric& fabric) {
  std::vector<glm::dvec3> path;
  path.reserve(fabric.stitch_count());
  const auto add = [&](const std::vector<Stitch>& stitches) {
    for (const Stitch& stitch : stitches) path.push_back(stitch.position);
  };
  std::size_t deal = 0;
  for (const auto& row : fabric.rows()) {
    add(row->stitches);
    if (works_back(*row)) std::reverse(path.end() - size_of(*row), path.end());
    for (; deal < fabric.deals().size() && fabric.deals()[deal]->after == row->id; ++deal)
      add(fabric.deals()[deal]->bridge);
  }
  return path;
}

}  // namespace knit
