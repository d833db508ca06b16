#include "app/session/run_figures.h"

#include <glm/geometric.hpp>

#include "knit/insight/narrate.h"
#include "knit/run/machine.h"

namespace app {

const knit::Parameters& parameters_at(const Knobs& knobs, const knit::Place& place) {
  const knit::Parameters* in_force = &knobs.base;
  for (const knit::Edit& edit : knobs.edits) {
    if (edit.at <= place) in_force = &edit.parameters;
  }
  return *in_force;
}

bool go_on(RunTally& run, const knit::Input& input, const Knobs& knobs, std::size_t most,
           knit::Stage before) {
  while (!run.ended() && run.state.stage() < before) {
    if (most-- == 0) return true;
    const knit::Parameters& parameters = parameters_at(knobs, run.state.next);
    const knit::Step step = knit::advance(input, parameters, run.state);
    run.problems.take(step, parameters);
    if (knit::is_stop(step)) {
      run.stop = step;
    } else {
      ++run.steps;
    }
  }
  return false;
}

RunTally whole_run(const knit::Input& input, const Knobs& knobs) {
  RunTally run;
  go_on(run, input, knobs, std::numeric_limits<std::size_t>::max());
  return run;
}

RunTally tally_of(const knit::Timeline& timeline) {
  RunTally run;
  run.state = timeline.furthest();
  run.steps = timeline.known();
  for (std::size_t i = 0; i < timeline.known(); ++i)
    run.problems.take(timeline.step(i), timeline.parameters_of_step(i));
  if (const knit::Step* stop = timeline.stop()) {
    run.stop = *stop;
    run.problems.take(*stop, timeline.parameters_of_stop());
  }
  return run;
}

RunFigures figures_of(const RunTally& run, const Knobs& knobs) {
  RunFigures figures;
  figures.steps = run.steps;
  figures.rows = run.state.fabric.rows().size();
  figures.stitches = run.state.fabric.stitch_count();
  figures.problems = run.problems;
  const knit::ShapingFigures shaping = knit::shaping_figures(run.state);
  figures.increases = shaping.increases;
  figures.decreases = shaping.decreases;
  figures.most_in_a_row = shaping.max_in_a_row;
  figures.course = knit::course_figures(run.state);
  figures.wale = knit::wale_figures(run.state);
  figures.finished = run.state.finished();
  if (run.stop) figures.stop = knit::narrate(*run.stop, parameters_at(knobs, run.stop->place));
  return figures;
}

RowFigures row_figures_of(const knit::State& state, double stitch_width) {
  RowFigures figures;
  for (const auto& row : state.fabric.rows()) {
    const knit::Edges edges = knit::edges_of(*row);
    double length = 0.0;
    for (const auto& [from, to] : edges)
      length += glm::distance(row->stitches[from].position, row->stitches[to].position);
    figures.stitches.push_back(static_cast<double>(row->stitches.size()));
    figures.course.push_back(length / (static_cast<double>(edges.size()) * stitch_width));
  }
  return figures;
}

}  // namespace app
