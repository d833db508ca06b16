#include "knit/order/limb_tubes.h"

#include <algorithm>

#include "knit/model/bug.h"
#include "knit/stitches/short_join.h"

namespace knit {

namespace {

std::int32_t at(const std::vector<std::int32_t>& list, std::int32_t i) {
  return list[static_cast<std::size_t>(i)];
}

HandsRow hands_of(const Join& join) {
  HandsRow hands;
  hands.operations = operations_of(join);
  const bool grows = cells_above(join);
  for (std::int32_t i = 0; i < join.below; ++i) {
    if (grows) {
      const auto first = std::lower_bound(join.link.begin(), join.link.end(), i);
      hands.up.push_back(static_cast<std::int32_t>(first - join.link.begin()));
      hands.crosses.push_back(0);
    } else {
      hands.up.push_back(at(join.link, i));
      hands.crosses.push_back(i > 0 && at(join.link, i - 1) == at(join.link, i) ? 1 : 0);
    }
  }
  return hands;
}

// By the links of a ring's strip; uppers: of each stitch below, in no order.
HandsRow hands_of(const std::vector<std::vector<std::int32_t>>& uppers, std::int32_t above) {
  HandsRow hands;
  hands.operations.assign(static_cast<std::size_t>(above), {});
  std::vector<std::int32_t> taken(static_cast<std::size_t>(above), 0);
  for (std::size_t i = 0; i < uppers.size(); ++i) {
    const std::vector<std::int32_t>& own = uppers[i];
    const auto before = [&](std::int32_t u) { return (u + above - 1) % above; };
    std::int32_t first = own.front();
    for (const std::int32_t u : own) {
      ++taken[static_cast<std::size_t>(u)];
      if (std::find(own.begin(), own.end(), before(u)) == own.end()) first = u;
    }
    for (const std::int32_t u : own)
      hands.operations[static_cast<std::size_t>(u)].hand = u == first ? Hand::knit : Hand::m1l;
    const std::vector<std::int32_t>& last = uppers[(i + uppers.size() - 1) % uppers.size()];
    hands.up.push_back(first);
    hands.crosses.push_back(std::find(last.begin(), last.end(), first) != last.end() ? 1 : 0);
  }
  for (std::size_t u = 0; u < taken.size(); ++u) {
    if (taken[u] > 1) hands.operations[u].hand = Hand::k2tog;
    hands.possible = hands.possible && taken[u] <= 2;
  }
  return hands;
}

// How far `loop` is turned against these stitches; -1: it is another loop.
std::int32_t turn_of(const std::vector<std::int32_t>& loop, const std::vector<std::int32_t>& wanted) {
  const std::size_t n = loop.size();
  if (n != wanted.size()) return -1;
  for (std::size_t turn = 0; turn < n; ++turn) {
    std::size_t same = 0;
    while (same < n && loop[(turn + same) % n] == wanted[same]) ++same;
    if (same == n) return static_cast<std::int32_t>(turn);
  }
  return -1;
}

Places stretch(const Places& loop, std::int32_t first, std::int32_t count) {
  Places part;
  for (std::int32_t i = 0; i < count; ++i) part.push_back(at(loop, (first + i) % size_of(loop)));
  return part;
}

void append(Places& to, const Places& more) { to.insert(to.end(), more.begin(), more.end()); }

// Whether short rows cannot be worked with the marker in a gap: it would stand where they turn, or a stitch is slipped back over it.
bool is_in_the_way(const HandsRow& hands, std::int32_t gap) {
  const auto stitches = static_cast<std::int32_t>(hands.up.size());
  const bool slips = hands.crosses[static_cast<std::size_t>(gap)] != 0;
  return std::any_of(hands.pairs.begin(), hands.pairs.end(), [&](const ShortRowPair& pair) {
    return slips || (pair.first - gap) % stitches == 0 || (pair.last + 1 - gap) % stitches == 0;
  });
}

void climb(const std::vector<HandsRow>& hands, std::size_t from, std::int32_t gaps,
           std::vector<std::int32_t>& last, std::vector<std::int32_t>& slips,
           std::vector<std::int32_t>* turns = nullptr) {
  for (std::int32_t i = 0; i < gaps; ++i) {
    std::int32_t gap = i, slipped = 0;
    if (turns != nullptr) turns->push_back(0);
    for (std::size_t row = from; row < hands.size(); ++row) {
      slipped += hands[row].crosses[static_cast<std::size_t>(gap)];
      if (turns != nullptr && is_in_the_way(hands[row], gap)) ++turns->back();
      gap = at(hands[row].up, gap);
    }
    last.push_back(gap);
    slips.push_back(slipped);
  }
}

}  // namespace

Places turned_to(const Places& loop, std::int32_t first) { return stretch(loop, first, size_of(loop)); }

std::int32_t same_gap(const Places& from, std::int32_t i, const Places& to) {
  const std::int32_t n = size_of(to), before = at(from, (i + size_of(from) - 1) % size_of(from)),
                     after = at(from, i);
  std::int32_t by_after = -1, by_before = -1;
  for (std::int32_t j = 0; j < n; ++j) {
    if (at(to, j) == after) by_after = j;
    if (at(to, j) == before) by_before = (j + 1) % n;
  }
  return by_after >= 0 ? by_after : by_before;
}

std::int32_t LimbTubes::index_of(TubeId id) {
  const auto found =
      std::find_if(tubes_.begin(), tubes_.end(), [&](const LimbTube& tube) { return tube.id == id; });
  if (found != tubes_.end()) return static_cast<std::int32_t>(found - tubes_.begin());
  LimbTube tube;
  tube.id = id;
  tubes_.push_back(std::move(tube));
  live_.emplace_back();
  return count() - 1;
}

LimbTube& LimbTubes::tube_of(TubeId id) { return tubes_[static_cast<std::size_t>(index_of(id))]; }

std::int32_t LimbTubes::add_places(std::int32_t count, std::int32_t bridge, bool two_sides) {
  const std::int32_t first = place_count();
  for (std::int32_t i = 0; i < count; ++i) {
    for (std::int32_t side = 0; side < (two_sides ? 2 : 1); ++side) {
      stitch_of_.push_back(place_count() - side);
      bridge_of_.push_back(bridge);
    }
  }
  return first;
}

namespace {

// Where the sections of a repeat begin, in the row that it makes or in the one that it takes: that one is the first, or, with rests
// between, has as many stitches as the first.
std::vector<std::int32_t> mains_of_first(const Join& join, bool makes_first) {
  std::vector<std::int32_t> mains;
  for (const PlacedLabel& placed : join.placed) {
    if (placed.label != Label::main) continue;
    const CellEnds ends = ends_of(join, placed.cell);
    mains.push_back(makes_first ? ends.above : ends.below);
  }
  return mains;
}

}  // namespace

// Of short rows nothing is kept but where they stand: they leave the loop as many stitches, each in its place.
void LimbTubes::add_row(const Fabric& fabric, const Row& row) {
  if (is_short(row)) return;
  LimbTube& tube = tube_of(row.tube);
  Places& live = live_[static_cast<std::size_t>(index_of(row.tube))];
  if (tube.rows.empty()) tube.base = live;
  tube.rows.push_back(row.id);
  const std::int32_t first = add_places(size_of(row), -1, false);
  live.clear();
  for (std::int32_t i = 0; i < size_of(row); ++i) live.push_back(first + i);
  tube.places.push_back(live);
  const Join* join = fabric.join_into(row.id);
  tube.hands.push_back(join != nullptr ? hands_of(*join) : HandsRow{});
  for (const auto& [low, high] : short_arcs_below(fabric, row.id))
    tube.hands.back().pairs.push_back({low, high});
  if (tube.mains.empty() && join != nullptr && join->rule == Rule::repeat)
    tube.mains = mains_of_first(*join, tube.rows.size() == 1);
}

namespace {

// The stitches of a loop that was dealt, by number; those of the last rows and bridges from `first_of` on.
class StitchNumbers {
 public:
  StitchNumbers(const LimbTubes& tubes, std::int32_t bridge_first, RowId bridge)
      : tubes_(tubes), bridge_first_(bridge_first), bridge_(bridge) {}
  // `known`: loops that stretches are taken from, with the stitches that they are of the fabric.
  [[nodiscard]] std::vector<std::int32_t> of(
      const LiveStitches& live, const std::vector<std::pair<LiveStitches, const Places*>>& known) const {
    std::vector<std::int32_t> numbers;
    numbers.reserve(static_cast<std::size_t>(live.size()));
    for (std::int32_t i = 0; i < live.size(); ++i) numbers.push_back(number(live.at(i), known));
    return numbers;
  }

