#include "knit/limbs/limb_plan.h"

#include <algorithm>

#include "knit/order/limb_order.h"

namespace knit {

namespace {

// Tubes of the fabric, by their number here; empty where they are not exactly those that have rows.
std::vector<std::int32_t> numbers_of(const LimbTubes& tubes, const std::vector<TubeId>& ids) {
  std::vector<std::int32_t> numbers;
  for (const TubeId id : ids) {
    for (std::int32_t i = 0; i < tubes.count(); ++i) {
      if (tubes.tube(i).id == id && tubes.tube(i).has_rows()) numbers.push_back(i);
    }
  }
  std::int32_t with_rows = 0;
  for (std::int32_t i = 0; i < tubes.count(); ++i) with_rows += tubes.tube(i).has_rows() ? 1 : 0;
  if (static_cast<std::int32_t>(numbers.size()) != with_rows || numbers.size() != ids.size()) numbers.clear();
  return numbers;
}

LimbTubes limb_tubes_of(const State& state) { return {state.fabric, state.tubes.pointer().get()}; }

// Rows were made in the order that was cheapest when they were planned (knit/run/knitters_order.h). Another is looked for only
// where it cannot be worked: a fabric that was not planned so, or links of another placement.
OrderedLimbs limbs_in_order(const LimbTubes& tubes, const std::vector<std::int32_t>& wanted) {
  for (const auto& order : {wanted, order_of_rows(tubes)}) {
    if (order.empty()) continue;
    if (std::optional<OrderedLimbs> limbs = in_order(tubes, order)) return std::move(*limbs);
  }
  return cheapest_order(tubes);
}

std::int64_t stitches_in(const LimbPiece& piece) {
  std::int64_t stitches = piece.is_cast_on() ? piece.first_count() : 0;
  for (const LimbRound& round : piece.rounds) stitches += round.after;
  return stitches;
}

std::int32_t widest_of(const LimbPiece& piece) {
  std::int32_t widest = piece.first_count();
  for (const LimbRound& round : piece.rounds) widest = std::max(widest, round.after);
  return widest;
}

// The largest is the body; what ends on one side is a limb, if it is one of twins or narrow; between two deals it is a branch.
void give_roles(LimbPlan& plan) {
  std::size_t largest = 0;
  std::int32_t widest = 0;
  for (std::size_t i = 0; i < plan.pieces.size(); ++i) {
    if (stitches_in(plan.pieces[i]) > stitches_in(plan.pieces[largest])) largest = i;
    widest = std::max(widest, widest_of(plan.pieces[i]));
  }
  for (std::size_t i = 0; i < plan.pieces.size(); ++i) {
    LimbPiece& piece = plan.pieces[i];
    const bool begins = piece.deals.front().kind == LimbDealKind::cast_on;
    const bool closes = piece.end.kind == LimbEndKind::closed;
    const bool leaf = begins != closes, twin = piece.twins.size() > 1;
    if (piece.inner)
      piece.role = LimbRole::lining;
    else if (twin)
      piece.role = leaf ? LimbRole::limb : LimbRole::branch;
    else if (i == largest)
      piece.role = LimbRole::body;
    else if (leaf)
      piece.role = 2 * widest_of(piece) >= widest ? LimbRole::part : LimbRole::limb;
    else
      piece.role =
          piece.deals.back().kind == LimbDealKind::divide || piece.deals.back().kind == LimbDealKind::rejoin
              ? LimbRole::branch
              : LimbRole::part;
  }
}

// The first of twins gives its operations to the others, round by round; a first round on another count stays.
void shape_alike(const LimbPiece& first, LimbPiece& piece) {
  if (first.rounds.size() != piece.rounds.size() || first.first_count() == 0) return;
  for (std::size_t i = 0; i < first.rounds.size(); ++i) {
    if (first.rounds[i].after != piece.rounds[i].after) return;
  }
  for (std::size_t i = 0; i < first.rounds.size(); ++i) {
    LimbRound& round = piece.rounds[i];
    if (first.rounds[i].before != round.before || first.rounds[i] == round) continue;
    round = first.rounds[i];
    round.copied = true;
  }
}

void shape_twins_alike(LimbPlan& plan) {
  for (std::size_t i = 0; i < plan.pieces.size(); ++i) {
    const std::int32_t first = plan.pieces[i].twins.front();
    if (first != static_cast<std::int32_t>(i)) shape_alike(plan.piece(first), plan.pieces[i]);
  }
}

}  // namespace

bool has_limbs(const State& state) {
  const auto& rows = state.fabric.rows();
  return !state.fabric.deals().empty() || std::any_of(rows.begin(), rows.end(), [&](const auto& row) {
    return row->tube != rows.front()->tube;
  });
}

bool limbs_are_known(const State& state) {
  const auto& rows = state.fabric.rows();
  const auto worked =
      std::count_if(rows.begin(), rows.end(), [](const auto& row) { return !row->on.empty(); });
  // Of two rounds that are cast on together none is worked on another.
  const bool begun = worked > 0 || (state.finished() && !state.fabric.deals().empty());
  return begun && static_cast<std::size_t>(worked) == state.fabric.joins().size();
}

namespace {

void bind_off_together(LimbPlan& plan) {
  plan.three_needle = true;
  for (LimbPiece& piece : plan.pieces) {
    const std::vector<LimbGraft>& grafts = piece.end.grafts;
    piece.end.three_needle = piece.end.kind == LimbEndKind::grafted &&
                             std::all_of(grafts.begin(), grafts.end(),
                                         [](const LimbGraft& graft) { return graft == LimbGraft{}; });
  }
}

}  // namespace

LimbPlan plan_limbs(const State& state, const LimbOptions& options) {
  const LimbTubes tubes = limb_tubes_of(state);
  OrderedLimbs limbs = limbs_in_order(tubes, numbers_of(tubes, options.order));
  LimbPlan plan = std::move(limbs.layout.plan);
  add_rounds(tubes, limbs.runs, limbs.markers, plan);
  give_roles(plan);
  if (options.twins_alike) shape_twins_alike(plan);
  if (options.three_needle) bind_off_together(plan);
  plan.cost = limbs.cost;
  return plan;
}

std::optional<LimbOrderCost> cost_of_order(const State& state, const std::vector<TubeId>& order) {
  const LimbTubes tubes = limb_tubes_of(state);
  const std::vector<std::int32_t> numbers = numbers_of(tubes, order);
  if (numbers.empty()) return std::nullopt;
  const std::optional<OrderedLimbs> found = in_order(tubes, numbers);
  if (!found) return std::nullopt;
  return LimbOrderCost{found->cost, found->layout.plan.held_most, found->layout.plan.yarns};
}

}  // namespace knit
