// Makes pictures and animations for files, with whatever OpenGL is current and beside what else is drawn
// there.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/files/figures.h"
#include "app/session/outbox.h"
#include "app/window/frame.h"

namespace app {

// One frame a call, so that a window goes on meanwhile. Gone before the last, it leaves nothing.
class AnimationMaker {
 public:
  explicit AnimationMaker(std::shared_ptr<const AnimationRun> run);
  ~AnimationMaker();
  AnimationMaker(const AnimationMaker&) = delete;
  AnimationMaker& operator=(const AnimationMaker&) = delete;

  // Makes the next frame, and after the last puts the file in place. The error is one sentence.
  std::optional<std::string> step();
  [[nodiscard]] bool finished() const;
  [[nodiscard]] std::size_t done() const;
  // Whether this is the animation that it makes.
  [[nodiscard]] bool makes(const AnimationRun& run) const;

 private:
  struct Inside;
  std::optional<std::string> make_next();
  std::shared_ptr<const AnimationRun> run_;
  std::unique_ptr<Inside> inside_;  // from the first frame on
  std::size_t done_ = 0;
};

// For a loop, once a turn: takes session.jobs->animation one frame on; `maker` is its to keep.
void tend_animation(Session& session, std::unique_ptr<AnimationMaker>& maker);

// One after the other; says so in the session's notices.
void save_figures(Session& session, const std::vector<FigureWish>& wishes);

// The picture into its file; the error is one sentence.
std::optional<std::string> save_figure(const Session& session, const FigureWish& wish);

// All of it at once. `says_progress`: lines on standard error, now and then.
std::optional<std::string> save_animation(const Session& session, const SaveAnimation& wish,
                                          bool says_progress);

// The same without any display.
std::optional<std::string> save_animation_headless(const Session& session, const SaveAnimation& wish,
                                                   bool says_progress);
std::optional<std::string> save_figure_headless(const Session& session, const FigureWish& wish);

}  // namespace app
