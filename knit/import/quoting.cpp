#include "knit/import/quoting.h"

namespace knit {

std::string printable(std::string_view name) {
  std::string out(name);
  for (char& c : out)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
  return out;
}

std::string printable_start(std::string_view name, std::size_t most) {
  const auto goes_on = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
  while (most < name.size() && goes_on(name[most])) ++most;
  return printable(name.substr(0, most)) + (name.size() > most ? "..." : "");
}

std::string quoted(std::string_view word) {
  constexpr std::size_t longest = 24;
  std::string out = "\"";
  for (const char c : word.substr(0, longest)) out += c >= ' ' && c <= '~' ? c : '?';
  return out + (word.size() > longest ? "...\"" : "\"");
}

std::string counted(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

}  // namespace knit
