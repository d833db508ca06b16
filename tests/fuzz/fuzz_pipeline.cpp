// The whole pipeline on a small mesh with any parameters: to its end or to a stop that says why, and back and forth.
#include <algorithm>

#include "knit/import/check.h"
#include "knit/insight/narrate.h"
#include "knit/insight/step_fields.h"
#include "knit/model/settings_table.h"
#include "knit/model/stitch_size.h"
#include "knit/run/timeline.h"
#include "tests/fuzz/small_run.h"
#include "tests/support/promises.h"

namespace {

constexpr std::size_t most_steps = 3000;  // a run that takes more is left there: it would only be slow

void promise_words(const knit::Step& step, const knit::Parameters& parameters) {
  fuzz::promise_sentence(knit::narrate(step, parameters));
  fuzz::promise(!knit::fields_of(step).empty(), "a step has numbers");
}

void promise_run(const knit::Timeline& timeline) {
  const std::string broken = test_support::broken_promise(timeline.furthest());
  fuzz::promise(broken.empty(), broken);
  const bool over = !timeline.complete() || timeline.stop() != nullptr || timeline.furthest().finished();
  fuzz::promise(over, "a run ends or says why");
  if (timeline.stop() != nullptr) promise_words(*timeline.stop(), timeline.parameters_of_stop());
  for (std::size_t i = 0; i < timeline.known(); i += 1 + i / 8) {
    promise_words(timeline.step(i), timeline.parameters_of_step(i));
    fuzz::promise(i == 0 || timeline.step(i - 1).place < timeline.step(i).place, "places rise");
  }
}

// Replaying from a keyframe gives the state that stepping gave; the timeline compares every step itself.
void promise_scrubbing(knit::Timeline& timeline, fuzz::Bytes& bytes) {
  const std::size_t half = timeline.known() * bytes.byte() / 256;
  timeline.seek(half);
  const std::uint64_t there = hash_of(timeline.state());
  while (timeline.position() < timeline.known() && timeline.forward()) continue;
  fuzz::promise(hash_of(timeline.state()) == hash_of(timeline.furthest()), "stepping leads to the end");
  timeline.back();
  timeline.seek(half);
  fuzz::promise(hash_of(timeline.state()) == there, "seeking leads to the same state");
}

// A tuned run is a fresh one; an edited run ends too.
void promise_changes(knit::Timeline& timeline, fuzz::Bytes& bytes) {
  const knit::Input& input = timeline.input();
  const knit::Parameters changed =
      fuzz::parameters_of(bytes, input.bounds.diagonal(),
                          static_cast<unsigned>(std::min<std::size_t>(input.mesh.positions.size(), 255)));
  if (knit::fault_of(changed, input)) return;
  if (bytes.below(2) == 0) {
    timeline.edit_from_here(changed);
    timeline.extend(most_steps);
    promise_run(timeline);
    return;
  }
  timeline.tune(changed);
  timeline.extend(most_steps);
  promise_run(timeline);
  knit::Timeline fresh(timeline.input_pointer(), changed);
  fresh.extend(std::max(timeline.known(), std::size_t{1}));
  fuzz::promise(fresh.known() >= timeline.known() &&
                    std::equal(timeline.steps().begin(), timeline.steps().end(), fresh.steps().begin()),
                "a tuned run is a fresh one");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  const unsigned then = bytes.byte();
  knit::Mesh mesh = fuzz::mesh_of(bytes);
  if (!knit::check(mesh).fit()) return 0;
  const auto input = knit::make_input(std::move(mesh));
  const auto vertices = static_cast<unsigned>(std::min<std::size_t>(input->mesh.positions.size(), 255));
  const knit::Parameters parameters = fuzz::parameters_of(bytes, input->bounds.diagonal(), vertices);
  if (const auto fault = knit::fault_of(parameters, *input)) {
    fuzz::promise_sentence(*fault);
    return 0;
  }
  if (knit::fault_of(parameters, *input)) return 0;

  knit::Timeline timeline(input, parameters, then % 4 == 0 ? 4000 : knit::Timeline::default_budget_bytes);
  timeline.extend(most_steps);
  promise_run(timeline);
  promise_scrubbing(timeline, bytes);
  if (then % 3 == 0) promise_changes(timeline, bytes);
  return 0;
}
