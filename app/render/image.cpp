#include "app/render/image.h"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

// Only this file sees stb's functions; the system's library may hold the same names.
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb_image_write.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace app {

namespace {

namespace fs = std::filesystem;

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

std::string reason() { return std::error_code(errno, std::generic_category()).message(); }

bool write_and_close(std::FILE* file, const std::vector<std::uint8_t>& bytes) {
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  const int error = errno;
  const bool closed = std::fclose(file) == 0;
  errno = written ? errno : error;
  return written && closed;
}

// A new file beside `path`, or null with errno set.
std::FILE* open_beside(const fs::path& path, fs::path& beside) {
  for (int i = 0; i < 1000; ++i) {
    beside = path;
    beside += ".part" + std::to_string(i);
    if (std::FILE* file = std::fopen(beside.string().c_str(), "wbx"); file != nullptr || errno != EEXIST) {
      return file;
    }
  }
  return nullptr;
}

std::optional<std::string> write_file(const std::string& name, const std::vector<std::uint8_t>& bytes) {
  const std::string failed = "Cannot write the picture " + name + ": ";
  std::error_code ignored;
  fs::path path = name;
  if (fs::exists(path, ignored)) {
    if (fs::is_directory(path, ignored)) {
      return failed + "it is a folder. Give a file name.";
    }
    if (!fs::is_regular_file(path, ignored)) {  // a pipe or /dev/null is written to, never replaced
      std::FILE* file = std::fopen(name.c_str(), "wb");
      return file != nullptr && write_and_close(file, bytes) ? std::nullopt
                                                             : std::optional(failed + reason() + ".");
    }
    path = fs::canonical(path, ignored);  // a link stays a link
  }
  fs::path beside;
  std::FILE* file = open_beside(path, beside);
  if (file == nullptr) {
    return failed + reason() + ".";
  }
  if (!write_and_close(file, bytes)) {
    const std::string why = reason();
    fs::remove(beside, ignored);
    return failed + why + ".";
  }
  std::error_code error;
  fs::rename(beside, path, error);
  if (error) {
    fs::remove(beside, ignored);
    return failed + error.message() + ".";
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::uint8_t> png_bytes(const Image& image) {
  const auto pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  if (image.width < 1 || image.height < 1 || image.rgba.size() != pixels * 4) return {};
  return encode(image);
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
  if (path == "-") {
    const bool good =
        std::fwrite(bytes.data(), 1, bytes.size(), stdout) == bytes.size() && std::fflush(stdout) == 0;
    return good ? std::nullopt
                : std::optional("Cannot write the picture to standard output: " + reason() + ".");
  }
  return write_file(path, bytes);
}

}  // namespace app
