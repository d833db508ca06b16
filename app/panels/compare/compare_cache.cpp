#include "app/panels/compare/compare_cache.h"

#include "app/session/document.h"

namespace app {

void CompareCache::refresh(const Session& session, const knit::ProblemCounts& problems) {
  if (!session.document || !session.document->pinned || !session.document->pinned->known) {
    difference_.reset();
    return;
  }
  const knit::Timeline& timeline = session.document->timeline;
  if (!timeline.complete()) return;
  const Pin& pin = *session.document->pinned;
  Key key{
      timeline.input_pointer(), pin.input, knobs_of(timeline), pin.knobs, knit::hash_of(timeline.furthest()),
      knit::hash_of(pin.end)};
  if (difference_ && key == key_) return;
  key_ = std::move(key);
  RunTally run;
  run.state = timeline.furthest();
  run.steps = timeline.known();
  run.problems = problems;
  if (timeline.stop() != nullptr) run.stop = *timeline.stop();
  const RunFigures figures = figures_of(run, key_.knobs);
  difference_ = difference_of({*pin.input, pin.knobs, pin.end, pin.figures},
                              {timeline.input(), key_.knobs, run.state, figures});
  const auto width = [](const Knobs& knobs, const knit::State& state) {
    return parameters_at(knobs, state.next).stitch.width;
  };
  pinned_rows_ = row_figures_of(pin.end, width(pin.knobs, pin.end));
  rows_ = row_figures_of(run.state, width(key_.knobs, run.state));
  ++times_compared_;
}

}  // namespace app
