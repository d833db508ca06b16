#include "app/actions/pinned_session.h"

#include <utility>

#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/pins.h"
#include "app/session/program.h"
#include "app/session/view.h"

namespace app {

// What both runs have in common need not be worked out twice.
void PinnedSession::begin(const Session& session) {
  const Pin& pin = *session.document->pinned;
  input_ = pin.input;
  knobs_ = pin.knobs;
  knit::Timeline run =
      is_of_this_mesh(session, pin) ? session.document->timeline : knit::Timeline(pin.input, pin.knobs.base);
  run.set_knobs(pin.knobs.base, pin.knobs.edits, pin.input);
  work_.drop();
  if (!session.jobs->beside) {
    run.extend_to_end();
  } else if (!run.complete()) {
    work_ = Work<knit::Timeline>([run](const knit::Heard& heard) mutable {
      run.extend_to({knit::Stage::done, 0, 0}, heard);
      run.extend_to_end();
      return std::move(run);
    });
  }
  pinned_ = std::make_unique<Session>();
  pinned_->document = Document(std::move(run));
}

void PinnedSession::follow(const Session& session) {
  const knit::Timeline& here = session.document->timeline;
  knit::Timeline& there = pinned_->document->timeline;
  if (here.position() == 0 && !here.sought()) return there.seek(0);
  if (here.complete() && here.position() == here.known()) return there.seek(there.known());
  there.await(here.sought().value_or(here.place()));
}

const Session* PinnedSession::refresh(const Session& session) {
  if (!shows_both(session)) {
    work_.drop();
    pinned_.reset();
    return nullptr;
  }
  const Pin& pin = *session.document->pinned;
  if (!pinned_ || pin.input != input_ || pin.knobs != knobs_) begin(session);
  if (work_.ready()) pinned_->document = Document(work_.take());
  pinned_->program = session.program;
  pinned_->view = session.view;
  pinned_->view->gaze.hovered_stitch.reset();
  follow(session);
  return pinned_.get();
}

}  // namespace app
