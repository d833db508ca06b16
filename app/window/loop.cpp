#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <utility>

#include "app/core/export.h"
#include "app/core/figure_words.h"
#include "app/core/opening.h"
#include "app/core/pattern_file.h"
#include "app/core/preferences_file.h"
#include "app/core/queries.h"
#include "app/core/rescue.h"
#include "app/core/session_file.h"
#include "app/core/sweep_work.h"
#include "app/core/terminal.h"
#include "app/render/memory.h"
#include "app/window/animation.h"
#include "app/window/frame.h"
#include "app/window/run.h"
#include "app/window/window.h"

namespace app {

namespace {

// Popups and notices find their size in a few frames; after these nothing changes until something happens.
constexpr int frames_after_event = 3;
constexpr double slow_frame_seconds = 0.04;

struct Pace {
  std::chrono::steady_clock::time_point last = std::chrono::steady_clock::now();
  double frame_seconds = 1.0 / 60.0;  // what a frame costs, smoothed
  int frames_due = frames_after_event;

  double tick() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last).count();
    last = now;
    return seconds;
  }
};

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

// Threads of their own are at it: a sweep, the pinned run's end.
bool working_beside(const Session& session) {
  return pin_is_pending(session) || (session.sweep && session.sweep->work->running());
}

bool working(const Session& session) {
  if (session.opening) return true;
  return session.timeline && (session.animation || working_beside(session) || session.playback.playing ||
                              !session.timeline->complete() || session.measuring);
}

// Only a worker is at it: looking now and then is enough.
bool only_waiting(const Session& session) {
  if (!session.timeline) return session.opening != nullptr;
  return !session.playback.playing && !session.animation &&
         (session.long_step.has_value() ||
          (session.timeline->complete() &&
           (session.opening || session.measuring || working_beside(session))));
}

void save_pictures_wanted(Session& session, const Target& target) {
  for (const std::filesystem::path& path : session.screenshots_wanted) {
    const auto error = save_png(path.string(), target.read());
    session.notices.push_back(error ? Notice{Notice::Kind::error, *error}
                                    : Notice{Notice::Kind::info, "Saved " + path.string() + "."});
  }
  session.screenshots_wanted.clear();
}

void save_pages_wanted(Session& session, FrameDrawer& drawer) {
  for (const std::filesystem::path& path : std::exchange(session.pages_wanted, {})) {
    const auto missing = pattern_missing(session);
    const auto error =
        missing ? missing
                : export_pattern(session, path, png_bytes(drawer.finished(session, page_picture_px)));
    session.notices.push_back(error ? Notice{Notice::Kind::error, *error}
                                    : Notice{Notice::Kind::info, "Saved " + path.string() + "."});
  }
}

void save_what_is_wanted(Session& session, FrameDrawer& drawer) {
  save_pictures_wanted(session, drawer.target());
  save_pages_wanted(session, drawer);
  save_figures_wanted(session);
}

