// A folder of numbered pictures: frame_0001.png and so on, gathered aside and put in place together.
#include <array>
#include <cstdio>
#include <system_error>
#include <utility>

#include "app/base/files.h"
#include "app/render/animation_file.h"

namespace app {

namespace {

namespace fs = std::filesystem;

std::string frame_name(std::size_t number) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "frame_%04zu.png", number);
  return buffer.data();
}

class FrameFolder : public AnimationFile {
 public:
  FrameFolder(fs::path folder, fs::path aside) : folder_(std::move(folder)), aside_(std::move(aside)) {}
  FrameFolder(const FrameFolder&) = delete;
  FrameFolder& operator=(const FrameFolder&) = delete;
  ~FrameFolder() override {
    std::error_code ignored;
    fs::remove_all(aside_, ignored);
  }

  std::optional<std::string> add(const Image& image) override {
    auto trouble = save_png((aside_ / frame_name(++count_)).string(), image);
    if (!trouble) return trouble;
    // People know the folder by the name that they gave it.
    const std::size_t at = trouble->find(aside_.string());
    if (at != std::string::npos) trouble->replace(at, aside_.string().size(), folder_.string());
    return trouble;
  }

  // Other files of the folder stay.
  std::optional<std::string> finish() override {
    std::error_code error;
    fs::create_directories(folder_, error);
    for (std::size_t number = 1; number <= count_ && !error; ++number)
      fs::rename(aside_ / frame_name(number), folder_ / frame_name(number), error);
    if (error) return cannot_write(folder_, error.message());
    return std::nullopt;
  }

 private:
  fs::path folder_, aside_;
  std::size_t count_ = 0;
};

}  // namespace

OpenedAnimation open_frame_folder(const fs::path& path, const AnimationShape& /*shape*/) {
  std::error_code error;
  const fs::path folder = path.has_filename() ? path : path.parent_path();
  if (fs::exists(folder, error) && !fs::is_directory(folder, error)) {
    return "cannot write " + path.string() +
           ": it is a file, and numbered pictures need a folder; give another name, or one that ends in .gif "
           "or .png.";
  }
  clear_leftovers(folder);
  const fs::path aside = aside_of(folder);
  fs::create_directory(aside, error);
  if (error) return cannot_write(path, error.message());
  return std::make_unique<FrameFolder>(folder, aside);
}

}  // namespace app
