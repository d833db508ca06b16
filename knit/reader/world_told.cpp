#include "knit/reader/world_told.h"

#include <algorithm>

#include "knit/trade/world_grammar.h"

namespace knit {

bool same_world_name(const std::string& told, const std::string& known) {
  if (told.empty() || known.empty()) return true;
  if (told.find(known) != std::string::npos || known.find(told) != std::string::npos) return true;
  const auto stem = [](std::string name) {
    if (name.size() > 3 && name.back() == 's') name.pop_back();
    return name;
  };
  return stem(told).find(stem(known)) != std::string::npos ||
         stem(known).find(stem(told)) != std::string::npos;
}

std::optional<std::int64_t> stitches_in(const Atoms& part) {
  for (std::size_t i = 0; i < part.size(); ++i) {
    if (!part[i].is_number()) continue;
    for (std::size_t j = i + 1; j < std::min(part.size(), i + 5); ++j) {
      if (is_stitches(part[j])) return part[i].value;
      if (!part[j].is_word()) break;
    }
  }
  return std::nullopt;
}

bool names_holder(const Atoms& part) {
  if (holds_any(part, {"holder", "holders", "hold", "pin"})) return true;
  for (std::size_t i = 0; i + 1 < part.size(); ++i) {
    if (is_any(part[i], {"waste", "scrap", "spare", "contrasting"}) &&
        is_any(part[i + 1], {"yarn", "needle", "needles", "dpn", "dpns", "thread", "circular", "double"}))
      return true;
  }
  return false;
}

std::string name_behind(const Atoms& part, AtomWords words) {
  for (std::size_t i = part.size(); i-- > 0;) {
    if (!is_any(part[i], words)) continue;
    std::size_t end = i + 1;
    while (end < part.size() && part[end].is_word() &&
           !is_any(part[end], {"on", "onto", "to", "and", "then"}))
      ++end;
    return world_name(std::span(part).subspan(i + 1, end - i - 1));
  }
  return "";
}

// "the 12 held left leg sts": the name before the first stitches told.
std::string name_before_stitches(const Atoms& part) {
  for (std::size_t i = 1; i < part.size(); ++i) {
    if (!is_stitches(part[i])) continue;
    std::size_t begin = i;
    while (begin > 1 && part[begin - 1].is_word() &&
           !is_any(part[begin - 1], {"held", "next", "remaining", "live", "all", "slip", "place", "put",
                                     "return", "transfer"}))
      --begin;
    return world_name(std::span(part).subspan(begin, i - begin));
  }
  return "";
}

}  // namespace knit