 private:
  [[nodiscard]] std::int32_t number(const StitchRef& ref,
                                    const std::vector<std::pair<LiveStitches, const Places*>>& known) const {
    if (ref.row == bridge_) return bridge_first_ + 2 * ref.stitch;
    for (const auto& [live, places] : known) {
      for (std::int32_t i = 0; i < live.size(); ++i) {
        if (live.at(i) == ref) return tubes_.stitch_of((*places)[static_cast<std::size_t>(i)]);
      }
    }
    throw Bug("a deal gives what it did not take");
  }
  const LimbTubes& tubes_;
  std::int32_t bridge_first_;
  RowId bridge_;
};

}  // namespace

// What is given is found again as places: an arc and the bridge, or two loops and the bridge twice, turned somehow.
void LimbTubes::add_deal(const Fabric& fabric, const Deal& deal, std::int32_t number) {
  LimbFork fork;
  fork.kind = deal.kind;
  for (const TubeId id : deal.from) fork.from.push_back(index_of(id));
  for (const TubeId id : deal.to) fork.to.push_back(index_of(id));
  const bool ring_start = deal.kind == DealKind::ring_cast_on;
  for (const std::int32_t from : fork.from) {
    LimbTube& tube = tubes_[static_cast<std::size_t>(from)];
    (ring_start ? tube.bottom : tube.top) = number;
  }
  for (const std::int32_t to : fork.to) tubes_[static_cast<std::size_t>(to)].bottom = number;
  const auto bridge = static_cast<std::int32_t>(deal.bridge.size());
  const std::int32_t first = add_places(bridge, number, true);
  Places there, back;
  there.reserve(deal.bridge.size());
  back.reserve(deal.bridge.size());
  for (std::int32_t i = 0; i < bridge; ++i) {
    there.push_back(first + 2 * i);
    back.push_back(first + 2 * (bridge - 1 - i) + 1);
  }
  std::vector<std::pair<LiveStitches, const Places*>> known;
  for (std::size_t i = 0; i < deal.taken.size() && !ring_start; ++i)
    known.emplace_back(deal.taken[i], &live_[static_cast<std::size_t>(fork.from[i])]);
  const StitchNumbers numbers(*this, first, bridge_row(number + 1));
  std::vector<std::vector<std::int32_t>> given;
  for (const LiveStitches& live : deal.given) given.push_back(numbers.of(live, known));
  std::vector<Places> made;
  if (deal.kind == DealKind::split) made = split_places(fork, given, there, back);
  if (deal.kind == DealKind::join) made = {joined_places(fork, given.front(), there, back)};
  for (std::size_t i = 0; i < made.size(); ++i) live_[static_cast<std::size_t>(fork.to[i])] = made[i];
  // A tube without a row begins and ends on what it was given.
  for (std::size_t i = 0; i < made.size(); ++i) tubes_[static_cast<std::size_t>(fork.to[i])].base = made[i];
  if (deal.kind == DealKind::ring_cast_on || deal.kind == DealKind::ring_bind_off)
    add_ring(fabric, deal, fork);
  forks_.push_back(std::move(fork));
}

std::vector<std::int32_t> LimbTubes::stitches_of(const Places& places) const {
  std::vector<std::int32_t> stitches;
  for (const std::int32_t place : places) stitches.push_back(stitch_of(place));
  return stitches;
}

std::vector<Places> LimbTubes::split_places(LimbFork& fork,
                                            const std::vector<std::vector<std::int32_t>>& given,
                                            const Places& there, const Places& back) const {
  const Places& loop = live_[static_cast<std::size_t>(fork.from.front())];
  const std::int32_t n = size_of(loop), arc = size_of(given[0]) - size_of(there);
  for (std::int32_t first = 0; first < n; ++first) {
    const std::array<Places, 2> arcs{stretch(loop, first, arc), stretch(loop, first + arc, n - arc)};
    std::array<Places, 2> whole = arcs;
    append(whole[0], there);
    append(whole[1], back);
    const std::int32_t one = turn_of(stitches_of(whole[0]), given[0]),
                       two = turn_of(stitches_of(whole[1]), given[1]);
    if (one < 0 || two < 0) continue;
    fork.arcs = arcs;
    return {turned_to(whole[0], one), turned_to(whole[1], two)};
  }
  throw Bug("a split gives what it did not take");
}

Places LimbTubes::joined_places(const LimbFork& fork, const std::vector<std::int32_t>& given,
                                const Places& there, const Places& back) const {
  const Places& one = live_[static_cast<std::size_t>(fork.from[0])];
  const Places& two = live_[static_cast<std::size_t>(fork.from[1])];
  const std::int32_t n = size_of(given);
  for (std::int32_t begin = 0; begin < n; ++begin) {
    const Places turned = turned_to(given, begin);
    const std::int32_t second = size_of(one) + size_of(there);
    const std::int32_t turn_one = turn_of(stitches_of(one), stretch(turned, 0, size_of(one)));
    const std::int32_t turn_two =
        turn_one < 0 ? -1 : turn_of(stitches_of(two), stretch(turned, second, size_of(two)));
    if (turn_two < 0) continue;
    Places whole = turned_to(one, turn_one);
    append(whole, there);
    append(whole, turned_to(two, turn_two));
    append(whole, back);
    if (stitches_of(whole) == turned) return turned_to(whole, (n - begin) % n);
  }
  throw Bug("a join gives what it did not take");
}

void LimbTubes::add_ring(const Fabric& fabric, const Deal& deal, LimbFork& fork) {
  const KnittingPath path(fabric);
  const bool cast_on = deal.kind == DealKind::ring_cast_on;
  std::array<RowId, 2> rows{};
  std::array<std::int32_t, 2> sizes{};
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    const LimbTube& tube = this->tube(fork.from[i]);
    rows[i] = cast_on ? tube.rows.front() : tube.rows.back();
    sizes[i] = size_of(fabric.row(rows[i]));
  }
  std::array<std::vector<std::vector<std::int32_t>>, 2> uppers;  // of each row's stitches: those of the other
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}})
    uppers[i].resize(static_cast<std::size_t>(sizes[i]));
  for (const auto& edge : deal.column_edges) {
    StitchRef one = path.at(edge[0]), two = path.at(edge[1]);
    if (one.row != rows[0]) std::swap(one, two);
    if (one.row != rows[0] || two.row != rows[1]) throw Bug("a ring's strip joins two rows");
    uppers[0][static_cast<std::size_t>(one.stitch)].push_back(two.stitch);
    uppers[1][static_cast<std::size_t>(two.stitch)].push_back(one.stitch);
  }
  if (!cast_on) {
    fork.joined = uppers[0];
    return;
  }
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    std::vector<std::vector<std::int32_t>> backwards = uppers[1 - i];
    std::reverse(backwards.begin(), backwards.end());
    fork.on_loops[i] = hands_of(backwards, sizes[i]);
  }
}

