#include "knit/settle/settle_stage.h"

namespace knit {

Advanced<SettleEvent> advance_settle(const Input& input, const SettleSettings& settings,
                                     const StitchSize& stitch, SettleWork& work, Fabric& fabric,
                                     const Heard& heard) {
  if (!work.plan) {
    begin_settling(input, fabric, stitch, settings, work, heard);
    const SettleGraph& graph = work.plan->terms.graph;
    return SettlingBegun{static_cast<std::int32_t>(work.at->positions.size()),
                         static_cast<std::int32_t>(graph.wales.size()),
                         static_cast<std::int32_t>(graph.courses.size()), work.sum};
  }
  const SettleIteration told = advance_settling(input, settings, work, heard);
  if (told.taken) fabric = fabric.moved_to(work.at->positions);
  const StitchesSettled step{told.iteration,
                             told.tries,
                             told.taken,
                             work.done,
                             static_cast<float>(told.before),
                             static_cast<float>(told.after),
                             static_cast<float>(told.shift),
                             static_cast<float>(told.mean_move),
                             static_cast<float>(told.greatest_move)};
  return {step, work.done ? Ended::stage : Ended::step};
}

}  // namespace knit
