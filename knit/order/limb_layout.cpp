#include "knit/order/limb_layout.h"

#include <algorithm>

#include "knit/model/bug.h"

namespace knit {

namespace {

class Layout {
 public:
  Layout(const LimbTubes& tubes, const LimbRuns& runs, const LimbMarkers& markers)
      : tubes_(tubes), runs_(runs), markers_(markers), holders_(runs.order.size()) {
    const auto places = static_cast<std::size_t>(tubes.place_count());
    on_holder_.assign(places, -1);
    at_.assign(places, -1);
    gap_of_.assign(places, 0);
    in_gap_.assign(places, 0);
    on_needle_.assign(places, 0);
    holder_of_.assign(static_cast<std::size_t>(tubes.count()), -1);
    piece_of_.assign(static_cast<std::size_t>(tubes.count()), -1);
    for (std::size_t i = 0; i < runs.order.size(); ++i)
      piece_of_[static_cast<std::size_t>(runs.order[i])] = static_cast<std::int32_t>(i);
  }

  std::optional<LimbLayout> run() {
    for (now_ = 0; now_ < runs_.order.size() && possible_; ++now_) {
      LimbPiece& piece = layout_.plan.pieces.emplace_back();
      describe(piece);
      for (std::size_t step = 0; step < runs_.steps[now_].size() && possible_; ++step) take_step(step, piece);
      if (!possible_) return std::nullopt;
      begin_rounds();
      layout_.plan.held_most = std::max(layout_.plan.held_most, held());
      end_piece(piece);
    }
    layout_.plan.yarns += markers_.moves;
    return std::move(layout_);
  }

 private:
  [[nodiscard]] std::int32_t tube_now() const { return runs_.order[now_]; }
  [[nodiscard]] const LimbTube& tube(std::int32_t i) const { return tubes_.tube(i); }
  [[nodiscard]] std::int32_t held() const {
    return static_cast<std::int32_t>(std::count_if(holders_.begin(), holders_.end(),
                                                   [](const Places& holder) { return !holder.empty(); }));
  }
  [[nodiscard]] bool is_worked(std::int32_t tube) const {
    const std::int32_t piece = piece_of_[static_cast<std::size_t>(tube)];
    return piece >= 0 && piece < static_cast<std::int32_t>(now_);
  }

  void describe(LimbPiece& piece) const {
    const LimbTube& own = tube(tube_now());
    piece.tube = own.id;
    piece.inner = own.inner;
    piece.rows = own.rows;
    for (const std::int32_t twin : own.twins) {
      const std::int32_t other = piece_of_[static_cast<std::size_t>(twin)];
      if (other >= 0) piece.twins.push_back(other);
    }
    std::sort(piece.twins.begin(), piece.twins.end());
  }

  void put_on_needle(Places loop) {
    for (const std::int32_t place : needle_) on_needle_[static_cast<std::size_t>(place)] = 0;
    needle_ = std::move(loop);
    for (const std::int32_t place : needle_) on_needle_[static_cast<std::size_t>(place)] = 1;
  }
  // Of several holders that go by one piece the first that is free.
  [[nodiscard]] std::int32_t free_holder(std::int32_t piece) {
    const auto pieces = static_cast<std::int32_t>(runs_.order.size());
    std::int32_t holder = piece;
    while (holder < static_cast<std::int32_t>(holders_.size()) &&
           !holders_[static_cast<std::size_t>(holder)].empty())
      holder += pieces;
    if (holder >= static_cast<std::int32_t>(holders_.size()))
      holders_.resize(static_cast<std::size_t>(holder) + 1);
    return holder;
  }
  [[nodiscard]] std::int32_t piece_of_holder(std::int32_t holder) const {
    return holder % static_cast<std::int32_t>(runs_.order.size());
  }
  [[nodiscard]] std::int32_t number_of_holder(std::int32_t holder) const {
    return holder / static_cast<std::int32_t>(runs_.order.size());
  }
  // By which a deal tells of it.
  void name_holder(std::int32_t holder, LimbDeal& deal) const {
    deal.piece = piece_of_holder(holder);
    deal.holder = number_of_holder(holder);
  }
  void put_on_holder(std::int32_t number, Places loop) {
    Places& holder = holders_[static_cast<std::size_t>(number)];
    for (std::int32_t i = 0; i < size_of(loop); ++i) {
      on_holder_[static_cast<std::size_t>(loop[static_cast<std::size_t>(i)])] = number;
      at_[static_cast<std::size_t>(loop[static_cast<std::size_t>(i)])] = i;
    }
    holder = std::move(loop);
  }
  void empty_holder(std::int32_t number) {
    for (const std::int32_t place : holders_[static_cast<std::size_t>(number)])
      on_holder_[static_cast<std::size_t>(place)] = -1;
    holders_[static_cast<std::size_t>(number)].clear();
  }

