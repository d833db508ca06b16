// Pictures at any size, and animations of a stretch of the timeline.
//
// What is wished is checked here and by `apply`; whoever has OpenGL (app/window) makes it. An animation works
// on its own copy of the session, so that a person may go on looking at the other.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/session/action.h"

namespace app {

inline constexpr int smallest_side = 64, largest_side = 16384;  // pixels
inline constexpr int most_frames = 9999;
inline constexpr double slowest_rate = 0.5, fastest_rate = 50.0;  // frames a second

enum class AnimationKind : std::uint8_t { gif, apng, folder };
// By the ending: .gif; .png or .apng; a folder for numbered PNG where there is none. None for any other.
std::optional<AnimationKind> animation_kind_of(const std::filesystem::path& path);

// What is wrong with a wish, in one sentence; nothing when it can be done.
std::optional<std::string> fault_of(const SavePicture& wish);
std::optional<std::string> fault_of(const SaveAnimation& wish);

// Frames are spread evenly over the stretch, both of its ends among them; of one alone, the end. As many as
// wished, but none shows what another does.
std::size_t frames_in(const Stretch& stretch, int most);
std::size_t position_of_frame(const Stretch& stretch, std::size_t frames, std::size_t frame);

// An animation in the making, or asked for.
struct AnimationRun {
  SaveAnimation wish;  // its stretch is known to the end
  std::size_t frames = 0, done = 0;
  std::shared_ptr<const Session> from;  // as it was when it was asked for: a figure_session
};

}  // namespace app
