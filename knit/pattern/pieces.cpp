#include "knit/pattern/pieces.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "knit/model/bug.h"
#include "knit/model/words.h"

namespace knit {

namespace {

std::vector<StitchRef> stitches_in(const LiveStitches& live) {
  std::vector<StitchRef> stitches;
  for (const StitchSpan& span : live.spans) {
    for (std::int32_t i = 0; i < span.count; ++i) stitches.push_back({span.row, span.first + i});
  }
  return stitches;
}

// --- rows and who takes them -------------------------------------------------------------------------------------

struct RowsOfPiece {
  TubeId tube = 0;
  RowId first = 1, last = 1;
};

// The rows in pieces, and which piece takes each stitch of a last row.
class PieceRows {
 public:
  explicit PieceRows(const Fabric& fabric) : fabric_(fabric) {
    for (const auto& row : fabric.rows()) {
      if (rows_.empty() || rows_.back().tube != row->tube) rows_.push_back({row->tube, row->id, row->id});
      rows_.back().last = row->id;
    }
    for (std::int32_t piece = 0; piece < count(); ++piece)
      takers_.emplace_back(static_cast<std::size_t>(last_size(piece)), -1);
    for (std::int32_t piece = 0; piece < count(); ++piece) {
      for (const StitchRef& ref : begins_on(piece)) {
        if (is_bridge(ref)) continue;
        const auto from = static_cast<std::size_t>(piece_of(ref));
        takers_[from][static_cast<std::size_t>(ref.stitch)] = piece;
      }
    }
  }

  [[nodiscard]] std::int32_t count() const { return static_cast<std::int32_t>(rows_.size()); }
  [[nodiscard]] const RowsOfPiece& at(std::int32_t piece) const {
    return rows_[static_cast<std::size_t>(piece)];
  }
  [[nodiscard]] std::int32_t last_size(std::int32_t piece) const {
    return size_of(fabric_.row(at(piece).last));
  }
  [[nodiscard]] std::int32_t of_tube(TubeId tube) const {
    const auto found =
        std::find_if(rows_.begin(), rows_.end(), [&](const RowsOfPiece& rows) { return rows.tube == tube; });
    if (found == rows_.end()) throw Bug("a tube without a row has no piece");
    return static_cast<std::int32_t>(found - rows_.begin());
  }
  // Of a stitch of a last row.
  [[nodiscard]] std::int32_t piece_of(const StitchRef& ref) const {
    const std::int32_t piece = of_tube(fabric_.row(ref.row).tube);
    if (at(piece).last != ref.row) throw Bug("only last rows are dealt");
    return piece;
  }
  [[nodiscard]] std::vector<StitchRef> begins_on(std::int32_t piece) const {
    return stitches_in(fabric_.row(at(piece).first).on);
  }
  // Of each stitch of its last row; -1: none.
  [[nodiscard]] const std::vector<std::int32_t>& takers(std::int32_t piece) const {
    return takers_[static_cast<std::size_t>(piece)];
  }
  [[nodiscard]] std::vector<std::int32_t> all_takers(std::int32_t piece) const {
    std::set<std::int32_t> all(takers(piece).begin(), takers(piece).end());
    all.erase(-1);
    return {all.begin(), all.end()};
  }
  // The piece that begins with the stitch at which the yarn of this one hangs; -1: none.
  [[nodiscard]] std::int32_t yarn_for(std::int32_t piece) const {
    const std::int32_t taker = takers(piece).front();
    return taker >= 0 && begins_on(taker).front() == StitchRef{at(piece).last, 0} ? taker : -1;
  }

 private:
  const Fabric& fabric_;
  std::vector<RowsOfPiece> rows_;
  std::vector<std::vector<std::int32_t>> takers_;
};

// --- what a piece begins on --------------------------------------------------------------------------------------

// Gaps are numbered as they are met.
class GapList {
 public:
  [[nodiscard]] bool is_cast_on(const StitchRef& ref) const { return places_.count(ref) != 0; }

