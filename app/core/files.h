// Whole files, written aside and renamed into place: never half, the old one intact until the new one is
// done.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

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

}  // namespace app
