#include "app/core/files.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>

namespace app {

namespace {

std::string cannot_write(const std::filesystem::path& path, const std::string& why) {
  return "cannot write " + path.string() + ": " + why + "; choose another place or make room.";
}

std::optional<std::string> write_standard_output(std::string_view content) {
  const bool done =
      std::fwrite(content.data(), 1, content.size(), stdout) == content.size() && std::fflush(stdout) == 0;
  return done ? std::nullopt : std::optional(cannot_write("standard output", std::strerror(errno)));
}

}  // namespace

std::filesystem::path aside_of(const std::filesystem::path& path) {
  std::filesystem::path aside = path;
  aside += ".part-" + std::to_string(::getpid());
  return aside;
}

std::optional<std::string> put_in_place(const std::filesystem::path& aside,
                                        const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::rename(aside, path, error);
  if (!error) return std::nullopt;
  std::error_code ignored;
  std::filesystem::remove(aside, ignored);
  return cannot_write(path, error.message());
}

std::optional<std::string> write_file(const std::filesystem::path& path, std::string_view content) {
  if (path == "-") return write_standard_output(content);
  const std::filesystem::path aside = aside_of(path);
  errno = 0;
  std::ofstream out(aside, std::ios::binary);
  out.write(content.data(), static_cast<std::streamsize>(content.size()));
  out.close();
  if (!out) {
    const std::string why = errno != 0 ? std::strerror(errno) : "the file could not be written whole";
    std::error_code ignored;
    std::filesystem::remove(aside, ignored);
    return cannot_write(path, why);
  }
  return put_in_place(aside, path);
}

}  // namespace app
