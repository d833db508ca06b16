// A file's own words in a message: they must neither break its line nor speak to a terminal, whatever they hold.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace knit {

// A name as it stands, UTF-8 and all, with ? for control characters.
std::string printable(std::string_view name);
// Likewise, with "..." for what follows the first `most` bytes or so: no character of UTF-8 is cut.
std::string printable_start(std::string_view name, std::size_t most);
// The beginning of a word that was read, in quotation marks, with ? for all that is not printable ASCII.
std::string quoted(std::string_view word);
// "1 vertex has", "2 vertices have".
std::string counted(std::size_t count, const char* one, const char* many);

}  // namespace knit
