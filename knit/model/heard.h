// Long work that is heard: it says how far it has come, and may be broken off where it says so.
//
// Shares run from 0 to 1 and never fall. What the listener throws breaks the work off, which leaves everything as it was.
// Work that is heard says so at least every twentieth of a second on a common machine; an empty Heard: nobody listens.
#pragma once

#include <cstddef>
#include <functional>

namespace knit {

using Heard = std::function<void(double share)>;

inline void hear(const Heard& heard, double share) {
  if (heard) heard(share);
}

// In a loop over `count` items of some nanoseconds each: now and then, at item `i`.
inline void hear_at(const Heard& heard, std::size_t i, std::size_t count) {
  constexpr std::size_t few = 8192;
  if (i % few == 0) hear(heard, count > 0 ? static_cast<double>(i) / static_cast<double>(count) : 0.0);
}

// A part of what is heard: its own 0 to 1 is `from` to `to` of the whole. Refers to `heard`.
inline Heard part_of(const Heard& heard, double from, double to) {
  if (!heard) return {};
  return [&heard, from, to](double share) { heard(from + (to - from) * share); };
}

}  // namespace knit
