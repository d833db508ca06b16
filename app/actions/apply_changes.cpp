#include <utility>

#include "app/actions/apply_parts.h"
#include "app/actions/opening.h"
#include "app/actions/parameters_text.h"
#include "app/compare/sweep_work.h"

namespace app {

namespace {

// Shows exactly these again. False, and nothing done, where the mesh must be made for it first or cannot be.
bool restore(Session& session, const Action& action, const Knobs& knobs) {
  knit::Timeline& timeline = *session.timeline;
  std::shared_ptr<const knit::Input> input;
  if (knobs.base.weld != timeline.base_parameters().weld) {
    const auto loaded = welded_for(session, action, knobs.base);
    if (!loaded) return false;
    if (const auto* error = std::get_if<std::string>(&*loaded)) {
      session.notices.push_back({Notice::Kind::error, *error});
      return false;
    }
    input = std::get<Loaded>(*loaded).input;
  }
  if (!session.long_step) session.before_change = timeline.parameters();
  timeline.set_knobs(knobs.base, knobs.edits, std::move(input));
  return true;
}

// The nearest entry of `from` becomes what is in force; what was goes to `to`. `action`: which asks for it.
void go(Session& session, const Action& action, std::vector<Knobs>& from, std::vector<Knobs>& to) {
  session.changes.open = false;
  if (!session.timeline || from.empty()) return;
  give_up_making(session);
  Knobs now = knobs_of(*session.timeline);
  if (!restore(session, action, from.back())) return;
  from.pop_back();
  to.push_back(std::move(now));
}

}  // namespace

void take(Session& session, const Settle& /*action*/) { session.changes.open = false; }

void take(Session& session, const Undo& action) {
  go(session, action, session.changes.undo, session.changes.redo);
}

void take(Session& session, const Redo& action) {
  go(session, action, session.changes.redo, session.changes.undo);
}

void take(Session& session, const CopyParameters& /*action*/) {
  if (!session.timeline) return;
  session.clipboard_wanted = "# knit-mesh: the parameters of " + session.timeline->input().mesh.name + "\n" +
                             parameters_text(session.timeline->parameters());
  tell(session, "Copied all parameters as text.");
}

void take(Session& session, const PasteParameters& action) {
  if (!session.timeline) return;
  auto read = read_parameters_text(action.text, session.timeline->parameters());
  if (auto* error = std::get_if<std::string>(&read)) {
    session.notices.push_back({Notice::Kind::error, "What was pasted: " + *error});
    return;
  }
  apply(session, Tune{std::get<knit::Parameters>(read)});
}

void remember_knobs(Session& session) {
  give_up_making(session);
  if (session.timeline) session.changes.before = knobs_of(*session.timeline);
}

void tell(Session& session, const std::string& words) {
  const bool said = !session.notices.empty() && session.notices.back().text == words;
  if (!said) session.notices.push_back({Notice::Kind::info, words});
}

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
