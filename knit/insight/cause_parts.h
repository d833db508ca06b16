// Why a row has its number of stitches, by what it is made from. Parts of causes.
#pragma once

#include <string>

#include "knit/insight/why.h"
#include "knit/model/words.h"

namespace knit {

// Each begins after "Row 7 has 33 stitches: ".
std::string why_picked(const Timeline& timeline, std::int32_t row);
std::string why_contour_count(const Timeline& timeline, std::int32_t row);

inline std::string whole_text(std::int64_t number) { return std::to_string(number); }

// "2nd"
inline std::string nth_text(std::int32_t n) {
  const std::int32_t last_two = n % 100, last = n % 10;
  const bool teens = last_two >= 11 && last_two <= 13;
  const char* const ending = teens ? "th" : last == 1 ? "st" : last == 2 ? "nd" : last == 3 ? "rd" : "th";
  return std::to_string(n) + ending;
}

}  // namespace knit
