// A picture in memory and as a PNG file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace app {

struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  // top row first, 4 bytes a pixel
};

// The picture as a PNG file's bytes; none when it is empty or too large.
std::vector<std::uint8_t> png_bytes(const Image& image);

// None where there is no such file or it is no PNG.
std::optional<Image> read_png(const std::filesystem::path& path);

// Writes beside `path` and renames, so that there is never half a picture; "-" is standard output. Returns
// what went wrong and what to do, or nothing.
std::optional<std::string> save_png(const std::string& path, const Image& image);

}  // namespace app
