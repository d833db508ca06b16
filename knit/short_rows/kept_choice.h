// Which rows tubes keep beside events, and whether there are short rows at all.
//
// No number is best on every shape, and on many none is better than no short rows. So each is worked out and settled, and the one
// of the least settled sum a stitch is taken; of equal ones the first: no short rows, then fewest rows kept. Where no arc of
// any tube pays, nothing has to settle. A piece of one tube has no events, so only 0 is tried there.
#pragma once

#include <cstdint>
#include <span>
#include <tuple>

namespace knit {

inline constexpr std::int32_t no_short_rows = -1;

struct KeptTry {
  std::int32_t kept = no_short_rows;
  std::int32_t pairs = 0;     // that are worked
  std::int32_t stitches = 0;  // of the whole piece
  double sum = 0.0;           // a stitch, settled; infinite where the run stopped
  [[nodiscard]] auto fields() const { return std::tie(kept, pairs, stitches, sum); }
  friend bool operator==(const KeptTry&, const KeptTry&) = default;
};

// Requires one at least.
const KeptTry& best_of(std::span<const KeptTry> tries);

}  // namespace knit
