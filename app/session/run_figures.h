// A run worked out without recording it, and its figures: what two runs are compared by, and what a sweep plots.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "app/session/changes.h"
#include "knit/insight/problem_counts.h"
#include "knit/quality/measures.h"

namespace app {

// How far a run has come and what was met on the way: the same numbers whether its steps are recorded or not.
struct RunTally {
  knit::State state;
  std::size_t steps = 0;         // taken; a stop is none
  knit::ProblemCounts problems;  // a stop is one
  std::optional<knit::Step> stop;
  [[nodiscard]] bool ended() const { return stop.has_value() || state.finished(); }
};

// In force for the step at a place.
const knit::Parameters& parameters_at(const Knobs& knobs, const knit::Place& place);

// Takes up to `most` steps more, but none of the stage `before` or a later one. True while such are to come.
bool go_on(RunTally& run, const knit::Input& input, const Knobs& knobs, std::size_t most,
           knit::Stage before = knit::Stage::done);
RunTally whole_run(const knit::Input& input, const Knobs& knobs);
// The same of a recorded run, as far as it has been worked out.
RunTally tally_of(const knit::Timeline& timeline);

// Of a run that has finished or stopped.
struct RunFigures {
  std::size_t steps = 0, rows = 0, stitches = 0;
  knit::ProblemCounts problems;
  std::int32_t increases = 0, decreases = 0, most_in_a_row = 0;
  knit::LengthFigures course, wale;  // mesh units; wale has the count 0 while there are no faces
  bool finished = false;
  std::string stop;  // why it stopped, in one sentence; else empty
};
RunFigures figures_of(const RunTally& run, const Knobs& knobs);

// Row by row, the first row first.
struct RowFigures {
  std::vector<double> stitches;
  std::vector<double> course;  // the mean length along the row, in stitch widths
};
RowFigures row_figures_of(const knit::State& state, double stitch_width);

}  // namespace app
