// The least of many values, without sorting them all.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

namespace knit {

// Puts the `count` least values in front, and the least of the others right behind them. `less` must tell any two
// apart. In which order the rest lies differs from one standard library to another: nothing may hang on it.
template <class Value, class Less>
void put_least_first(std::span<Value> values, std::size_t count, Less less) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count), values.end(), less);
}

}  // namespace knit