  // The piece that is worked first from a tube's loop: its holder goes by it.
  [[nodiscard]] std::int32_t first_piece(std::int32_t from) const {
    if (tube(from).has_rows()) return piece_of_[static_cast<std::size_t>(from)];
    std::int32_t first = static_cast<std::int32_t>(runs_.order.size());
    for (const std::int32_t to : tubes_.fork(tube(from).top).to) first = std::min(first, first_piece(to));
    return first;
  }

  void take_step(std::size_t number, LimbPiece& piece) {
    const LimbStep& step = runs_.steps[now_][number];
    LimbDeal deal;
    switch (step.kind) {
      case LimbStepKind::cast_on:
      case LimbStepKind::provisional:
        deal.kind = step.kind == LimbStepKind::cast_on ? LimbDealKind::cast_on : LimbDealKind::provisional;
        deal.after = size_of(tube(step.tube).places.front());
        ++layout_.plan.yarns;
        break;
      case LimbStepKind::loops:
        deal.kind = LimbDealKind::loops;
        deal.piece = piece_of_[static_cast<std::size_t>(step.other)];
        deal.after = size_of(tube(step.other).places.front());
        ++layout_.plan.yarns;
        break;
      case LimbStepKind::rejoin:
        rejoin(step.tube, markers_.entered[now_][number], deal);
        ++layout_.plan.yarns;
        break;
      case LimbStepKind::set_aside:
        deal.kind = LimbDealKind::set_aside;
        deal.before = size_of(needle_);
        hold(step.tube, needle_, deal);
        put_on_needle({});
        break;
      case LimbStepKind::divide:
        if (markers_.moved[now_][number] != 0) piece.deals.push_back(move_to(step.tube));
        divide(step.tube, step.other, deal);
        break;
      case LimbStepKind::join:
        join(step.tube, deal);
        break;
    }
    piece.deals.push_back(std::move(deal));
  }

  void hold(std::int32_t tube, Places loop, LimbDeal& deal) {
    const std::int32_t holder = free_holder(first_piece(tube));
    holder_of_[static_cast<std::size_t>(tube)] = holder;
    name_holder(holder, deal);
    put_on_holder(holder, std::move(loop));
  }

  void rejoin(std::int32_t from, std::int32_t entered, LimbDeal& deal) {
    deal.kind = LimbDealKind::rejoin;
    const std::int32_t holder = holder_of_[static_cast<std::size_t>(from)];
    name_holder(holder, deal);
    const Places loop = turned_to(waiting_loop(tubes_, from, is_worked(from)), entered);
    deal.items = items_of(loop);
    deal.after = size_of(loop);
    empty_holder(holder);
    put_on_needle(loop);
  }

  void join(std::int32_t into, LimbDeal& deal) {
    deal.kind = LimbDealKind::join;
    const Places loop = turned_to(tube(into).base, same_gap(needle_, 0, tube(into).base));
    deal.items = items_of(loop);
    deal.after = size_of(loop);
    for (const LimbItem& item : deal.items) {
      if (item.kind == LimbItemKind::take)
        empty_holder(item.piece + item.holder * static_cast<std::int32_t>(runs_.order.size()));
    }
    put_on_needle(loop);
  }

  LimbDeal move_to(std::int32_t child) {
    const std::int32_t bottom = tube(child).bottom;
    const std::int32_t pinch = tubes_.fork(bottom).arcs[tubes_.side(bottom, child)].front();
    const auto slipped =
        static_cast<std::int32_t>(std::find(needle_.begin(), needle_.end(), pinch) - needle_.begin());
    LimbDeal deal;
    deal.kind = LimbDealKind::move;
    deal.before = slipped;
    deal.rest = size_of(needle_) - slipped;
    deal.after = size_of(needle_);
    put_on_needle(turned_to(needle_, slipped));
    return deal;
  }

