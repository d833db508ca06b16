#include "app/window/turn.h"

#include <algorithm>
#include <optional>

#include "app/actions/hosting.h"
#include "app/checker/checker.h"
#include "app/compare/sweep_work.h"
#include "app/files/export.h"
#include "app/files/pattern_export.h"
#include "app/files/session_file.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/outbox.h"
#include "app/session/view.h"
#include "app/window/animation.h"
#include "app/window/worksheet.h"
#include "knit/import/quoting.h"

namespace app {

namespace {

constexpr double slow_frame_seconds = 0.04;

// Threads of their own are at it: a sweep, the pinned run's end. Requires something open.
bool working_beside(const Session& session) {
  const auto& sweep = session.document->sweep;
  return pin_is_pending(session) || (sweep && sweep->work->running());
}

bool working(const Session& session) {
  if (session.jobs->opening || session.jobs->pattern_check) return true;
  return session.document && (session.jobs->animation || session.jobs->flight || working_beside(session) ||
                              session.view->playback.playing || !session.document->timeline.complete() ||
                              session.jobs->run.measuring);
}

// Only a worker is at it: looking now and then is enough.
bool only_waiting(const Session& session) {
  if (!session.document) return session.jobs->opening || session.jobs->pattern_check;
  return !session.view->playback.playing && !session.jobs->animation && !session.jobs->flight &&
         (session.jobs->run.long_step.has_value() ||
          (session.document->timeline.complete() &&
           (session.jobs->opening || session.jobs->pattern_check || session.jobs->run.measuring ||
            working_beside(session))));
}

std::optional<std::string> save_page(const Session& session, const std::filesystem::path& path,
                                     FrameDrawer& drawer) {
  if (auto missing = pattern_missing(session)) return missing;
  return export_to_file(session, {"pattern", path}, png_bytes(drawer.finished(session, page_picture_px)));
}

void save_what_is_wanted(Session& session, FrameDrawer& drawer) {
  const Outbox wanted = take_outgoing(session);
  for (const std::filesystem::path& path : wanted.screenshots)
    notify_saved(session, path, save_png(path.string(), drawer.target().read()));
  for (const std::filesystem::path& path : wanted.pages)
    notify_saved(session, path, save_page(session, path, drawer));
  for (const std::filesystem::path& path : wanted.worksheets)
    notify_saved(session, path, save_worksheet(session, path, drawer));
  save_figures(session, wanted.pictures);
}

// Once each time that it changes.
void tell_shader_problem(Session& session, const FrameDrawer& drawer, Pace& pace) {
  if (drawer.shader_problem() == pace.shader_problem) return;
  pace.shader_problem = drawer.shader_problem();
  if (!pace.shader_problem.empty()) notify(session, Notice::Kind::warning, pace.shader_problem);
}

std::string title_of(const Session& session) {
  if (session.view->checking && session.view->checker && !session.view->checker->path.empty())
    return knit::printable(session.view->checker->path.filename().string()) + " - knit-mesh";
  if (!session.document) return "knit-mesh";
  const Source& source = session.document->source;
  const std::string name = source.file.empty() ? source.example : source.file.filename().string();
  return name.empty() ? "knit-mesh" : knit::printable(name) + " - knit-mesh";
}

}  // namespace

void Pace::look_at(bool panels_wait) {
  if (panels_waited && !panels_wait) frames_due = frames_after_event;
  panels_waited = panels_wait;
}

double Pace::tick() {
  const auto now = std::chrono::steady_clock::now();
  const double seconds = std::chrono::duration<double>(now - last).count();
  last = now;
  return seconds;
}

FrameShape shape_of(const Window& window, double seconds, int samples) {
  const Window::Size size = window.size();
  const Window::Size pixels = window.framebuffer_size();
  return {static_cast<float>(size.width),
          static_cast<float>(size.height),
          pixels.width,
          pixels.height,
          window.unit_scale(),
          window.pixel_scale(),
          static_cast<float>(seconds),
          samples};
}

double turn(Session& session, Window& window, FrameDrawer& drawer, Pace& pace) {
  // What panels wait for is looked at twenty times a second, and drawn then.
  const bool panels_wait = drawer.waits_for_panels();
  pace.look_at(panels_wait);
  const bool idle = pace.frames_due == 0 && window.input().empty() && !drawer.busy() && !working(session);
  if (idle) {
    window.wait(panels_wait ? 0.05 : 0.5);
    if (panels_wait) pace.frames_due = 1;
  } else if (pace.frames_due == 0 && window.input().empty() && only_waiting(session)) {
    window.wait(0.05);
  } else {
    window.poll();
  }
  const double seconds = pace.tick();
  // When the work ends, its last state is still to be drawn.
  if (window.take_refresh() || !window.input().empty() || working(session)) {
    pace.frames_due = frames_after_event;
  }
  for (const std::string& path : window.take_dropped()) app::apply(session, opening_of(path));
  apply(session, PassTime{idle ? 0.0 : seconds});
  const Window::Size pixels = window.framebuffer_size();
  if (window.minimised() || pixels.width == 0 || pixels.height == 0) {
    window.wait(0.1);
    return seconds;
  }
  const bool drawing = pace.frames_due > 0 || working(session) || drawer.busy();
  if (!drawing) return seconds;

  // A slow machine gets jagged edges while things move, smooth ones when they rest.
  const bool moving = pace.frames_due > 1 || working(session);
  const int samples = moving && pace.frame_seconds > slow_frame_seconds ? 1 : 4;
  const auto start = std::chrono::steady_clock::now();
  const std::size_t views = drawer.views_drawn();
  const Actions wishes =
      drawer.draw(session, shape_of(window, seconds, samples), window.input().take_frame());
  tell_shader_problem(session, drawer, pace);
  window.set_title(title_of(session));
  window.set_cursor(drawer.glue().wanted_cursor());
  drawer.target().present(pixels.width, pixels.height);
  if (samples > 1 && drawer.views_drawn() != views) {
    const double cost = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    pace.frame_seconds += 0.3 * (cost - pace.frame_seconds);
  }
  window.swap();
  save_what_is_wanted(session, drawer);
  for (const Action& wish : wishes) apply(session, wish);
  if (const auto text = take_clipboard(session)) window.set_clipboard(*text);
  pace.frames_due = wishes.empty() ? std::max(0, pace.frames_due - 1) : frames_after_event;
  return seconds;
}

}  // namespace app
