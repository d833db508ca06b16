#include "app/actions/background_work.h"

#include "app/actions/playing.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "knit/model/stitch_size.h"

namespace app {

namespace {

void tend_long_step(Session& session, double seconds) {
  knit::Timeline& timeline = session.document->timeline;
  if (session.jobs->run.long_step) {
    LongStep& step = *session.jobs->run.long_step;
    step.seconds += seconds;
    // The parameters may have changed meanwhile; then it is another step that is due.
    const bool stale = !timeline.next_is_long() || step.job.state != timeline.furthest() ||
                       step.job.parameters != timeline.next_job().parameters;
    if (stale) {
      session.jobs->run.long_step.reset();
    } else if (step.work.ready()) {
      timeline.accept(step.job, step.work.take());
      session.document->run_ms += 1000.0 * step.seconds;
      session.jobs->run.long_step.reset();
    }
  }
  if (session.jobs->run.long_step || !timeline.next_is_long()) return;
  LongStep step{timeline.next_job(), {}, 0.0};
  step.work = Work<knit::Timeline::Outcome>(
      [job = step.job](const knit::Heard& heard) { return knit::Timeline::work(job, heard); });
  session.jobs->run.long_step.emplace(std::move(step));
}

// One at a time: what is wished while it is under way begins when it is there.
void tend_awaited_run(Session& session, double seconds) {
  knit::Timeline& timeline = session.document->timeline;
  std::optional<AwaitedRun>& awaited = session.jobs->run.awaited;
  if (!timeline.is_waiting()) awaited.reset();
  if (awaited) {
    awaited->seconds += seconds;
    if (!awaited->work.ready()) return;
    if (timeline.take_over(awaited->work.take())) session.document->run_ms += 1000.0 * awaited->seconds;
    awaited.reset();
  }
  if (!timeline.is_waiting()) return;
  awaited.emplace();
  // Where stitches settle it is shown as they are placed, and settles step by step.
  awaited->work = Work<knit::Timeline>([run = timeline.awaited_run()](const knit::Heard& heard) mutable {
    run.extend_to({knit::Stage::settle, 0, 0}, heard);
    if (run.furthest().stage() != knit::Stage::settle) run.extend_to_end();
    run.seek(run.known());
    return std::move(run);
  });
}

void tend_measuring(Session& session) {
  const knit::Timeline& timeline = session.document->timeline;
  const bool finished = timeline.complete() && timeline.furthest().finished();
  const std::uint64_t run = finished ? closeness_key(timeline.furthest(), timeline.parameters_of_stop()) : 0;
  if (session.document->closeness_run != run) {
    session.document->closeness.reset();
    session.document->closeness_run = 0;
  }
  if (session.jobs->run.measuring && session.jobs->run.measuring->run != run)
    session.jobs->run.measuring.reset();
  if (session.jobs->run.measuring && session.jobs->run.measuring->work.ready()) {
    if (const auto measured = session.jobs->run.measuring->work.take())
      session.document->closeness = std::make_shared<const knit::Closeness>(*measured);
    session.document->closeness_run = run;
    session.jobs->run.measuring.reset();
  }
  if (finished && !session.document->closeness && !session.jobs->run.measuring &&
      session.document->closeness_run != run) {
    session.jobs->run.measuring = Measuring{
        run,
        Work<std::optional<knit::Closeness>>([input = timeline.input_pointer(), state = timeline.furthest(),
                                              stitch = timeline.parameters_of_stop().stitch] {
          return knit::measure_closeness(*input, state, stitch.width, stitch.height);
        })};
  }
}

// Takes the end from the current run or from a worker, as soon as either has it.
void tend_pin(Session& session) {
  if (!pin_is_pending(session)) return;
  Pin& pin = *session.document->pinned;
  if (is_at_hand(session, pin)) {
    // It is being worked out anyway.
    if (session.document->timeline.complete())
      take_end(pin, end_of(tally_of(session.document->timeline), pin.knobs));
    return;
  }
  if (!pin.work) {
    pin.work.emplace(
        [input = pin.input, knobs = pin.knobs] { return end_of(whole_run(*input, knobs), knobs); });
  } else if (pin.work->ready()) {
    take_end(pin, pin.work->take());
  }
}

}  // namespace

void tune_run(Session& session, const knit::Parameters& parameters) {
  knit::Timeline& timeline = session.document->timeline;
  if (session.jobs->beside && timeline.whole() &&
      knit::change_takes_a_moment(timeline.input(), timeline.base_parameters(),
                                  knit::resolved(parameters, timeline.input()), timeline.furthest()))
    return timeline.tune_beside(parameters);
  timeline.tune(parameters);
}

void note_before_change(Session& session) {
  const knit::Timeline& timeline = session.document->timeline;
  if (session.jobs->run.long_step || timeline.is_waiting()) return;
  session.document->before_change = timeline.parameters();
}

void finish_pin(Session& session) {
  if (!pin_is_pending(session)) return;
  Pin& pin = *session.document->pinned;
  take_end(pin, end_of(whole_run(*pin.input, pin.knobs), pin.knobs));
}

void work_beside(Session& session, double seconds) {
  if (!session.jobs->beside || !session.document) return;
  tend_awaited_run(session, seconds);
  tend_long_step(session, seconds);
  tend_measuring(session);
  tend_pin(session);
}

std::size_t steps_of_slice(const knit::Timeline& timeline) {
  // The shortest way over the surface, for each candidate measured: a good tenth of a millisecond.
  constexpr std::size_t dear_steps = 64;
  const knit::Parameters parameters = as_chosen(timeline.parameters_of_stop(), timeline.furthest());
  const bool dear = parameters.rows.source == knit::RowSource::rings &&
                    parameters.rows.metric == knit::Metric::geodesic &&
                    timeline.furthest().stage() <= knit::Stage::rows;
  if (dear) return dear_steps;
  // On a very large mesh the keyframes on the way are dear: the times of its vertices so far, in blocks.
  constexpr std::size_t many_vertices = 500000;
  const std::size_t vertices = timeline.input().mesh.positions.size();
  return vertices > many_vertices ? steps_per_tick * many_vertices / vertices : steps_per_tick;
}

}  // namespace app