void LimbTubes::add_twins(const TubePlan* plan) {
  for (std::int32_t i = 0; i < count(); ++i) {
    LimbTube& tube = tubes_[static_cast<std::size_t>(i)];
    tube.twins = {i};
    if (plan == nullptr || tube.id >= static_cast<TubeId>(plan->tubes.size())) continue;
    tube.inner = plan->tube(tube.id).inner;
    tube.twins.clear();
    for (const TubeId twin : plan->tube(tube.id).twins) tube.twins.push_back(index_of(twin));
    if (tube.twins.empty()) tube.twins = {i};
  }
}

LimbTubes::LimbTubes(const Fabric& fabric, const TubePlan* plan) {
  std::size_t deal = 0;
  for (const auto& row : fabric.rows()) {
    add_row(fabric, *row);
    for (; deal < fabric.deals().size() && fabric.deals()[deal]->after == row->id; ++deal)
      add_deal(fabric, *fabric.deals()[deal], static_cast<std::int32_t>(deal));
  }
  add_twins(plan);
  for (LimbTube& tube : tubes_) {
    if (!tube.has_rows()) continue;
    climb(tube.hands, 0, tube.base.empty() ? 0 : size_of(tube.base), tube.last_of_base, tube.slips_of_base);
    climb(tube.hands, 1, size_of(tube.places.front()), tube.last_of_first, tube.slips_of_first,
          &tube.turns_of_first);
  }
}

std::size_t LimbTubes::side(std::int32_t deal, std::int32_t tube) const {
  const LimbFork& at = fork(deal);
  const std::vector<std::int32_t>& two = at.kind == DealKind::split ? at.to : at.from;
  return two[0] == tube ? 0 : 1;
}

std::int32_t LimbTubes::sibling(std::int32_t tube) const {
  const std::int32_t deal = this->tube(tube).bottom;
  return fork(deal).to[1 - side(deal, tube)];
}

std::int32_t LimbTubes::other_of_ring(std::int32_t deal, std::int32_t tube) const {
  return fork(deal).from[1 - side(deal, tube)];
}

}  // namespace knit