// One turn: collect, let time pass, draw, and do what was wished. Gives the seconds since the one before.
double turn(Session& session, Window& window, FrameDrawer& drawer, Pace& pace) {
  const bool idle = pace.frames_due == 0 && window.input().empty() && !drawer.busy() && !working(session);
  if (idle) {
    window.wait(0.5);
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
  const Actions wishes =
      drawer.draw(session, shape_of(window, seconds, samples), window.input().take_frame());
  window.set_cursor(drawer.glue().wanted_cursor());
  drawer.target().present(pixels.width, pixels.height);
  if (samples > 1) {
    const double cost = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    pace.frame_seconds += 0.3 * (cost - pace.frame_seconds);
  }
  window.swap();
  save_what_is_wanted(session, drawer);
  for (const Action& wish : wishes) apply(session, wish);
  if (const auto text = std::exchange(session.clipboard_wanted, std::nullopt)) window.set_clipboard(*text);
  pace.frames_due = wishes.empty() ? std::max(0, pace.frames_due - 1) : frames_after_event;
  return seconds;
}

// A large mesh named on the command line is read while the window is there already.
class AskedOpening {
 public:
  explicit AskedOpening(const Session& session) : opening_(session.opening) {}
  // After each turn: once it is open, the command line's settings are made.
  void tend(Session& session, const CommandLine& line) {
    if (!opening_ || session.opening == opening_) return;
    const bool opened = !opening_->progress->stopped() && session.timeline;
    opening_.reset();
    if (!opened) return;
    if (auto error = set_as_asked(session, line))
      session.notices.push_back({Notice::Kind::error, std::move(*error)});
  }

 private:
  std::shared_ptr<const Opening> opening_;
};

// What is asked on the command line is answered there, and shown.
void answer_in_window(Session& session, const CommandLine& line) {
  const auto give = [&](const Answer& answer) {
    std::fputs(answer.out.c_str(), stdout);
    if (!answer.error.empty()) session.notices.push_back({Notice::Kind::warning, answer.error});
  };
  if (!line.why.empty()) give(why_answer(session, line.why));
  if (!line.diff.empty()) give(diff_answer(session, line.diff));
}

std::optional<std::string> save_animation_asked(Session& session, const CommandLine& line) {
  session.beside = false;
  session.timeline->extend_to_end();
  SaveAnimation wish = *line.animation;
  const AskedStretch asked = asked_stretch(session, line);
  for (const std::string& note : asked.notes) std::fprintf(stderr, "knit-mesh: %s\n", note.c_str());
  wish.stretch = asked.stretch;
  return save_animation(session, wish, error_is_terminal());
}

int save_at_closing(Session& session, const CommandLine& line, const FrameDrawer& drawer) {
  int code = exit_done;
  const auto note = [&](const std::optional<std::string>& error) {
    if (!error) return;
    std::fprintf(stderr, "knit-mesh: %s\n", error->c_str());
    code = exit_usage;
  };
  for (const Export& wish : line.saves) {
    note(wish.kind == ExportKind::picture ? save_png(wish.path.string(), drawer.target().read())
                                          : export_to_file(session, wish.kind, wish.path));
  }
  if (!session.timeline && (line.picture || line.animation))
    note("nothing is open any more, so its picture or animation was not saved.");
  if (!session.timeline) return code;
  if (const auto& wish = line.picture)
    note(save_figure(session, {wish->path, wish->width, wish->height, wish->panels, wish->transparent}));
  if (line.animation) note(save_animation_asked(session, line));
  return code;
}

}  // namespace

int run_window(Session& session, const CommandLine& line) {
  keep_freed_memory();
  auto opened = Window::open("knit-mesh", line.width, line.height);
  if (const auto* error = std::get_if<std::string>(&opened)) {
    std::fprintf(stderr, "knit-mesh: %s\n", error->c_str());
    return exit_usage;
  }
  Window& window = std::get<Window>(opened);
  try {
    FrameDrawer drawer(session.assets);
    drawer.set_clipboard(
        {[&] { return window.clipboard(); }, [&](const std::string& text) { window.set_clipboard(text); }});
    if (line.at && session.timeline) {
      if (const auto nearest = go_to(session, *line.at))
        session.notices.push_back({Notice::Kind::warning, *nearest});
    }
    if (session.timeline) answer_in_window(session, line);
    const auto folder = rescue_folder();
    if (folder) session.rescued = find_rescued(*folder);
    session.beside = true;
    PreferencesKeeper preferences(session, preferences_file(), {line.theme, line.scale});
    if (!line.sweep.empty() && session.timeline) sweep_answer(session, line.sweep);
    drawer.draw(session, shape_of(window, 0.0, 1), {});
    if (!session.camera_kept) apply(session, FrameAll{});  // now that the view's shape is known
    RescueKeeper keeper(session, folder);
    Pace pace;
    std::unique_ptr<AnimationMaker> animation;
    AskedOpening asked(session);
    while (!session.quit && !window.close_requested()) {
      const double seconds = turn(session, window, drawer, pace);
      asked.tend(session, line);
      keeper.pass(session, seconds);
      preferences.pass(session, seconds);
      tend_animation(session, animation);
    }
    cancel_opening(session);
    keeper.end();
    preferences.end(session);
    return save_at_closing(session, line, drawer);
  } catch (const GlError& error) {
    std::fprintf(stderr, "knit-mesh: %s Run with --headless to work without a window.\n", error.what());
    return exit_usage;
  }
}

}  // namespace app
