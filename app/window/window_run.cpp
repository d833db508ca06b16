#include "app/window/window_run.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/actions/hosting.h"
#include "app/actions/navigate.h"
#include "app/actions/opening.h"
#include "app/actions/preferences_keeper.h"
#include "app/base/files.h"
#include "app/files/export.h"
#include "app/files/preferences_file.h"
#include "app/files/rescue.h"
#include "app/panels/kit/layout.h"
#include "app/render/memory.h"
#include "app/script/figure_words.h"
#include "app/script/open_as_asked.h"
#include "app/script/queries.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/outbox.h"
#include "app/session/program.h"
#include "app/session/view.h"
#include "app/window/animation.h"
#include "app/window/turn.h"

namespace app {

// Named, because the fields of WindowRun::Inside are of these types.
namespace turning {

// What is asked on the command line is answered there, and shown.
void answer_in_window(Session& session, const CommandLine& line) {
  const auto give = [&](const Answer& answer) {
    std::fputs(answer.out.c_str(), stdout);
    if (!answer.error.empty()) notify(session, Notice::Kind::warning, answer.error);
  };
  if (!line.go_to.empty()) give(go_to_answer(session, line.go_to));
  if (!line.why.empty()) give(why_answer(session, line.why));
  if (line.ways_on) give(ways_answer(session));
  if (!line.diff.empty()) give(diff_answer(session, line.diff));
}

std::optional<std::string> save_animation_asked(Session& session, const CommandLine& line) {
  set_beside(session, false);
  work_out(session);
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
    note(find_export(wish.what)->write == nullptr ? save_png(wish.path.string(), drawer.target().read())
                                                  : export_to_file(session, wish));
  }
  if (!session.document && (line.picture || line.animation))
    note("nothing is open any more, so its picture or animation was not saved.");
  if (!session.document) return code;
  if (const auto& wish = line.picture)
    note(save_figure(session, {wish->path, wish->width, wish->height, wish->panels, wish->transparent}));
  if (line.animation) note(save_animation_asked(session, line));
  return code;
}

// The command line's questions about the run that is open now.
void ask(Session& session, const CommandLine& line) {
  if (!session.document) return;
  const bool beside = set_beside(session, false);  // the answers are wanted now
  if (line.at) {
    if (const auto nearest = go_to(session, *line.at)) notify(session, Notice::Kind::warning, *nearest);
  }
  select_as_asked(session, line.select);
  answer_in_window(session, line);
  set_beside(session, beside);
  if (!line.sweep.empty()) sweep_answer(session, line.sweep);
}

// What goes on when a window is lost and another takes its place.
struct Kept {
  PreferencesKeeper preferences;
  RescueKeeper rescue;
  AskedAtStart asked;
};

Kept begin(Session& session, const CommandLine& line, const Window& window, FrameDrawer& drawer) {
  set_beside(session, true);
  ask(session, line);
  const auto folder = rescue_folder();
  if (folder) offer_rescued(session, find_rescued(*folder));
  PreferencesKeeper preferences(session, preferences_file(), {line.theme, line.scale, line.row_columns});
  if (static_cast<float>(window.size().width) < narrow_window * window.unit_scale()) {
    apply(session, ShowPanel{Panel::parameters, false});
    apply(session, ShowPanel{Panel::side, false});
  }
  drawer.draw(session, shape_of(window, 0.0, 1), {});
  if (!session.view->gaze.camera_kept) apply(session, FrameAll{});  // now that the view's shape is known
  // What has just appeared finds its size in a frame that is not shown: a click that waits already shall meet it.
  for (int i = 0; i < 2; ++i) drawer.draw(session, shape_of(window, 0.0, 1), {});
  return {std::move(preferences), RescueKeeper(session, folder), AskedAtStart(session)};
}

// How often the driver may lose a window before it is left alone.
class Losses {
 public:
  bool one_too_many() {
    const auto now = std::chrono::steady_clock::now();
    while (!times_.empty() && now - times_.front() > std::chrono::minutes(1)) times_.erase(times_.begin());
    times_.push_back(now);
    return times_.size() > 2;
  }

