#include "knit/rows/contour_stage.h"

#include <utility>
#include <variant>

#include "knit/rows/contour_rows.h"
#include "knit/rows/ring.h"

namespace knit {

namespace {

const Cut& cut_at_hand(const ContourWork& work) {
  return work.plan->cuts[static_cast<std::size_t>(work.cut)];
}
const Ring& ring_at_hand(const ContourWork& work) { return *cut_at_hand(work).loops.front(); }

Advanced<ContourEvent> plan(const Input& input, const RowsSettings& rows, const StitchSize& stitch,
                            const ContourRow& at, ContourWork& work) {
  auto planned = plan_cuts(input, at.timing, rows, stitch, at.from);
  if (const auto* stopped = std::get_if<Stopped>(&planned)) return *stopped;
  work.plan = Shared(std::get<CutPlan>(std::move(planned)));
  work.cut = 0;
  work.phase = ContourPhase::cut;
  const CutPlan& cuts = *work.plan;
  const RowsPlanned step{static_cast<std::int32_t>(cuts.cuts.size()), cuts.passed_over, cuts.height,
                         cuts.row_height, cuts.stitch_height};
  return {step, cuts.cuts.empty() ? Ended::stage : Ended::step};
}

CutFound find_cut(ContourWork& work) {
  const Cut& cut = cut_at_hand(work);
  work.phase = ContourPhase::loop;
  return {work.cut, cut.edges, static_cast<std::int32_t>(cut.loops.size()), cut.time};
}

Advanced<ContourEvent> close_loop(std::int32_t row, ContourWork& work) {
  const Cut& cut = cut_at_hand(work);
  if (const auto& split = work.plan->split; split && split->level == work.cut) {
    return Stopped{StopReason::splits, split->cause, work.cut, split->loops, row,
                   split->vertex,      split->time,  cut.time};
  }
  // Where the surface is pinched to a point there is nothing to go round.
  if (cut.loops.empty())
    return Stopped{StopReason::not_a_ring, {}, work.cut, cut.edges, 0, no_vertex, 0.0, cut.time};
  work.phase = ContourPhase::measure;
  return LoopClosed{static_cast<std::int32_t>(ring_at_hand(work).points.size())};
}

LengthMeasured measure(const StitchSize& stitch, ContourWork& work) {
  work.phase = ContourPhase::count;
  const double length = ring_at_hand(work).length;
  return {length, length / stitch.width};
}

CountChosen count(const RowsSettings& rows, const StitchSize& stitch, std::int32_t below, ContourWork& work) {
  const ChosenCount chosen = choose_count(*work.plan, work.cut, below, rows, stitch);
  work.count = chosen.count;
  work.phase = ContourPhase::place;
  return {chosen.count, below, chosen.reason, chosen.ideal, ring_at_hand(work).length / chosen.count};
}

// True when no row follows.
bool finish_row(const ContourRow& at, ContourWork& work, std::optional<Row>& row) {
  const Cut& cut = cut_at_hand(work);
  row = Row{0, at.number, at.on, work.cut, cut.time, cut.loops.front(), std::move(work.stitches)};
  ContourWork next;
  next.phase = ContourPhase::cut;
  next.plan = work.plan;
  next.cut = work.cut + 1;
  work = std::move(next);
  return work.cut == static_cast<std::int32_t>(work.plan->cuts.size());
}

Advanced<ContourEvent> place(const ContourRow& at, ContourWork& work, std::optional<Row>& row) {
  const auto placed = static_cast<std::int32_t>(work.stitches.size());
  const Ring& ring = ring_at_hand(work);
  const StitchPlaced step{placed + 1, work.count, ring.length * placed / work.count};
  work.stitches.push_back({point_at(ring, step.arc), no_vertex});
  if (step.stitch < step.of) return step;
  return {step, finish_row(at, work, row) ? Ended::stage : Ended::row};
}

}  // namespace

Advanced<ContourEvent> advance_contours(const Input& input, const RowsSettings& rows,
                                        const StitchSize& stitch, const ContourRow& at, ContourWork& work,
                                        std::optional<Row>& row) {
  switch (work.phase) {
    case ContourPhase::plan:
      return plan(input, rows, stitch, at, work);
    case ContourPhase::cut:
      // The stitch height may be edited on the way; then the rest of the surface is planned anew.
      if (next_plans_cuts(stitch, work)) return plan(input, rows, stitch, at, work);
      return find_cut(work);
    case ContourPhase::loop:
      return close_loop(at.number, work);
    case ContourPhase::measure:
      return measure(stitch, work);
    case ContourPhase::count:
      return count(rows, stitch, at.on.size(), work);
    case ContourPhase::place:
      break;
  }
  return place(at, work, row);
}

bool next_plans_cuts(const StitchSize& stitch, const ContourWork& work) {
  return work.phase == ContourPhase::plan ||
         (work.phase == ContourPhase::cut && work.plan->stitch_height != stitch.height);
}

}  // namespace knit
