#include "app/actions/show_session.h"

#include <utility>

#include "app/actions/apply_parts.h"
#include "app/files/session_file.h"

namespace app {

namespace {

void show_the_view(Session& session, const SavedSession& saved) {
  session.camera = saved.camera;
  session.camera_kept = true;
  session.layers = saved.layers;
  session.side = saved.side;
  session.list = saved.list;
  session.centre = saved.centre;
  session.playback = {false, 1, saved.steps_per_second, 0.0};
  session.travel = {};
  session.travel.slow_motion = saved.slow_motion;
  session.travel.loop = saved.loop;
  session.travel.breaks = saved.breaks;
  session.pattern = saved.pattern;
  session.knit_along_round = saved.round;
  if (saved.knitting_along) session.knit_along = saved.round;
}

void go_to_place(Session& session, const SavedSession& saved) {
  if (!saved.at) return session.timeline->seek(0);
  apply(session, SeekPlace{*saved.at});
  session.travel.history = {};
  const knit::Timeline& timeline = *session.timeline;
  if (timeline.sought() || timeline.place() == *saved.at) return;
  session.notices.push_back(
      {Notice::Kind::warning,
       "The run no longer has the place where the session was; showing the nearest before it."});
}

}  // namespace

void show_session(Session& session, OpenedSession opened, std::chrono::steady_clock::time_point start) {
  const SavedSession& saved = opened.saved;
  show_loaded(session, std::move(opened.loaded), saved.source, start);
  session.timeline->set_knobs(saved.knobs.base, saved.knobs.edits, opened.input);
  session.pinned = std::move(opened.pinned);
  show_the_view(session, saved);
  go_to_place(session, saved);
  if (opened.changed) {
    session.notices.push_back({Notice::Kind::warning, session.timeline->input().mesh.name +
                                                          " is another mesh than when the session was saved; "
                                                          "rows and stitches may differ."});
  }
  note_saved(session, opened.path);
}

std::optional<std::string> open_session(Session& session, const std::filesystem::path& path) {
  const auto start = std::chrono::steady_clock::now();
  auto read = read_session(session.assets, path);
  if (auto* error = std::get_if<std::string>(&read)) return std::move(*error);
  show_session(session, std::get<OpenedSession>(std::move(read)), start);
  return std::nullopt;
}

}  // namespace app
