// Numbers read from text and written as text, the same whatever the machine's language: std::from_chars and
// std::to_chars, and what stands in for them where the library has none for doubles (libc++ 13, the page's).
//
// Arguments and results are those of <charconv>. Whole numbers take the same names.
#pragma once

#include <charconv>
#include <concepts>

namespace knit {

std::from_chars_result number_from(const char* begin, const char* end, double& value);
// The shortest text that reads as the same number.
std::to_chars_result number_into(char* begin, char* end, double value);
// With so many digits that count, as printf's %g writes them.
std::to_chars_result number_into(char* begin, char* end, double value, int digits);

template <std::integral Whole>
std::from_chars_result number_from(const char* begin, const char* end, Whole& value) {
  return std::from_chars(begin, end, value);
}
template <std::integral Whole>
std::to_chars_result number_into(char* begin, char* end, Whole value) {
  return std::to_chars(begin, end, value);
}

// What stands in, built everywhere so that it can be held against the library's own. It takes decimal digits alone:
// no infinity, no NaN. Requires the C locale of numbers, which every program has that sets none.
std::from_chars_result plain_number_from(const char* begin, const char* end, double& value);
std::to_chars_result plain_number_into(char* begin, char* end, double value);
std::to_chars_result plain_number_into(char* begin, char* end, double value, int digits);

}  // namespace knit