  void cast_on(const StitchRef& ref, std::vector<Lay>& laid) {
    const bool goes_on =
        !laid.empty() && laid.back().kind == LayKind::cast_on && follows(ref, stitches_.back());
    if (!goes_on) {
      stitches_.emplace_back();
      laid.push_back({LayKind::cast_on, 0, 0, 0, static_cast<std::int32_t>(stitches_.size())});
    }
    ++laid.back().count;
    places_[ref] = {laid.back().gap, static_cast<std::int32_t>(stitches_.back().size())};
    stitches_.back().push_back(ref);
  }
  // A gap's stitches are met the other way on its other side.
  void pick_up(const StitchRef& ref, std::vector<Lay>& laid) const {
    const auto [gap, place] = places_.at(ref);
    const bool goes_on = !laid.empty() && laid.back().kind == LayKind::pick_up && laid.back().gap == gap &&
                         laid.back().first == place + 1;
    if (!goes_on) laid.push_back({LayKind::pick_up, 0, place, 0, gap});
    laid.back().first = place;
    ++laid.back().count;
  }
  [[nodiscard]] std::vector<std::int32_t> sizes() const {
    std::vector<std::int32_t> sizes;
    for (const auto& gap : stitches_) sizes.push_back(static_cast<std::int32_t>(gap.size()));
    return sizes;
  }

