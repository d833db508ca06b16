#include "knit/run/timeline.h"

#include "knit/model/settings_table.h"
#include "knit/model/stitch_size.h"
#include "knit/run/basic_timeline_impl.h"

namespace knit {

template class BasicTimeline<KnitMachine>;

Step KnitMachine::advance(const Input& input, const Parameters& parameters, State& state,
                          const Heard& heard) {
  return knit::advance(input, parameters, state, heard);
}

bool KnitMachine::sweeps(const Input& input, const Parameters& parameters, const State& state) {
  return step_sweeps(input, parameters, state);
}

bool KnitMachine::is_long(const Input& input, const Parameters& parameters, const State& state) {
  return step_is_long(input, parameters, state);
}

// What first reads a parameter is a stage, so its first step; a stage's first step has row and item at least 0. But the
// first of the stage tubes, the times' own graph, reads only whether to smooth.
Place KnitMachine::first_reader(const Parameters& before, const Parameters& after) {
  const Stage stage = first_reader_of_change(before, after);
  const bool graph_stays = stage == Stage::tubes && before.tubes.smoothing == after.tubes.smoothing;
  return {stage, 0, graph_stays ? 1 : 0};
}

Parameters KnitMachine::resolved(const Parameters& parameters, const Input& input) {
  return knit::resolved(parameters, input);
}

Parameters KnitMachine::with_change(const Parameters& parameters, const Parameters& before,
                                    const Parameters& after) {
  return knit::with_change(parameters, before, after);
}

// Just after a step that sweeps the surface, or at a stage's beginning.
bool KnitMachine::worth_keeping(const State& state) {
  if (const auto* tubes = std::get_if<TubesWork>(&state.work)) return tubes->shown == 0;
  if (const auto* timing = std::get_if<TimingWork>(&state.work))
    return (timing->net || timing->scale) && timing->times.empty();
  const bool first_row = state.next.row <= 1 || (state.next.row == 2 && state.next.stage != Stage::pattern);
  return state.next.item == 0 && first_row;
}

// About what a run takes: each vertex timed and measured, and as much again for what is made of them.
std::size_t KnitMachine::steps_expected(const Input& input) { return 3 * input.mesh.positions.size(); }

}  // namespace knit
