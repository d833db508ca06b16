#include <utility>

#include "app/core/apply_parts.h"
#include "app/core/opening.h"
#include "app/core/parameters_text.h"

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

}  // namespace app