 private:
  static bool follows(const StitchRef& ref, const std::vector<StitchRef>& gap) {
    if (ref.row != gap.back().row) return false;
    const std::int32_t step = ref.stitch - gap.back().stitch;
    return std::abs(step) == 1 && (gap.size() == 1 || step == gap.back().stitch - gap[gap.size() - 2].stitch);
  }
  std::vector<std::vector<StitchRef>> stitches_;
  std::map<StitchRef, std::pair<std::int32_t, std::int32_t>> places_;  // gap, place there
};

// Whether what lies on the needle can stay there: the round begins on it and meets it in its own order.
bool stays_on_needle(const PieceRows& rows, const std::vector<StitchRef>& begins_on, std::int32_t before) {
  const RowId row = rows.at(before).last;
  if (begins_on.front().row != row) return false;
  std::int32_t last = -1;
  for (const StitchRef& ref : begins_on) {
    if (ref.row != row) continue;
    if (ref.stitch < last) return false;
    last = ref.stitch;
  }
  return true;
}

void lay_stitch(const PieceRows& rows, const StitchRef& ref, std::int32_t needle, std::vector<Lay>& laid) {
  const std::int32_t piece = rows.piece_of(ref);
  const LayKind kind = piece == needle ? LayKind::keep : LayKind::take;
  const bool goes_on = !laid.empty() && laid.back().kind == kind && laid.back().piece == piece &&
                       (laid.back().first + laid.back().count) % rows.last_size(piece) == ref.stitch;
  if (!goes_on) laid.push_back({kind, piece, ref.stitch, 0, 0});
  ++laid.back().count;
}

// Those of the needle's stitches from `first` to before `end` that others take, each stretch for one.
std::vector<Lay> set_aside(const PieceRows& rows, std::int32_t needle, std::int32_t first, std::int32_t end) {
  std::vector<Lay> aside;
  for (std::int32_t i = first; i < end; ++i) {
    const std::int32_t taker = rows.takers(needle)[static_cast<std::size_t>(i)];
    if (aside.empty() || aside.back().piece != taker) aside.push_back({LayKind::set_aside, taker, i, 0, 0});
    ++aside.back().count;
  }
  return aside;
}

// What is set aside stands where the needle comes to it: behind what was kept before.
std::vector<Lay> with_set_aside(const PieceRows& rows, std::int32_t needle, const std::vector<Lay>& laid) {
  std::vector<Lay> all;
  std::size_t behind_kept = 0;
  std::int32_t next = 0;
  const auto put = [&](std::int32_t end) {
    const std::vector<Lay> aside = set_aside(rows, needle, next, end);
    all.insert(all.begin() + static_cast<std::ptrdiff_t>(behind_kept), aside.begin(), aside.end());
  };
  for (const Lay& lay : laid) {
    if (lay.kind == LayKind::keep) {
      put(lay.first);
      next = lay.first + lay.count;
    }
    all.push_back(lay);
    if (lay.kind == LayKind::keep) behind_kept = all.size();
  }
  put(rows.last_size(needle));
  return all;
}

void begin_on_live(const PieceRows& rows, std::int32_t number, GapList& gaps, Piece& piece) {
  const std::vector<StitchRef> begins_on = rows.begins_on(number);
  const bool divided = number > 0 && stays_on_needle(rows, begins_on, number - 1);
  const std::int32_t needle = divided ? number - 1 : -1;
  piece.start = divided ? PieceStart::divided : PieceStart::rejoined;
  for (const StitchRef& ref : begins_on) {
    if (!is_bridge(ref))
      lay_stitch(rows, ref, needle, piece.laid);
    else if (gaps.is_cast_on(ref))
      gaps.pick_up(ref, piece.laid);
    else
      gaps.cast_on(ref, piece.laid);
  }
  if (divided) piece.laid = with_set_aside(rows, needle, piece.laid);
  piece.rounds.cast_on = static_cast<std::int32_t>(begins_on.size());
  if (is_bridge(begins_on.front())) return;
  const std::int32_t first = rows.piece_of(begins_on.front());
  if (rows.yarn_for(first) == number)
    piece.yarn = first + 1 == number ? PieceYarn::goes_on : PieceYarn::hangs;
}

// --- rings -------------------------------------------------------------------------------------------------------

// Which stitches of one row each stitch of another is joined to, in the order of the ring's strip.
using RingLinks = std::vector<std::vector<std::int32_t>>;

RingLinks ring_links(const Fabric& fabric, const Deal& deal, RowId from, RowId to) {
  const KnittingPath path(fabric);
  RingLinks links(fabric.row(from).stitches.size());
  for (const auto& edge : deal.column_edges) {
    const StitchRef one = path.at(edge[0]), two = path.at(edge[1]);
    const StitchRef& own = one.row == from ? one : two;
    const StitchRef& other = one.row == from ? two : one;
    if (own.row != from || other.row != to) throw Bug("a ring's strip joins two rows");
    links[static_cast<std::size_t>(own.stitch)].push_back(other.stitch);
  }
  return links;
}

// Of several, which run backwards round and round, the one that is met first.
std::int32_t met_first(const std::vector<std::int32_t>& stitches, std::int32_t size) {
  for (const std::int32_t stitch : stitches) {
    const auto after = (stitch + 1) % size;
    if (std::find(stitches.begin(), stitches.end(), after) == stitches.end()) return stitch;
  }
  return stitches.front();
}

// The first round on loops that were cast on provisionally.
void begin_on_loops(const Fabric& fabric, const PieceRows& rows, const Deal& deal, std::int32_t below,
                    std::int32_t number, Piece& piece) {
  const RowId row = rows.at(number).first, loops_row = rows.at(below).first;
  const RingLinks links = ring_links(fabric, deal, row, loops_row);
  const std::int32_t loops = size_of(fabric.row(loops_row));
  piece.start = PieceStart::loops;
  piece.rounds.cast_on = loops;
  Round round{1, {}, loops, size_of(fabric.row(row))};
  std::optional<std::int32_t> first;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const std::vector<std::int32_t>& before = links[(i == 0 ? links.size() : i) - 1];
    const bool made = links.size() > 1 && links[i] == before && links[i].size() == 1;
    const Hand hand = made ? Hand::m1l : links[i].size() > 1 ? Hand::k2tog : Hand::knit;
    if (!made && !first) first = met_first(links[i], loops);
    round.operations.push_back({hand});
  }
  piece.laid = {{LayKind::loops, below, first.value_or(0), loops, 0}};
  piece.rounds.rounds.push_back(std::move(round));
}

// The two last rows that a graft joins, seen from the later one.
void graft(const Fabric& fabric, const PieceRows& rows, const Deal& deal, std::int32_t other,
           std::int32_t number, PieceEnd& end) {
  const RowId row = rows.at(number).last, other_row = rows.at(other).last;
  const RingLinks links = ring_links(fabric, deal, row, other_row);
  const std::int32_t others = size_of(fabric.row(other_row));
  const std::size_t own = links.size();
  const auto same = [&](std::size_t i, std::size_t k) {
    return links[i].size() == 1 && links[i] == links[k];
  };
  end.kind = PieceEndKind::grafted;
  end.to = {other};
  std::size_t first = 0;
  while (first + 1 < own && same(first, (first + own - 1) % own)) ++first;
  end.own_first = static_cast<std::int32_t>(first);
  end.other_first = met_first(links[first], others);
  for (std::size_t i = 0; i < own; ++i) {
    const std::size_t at = (first + i) % own;
    if (i > 0 && same(at, (at + own - 1) % own))
      ++end.grafts.back().own;
    else
      end.grafts.push_back({1, static_cast<std::int32_t>(links[at].size())});
  }
}

// --- the whole ---------------------------------------------------------------------------------------------------

struct RingOfPiece {
  const Deal* deal = nullptr;
  std::int32_t other = -1;
};
// The ring at whose bottom or top a piece stands; none: null.
RingOfPiece ring_of(const Fabric& fabric, const PieceRows& rows, DealKind kind, std::int32_t piece) {
  for (const auto& deal : fabric.deals()) {
    if (deal->kind != kind) continue;
    const std::int32_t one = rows.of_tube(deal->from[0]), two = rows.of_tube(deal->from[1]);
    if (one == piece || two == piece) return {&*deal, one == piece ? two : one};
  }
  return {};
}

void add_rounds(const Fabric& fabric, const RowsOfPiece& rows, Piece& piece) {
  for (RowId id = rows.first; id <= rows.last; ++id) {
    if (const Join* join = fabric.join_into(id))
      piece.rounds.rounds.push_back({id - rows.first + 1, operations_of(*join), join->below, join->above});
  }
}

void begin_piece(const State& state, const PieceRows& rows, std::int32_t number, GapList& gaps,
                 Piece& piece) {
  const Fabric& fabric = state.fabric;
  const RowsOfPiece& own = rows.at(number);
  piece.tube = own.tube;
  piece.first_row = own.first;
  piece.rows_before = number == 0 ? 0 : rows.at(number - 1).last;
  piece.inner = state.tubes && state.tubes->tube(own.tube).inner;
  const RingOfPiece ring = ring_of(fabric, rows, DealKind::ring_cast_on, number);
  if (!fabric.row(own.first).on.empty()) {
    begin_on_live(rows, number, gaps, piece);
  } else if (ring.deal != nullptr && ring.other < number) {
    begin_on_loops(fabric, rows, *ring.deal, ring.other, number, piece);
  } else {
    piece.start = ring.deal != nullptr ? PieceStart::provisional : PieceStart::cast_on;
    piece.rounds.cast_on = size_of(fabric.row(own.first));
  }
  add_rounds(fabric, own, piece);
}

void end_piece(const Fabric& fabric, const PieceRows& rows, std::int32_t number, Pieces& made) {
  PieceEnd& end = made.pieces[static_cast<std::size_t>(number)].end;
  end.to = rows.all_takers(number);
  end.yarn_for = rows.yarn_for(number);
  const RingOfPiece ring = ring_of(fabric, rows, DealKind::ring_bind_off, number);
  if (!end.to.empty()) {
    const bool stays = number + 1 < rows.count() && made.piece(number + 1).start == PieceStart::divided;
    end.kind = stays ? PieceEndKind::goes_on : PieceEndKind::held;
  } else if (ring.deal != nullptr && ring.other < number) {
    graft(fabric, rows, *ring.deal, ring.other, number, end);
  } else if (ring.deal != nullptr) {
    end.kind = PieceEndKind::held;
    end.to = {ring.other};
  }
}

// While a piece is worked: a holder for each piece that still waits for stitches of a divided one, and one for each held.
std::int32_t held_while(const Pieces& made, std::int32_t number) {
  std::int32_t held = 0;
  for (std::int32_t before = 0; before < number; ++before) {
    const PieceEnd& end = made.piece(before).end;
    if (end.kind == PieceEndKind::closed || end.kind == PieceEndKind::grafted) continue;
    // What is grafted later waits while the other is worked.
    const bool grafted = made.piece(end.to.back()).end.kind == PieceEndKind::grafted &&
                         made.piece(end.to.back()).end.to.front() == before;
    const auto waiting =
        static_cast<std::int32_t>(std::count_if(end.to.begin(), end.to.end(), [&](std::int32_t to) {
          return to > number || (grafted && to == number);
        }));
    held += end.kind == PieceEndKind::goes_on ? waiting : std::min(waiting, 1);
  }
  return held;
}

}  // namespace

