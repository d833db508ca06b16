#include "app/actions/show_session.h"

#include <utility>

#include "app/actions/apply_parts.h"
#include "app/actions/hosting.h"
#include "app/files/session_file.h"
#include "app/session/document.h"
#include "app/session/outbox.h"
#include "app/session/program.h"
#include "app/session/view.h"

namespace app {

namespace {

void show_the_view(Session& session, const SavedSession& saved) {
  View& view = *session.view;
  view.gaze.camera = saved.camera;
  view.gaze.camera_kept = true;
  view.gaze.knit_along_round = saved.round;
  view.gaze.knit_along_deal = saved.deal;
  if (saved.knitting_along) view.gaze.knit_along = saved.round;
  view.layers = saved.layers;
  view.side = saved.side;
  view.list = saved.list;
  view.centre = saved.centre;
  view.gaze.chart_piece = saved.chart_piece;
  view.positions = saved.positions;
  view.yarn = saved.yarn;
  view.playback = {false, 1, saved.steps_per_second, 0.0};
  view.slow_motion = saved.slow_motion;
  view.breaks = saved.breaks;
  view.pattern = saved.pattern;
  session.document->travel.loop = saved.loop;
  session.document->pieces = saved.pieces;
}

void go_to_place(Session& session, const SavedSession& saved) {
  if (!saved.at) return session.document->timeline.seek(0);
  apply(session, SeekPlace{*saved.at});
  session.document->travel.history = {};
  const knit::Timeline& timeline = session.document->timeline;
  if (timeline.sought() || timeline.place() == *saved.at) return;
  notify(session, Notice::Kind::warning,
         "The run no longer has the place where the session was; showing the nearest before it.");
}

}  // namespace

void show_session(Session& session, OpenedSession opened, std::chrono::steady_clock::time_point start) {
  const SavedSession& saved = opened.saved;
  show_loaded(session, std::move(opened.loaded), saved.source, start);
  session.document->timeline.set_knobs(saved.knobs.base, saved.knobs.edits, opened.input);
  session.document->pinned = std::move(opened.pinned);
  show_the_view(session, saved);
  go_to_place(session, saved);
  if (opened.changed) {
    notify(session, Notice::Kind::warning,
           session.document->timeline.input().mesh.name +
               " is another mesh than when the session was saved; "
               "rows and stitches may differ.");
  }
  session.document->saved = saved_as(session, opened.path);
}

}  // namespace app
