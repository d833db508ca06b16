// Wishes for pictures and animations; whoever draws (app/window) makes them.
#include <algorithm>
#include <utility>

#include "app/actions/apply_parts.h"
#include "app/actions/hosting.h"
#include "app/actions/picture_session.h"
#include "app/files/figures.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/outbox.h"
#include "app/session/view.h"

namespace app {

void take(Session& session, const SavePicture& action) {
  if (!session.document && !session.view->checking) return;
  if (auto fault = fault_of(action)) return notify(session, Notice::Kind::error, std::move(*fault));
  session.outbox->pictures.push_back(
      {action.path, action.width, action.height, action.panels, action.transparent});
}

void take(Session& session, const SaveAnimation& action) {
  if (!session.document) return;
  if (session.jobs->animation) {
    return notify(session, Notice::Kind::error,
                  "an animation is being made already; wait until it is done, or cancel it, then save this.");
  }
  SaveAnimation wish = action;
  wish.stretch.end = std::min(wish.stretch.end, session.document->timeline.known());
  if (auto fault = fault_of(wish)) return notify(session, Notice::Kind::error, std::move(*fault));
  AnimationRun run{wish, frames_in(wish.stretch, wish.frames), 0,
                   std::make_shared<const Session>(figure_session(session))};
  session.jobs->animation = std::make_shared<const AnimationRun>(std::move(run));
}

void take(Session& session, const CancelAnimation& /*action*/) { session.jobs->animation.reset(); }

}  // namespace app
