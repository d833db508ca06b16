// Animated GIF by giflib. Every picture has colours of its own and covers only what changes.
#include <utility>

#include "app/base/files.h"
#include "app/render/animation_file.h"

#if KNIT_HAVE_GIF
#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "app/render/gif_palette.h"
#endif

namespace app {

#if KNIT_HAVE_GIF

namespace {

constexpr int palette_size = 256;
constexpr int largest_gif_side = 65535;

int write_piece(GifFileType* gif, const GifByteType* bytes, int size) {
  auto* file = static_cast<AsideFile*>(gif->UserData);
  return file->write({bytes, static_cast<std::size_t>(size)}) ? size : 0;
}

class GifFile : public AnimationFile {
 public:
  GifFile(AsideFile file, const AnimationShape& shape) : file_(std::move(file)), shape_(shape) {
    int error = 0;
    gif_ = EGifOpen(&file_, write_piece, &error);
    if (gif_ == nullptr) return;
    EGifSetGifVersion(gif_, true);
    put(EGifPutScreenDesc(gif_, shape.width, shape.height, 8, 0, nullptr));
    put_loop();
  }
  GifFile(const GifFile&) = delete;
  GifFile& operator=(const GifFile&) = delete;
  ~GifFile() override { close(); }

  std::optional<std::string> add(const Image& image) override {
    if (gif_ == nullptr) return trouble();
    const bool first = before_.rgba.empty();
    const PixelPatch patch =
        first ? PixelPatch{0, 0, image.width, image.height} : changed_patch(before_, image);
    const Image now = cut_out(image, patch);
    const Image was = first ? Image() : cut_out(before_, patch);
    PalettedImage paletted = palette_.next(now, first ? nullptr : &was);
    put_control(!first);
    put_picture(patch, paletted);
    before_ = image;
    return good_ ? std::nullopt : trouble();
  }

  std::optional<std::string> finish() override {
    if (!close()) return trouble();
    return file_.finish();
  }

 private:
  void put(int result) { good_ = result == GIF_OK && good_; }

  std::optional<std::string> trouble() {
    const auto why = file_.finish();  // it knows when there was no room
    return why ? why : std::optional<std::string>("the GIF could not be written; save as .png instead.");
  }

  void put_loop() {
    constexpr std::array<GifByteType, 3> over_and_over{1, 0, 0};
    put(EGifPutExtensionLeader(gif_, APPLICATION_EXT_FUNC_CODE));
    put(EGifPutExtensionBlock(gif_, 11, "NETSCAPE2.0"));
    put(EGifPutExtensionBlock(gif_, static_cast<int>(over_and_over.size()), over_and_over.data()));
    put(EGifPutExtensionTrailer(gif_));
  }

  // Delays are whole hundredths of a second; rounding does not add up.
  void put_control(bool leaves_out) {
    const auto at = [&](std::size_t frame) {
      return std::lround(100.0 * static_cast<double>(frame) / shape_.frames_per_second);
    };
    GraphicsControlBlock control{};
    control.DisposalMode = DISPOSE_DO_NOT;
    control.DelayTime = static_cast<int>(at(count_ + 1) - at(count_));
    control.TransparentColor = leaves_out ? unchanged_index : NO_TRANSPARENT_COLOR;
    ++count_;
    std::array<GifByteType, 4> bytes{};
    EGifGCBToExtension(&control, bytes.data());
    put(EGifPutExtension(gif_, GRAPHICS_EXT_FUNC_CODE, static_cast<int>(bytes.size()), bytes.data()));
  }

  void put_picture(const PixelPatch& patch, PalettedImage& paletted) {
    std::array<GifColorType, palette_size> colours{};
    for (std::size_t i = 0; i < paletted.colours.size(); ++i)
      colours[i] = {paletted.colours[i].r, paletted.colours[i].g, paletted.colours[i].b};
    ColorMapObject* map = GifMakeMapObject(palette_size, colours.data());
    good_ = good_ && map != nullptr;
    if (!good_) return;
    put(EGifPutImageDesc(gif_, patch.x, patch.y, patch.width, patch.height, false, map));
    GifFreeMapObject(map);
    for (int y = 0; y < patch.height && good_; ++y) {
      GifPixelType* row = paletted.pixels.data() + static_cast<std::ptrdiff_t>(y) * patch.width;
      put(EGifPutLine(gif_, row, patch.width));
    }
  }

  bool close() {
    if (gif_ == nullptr) return good_;
    int error = 0;
    put(EGifCloseFile(std::exchange(gif_, nullptr), &error));
    return good_;
  }

  AsideFile file_;  // giflib points to it: this object does not move
  AnimationShape shape_;
  GifFileType* gif_ = nullptr;
  GifPalette palette_;
  Image before_;
  std::size_t count_ = 0;
  bool good_ = true;
};

}  // namespace

OpenedAnimation open_gif(const std::filesystem::path& path, const AnimationShape& shape) {
  if (std::max(shape.width, shape.height) > largest_gif_side)
    return "a GIF of that size cannot be made; give each side up to 65535 pixels.";
  auto file = AsideFile::open(path);
  if (auto* error = std::get_if<std::string>(&file)) return std::move(*error);
  return std::make_unique<GifFile>(std::move(std::get<AsideFile>(file)), shape);
}

#else

OpenedAnimation open_gif(const std::filesystem::path& path, const AnimationShape& /*shape*/) {
  return "cannot write " + path.string() +
         ": this program was built without giflib (Debian's libgif-dev); give a name that ends in .png.";
}

#endif

}  // namespace app
