#include "app/render/image.h"

#include "app/base/files.h"

// Only this file sees stb's functions; the system's library may hold the same names.
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb_image_write.h>
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_MAX_DIMENSIONS 4096
#include <stb_image.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace app {

namespace {

std::vector<std::uint8_t> encode(const Image& image) {
  std::vector<std::uint8_t> bytes;
  const auto append = [](void* context, void* data, int size) {
    const auto* from = static_cast<const std::uint8_t*>(data);
    static_cast<std::vector<std::uint8_t>*>(context)->insert(
        static_cast<std::vector<std::uint8_t>*>(context)->end(), from, from + size);
  };
  if (stbi_write_png_to_func(append, &bytes, image.width, image.height, 4, image.rgba.data(),
                             image.width * 4) == 0) {
    bytes.clear();
  }
  return bytes;
}

}  // namespace

std::vector<std::uint8_t> png_bytes(const Image& image) {
  const auto pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  if (image.width < 1 || image.height < 1 || image.rgba.size() != pixels * 4) return {};
  return encode(image);
}

std::optional<Image> read_png(const std::filesystem::path& path) {
  Image image;
  int channels = 0;
  stbi_uc* pixels = stbi_load(path.string().c_str(), &image.width, &image.height, &channels, 4);
  if (pixels == nullptr) return std::nullopt;
  const auto count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  image.rgba.assign(pixels, pixels + 4 * count);
  stbi_image_free(pixels);
  return image;
}

std::optional<std::string> save_png(const std::string& path, const Image& image) {
  const auto pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  if (image.width < 1 || image.height < 1 || image.rgba.size() != pixels * 4) {
    return "There is no picture to write to " + path + ".";
  }
  const std::vector<std::uint8_t> bytes = encode(image);
  if (bytes.empty()) {
    return "The picture for " + path + " is too large for a PNG file.";
  }
  return write_file(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace app
