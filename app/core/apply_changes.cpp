#include <utility>

#include "app/core/apply_parts.h"
#include "app/core/load.h"
#include "app/core/parameters_text.h"

namespace app {

namespace {

// Shows exactly these again. A sentence, and nothing done, where the mesh cannot be had that way any more.
std::optional<std::string> restore(Session& session, const Knobs& knobs) {
  knit::Timeline& timeline = *session.timeline;
  std::shared_ptr<const knit::Input> input;
  if (knobs.base.weld != timeline.base_parameters().weld) {
    auto loaded = load_again(session.original, knobs.base);
    if (auto* error = std::get_if<std::string>(&loaded)) return std::move(*error);
    input = std::get<Loaded>(loaded).input;
  }
  if (!session.long_step) session.before_change = timeline.parameters();
  timeline.set_knobs(knobs.base, knobs.edits, std::move(input));
  return std::nullopt;
}

// The nearest entry of `from` becomes what is in force; what was goes to `to`.
void go(Session& session, std::vector<Knobs>& from, std::vector<Knobs>& to) {
  session.changes.open = false;
  if (!session.timeline || from.empty()) return;
  Knobs now = knobs_of(*session.timeline);
  if (auto error = restore(session, from.back())) {
    session.notices.push_back({Notice::Kind::error, std::move(*error)});
    return;
  }
  from.pop_back();
  to.push_back(std::move(now));
}

}  // namespace

void take(Session& session, const Settle& /*action*/) { session.changes.open = false; }

void take(Session& session, const Undo& /*action*/) {
  go(session, session.changes.undo, session.changes.redo);
}

void take(Session& session, const Redo& /*action*/) {
  go(session, session.changes.redo, session.changes.undo);
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
  if (session.timeline) session.changes.before = knobs_of(*session.timeline);
}

void tell(Session& session, const std::string& words) {
  const bool said = !session.notices.empty() && session.notices.back().text == words;
  if (!said) session.notices.push_back({Notice::Kind::info, words});
}

}  // namespace app
