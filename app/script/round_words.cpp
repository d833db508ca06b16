#include "app/script/round_words.h"

#include <charconv>
#include <system_error>

namespace app {

std::optional<RoundWords> read_round(std::string_view words) {
  RoundWords read;
  const char* end = words.data() + words.size();
  auto result = std::from_chars(words.data(), end, read.round);
  const bool on_it = result.ec == std::errc() && result.ptr != end && *result.ptr == '.';
  if (on_it) result = std::from_chars(result.ptr + 1, end, read.short_row);
  if (result.ec != std::errc() || result.ptr != end || read.round < 1 || (on_it && read.short_row < 1))
    return std::nullopt;
  return read;
}

}  // namespace app
