#include "app/session/session.h"

#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/learning.h"
#include "app/session/outbox.h"
#include "app/session/program.h"
#include "app/session/view.h"
#include "knit/base/bits.h"
#include "knit/insight/narrate.h"
#include "knit/model/hash.h"
#include "knit/model/words.h"

namespace app {

Session::Session() : program(Program{}), view(View{}), learning(Learning{}), outbox(Outbox{}), jobs(Jobs{}) {}
Session::Session(const Session& other) = default;
Session::Session(Session&& other) noexcept = default;
Session& Session::operator=(const Session& other) = default;
Session& Session::operator=(Session&& other) noexcept = default;
Session::~Session() = default;

const knit::Step* last_step(const Session& session) {
  if (!session.document || session.document->timeline.position() == 0) return nullptr;
  return &session.document->timeline.step(session.document->timeline.position() - 1);
}

const knit::Parameters& parameters_of_last_step(const Session& session) {
  const knit::Timeline& timeline = session.document->timeline;
  return timeline.position() == 0 ? timeline.parameters()
                                  : timeline.parameters_of_step(timeline.position() - 1);
}

const knit::Step* stop_shown(const Session& session) {
  if (!session.document) return nullptr;
  const knit::Timeline& timeline = session.document->timeline;
  return timeline.complete() && timeline.position() == timeline.known() ? timeline.stop() : nullptr;
}

std::string sentence(const Session& session) {
  if (!session.document) return "No mesh is open. Choose an example, or open a mesh.";
  if (const knit::Step* stop = stop_shown(session))
    return knit::narrate(*stop, session.document->timeline.parameters());
  const knit::Step* step = last_step(session);
  // What to do a lesson says.
  if (step == nullptr && session.learning->lesson) return "Nothing has been done yet.";
  const knit::Timeline& timeline = session.document->timeline;
  if (step == nullptr && timeline.complete() && timeline.stop() != nullptr)
    return "Nothing has been done yet, and this run stops after step " + std::to_string(timeline.known()) +
           ": press End to see where and why, or Space to play.";
  if (step == nullptr)
    return "Nothing has been done yet: press Space to play, or the right arrow for one step.";
  return knit::narrate(*step, parameters_of_last_step(session));
}

Change change_of(const Document& document) {
  return {knobs_of(document.timeline), document.pieces, document.source.curves};
}

std::uint64_t closeness_key(const knit::State& state, const knit::Parameters& parameters) {
  knit::Hasher hasher;
  hasher.add(knit::hash_of(state));
  hasher.add(knit::bits_as<std::uint64_t>(parameters.stitch.width));
  hasher.add(knit::bits_as<std::uint64_t>(parameters.stitch.height));
  return hasher.value();
}

std::shared_ptr<const knit::Closeness> closeness_now(const Document& document) {
  const knit::Timeline& timeline = document.timeline;
  if (document.closeness && document.closeness_run == closeness_key(timeline.state(), timeline.parameters()))
    return document.closeness;
  const knit::StitchSize& stitch = timeline.parameters().stitch;
  const auto measured =
      knit::measure_closeness(timeline.input(), timeline.state(), stitch.width, stitch.height);
  return measured ? std::make_shared<const knit::Closeness>(*measured) : nullptr;
}

}  // namespace app