  void divide(std::int32_t child, std::int32_t sibling, LimbDeal& deal) {
    const std::int32_t bottom = tube(child).bottom;
    const Places& arc = tubes_.fork(bottom).arcs[tubes_.side(bottom, sibling)];
    std::vector<std::uint8_t> goes(at_.size(), 0);
    for (const std::int32_t place : arc) goes[static_cast<std::size_t>(place)] = 1;
    const auto is_held = [&](std::int32_t place) { return goes[static_cast<std::size_t>(place)] != 0; };
    const auto first = std::find_if(needle_.begin(), needle_.end(), is_held);
    const auto end = std::find_if_not(first, needle_.end(), is_held);
    if (first == needle_.end() || std::any_of(end, needle_.end(), is_held)) {
      possible_ = false;
      return;
    }
    Places kept(needle_.begin(), first), across;
    const Places loop = turned_to(tube(child).base, same_gap(needle_, 0, tube(child).base));
    for (const std::int32_t place : loop) {
      if (tubes_.bridge_of(place) == bottom) across.push_back(place);
    }
    deal.kind = LimbDealKind::divide;
    deal.before = size_of(kept);
    deal.held = static_cast<std::int32_t>(end - first);
    deal.rest = static_cast<std::int32_t>(needle_.end() - end);
    deal.bridge = size_of(across);
    if (!across.empty()) deal.gap = begin_gap(across);
    deal.after = size_of(loop);
    Places aside(first, end);
    kept.insert(kept.end(), across.begin(), across.end());
    kept.insert(kept.end(), end, needle_.end());
    if (kept != loop) throw Bug("a divided needle is not what is worked on");
    hold(sibling, std::move(aside), deal);
    put_on_needle(std::move(kept));
  }

  std::int32_t begin_gap(const Places& stitches) {
    layout_.plan.gaps.push_back(size_of(stitches));
    const auto gap = static_cast<std::int32_t>(layout_.plan.gaps.size());
    std::int32_t in_gap = 0;
    for (const std::int32_t place : stitches) {
      gap_of_[static_cast<std::size_t>(tubes_.stitch_of(place))] = gap;
      in_gap_[static_cast<std::size_t>(tubes_.stitch_of(place))] = in_gap++;
    }
    return gap;
  }

  // What is new in a loop, stretch by stretch: stitches of one bridge that lie side by side when they are first met.
  void number_gaps(const Places& loop) {
    Places stretch;
    const auto finish = [&] {
      if (!stretch.empty()) begin_gap(stretch);
      stretch.clear();
    };
    for (const std::int32_t place : loop) {
      const auto p = static_cast<std::size_t>(place);
      const bool fresh = tubes_.bridge_of(place) >= 0 && on_needle_[p] == 0 && on_holder_[p] < 0 &&
                         gap_of_[static_cast<std::size_t>(tubes_.stitch_of(place))] == 0;
      const bool again = fresh && std::any_of(stretch.begin(), stretch.end(), [&](std::int32_t other) {
                           return tubes_.stitch_of(other) == tubes_.stitch_of(place);
                         });
      if (!fresh || again ||
          (!stretch.empty() && tubes_.bridge_of(place) != tubes_.bridge_of(stretch.back())))
        finish();
      if (fresh && !again) {
        stretch.push_back(place);
        fresh_.push_back(place);
      }
    }
    finish();
  }

  std::vector<LimbItem> items_of(const Places& loop) {
    fresh_.clear();
    number_gaps(loop);
    std::vector<LimbItem> items;
    std::int32_t last = -1;
    for (const std::int32_t place : loop) {
      const LimbItem item = item_of(place);
      const bool same = !items.empty() && items.back().kind == item.kind && items.back().gap == item.gap &&
                        items.back().piece == item.piece && items.back().holder == item.holder &&
                        follows(item, last);
      if (same)
        ++items.back().count;
      else
        begin_item(items, item);
      last = item.first;
    }
    return items;
  }
  static bool follows(const LimbItem& item, std::int32_t last) {
    if (item.kind == LimbItemKind::take) return (last + 1) % item.held == item.first;
    return item.kind != LimbItemKind::pick_up || last == item.first + 1;
  }
  void begin_item(std::vector<LimbItem>& items, const LimbItem& item) {
    const bool again = std::any_of(items.begin(), items.end(), [&](const LimbItem& before) {
      return before.kind == LimbItemKind::take && before.piece == item.piece && before.holder == item.holder;
    });
    if (item.kind == LimbItemKind::take && !again && item.first > 0) ++layout_.offsets;
    items.push_back(item);
  }

