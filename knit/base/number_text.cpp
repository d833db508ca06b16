#include "knit/base/number_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>

namespace knit {

namespace {

constexpr int most_digits = 17;  // tell any two doubles apart

const char* after_digits(const char* at, const char* end) {
  return std::find_if(at, end, [](char c) { return c < '0' || c > '9'; });
}

// The end of the number that the text begins with; `begin`: none.
const char* end_of_number(const char* begin, const char* end) {
  const char* at = begin != end && *begin == '-' ? begin + 1 : begin;
  const char* const whole = at;
  at = after_digits(at, end);
  auto digits = at - whole;
  if (at != end && *at == '.') {
    const char* const after = after_digits(at + 1, end);
    digits += after - (at + 1);
    at = after;
  }
  if (digits == 0) return begin;
  if (at == end || (*at != 'e' && *at != 'E')) return at;
  const char* const power = at + 1 != end && (at[1] == '-' || at[1] == '+') ? at + 2 : at + 1;
  const char* const after = after_digits(power, end);
  return after == power ? at : after;
}

std::to_chars_result put(char* begin, char* end, const char* text) {
  const std::size_t length = std::strlen(text);
  if (static_cast<std::size_t>(end - begin) < length) return {end, std::errc::value_too_large};
  return {std::copy_n(text, length, begin), std::errc()};
}

}  // namespace

std::from_chars_result plain_number_from(const char* begin, const char* end, double& value) {
  const char* const stop = end_of_number(begin, end);
  if (stop == begin) return {begin, std::errc::invalid_argument};
  const std::string text(begin, stop);
  const double read = std::strtod(text.c_str(), nullptr);
  if (std::isinf(read)) return {stop, std::errc::result_out_of_range};
  const std::string digits = text.substr(0, text.find_first_of("eE"));
  if (read == 0.0 && digits.find_first_of("123456789") != std::string::npos)
    return {stop, std::errc::result_out_of_range};
  value = read;
  return {stop, std::errc()};
}

std::to_chars_result plain_number_into(char* begin, char* end, double value) {
  std::array<char, 32> power{};
  int digits = 1;
  for (; digits <= most_digits; ++digits) {
    std::snprintf(power.data(), power.size(), "%.*e", digits - 1, value);
    if (std::strtod(power.data(), nullptr) == value) break;
  }
  if (!std::isfinite(value)) return put(begin, end, power.data());
  const int exponent = std::atoi(std::strchr(power.data(), 'e') + 1);
  std::array<char, 400> fixed{};
  std::snprintf(fixed.data(), fixed.size(), "%.*f", std::max(0, digits - 1 - exponent), value);
  const bool is_fixed = std::strlen(fixed.data()) <= std::strlen(power.data());
  return put(begin, end, is_fixed ? fixed.data() : power.data());
}

std::to_chars_result plain_number_into(char* begin, char* end, double value, int digits) {
  std::array<char, 400> text{};
  std::snprintf(text.data(), text.size(), "%.*g", digits, value);
  return put(begin, end, text.data());
}

#if defined(__cpp_lib_to_chars)

std::from_chars_result number_from(const char* begin, const char* end, double& value) {
  return std::from_chars(begin, end, value);
}
std::to_chars_result number_into(char* begin, char* end, double value) {
  return std::to_chars(begin, end, value);
}
std::to_chars_result number_into(char* begin, char* end, double value, int digits) {
  return std::to_chars(begin, end, value, std::chars_format::general, digits);
}

#else

std::from_chars_result number_from(const char* begin, const char* end, double& value) {
  return plain_number_from(begin, end, value);
}
std::to_chars_result number_into(char* begin, char* end, double value) {
  return plain_number_into(begin, end, value);
}
std::to_chars_result number_into(char* begin, char* end, double value, int digits) {
  return plain_number_into(begin, end, value, digits);
}

#endif

}  // namespace knit
