// Sorting that is heard: many values, in stretches that are merged, each in a moment.
//
// `less` must tell any two values apart that are not the same, so that the order is the one that std::sort finds too.
// O(n log n), with a second copy of the values; O(n) where they are in order already.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "knit/model/heard.h"

namespace knit {

template <class Value, class Less>
void sort_heard(std::vector<Value>& values, Less less, const Heard& heard) {
  constexpr std::size_t stretch = 32768;
  if (std::is_sorted(values.begin(), values.end(), less)) return;
  const std::size_t size = values.size();
  const auto at = [size](std::vector<Value>& of, std::size_t i) {
    return of.begin() + static_cast<std::ptrdiff_t>(std::min(i, size));
  };
  for (std::size_t i = 0; i < size; i += stretch) {
    hear(heard, 0.5 * static_cast<double>(i) / static_cast<double>(size));
    std::sort(at(values, i), at(values, i + stretch), less);
  }
  std::vector<Value> merged;
  for (std::size_t length = stretch; length < size; length *= 2) {
    merged.resize(size);
    for (std::size_t i = 0; i < size; i += 2 * length) {
      hear(heard, 0.5);
      std::merge(at(values, i), at(values, i + length), at(values, i + length), at(values, i + 2 * length),
                 at(merged, i), less);
    }
    values.swap(merged);
  }
}

}  // namespace knit
