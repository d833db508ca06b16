// Pictures one after the other into a file, or a folder of files: of all of them only the last is kept in
// memory.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "app/files/figures.h"
#include "app/render/image.h"

namespace app {

struct AnimationShape {
  int width = 0, height = 0;
  std::size_t frames = 1;
  double frames_per_second = 20.0;
};

// What is not finished leaves nothing behind, and the old file as it was.
class AnimationFile {
 public:
  AnimationFile() = default;
  AnimationFile(const AnimationFile&) = delete;
  AnimationFile& operator=(const AnimationFile&) = delete;
  virtual ~AnimationFile() = default;

  // The next picture, of the shape's size. The error is one sentence.
  virtual std::optional<std::string> add(const Image& image) = 0;
  // After the last: puts the whole in place.
  virtual std::optional<std::string> finish() = 0;
};

// Or a sentence that says why nothing can be written there.
using OpenedAnimation = std::variant<std::unique_ptr<AnimationFile>, std::string>;

// As the path says: see animation_kind_of.
OpenedAnimation open_animation(const std::filesystem::path& path, const AnimationShape& shape);

// The kinds. apng_file.cpp, gif_file.cpp, frame_folder.cpp
OpenedAnimation open_apng(const std::filesystem::path& path, const AnimationShape& shape);
OpenedAnimation open_gif(const std::filesystem::path& path, const AnimationShape& shape);
OpenedAnimation open_frame_folder(const std::filesystem::path& path, const AnimationShape& shape);

// What changes from one picture to another of its size: the smallest box; one pixel where nothing does.
struct PixelPatch {
  int x = 0, y = 0, width = 1, height = 1;
};
PixelPatch changed_patch(const Image& before, const Image& now);
Image cut_out(const Image& image, const PixelPatch& patch);

}  // namespace app
