#include "app/files/figures.h"

#include <algorithm>
#include <cctype>

#include "app/base/text.h"

namespace app {

namespace {

namespace fs = std::filesystem;

std::string ending_of(const fs::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending;
}

std::optional<std::string> fault_of_size(const std::string& what, int width, int height) {
  const auto fits = [](int side) { return side >= smallest_side && side <= largest_side; };
  if (fits(width) && fits(height)) return std::nullopt;
  return what + " of " + std::to_string(width) + " x " + std::to_string(height) +
         " pixels cannot be made; give each side from " + std::to_string(smallest_side) + " to " +
         std::to_string(largest_side) + " pixels.";
}

}  // namespace

std::optional<AnimationKind> animation_kind_of(const fs::path& path) {
  const std::string ending = ending_of(path);
  if (ending == ".gif") return AnimationKind::gif;
  if (ending == ".png" || ending == ".apng") return AnimationKind::apng;
  std::error_code ignored;
  const bool folder = ending.empty() || fs::is_directory(path, ignored);
  return folder && !path.empty() ? std::optional(AnimationKind::folder) : std::nullopt;
}

std::optional<std::string> fault_of(const SavePicture& wish) {
  if (wish.path != "-" && ending_of(wish.path) != ".png")
    return "a picture cannot be written as " + wish.path.string() + "; give a name that ends in .png.";
  if (wish.transparent && wish.panels)
    return "panels have a background of their own; for a transparent picture leave them out.";
  return fault_of_size("a picture", wish.width, wish.height);
}

std::optional<std::string> fault_of(const SaveAnimation& wish) {
  if (!animation_kind_of(wish.path)) {
    return "an animation cannot be written as " + wish.path.string() +
           "; give a name that ends in .gif or .png, or one without an ending for a folder of numbered "
           "pictures.";
  }
  if (wish.stretch.begin > wish.stretch.end) {
    return "an animation cannot go from step " + std::to_string(wish.stretch.begin) + " back to step " +
           std::to_string(wish.stretch.end) + "; let it begin before it ends.";
  }
  if (wish.frames < 1 || wish.frames > most_frames) {
    return "an animation cannot have " + std::to_string(wish.frames) + " frames; give a number from 1 to " +
           std::to_string(most_frames) + ".";
  }
  if (!(wish.frames_per_second >= slowest_rate && wish.frames_per_second <= fastest_rate)) {
    return "an animation cannot run at " + fixed_text(wish.frames_per_second, 2) +
           " frames a second; give a number from 0.5 to 50.";
  }
  return fault_of_size("an animation", wish.width, wish.height);
}

std::size_t frames_in(const Stretch& stretch, int most) {
  return std::min(stretch.end - stretch.begin + 1, static_cast<std::size_t>(std::max(most, 1)));
}

std::size_t position_of_frame(const Stretch& stretch, std::size_t frames, std::size_t frame) {
  if (frames <= 1) return stretch.end;
  const std::size_t gaps = frames - 1;
  return stretch.begin + (frame * (stretch.end - stretch.begin) + gaps / 2) / gaps;
}

}  // namespace app
