// Wishes for pictures and animations; whoever draws (app/window) makes them.
#include <algorithm>
#include <utility>

#include "app/actions/apply_parts.h"
#include "app/files/figures.h"

namespace app {

namespace {

void blame(Session& session, std::string sentence) {
  session.notices.push_back({Notice::Kind::error, std::move(sentence)});
}

}  // namespace

void take(Session& session, const SavePicture& action) {
  if (!session.timeline) return;
  if (auto fault = fault_of(action)) return blame(session, std::move(*fault));
  session.figures_wanted.push_back(
      {action.path, action.width, action.height, action.panels, action.transparent});
}

void take(Session& session, const SaveAnimation& action) {
  if (!session.timeline) return;
  if (session.animation) {
    return blame(session,
                 "an animation is being made already; wait until it is done, or cancel it, then save this.");
  }
  SaveAnimation wish = action;
  wish.stretch.end = std::min(wish.stretch.end, session.timeline->known());
  if (auto fault = fault_of(wish)) return blame(session, std::move(*fault));
  AnimationRun run{wish, frames_in(wish.stretch, wish.frames), 0,
                   std::make_shared<const Session>(figure_session(session))};
  session.animation = std::make_shared<const AnimationRun>(std::move(run));
}

void take(Session& session, const CancelAnimation& /*action*/) { session.animation.reset(); }

}  // namespace app
