// Whole files, written aside and renamed into place: never half, the old one intact until the new one is
// done.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace app {

// "-" writes to standard output; a device or a pipe is written to as it is. The error is one sentence.
std::optional<std::string> write_file(const std::filesystem::path& path, std::string_view content);

// Removes what was written aside of `path` by programs that are no longer there: they were killed before the rename.
void clear_leftovers(const std::filesystem::path& path);

// The name to write `path` under before it is renamed: beside it, and nobody else's.
std::filesystem::path aside_of(const std::filesystem::path& path);

// Moves a file written aside into place; on failure removes it.
std::optional<std::string> put_in_place(const std::filesystem::path& aside,
                                        const std::filesystem::path& path);

// The sentence for it.
std::string cannot_write(const std::filesystem::path& path, const std::string& why);

// A file that is written piece by piece, aside, and stands in its place only once it is whole.

class AsideFile {
 public:
  // Or a sentence that says why nothing can be written there.
  static std::variant<AsideFile, std::string> open(const std::filesystem::path& path);

  AsideFile(AsideFile&&) noexcept = default;
  AsideFile& operator=(AsideFile&&) = delete;
  // What was not finished goes; the old file stays.
  ~AsideFile();

  // False when there is no room; `finish` says so.
  bool write(std::span<const std::uint8_t> bytes);
  // Puts the whole file in place, over an old one; or a sentence.
  std::optional<std::string> finish();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  AsideFile() = default;

  std::filesystem::path path_;    // as given
  std::filesystem::path target_;  // links followed
  std::filesystem::path aside_;   // equal to the target for what is written to as it is: a device, a pipe
  std::unique_ptr<std::FILE, Close> file_;
  std::string trouble_;
};

// Whether somebody reads along.

bool error_is_terminal();

}  // namespace app
