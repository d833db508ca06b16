// Small parts that command lines are read with.
#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace app {

template <class Number>
std::optional<Number> whole_number(std::string_view text) {
  Number value{};
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || result.ec != std::errc() || result.ptr != text.data() + text.size())
    return std::nullopt;
  return value;
}

inline std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

// "a, b or c"
std::string one_of(std::span<const std::string_view> names);

// Numbers for tables and plots.

// With this many decimals; never "-0.00".
std::string fixed_text(double value, int decimals);

// Text inside XML and HTML.

// For between tags and in attributes in double quotes. What XML cannot hold (control characters) is left out.
std::string xml_text(std::string_view text);

// RFC 4648, with padding, in one line.
std::string base64(std::span<const std::uint8_t> bytes);

// Rounded to so many digits, without zeros at its end: for drawings in millimetres.
std::string trimmed_text(double value, int digits);
// ` name="value"`, for a tag.
std::string attribute(std::string_view name, double value, int digits = 3);
std::string attribute(std::string_view name, std::string_view value);

}  // namespace app
