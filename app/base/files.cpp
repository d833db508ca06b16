#include "app/base/files.h"

#include <unistd.h>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <system_error>
#include <utility>

#include "app/base/outside.h"
#include "app/base/text.h"

namespace app {

std::string cannot_write(const std::filesystem::path& path, const std::string& why) {
  return "cannot write " + path.string() + ": " + why + "; choose another place or make room.";
}

namespace {

std::optional<std::string> write_standard_output(std::string_view content) {
  const bool done =
      std::fwrite(content.data(), 1, content.size(), stdout) == content.size() && std::fflush(stdout) == 0;
  return done ? std::nullopt : std::optional(cannot_write("standard output", std::strerror(errno)));
}

// What went wrong, if anything did.
std::optional<std::string> write_whole(const std::filesystem::path& path, std::string_view content) {
  errno = 0;
  std::ofstream out(path, std::ios::binary);
  out.write(content.data(), static_cast<std::streamsize>(content.size()));
  out.close();
  if (out) return std::nullopt;
  return errno != 0 ? std::strerror(errno) : "the file could not be written whole";
}

}  // namespace

namespace {

constexpr std::string_view aside_mark = ".part-";

// The process that `name` belongs to, if it is an aside of a file called `target`.
std::optional<pid_t> writer_of(const std::string& name, const std::string& target) {
  const std::string beginning = target + std::string(aside_mark);
  if (name.rfind(beginning, 0) != 0) return std::nullopt;
  const auto id = whole_number<pid_t>(name.substr(beginning.size()));
  return id && *id > 0 ? id : std::nullopt;
}

bool is_gone(pid_t process) { return ::kill(process, 0) != 0 && errno == ESRCH; }

}  // namespace

void clear_leftovers(const std::filesystem::path& path) {
  namespace fs = std::filesystem;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const std::string target = path.filename().string();
  std::error_code error;
  for (fs::directory_iterator it(folder, error); !error && it != fs::directory_iterator();
       it.increment(error)) {
    const auto writer = writer_of(it->path().filename().string(), target);
    std::error_code ignored;
    if (writer && is_gone(*writer)) fs::remove_all(it->path(), ignored);
  }
}

std::filesystem::path aside_of(const std::filesystem::path& path) {
  std::filesystem::path aside = path;
  aside += std::string(aside_mark) + std::to_string(::getpid());
  return aside;
}

std::optional<std::string> put_in_place(const std::filesystem::path& aside,
                                        const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::rename(aside, path, error);
  if (!error) tell_written(path);
  if (!error) return std::nullopt;
  std::error_code ignored;
  std::filesystem::remove(aside, ignored);
  return cannot_write(path, error.message());
}

std::optional<std::string> write_file(const std::filesystem::path& path, std::string_view content) {
  if (path == "-") return write_standard_output(content);
  std::error_code ignored;
  std::filesystem::path target = path;
  if (std::filesystem::exists(path, ignored) && !std::filesystem::is_directory(path, ignored)) {
    // A device or a pipe is written to, never replaced; a link stays a link.
    if (!std::filesystem::is_regular_file(path, ignored)) {
      const auto trouble = write_whole(path, content);
      return trouble ? std::optional(cannot_write(path, *trouble)) : std::nullopt;
    }
    target = std::filesystem::canonical(path, ignored);
  }
  clear_leftovers(target);
  const std::filesystem::path aside = aside_of(target);
  if (const auto trouble = write_whole(aside, content)) {
    std::filesystem::remove(aside, ignored);
    return cannot_write(path, *trouble);
  }
  return put_in_place(aside, target);
}

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
    if (!error) tell_written(target_);
    if (!error) return std::nullopt;
    trouble_ = error.message();
  }
  std::error_code ignored;
  if (aside_ != target_) fs::remove(aside_, ignored);
  return cannot_write(path_, trouble_);
}

bool error_is_terminal() { return ::isatty(STDERR_FILENO) == 1; }

}  // namespace app
