#include "knit/run/knitters_order.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <optional>
#include <utility>

#include "knit/order/limb_order.h"
#include "knit/rows/contour_stage.h"
#include "knit/rows/dealing.h"
#include "knit/stitches/below_joins.h"
#include "knit/stitches/index_stage.h"

namespace knit {

namespace {

constexpr int most_times = 4;  // that rows are worked out

void add_rows_and_deals(const UnorderedTubes& at, const TubePlan& plan, Fabric& fabric) {
  ContourWork work;
  for (Ended ended = Ended::step; ended != Ended::stage;) {
    std::optional<Row> row;
    std::optional<Deal> deal;
    std::optional<TubePlan> other_plan;  // never made: the stitch stays
    std::optional<TubeRhythm> rhythm;    // nor is this: whole counts are enough for an order
    const ContourAt now{at.input, at.timing, at.graph, plan, fabric};
    ended = advance_contours(at.rows, {}, at.stitch, now, work, {row, deal, other_plan, rhythm}).ended;
    if (row) fabric.add(std::move(*row));
    if (deal) fabric.add(std::move(*deal));
  }
}

void add_joins(const UnorderedTubes& at, Fabric& fabric) {
  const bool follows = at.rows.round_start == RoundStart::follow;
  for (RowId id = fabric.next_worked(0); id > 0; id = fabric.next_worked(id)) {
    const Row& row = fabric.row(id);
    const std::vector<Stitch> below = fabric.stitches_of(row.on);
    const BelowJoins joins = joins_below(fabric, row.on);
    Join join = plan_row_join(
        at.stitches, at.stitch,
        {id, row.on, below, joins.mains, joins.shaped, joins.cast_on, &row, follows, {}, false});
    join.from = row.on;
    fabric.add(Shared(std::move(join)));
  }
}

LimbTubes knitted(const UnorderedTubes& at, const TubePlan& plan) {
  Fabric fabric;
  add_rows_and_deals(at, plan, fabric);
  add_joins(at, fabric);
  return {fabric, &plan};
}

struct FoundOrder {
  std::vector<TubeId> order;  // of the plan that was searched
  OrderedLimbs limbs;
  std::int32_t tried = 0;  // orders
};
FoundOrder search(const LimbTubes& tubes, const TubePlan& plan) {
  OrderedLimbs best = cheapest_order(tubes);
  std::vector<TubeId> worked;
  for (const std::int32_t tube : best.runs.order) worked.push_back(tubes.tube(tube).id);
  const std::int32_t tried = best.tried;
  return {with_rowless(plan, worked), std::move(best), tried};
}

TubePlan in_order_of(const TubePlan& plan, const TubeOrder& least, const FoundOrder& found) {
  const std::int32_t held = found.limbs.layout.plan.held_most, yarns = found.limbs.layout.plan.yarns;
  const bool exact = least.exact && held <= least.held_most && yarns <= least.yarns;
  TubePlan ordered = renumbered(plan, {found.order, held, yarns, exact});
  ordered.orders_tried = found.tried;
  return ordered;
}

TubeId first_with_rows(const TubePlan& plan, const std::vector<TubeId>& order) {
  return *std::find_if(order.begin(), order.end(), [&](TubeId id) { return plan.tube(id).rows() > 0; });
}

// Whether two orders make the same rows but for their numbers: of each join the same loop brings the yarn, of each ring the same
// side is cast on first, and so is the tube whose count was given.
bool make_the_same_rows(const RowsSettings& rows, const TubePlan& plan, const std::vector<TubeId>& one,
                        const std::vector<TubeId>& two) {
  const auto comes_first = [](const std::vector<TubeId>& order, const std::vector<TubeId>& pair) {
    return std::find(order.begin(), order.end(), pair[0]) < std::find(order.begin(), order.end(), pair[1]);
  };
  if (rows.cast_on != 0 && first_with_rows(plan, one) != first_with_rows(plan, two)) return false;
  return std::all_of(plan.events.begin(), plan.events.end(), [&](const TubeEvent& event) {
    if (event.kind == EventKind::join)
      return yarn_bringer(plan, one, event) == yarn_bringer(plan, two, event);
    return event.kind != EventKind::ring_cast_on ||
           comes_first(one, event.above) == comes_first(two, event.above);
  });
}

}  // namespace

TubePlan in_knitters_order(const UnorderedTubes& at, const TubePlan& plan) {
  const auto with_rows =
      std::count_if(plan.tubes.begin(), plan.tubes.end(), [](const Tube& tube) { return tube.rows() > 0; });
  if (with_rows < 2) return plan;
  const TubeOrder least{plan.order, plan.held_most, plan.yarns, plan.order_is_exact};
  // Each time on the rows of the order found last, until it makes them again.
  TubePlan worked = plan;
  std::optional<TubePlan> cheapest;  // of those that were worked as they stand
  double least_cost = 0.0;
  for (int times = 0; times < most_times; ++times) {
    const LimbTubes tubes = knitted(at, worked);
    const FoundOrder found = search(tubes, worked);
    if (make_the_same_rows(at.rows, worked, worked.order, found.order))
      return in_order_of(worked, least, found);
    const auto limbs = in_order(tubes, order_of_rows(tubes));
    if (limbs && (!cheapest || limbs->cost < least_cost)) {
      least_cost = limbs->cost;
      cheapest = in_order_of(worked, least, {worked.order, *limbs, found.tried});
    }
    worked = in_order_of(worked, least, found);
  }
  return cheapest.value_or(plan);
}

// Rows after deals take longest, and there are as many as tubes; of many tubes fewer orders are tried.
double microseconds_to_order(const TubeGraph& graph, const StitchSize& stitch) {
  constexpr double of_a_stitch = 0.5, of_a_search = 0.25, longest_search = 150000.0;
  const auto tubes = static_cast<double>(graph.tubes.size());
  if (tubes < 2.0) return 0.0;
  double area = 0.0;
  for (const auto& [a, b, c] : graph.surface.triangles) {
    const auto& p = graph.surface.positions;
    area += 0.5 * glm::length(glm::cross(p[b] - p[a], p[c] - p[a]));
  }
  const double stitches = area / (stitch.width * stitch.height);
  return of_a_stitch * stitches * tubes +
         std::min(of_a_search * tubes * tubes * tubes * tubes, longest_search);
}

}  // namespace knit
