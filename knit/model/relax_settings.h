// What a person says of the knitted thing in the air: whether it is looked at, and how firmly it is stuffed.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace knit {

// The share by which stuffing stretches fabric on a ball, about.
inline constexpr double stuffing_soft = 0.02, stuffing_usual = 0.03, stuffing_firm = 0.05,
                        stuffing_hard = 0.1;

enum class Relaxing : std::uint8_t { off, on };

struct RelaxSettings {
  Relaxing relaxing = Relaxing::off;
  double stuffing = stuffing_usual;  // 0: none
  int most_iterations = 1500;
  friend bool operator==(const RelaxSettings&, const RelaxSettings&) = default;
};

}  // namespace knit
