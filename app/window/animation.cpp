#include "app/window/animation.h"

#include <chrono>
#include <cstdio>
#include <utility>

#include "app/actions/hosting.h"
#include "app/actions/picture_session.h"
#include "app/render/animation_file.h"
#include "app/render/headless_gl.h"
#include "app/session/jobs.h"
#include "app/session/outbox.h"
#include "app/session/program.h"

namespace app {

namespace {

std::string with_hint(const GlError& error) { return std::string(error.what()) + " Give a smaller size."; }

// Its own glue and card memory, so that what is shown in a window is not disturbed.
Image picture_of(Session session, const FigureShape& shape) {
  fit_view(session, view_aspect_of(session, shape));
  FrameDrawer drawer(session.program->assets);
  return drawer.figure(session, shape);
}

}  // namespace

struct AnimationMaker::Inside {
  Inside(const Session& from, std::unique_ptr<AnimationFile> to)
      : session(from), drawer(from.program->assets), file(std::move(to)) {}
  Session session;
  FrameDrawer drawer;
  std::unique_ptr<AnimationFile> file;
};

AnimationMaker::AnimationMaker(std::shared_ptr<const AnimationRun> run) : run_(std::move(run)) {}

AnimationMaker::~AnimationMaker() {
  const ContextKept kept;
  inside_.reset();
}

bool AnimationMaker::finished() const { return done_ == run_->frames; }
std::size_t AnimationMaker::done() const { return done_; }
bool AnimationMaker::makes(const AnimationRun& run) const { return run.from == run_->from; }

std::optional<std::string> AnimationMaker::step() {
  const ContextKept kept;
  try {
    return make_next();
  } catch (const GlError& error) {
    return with_hint(error);
  }
}

std::optional<std::string> AnimationMaker::make_next() {
  const SaveAnimation& wish = run_->wish;
  const FigureShape shape{wish.width, wish.height, wish.panels, false};
  if (!inside_) {
    auto file = open_animation(wish.path, {wish.width, wish.height, run_->frames, wish.frames_per_second});
    if (auto* error = std::get_if<std::string>(&file)) return std::move(*error);
    inside_ =
        std::make_unique<Inside>(*run_->from, std::move(std::get<std::unique_ptr<AnimationFile>>(file)));
    fit_view(inside_->session, view_aspect_of(inside_->session, shape));
  }
  Session& session = inside_->session;
  show_position(session, position_of_frame(wish.stretch, run_->frames, done_));
  if (auto error = inside_->file->add(inside_->drawer.figure(session, shape))) return error;
  ++done_;
  return finished() ? inside_->file->finish() : std::nullopt;
}

void tend_animation(Session& session, std::unique_ptr<AnimationMaker>& maker) {
  if (!session.jobs->animation || (maker && !maker->makes(*session.jobs->animation))) maker.reset();
  if (!session.jobs->animation) return;
  if (!maker) maker = std::make_unique<AnimationMaker>(session.jobs->animation);
  const auto error = maker->step();
  if (!error && !maker->finished()) return note_frames_made(session, maker->done());
  notify_saved(session, session.jobs->animation->wish.path, error);
  maker.reset();
  apply(session, CancelAnimation{});
}

std::optional<std::string> save_figure(const Session& session, const FigureWish& wish) {
  const ContextKept kept;
  try {
    const FigureShape shape{wish.width, wish.height, wish.panels, wish.transparent};
    return save_png(wish.path.string(), picture_of(figure_session(session), shape));
  } catch (const GlError& error) {
    return with_hint(error);
  }
}

void save_figures(Session& session, const std::vector<FigureWish>& wishes) {
  for (const FigureWish& wish : wishes) notify_saved(session, wish.path, save_figure(session, wish));
}

std::optional<std::string> save_figure_headless(const Session& session, const FigureWish& wish) {
  auto opened = HeadlessGl::open();
  if (auto* error = std::get_if<std::string>(&opened)) return std::move(*error);
  return save_figure(session, wish);
}

std::optional<std::string> save_animation(const Session& session, const SaveAnimation& wish,
                                          bool says_progress) {
  if (auto fault = fault_of(wish)) return fault;
  const AnimationRun run{wish, frames_in(wish.stretch, wish.frames), 0,
                         std::make_shared<const Session>(figure_session(session))};
  AnimationMaker maker(std::make_shared<const AnimationRun>(run));
  auto last = std::chrono::steady_clock::now();
  while (!maker.finished()) {
    if (auto error = maker.step()) return error;
    const auto now = std::chrono::steady_clock::now();
    if (!says_progress || now - last < std::chrono::seconds(1)) continue;
    last = now;
    std::fprintf(stderr, "knit-mesh: %s: %zu of %zu frames\n", wish.path.string().c_str(), maker.done(),
                 run.frames);
  }
  return std::nullopt;
}

std::optional<std::string> save_animation_headless(const Session& session, const SaveAnimation& wish,
                                                   bool says_progress) {
  auto opened = HeadlessGl::open();
  if (auto* error = std::get_if<std::string>(&opened)) return std::move(*error);
  return save_animation(session, wish, says_progress);
}

}  // namespace app
