#include "app/core/aside_file.h"

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "app/core/files.h"

namespace app {

namespace fs = std::filesystem;

std::variant<AsideFile, std::string> AsideFile::open(const fs::path& path) {
  AsideFile made;
  std::error_code ignored;
  made.path_ = made.target_ = path;
  if (fs::is_directory(path, ignored)) return cannot_write(path, "it is a folder");
  bool as_it_is = false;
  if (fs::exists(path, ignored)) {
    as_it_is = !fs::is_regular_file(path, ignored);
    if (!as_it_is) made.target_ = fs::canonical(path, ignored);
  }
  if (!as_it_is) clear_leftovers(made.target_);
  made.aside_ = as_it_is ? made.target_ : aside_of(made.target_);
  errno = 0;
  made.file_.reset(std::fopen(made.aside_.string().c_str(), "wb"));
  if (!made.file_) return cannot_write(path, std::strerror(errno));
  return made;
}

AsideFile::~AsideFile() {
  if (!file_) return;
  file_.reset();
  std::error_code ignored;
  if (aside_ != target_) fs::remove(aside_, ignored);
}

bool AsideFile::write(std::span<const std::uint8_t> bytes) {
  if (!file_ || !trouble_.empty()) return false;
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) == bytes.size()) return true;
  trouble_ = std::strerror(errno);
  return false;
}

std::optional<std::string> AsideFile::finish() {
  if (!file_) return cannot_write(path_, "it is closed already");
  if (trouble_.empty() && std::fflush(file_.get()) != 0) trouble_ = std::strerror(errno);
  const bool closed = std::fclose(file_.release()) == 0;
  if (trouble_.empty() && !closed) trouble_ = std::strerror(errno);
  if (trouble_.empty()) {
    if (aside_ == target_) return std::nullopt;
    std::error_code error;
    fs::rename(aside_, target_, error);
    if (!error) return std::nullopt;
    trouble_ = error.message();
  }
  std::error_code ignored;
  if (aside_ != target_) fs::remove(aside_, ignored);
  return cannot_write(path_, trouble_);
}

}  // namespace app
