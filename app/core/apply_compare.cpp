#include "app/core/apply_parts.h"
#include "app/core/sweep_work.h"

namespace app {

namespace {

void complain(Session& session, std::string sentence) {
  session.notices.push_back({Notice::Kind::error, std::move(sentence)});
}

}  // namespace

void take(Session& session, const PinRun& /*action*/) {
  if (!session.timeline) return;
  if (!session.beside) session.timeline->extend_to_end();
  session.pinned = pin_of(session);
}

// The place stays as after tuning; what was at hand is the pinned one then.
void take(Session& session, const SwapPinned& /*action*/) {
  if (!session.timeline || !session.pinned) return;
  if (!is_of_this_mesh(session, *session.pinned)) {
    complain(session, "The pinned run is of another mesh, " + session.pinned->input->mesh.name +
                          "; open that one to swap with it.");
    return;
  }
  remember_knobs(session);
  knit::Timeline& timeline = *session.timeline;
  if (!session.beside) timeline.extend_to_end();
  Pin other = pin_of(session);
  if (!session.long_step) session.before_change = timeline.parameters();
  // Welded or not is of the mesh as it is run.
  if (session.pinned->input != timeline.input_pointer())
    timeline.change_input(session.pinned->input, timeline.parameters());
  timeline.set_knobs(session.pinned->knobs.base, session.pinned->knobs.edits);
  session.pinned = std::move(other);
}

void take(Session& session, const Unpin& /*action*/) { session.pinned.reset(); }

void take(Session& session, const StartSweep& action) {
  if (!session.timeline) return;
  if (auto fault = fault_of(action.plan)) return complain(session, std::move(*fault));
  session.sweep =
      Sweep{action.plan, std::make_shared<SweepWork>(sweep_base_of(*session.timeline), action.plan)};
  if (!session.beside) session.sweep->work->wait();
}

void take(Session& session, const CancelSweep& /*action*/) {
  if (session.sweep) session.sweep->work->cancel();
}

void take(Session& session, const TakeSweepValue& action) {
  if (!session.timeline || !session.sweep) return;
  const SweepRun* run = session.sweep->work->run(action.run);
  if (run == nullptr) return;
  apply(session, Tune{with_values(session.timeline->parameters(), session.sweep->plan, run->values)});
}

}  // namespace app
