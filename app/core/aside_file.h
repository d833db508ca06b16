// A file that is written piece by piece, aside, and stands in its place only once it is whole.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>

namespace app {

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

}  // namespace app
