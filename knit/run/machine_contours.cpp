#include <algorithm>

#include "knit/rows/contour_rows.h"
#include "knit/rows/ring.h"
#include "knit/run/machine.h"

namespace knit {

namespace {

const Cut& cut_at_hand(const ContourWork& work) {
  return work.plan->cuts[static_cast<std::size_t>(work.cut)];
}
const Ring& ring_at_hand(const ContourWork& work) { return *cut_at_hand(work).loops.front(); }

std::int32_t stitches_below(const State& state) { return state.fabric.live().size(); }

void finish_rows(State& state) {
  state.work = IndexWork{};
  state.next = {Stage::stitches, 2, 0};
}

Happening plan(const Input& input, const Parameters& parameters, State& state, ContourWork& work) {
  const double from = state.fabric.empty() ? 0.0 : state.fabric.rows().back()->time;
  auto planned = plan_cuts(input, *state.timing, parameters, from);
  if (const auto* stopped = std::get_if<Stopped>(&planned)) return *stopped;
  work.plan = Shared(std::get<CutPlan>(std::move(planned)));
  work.cut = 0;
  work.phase = ContourPhase::cut;
  const CutPlan& cuts = *work.plan;
  const RowsPlanned step{static_cast<std::int32_t>(cuts.cuts.size()), cuts.passed_over, cuts.height,
                         cuts.row_height, cuts.stitch_height};
  if (cuts.cuts.empty()) finish_rows(state);
  return step;
}

Happening find_cut(ContourWork& work) {
  const Cut& cut = cut_at_hand(work);
  work.phase = ContourPhase::loop;
  return CutFound{work.cut, cut.edges, static_cast<std::int32_t>(cut.loops.size()), cut.time};
}

Happening close_loop(const State& state, ContourWork& work) {
  const Cut& cut = cut_at_hand(work);
  if (const auto& split = work.plan->split; split && split->level == work.cut) {
    return Stopped{StopReason::splits, split->cause,  work.cut,    split->loops,
                   state.next.row,     split->vertex, split->time, cut.time};
  }
  // Where the surface is pinched to a point there is nothing to go round.
  if (cut.loops.empty())
    return Stopped{StopReason::not_a_ring, {}, work.cut, cut.edges, 0, no_vertex, 0.0, cut.time};
  work.phase = ContourPhase::measure;
  return LoopClosed{static_cast<std::int32_t>(ring_at_hand(work).points.size())};
}

Happening measure(const Parameters& parameters, ContourWork& work) {
  work.phase = ContourPhase::count;
  const double length = ring_at_hand(work).length;
  return LengthMeasured{length, length / parameters.stitch_width};
}

Happening count(const Parameters& parameters, const State& state, ContourWork& work) {
  const std::int32_t below = stitches_below(state);
  const ChosenCount chosen = choose_count(*work.plan, work.cut, below, parameters);
  work.count = chosen.count;
  work.phase = ContourPhase::place;
  return CountChosen{chosen.count, below, chosen.reason, chosen.ideal,
                     ring_at_hand(work).length / chosen.count};
}

void finish_row(State& state, ContourWork work) {
  const Cut& cut = cut_at_hand(work);
  const std::int32_t number = state.next.row;
  state.fabric.add(
      Row{0, number, state.fabric.live(), work.cut, cut.time, cut.loops.front(), std::move(work.stitches)});
  if (work.cut + 1 == static_cast<std::int32_t>(work.plan->cuts.size())) return finish_rows(state);
  ContourWork next;
  next.phase = ContourPhase::cut;
  next.plan = work.plan;
  next.cut = work.cut + 1;
  state.work = std::move(next);
  state.next = {Stage::rows, number + 1, 0};
}

Happening place(State& state, ContourWork& work) {
  const auto placed = static_cast<std::int32_t>(work.stitches.size());
  const Ring& ring = ring_at_hand(work);
  const StitchPlaced step{placed + 1, work.count, ring.length * placed / work.count};
  work.stitches.push_back({point_at(ring, step.arc), no_vertex});
  if (step.stitch == step.of) finish_row(state, ContourWork{work});
  return step;
}

}  // namespace

Happening advance_contours(const Input& input, const Parameters& parameters, State& state) {
  auto& work = std::get<ContourWork>(state.work);
  switch (work.phase) {
    case ContourPhase::plan:
      return plan(input, parameters, state, work);
    case ContourPhase::cut:
      // The stitch height may be edited on the way; then the rest of the surface is planned anew.
      if (work.plan->stitch_height != stitch_height_of(parameters))
        return plan(input, parameters, state, work);
      return find_cut(work);
    case ContourPhase::loop:
      return close_loop(state, work);
    case ContourPhase::measure:
      return measure(parameters, work);
    case ContourPhase::count:
      return count(parameters, state, work);
    case ContourPhase::place:
      break;
  }
  return place(state, work);
}

}  // namespace knit
