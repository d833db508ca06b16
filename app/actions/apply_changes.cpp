#include <utility>

#include "app/actions/apply_parts.h"
#include "app/actions/background_work.h"
#include "app/actions/hosting.h"
#include "app/actions/opening.h"
#include "app/actions/parameters_text.h"
#include "app/compare/sweep_work.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/outbox.h"

namespace app {

namespace {

// Shows exactly these again. False, and nothing done, where the mesh must be made for it first or cannot be.
bool restore(Session& session, const Action& action, const Change& change) {
  knit::Timeline& timeline = session.document->timeline;
  const Knobs& knobs = change.knobs;
  const bool cut = change.curves != session.document->source.curves;
  if (!cut && made_alike(knobs.base, timeline.base_parameters(), change.curves)) {
    note_before_change(session);
    timeline.set_knobs(knobs.base, knobs.edits);
    return true;
  }
  const auto made = made_with(session, action, knobs.base, change.curves);
  if (!made) return false;
  if (const auto* error = std::get_if<std::string>(&*made)) {
    notify(session, Notice::Kind::error, *error);
    return false;
  }
  note_before_change(session);
  const auto& loaded = std::get<Loaded>(*made);
  if (cut)
    show_cut(session, loaded, knobs);
  else
    timeline.set_knobs(knobs.base, knobs.edits, loaded.input);
  return true;
}

// The nearest entry of `from` becomes what is in force; what was goes to `to`. `action`: which asks for it.
void go(Session& session, const Action& action, std::vector<Change>& from, std::vector<Change>& to) {
  session.document->changes.open = false;
  if (from.empty()) return;
  give_up_making(session);
  Change now = change_of(*session.document);
  const bool differs = from.back().knobs != now.knobs || from.back().curves != now.curves;
  if (differs && !restore(session, action, from.back())) return;
  session.document->pieces = from.back().pieces;
  from.pop_back();
  to.push_back(std::move(now));
}

}  // namespace

void take(Session& session, const Settle& /*action*/) {
  if (session.document) session.document->changes.open = false;
}

void take(Session& session, const Undo& action) {
  if (session.document) go(session, action, session.document->changes.undo, session.document->changes.redo);
}

void take(Session& session, const Redo& action) {
  if (session.document) go(session, action, session.document->changes.redo, session.document->changes.undo);
}

void take(Session& session, const CopyParameters& /*action*/) {
  if (!session.document) return;
  session.outbox->clipboard = "# knit-mesh: the parameters of " +
                              session.document->timeline.input().mesh.name + "\n" +
                              parameters_text(session.document->timeline.parameters());
  tell(session, "Copied all parameters as text.");
}

void take(Session& session, const PasteParameters& action) {
  if (!session.document) return;
  auto read = read_parameters_text(action.text, session.document->timeline.parameters());
  if (auto* error = std::get_if<std::string>(&read)) {
    notify(session, Notice::Kind::error, "What was pasted: " + *error);
    return;
  }
  apply(session, Tune{std::get<knit::Parameters>(read)});
}

void remember_knobs(Session& session) {
  give_up_making(session);
  if (session.document) session.document->changes.before = knobs_of(session.document->timeline);
}

void tell(Session& session, const std::string& words) {
  const bool said = !session.outbox->notices.empty() && session.outbox->notices.back().text == words;
  if (!said) notify(session, Notice::Kind::info, words);
}

void take(Session& session, const PinRun& /*action*/) {
  if (!session.document) return;
  if (!session.jobs->beside) session.document->timeline.extend_to_end();
  if (session.document->pinned && !is_of_this_mesh(session, *session.document->pinned))
    tell(session,
         "This run is pinned now, instead of the one of " + session.document->pinned->input->mesh.name + ".");
  session.document->pinned = pin_of(session);
}

// The place stays as after tuning; what was current is the pinned one then.
void take(Session& session, const SwapPinned& /*action*/) {
  if (!session.document || !session.document->pinned) return;
  if (!is_of_this_mesh(session, *session.document->pinned)) {
    notify(session, Notice::Kind::error,
           "The pinned run is of another mesh, " + session.document->pinned->input->mesh.name +
               "; open that one to swap with it.");
    return;
  }
  remember_knobs(session);
  knit::Timeline& timeline = session.document->timeline;
  if (!session.jobs->beside) timeline.extend_to_end();
  Pin other = pin_of(session);
  note_before_change(session);
  // Welded or not is of the mesh as it is run.
  if (session.document->pinned->input != timeline.input_pointer())
    timeline.change_input(session.document->pinned->input, timeline.parameters());
  timeline.set_knobs(session.document->pinned->knobs.base, session.document->pinned->knobs.edits);
  session.document->pinned = std::move(other);
}

void take(Session& session, const Unpin& /*action*/) {
  if (!session.document || !session.document->pinned) return;
  session.document->pinned.reset();
  tell(session, "The pinned run is let go. Pin again (P) to compare with the run that is shown.");
}

void take(Session& session, const ShowBoth& action) {
  const bool pinned = session.document && session.document->pinned;
  session.view->both = action.on && pinned;
  if (action.on && session.document && !pinned)
    tell(session, "No run is pinned yet: pin this one (P), change a value, and see both side by side.");
}

void take(Session& session, const StartSweep& action) {
  if (!session.document) return;
  if (auto fault = fault_of(action.plan)) return notify(session, Notice::Kind::error, std::move(*fault));
  session.document->sweep =
      Sweep{action.plan, std::make_shared<SweepWork>(sweep_base_of(session.document->timeline), action.plan)};
  if (!session.jobs->beside) session.document->sweep->work->wait();
}

void take(Session& session, const CancelSweep& /*action*/) {
  if (session.document && session.document->sweep) session.document->sweep->work->cancel();
}

void take(Session& session, const TakeSweepValue& action) {
  if (!session.document || !session.document->sweep) return;
  const SweepRun* run = session.document->sweep->work->run(action.run);
  if (run == nullptr) return;
  apply(session, Tune{with_values(session.document->timeline.parameters(), session.document->sweep->plan,
                                  run->values)});
}

}  // namespace app