  [[nodiscard]] LimbItem item_of(std::int32_t place) const {
    const auto p = static_cast<std::size_t>(place);
    LimbItem item{LimbItemKind::keep, 1};
    if (on_needle_[p] != 0) return item;
    if (on_holder_[p] >= 0) {
      item.kind = LimbItemKind::take;
      item.piece = piece_of_holder(on_holder_[p]);
      item.holder = number_of_holder(on_holder_[p]);
      item.first = at_[p];
      item.held = size_of(holders_[static_cast<std::size_t>(on_holder_[p])]);
      return item;
    }
    item.gap = gap_of_[static_cast<std::size_t>(tubes_.stitch_of(place))];
    if (item.gap == 0) throw Bug("a piece begins on stitches that are nowhere");
    const bool fresh = std::find(fresh_.begin(), fresh_.end(), place) != fresh_.end();
    item.kind = fresh ? LimbItemKind::cast_on : LimbItemKind::pick_up;
    if (!fresh) item.first = in_gap_[static_cast<std::size_t>(tubes_.stitch_of(place))];
    return item;
  }

  void begin_rounds() {
    const std::int32_t number = tube_now();
    const LimbTube& own = tube(number);
    const auto t = static_cast<std::size_t>(number);
    const bool on_loops = runs_.steps[now_].front().kind == LimbStepKind::loops;
    if (!own.base.empty() && !on_loops && needle_ != turned_to(own.base, markers_.base[t]))
      throw Bug("the needle is not what the first round is worked on");
    put_on_needle(turned_to(own.places.back(), markers_.last[t]));
  }

  void end_piece(LimbPiece& piece) {
    const std::int32_t number = tube_now(), top = tube(number).top;
    LimbEnd& end = piece.end;
    if (top < 0) {
      end.kind = LimbEndKind::closed;
      put_on_needle({});
    } else if (runs_.grafted[now_] != 0) {
      end.kind = LimbEndKind::grafted;
      const std::int32_t other = tubes_.other_of_ring(top, number);
      end.piece = piece_of_[static_cast<std::size_t>(other)];
      empty_holder(holder_of_[static_cast<std::size_t>(other)]);
      put_on_needle({});
    } else if (runs_.goes_on[now_] != 0) {
      end.kind = LimbEndKind::goes_on;
      end.piece = static_cast<std::int32_t>(now_) + 1;
    } else {
      end.kind = LimbEndKind::held;
      const std::int32_t holder = free_holder(static_cast<std::int32_t>(now_));
      holder_of_[static_cast<std::size_t>(number)] = holder;
      if (holder != static_cast<std::int32_t>(now_)) possible_ = false;
      put_on_holder(holder, needle_);
      put_on_needle({});
    }
  }

