// Numbers read and written without a library's help, held against the library's own.
#include "knit/base/number_text.h"

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <string_view>

#include "knit/base/bits.h"
#include "tests/support/catch.h"

namespace {

std::string shortest(double value) {
  std::array<char, 512> room{};
  const auto end = knit::plain_number_into(room.data(), room.data() + room.size(), value);
  return {room.data(), end.ptr};
}
std::string shortest_of_library(double value) {
  std::array<char, 512> room{};
  const auto end = std::to_chars(room.data(), room.data() + room.size(), value);
  return {room.data(), end.ptr};
}
std::string rounded(double value, int digits) {
  std::array<char, 512> room{};
  const auto end = knit::plain_number_into(room.data(), room.data() + room.size(), value, digits);
  return {room.data(), end.ptr};
}
std::string rounded_by_library(double value, int digits) {
  std::array<char, 512> room{};
  const auto end =
      std::to_chars(room.data(), room.data() + room.size(), value, std::chars_format::general, digits);
  return {room.data(), end.ptr};
}

}  // namespace

TEST_CASE("number text: written as the library writes it") {
  std::mt19937_64 dice(7);
  std::uniform_real_distribution<double> plain(-1000.0, 1000.0);
  for (int i = 0; i < 20000; ++i) {
    const double value = i % 2 == 0 ? plain(dice) : knit::bits_as<double>(std::uint64_t{dice()});
    if (!std::isfinite(value)) continue;
    CAPTURE(value);
    REQUIRE(std::strtod(shortest(value).c_str(), nullptr) == value);
    REQUIRE(shortest(value).size() <= shortest_of_library(value).size());
    REQUIRE(rounded(value, 6) == rounded_by_library(value, 6));
  }
  for (const double value : {0.0, -0.0, 0.1, 1.0 / 3.0, 100.0, 1e21, 1e-7, 5e-324, 0.0269, 12.0})
    CHECK(shortest(value) == shortest_of_library(value));
}

TEST_CASE("number text: read as the library reads it") {
  for (const std::string_view text :
       {"0",     "-0", "12", "0.5", ".5", "5.",  "-3.25e2", "1e-3",   "1e+3", "1e",  "1e+", "12cm",
        "1.2.3", "-",  "",   " 1",  "+1", "1,5", "1e400",   "1e-400", "0x10", "--1", "e5",  "."}) {
    CAPTURE(text);
    const char* const begin = text.data();
    const char* const end = begin + text.size();
    double own = -7.0, of_library = -7.0;
    const auto read = knit::plain_number_from(begin, end, own);
    const auto by_library = std::from_chars(begin, end, of_library);
    CHECK(read.ec == by_library.ec);
    CHECK(read.ptr == by_library.ptr);
    CHECK(own == of_library);
  }
}

TEST_CASE("number text: too little room is said") {
  std::array<char, 3> room{};
  CHECK(knit::plain_number_into(room.data(), room.data() + room.size(), 0.125).ec ==
        std::errc::value_too_large);
}
