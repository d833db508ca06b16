#include "app/actions/background_work.h"

#include "app/actions/playing.h"

namespace app {

namespace {

void tend_long_step(Session& session, double seconds) {
  knit::Timeline& timeline = *session.timeline;
  if (session.long_step) {
    LongStep& step = *session.long_step;
    step.seconds += seconds;
    // The parameters may have changed meanwhile; then it is another step that is due.
    const bool stale = !timeline.next_is_long() || step.job.state != timeline.furthest() ||
                       step.job.parameters != timeline.next_job().parameters;
    if (stale) {
      session.long_step.reset();
    } else if (step.work.ready()) {
      timeline.accept(step.job, step.work.take());
      session.run_ms += 1000.0 * step.seconds;
      session.long_step.reset();
    }
  }
  if (session.long_step || !timeline.next_is_long()) return;
  LongStep step{timeline.next_job(), {}, 0.0};
  step.work = Work<knit::Timeline::Outcome>([job = step.job] { return knit::Timeline::work(job); });
  session.long_step.emplace(std::move(step));
}

void tend_measuring(Session& session) {
  const knit::Timeline& timeline = *session.timeline;
  const bool finished = timeline.complete() && timeline.furthest().finished();
  const std::uint64_t run = finished ? knit::hash_of(timeline.furthest()) : 0;
  if (session.closeness_run != run) {
    session.closeness.reset();
    session.closeness_run = 0;
  }
  if (session.measuring_run && session.measuring_run->run != run) session.measuring_run.reset();
  if (session.measuring_run && session.measuring_run->work.ready()) {
    if (const auto measured = session.measuring_run->work.take())
      session.closeness = std::make_shared<const knit::Closeness>(*measured);
    session.closeness_run = run;
    session.measuring_run.reset();
  }
  if (finished && !session.closeness && !session.measuring_run && session.closeness_run != run) {
    session.measuring_run = Measuring{
        run,
        Work<std::optional<knit::Closeness>>([input = timeline.input_pointer(), state = timeline.furthest()] {
          return knit::measure_closeness(*input, state);
        })};
  }
  session.measuring = session.measuring_run.has_value();
}

}  // namespace

void work_beside(Session& session, double seconds) {
  if (!session.beside || !session.timeline) return;
  tend_long_step(session, seconds);
  tend_measuring(session);
  tend_pin(session);
}

std::size_t steps_of_slice(const knit::Timeline& timeline) {
  // The shortest way over the surface, for each candidate measured: a good tenth of a millisecond.
  constexpr std::size_t dear_steps = 64;
  const knit::Parameters& parameters = timeline.parameters_of_stop();
  const bool dear = parameters.rows == knit::RowSource::rings &&
                    parameters.metric == knit::Metric::geodesic &&
                    timeline.furthest().stage() <= knit::Stage::rows;
  if (dear) return dear_steps;
  // On a very large mesh the keyframes on the way are dear: the times of its vertices so far, in blocks.
  constexpr std::size_t many_vertices = 500000;
  const std::size_t vertices = timeline.input().mesh.positions.size();
  return vertices > many_vertices ? steps_per_tick * many_vertices / vertices : steps_per_tick;
}

}  // namespace app
