// What pages of lessons do as they open.
#include <numbers>
#include <utility>

#include "app/actions/apply_parts.h"
#include "app/actions/navigate.h"
#include "app/lessons/lesson.h"
#include "app/session/document.h"
#include "app/session/outbox.h"
#include "app/session/view.h"
#include "knit/model/settings_table.h"

namespace app {

namespace {

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

// What is written and shown of the program itself stays.
void look_as_at_first(View& view) {
  View first;
  first.aspect = view.aspect;
  first.following = view.following;
  first.presenting = view.presenting;
  first.ring = view.ring;
  first.pattern = std::move(view.pattern);
  first.dialogs = std::move(view.dialogs);
  first.checker = std::move(view.checker);
  view = std::move(first);
}

struct DoDeed {
  Session& session;

  // What is open already keeps its run where its parameters are its own; everything else is as at the start.
  void operator()(const OpenAsItComes& deed) const {
    const Document* open = session.document ? &*session.document : nullptr;
    if (open == nullptr || open->source.example != deed.example ||
        open->timeline.base_parameters().mesh.weld != open->defaults.mesh.weld)
      apply(session, OpenExample{deed.example});
    // What could not be opened has said so.
    if (!session.document || session.document->source.example != deed.example) return;
    Document& document = *session.document;
    const Knobs wanted{document.defaults, {}};
    if (knobs_of(document.timeline) != wanted) document.timeline.set_knobs(wanted.base, wanted.edits);
    document.before_change.reset();
    document.travel = {};
    document.place_note.clear();
    session.outbox->notices.clear();
    look_as_at_first(*session.view);
    apply(session, Unpin{});
    apply(session, SetPredicting{false});
    (*this)(LookFrom{});
  }
  void operator()(const SetParameters& deed) const {
    if (!session.document) return;
    knit::Parameters parameters = session.document->timeline.parameters();
    knit::set_values(deed.settings, parameters);
    apply(session, Tune{parameters});
  }
  void operator()(const SeekAt& deed) const {
    if (session.document) go_to(session, deed.at);
  }
  void operator()(const LookFrom& deed) const {
    if (!session.document) return;
    const knit::Input& input = session.document->timeline.input();
    Camera camera;
    camera.yaw = radians(deed.yaw);
    camera.pitch = radians(deed.pitch);
    camera.frame(input.bounds, session.view->aspect);
    camera.distance /= deed.near;
    if (deed.at && *deed.at < input.mesh.positions.size()) camera.target = input.mesh.positions[*deed.at];
    session.view->gaze.camera = camera;
    session.view->gaze.camera_kept = true;
  }
  void operator()(const Action& action) const { apply(session, action); }
};

}  // namespace

void do_deed(Session& session, const Deed& deed) { std::visit(DoDeed{session}, deed); }

}  // namespace app