 private:
  std::vector<std::chrono::steady_clock::time_point> times_;
};

constexpr const char* instead = " Run with --headless to work without a window.";

int give_up(const std::string& why, const char* way_on, const Session& session, Kept* kept) {
  const bool safe = kept != nullptr && kept->rescue.keep(session);
  std::fprintf(stderr, "knit-mesh: %s%s%s\n", why.c_str(),
               safe ? " The session is kept; the next start offers it." : "", way_on);
  return exit_usage;
}

// As Window::open takes it.
Window::Size plain_size(const Window& window) {
  const auto plain = [&](int units) {
    return static_cast<int>(std::lround(static_cast<float>(units) / window.unit_scale()));
  };
  return {plain(window.size().width), plain(window.size().height)};
}

void tell_loss(Session& session) {
  if (session.jobs->animation)
    notify(session, Notice::Kind::warning, "The animation was given up. Save it again.");
  apply(session, CancelAnimation{});
  notify(session, Notice::Kind::warning,
         "The graphics driver lost the window, so it was opened again. Nothing else is lost.");
}

// A window and what draws in it. Neither outlives the other.
struct Shown {
  explicit Shown(Window opened, const std::filesystem::path& assets)
      : window(std::move(opened)), drawer(assets) {
    drawer.set_clipboard({[this] { return window.clipboard(); },
                          [this](const std::string& text) { window.set_clipboard(text); }});
  }
  Window window;
  FrameDrawer drawer;
  Pace pace;
  std::unique_ptr<AnimationMaker> animation;
};

}  // namespace turning

using turning::ask;
using turning::begin;
using turning::give_up;
using turning::instead;
using turning::Kept;
using turning::Losses;
using turning::plain_size;
using turning::save_at_closing;
using turning::Shown;
using turning::tell_loss;

struct WindowRun::Inside {
  Session& session;
  const CommandLine& line;
  Window::Size size{line.width, line.height};
  Losses losses;
  std::unique_ptr<Kept> kept;
  std::unique_ptr<Shown> shown;
  int code = exit_done;

  bool end(int with) {
    code = with;
    return false;
  }

  // Only while the window is there.
  bool go_on() {
    Shown& now = *shown;
    if (!kept) kept = std::make_unique<Kept>(begin(session, line, now.window, now.drawer));
    if (session.outbox->quit || now.window.close_requested()) {
      cancel_opening(session);
      kept->rescue.end();
      kept->preferences.end(session);
      return end(save_at_closing(session, line, now.drawer));
    }
    const double seconds = app::turn(session, now.window, now.drawer, now.pace);
    if (kept->asked.tend(session, line)) ask(session, line);
    kept->rescue.pass(session, seconds);
    kept->preferences.pass(session, seconds);
    tend_animation(session, now.animation);
    return !now.window.lost() || begin_again();
  }

  // The window is lost: the next turn opens another.
  bool begin_again() {
    size = plain_size(shown->window);
    shown.reset();
    if (losses.one_too_many())
      return end(give_up("The graphics driver lost the window three times within a minute.", instead, session,
                         kept.get()));
    tell_loss(session);
    return true;
  }

  bool turn() {
    std::optional<Window> opened;
    if (!shown) {
      auto window = Window::open("knit-mesh", size.width, size.height);
      if (const auto* error = std::get_if<std::string>(&window))
        return end(give_up(*error, "", session, kept.get()));
      opened = std::move(std::get<Window>(window));
    }
    try {
      if (opened) shown = std::make_unique<Shown>(std::move(*opened), session.program->assets);
      return go_on();
    } catch (const GlError& error) {
      // With a lost window nothing else works either.
      if (!shown || !shown->window.lost()) return end(give_up(error.what(), instead, session, kept.get()));
      return begin_again();
    }
  }
};

WindowRun::WindowRun(Session& session, const CommandLine& line)
    : inside_(std::make_unique<Inside>(Inside{session, line})) {
  keep_freed_memory();
}
WindowRun::~WindowRun() = default;
bool WindowRun::turn() { return inside_->turn(); }
const Box* WindowRun::place_of(std::string_view control) const {
  return inside_->shown ? inside_->shown->drawer.place_of(control) : nullptr;
}
int WindowRun::code() const { return inside_->code; }

}  // namespace app
