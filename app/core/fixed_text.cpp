#include "app/core/fixed_text.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace app {

std::string fixed_text(double value, int decimals) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, std::abs(value));
  const std::string digits(text.data());
  // What rounds to zero has no sign.
  const bool negative = value < 0.0 && digits.find_first_of("123456789") != std::string::npos;
  return negative ? "\xE2\x88\x92" + digits : digits;
}

}  // namespace app
