#include "knit/model/words.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace knit {

std::string_view name_of(Label label) {
  switch (label) {
    case Label::knit:
      return "knit";
    case Label::m1r:
      return "M1R";
    case Label::m1l:
      return "M1L";
    case Label::k2tog:
      return "K2tog";
    case Label::ssk:
      return "SSK";
    case Label::cast:
      return "cast on / off";
    case Label::main:
      return "main";
    case Label::turn_left:
      return "turn";
    case Label::turn_right:
      return "turn on the wrong side";
    case Label::marked:
      return "marked";
  }
  return "";
}

std::string_view name_of(Rule rule) {
  switch (rule) {
    case Rule::from_cast_on:
      return "from the cast on (R0)";
    case Rule::plain:
      return "plain (R1)";
    case Rule::equal:
      return "equal spacing (R2)";
    case Rule::follow:
      return "follow the mains (R3)";
    case Rule::remainder_last:
      return "remainder last (R4)";
    case Rule::dense:
      return "dense";
    case Rule::even:
      return "even";
    case Rule::nearest:
      return "nearest";
    case Rule::repeat:
      return "repeat";
  }
  return "";
}

std::string fixed_number(double value, int decimals) {
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.*f", decimals, value);
  return buffer.data();
}

std::string short_number(double value) {
  std::array<char, 32> buffer{};
  const bool plain = value == 0.0 || (std::abs(value) >= 1e-4 && std::abs(value) < 1e6);
  const int length = std::snprintf(buffer.data(), buffer.size(), plain ? "%.4g" : "%.3e", value);
  return {buffer.data(), static_cast<std::size_t>(length)};
}

std::string plural(std::int64_t count, std::string_view one, std::string_view many) {
  return std::to_string(count) + " " + std::string(count == 1 ? one : many);
}
std::string percent_text(double share) {
  const double percent = 100.0 * share;
  const bool small = percent < 0.95 && percent > 0.0;
  return short_number(small ? std::round(10.0 * percent) / 10.0 : std::round(percent)) + " %";
}
std::string stitch_count_text(std::int64_t count) { return plural(count, "stitch", "stitches"); }
std::string tube_name(std::int32_t tube) {
  std::string name;
  for (std::int32_t left = tube; left >= 0; left = left / 26 - 1)
    name.insert(name.begin(), static_cast<char>('A' + left % 26));
  return name;
}

std::string vertex_text(VertexId vertex) { return "vertex " + std::to_string(vertex); }

}  // namespace knit