bool in_pieces(const State& state) {
  const auto& rows = state.fabric.rows();
  return !state.fabric.deals().empty() || std::any_of(rows.begin(), rows.end(), [&](const auto& row) {
    return row->tube != rows.front()->tube;
  });
}

bool pieces_are_known(const State& state) {
  const auto& rows = state.fabric.rows();
  const auto worked =
      std::count_if(rows.begin(), rows.end(), [](const auto& row) { return !row->on.empty(); });
  return worked > 0 && static_cast<std::size_t>(worked) == state.fabric.joins().size();
}

Pieces pieces_of(const State& state) {
  const PieceRows rows(state.fabric);
  Pieces made;
  GapList gaps;
  for (std::int32_t number = 0; number < rows.count(); ++number)
    begin_piece(state, rows, number, gaps, made.pieces.emplace_back());
  for (std::int32_t number = 0; number < rows.count(); ++number) end_piece(state.fabric, rows, number, made);
  made.gaps = gaps.sizes();
  for (std::int32_t number = 0; number < rows.count(); ++number) {
    made.held_most = std::max(made.held_most, held_while(made, number));
    made.yarns += made.piece(number).yarn == PieceYarn::begun ? 1 : 0;
  }
  return made;
}

std::string piece_name(std::int32_t piece) { return "Piece " + tube_name(piece); }

}  // namespace knit