  const LimbTubes& tubes_;
  const LimbRuns& runs_;
  const LimbMarkers& markers_;
  LimbLayout layout_;
  std::size_t now_ = 0;
  bool possible_ = true;
  Places needle_;
  std::vector<Places> holders_;                // by the piece that each goes by, then second ones, and so on
  std::vector<std::int32_t> on_holder_, at_;   // of each place: which holder, where there; -1: none
  std::vector<std::int32_t> gap_of_, in_gap_;  // of each stitch: its gap, and its place there
  std::vector<std::uint8_t> on_needle_;        // of each place
  std::vector<std::int32_t> holder_of_, piece_of_;  // of each tube
  Places fresh_;                                    // cast on by the deal at hand
};

// --- rounds ------------------------------------------------------------------------------------------------------

// The same pair in a round that begins `gap` stitches later.
ShortRowPair begun_at(const ShortRowPair& pair, std::int32_t gap, std::int32_t stitches) {
  std::int32_t first = pair.first - gap, last = pair.last - gap;
  while (last < 0) {
    first += stitches;
    last += stitches;
  }
  return {first, last};
}

LimbRound round_of(const HandsRow& hands, std::int32_t gap) {
  LimbRound round;
  const auto first = static_cast<std::ptrdiff_t>(hands.up[static_cast<std::size_t>(gap)]);
  round.operations.assign(hands.operations.begin() + first, hands.operations.end());
  round.operations.insert(round.operations.end(), hands.operations.begin(), hands.operations.begin() + first);
  round.slips_back = hands.crosses[static_cast<std::size_t>(gap)] != 0;
  round.before = static_cast<std::int32_t>(hands.up.size());
  round.after = static_cast<std::int32_t>(hands.operations.size());
  for (const ShortRowPair& pair : hands.pairs) round.pairs.push_back(begun_at(pair, gap, round.before));
  return round;
}

void add_rounds_of(const LimbTubes& tubes, const LimbMarkers& markers, std::int32_t number, bool on_loops,
                   LimbPiece& piece) {
  const LimbTube& tube = tubes.tube(number);
  const auto t = static_cast<std::size_t>(number);
  if (on_loops) {
    const HandsRow& hands = tubes.fork(tube.bottom).on_loops[tubes.side(tube.bottom, number)];
    piece.rounds.push_back(round_of(hands, markers.base[t]));
  } else if (!tube.base.empty()) {
    piece.rounds.push_back(round_of(tube.hands.front(), markers.base[t]));
  }
  std::int32_t gap = markers.first[t];
  piece.starts.push_back(gap);
  for (std::size_t row = 1; row < tube.hands.size(); ++row) {
    piece.rounds.push_back(round_of(tube.hands[row], gap));
    gap = tube.hands[row].up[static_cast<std::size_t>(gap)];
    piece.starts.push_back(gap);
  }
}

// Of several stitches that run backwards round and round, the one that is met first.
std::int32_t met_first(const std::vector<std::int32_t>& stitches, std::int32_t size) {
  for (const std::int32_t stitch : stitches) {
    if (std::find(stitches.begin(), stitches.end(), (stitch + 1) % size) == stitches.end()) return stitch;
  }
  return stitches.front();
}

void add_grafts(const LimbTubes& tubes, const LimbMarkers& markers, std::int32_t number,
                const LimbPiece& other, LimbPiece& piece) {
  const std::int32_t top = tubes.tube(number).top;
  const LimbFork& ring = tubes.fork(top);
  const std::int32_t own = static_cast<std::int32_t>(tubes.tube(number).places.back().size());
  const auto others =
      static_cast<std::int32_t>(tubes.tube(tubes.other_of_ring(top, number)).places.back().size());
  if (own < 1 || others < 1) throw Bug("a graft of nothing");
  std::vector<std::vector<std::int32_t>> joined(static_cast<std::size_t>(own));
  for (std::size_t i = 0; i < ring.joined.size(); ++i) {
    for (const std::int32_t k : ring.joined[i]) {
      if (ring.from[0] == number)
        joined[i].push_back(k);
      else
        joined[static_cast<std::size_t>(k)].push_back(static_cast<std::int32_t>(i));
    }
  }
  const auto links = [&](std::int32_t i) -> const std::vector<std::int32_t>& {
    return joined[static_cast<std::size_t>((i + own) % own)];
  };
  const auto same = [&](std::int32_t i) { return links(i).size() == 1 && links(i) == links(i - 1); };
  std::int32_t first = markers.last[static_cast<std::size_t>(number)];
  LimbEnd& end = piece.end;
  while (end.slips_back < own && same(first)) {
    --first;
    ++end.slips_back;
  }
  for (std::int32_t i = 0; i < own; ++i) {
    if (i > 0 && same(first + i))
      ++end.grafts.back().own;
    else
      end.grafts.push_back({1, static_cast<std::int32_t>(links(first + i).size())});
  }
  end.other_first = (met_first(links(first), others) - other.starts.back() + others) % others;
}

}  // namespace

std::optional<LimbLayout> lay_out(const LimbTubes& tubes, const LimbRuns& runs, const LimbMarkers& markers) {
  return Layout(tubes, runs, markers).run();
}

void add_rounds(const LimbTubes& tubes, const LimbRuns& runs, const LimbMarkers& markers, LimbPlan& plan) {
  for (std::size_t i = 0; i < plan.pieces.size(); ++i) {
    LimbPiece& piece = plan.pieces[i];
    const bool on_loops = runs.steps[i].front().kind == LimbStepKind::loops;
    add_rounds_of(tubes, markers, runs.order[i], on_loops, piece);
    if (piece.end.kind == LimbEndKind::grafted)
      add_grafts(tubes, markers, runs.order[i], plan.piece(piece.end.piece), piece);
  }
}

}  // namespace knit
