// Which rows tubes keep beside events, and whether there are short rows at all.
//
// No number is best on every shape, and on many none is better than no short rows. So each is worked out and settled. A way whose
// wales come out clearly less even than without short rows, or whose longest wale is long and clearly longer, is no way:
// what evens most wales may pull a few beside its turns, and those are seen. Of the rest the one of the least settled sum a
// stitch is taken; of equal ones the first: no short rows, then fewest rows kept. Where no arc of any tube pays, nothing has to settle. A piece of one tube has no events, so only 0 is tried there. Where nothing can be settled
// ahead, a piece of one tube gets its pairs, and one that branches none: there lag is too often a phantom.
#pragma once

#include <cstdint>
#include <span>
#include <tuple>

#include "knit/short_rows/pair_plan.h"

namespace knit {

inline constexpr std::int32_t no_short_rows = -1;

// What a choice is made for: of another stitch or at other prices it says nothing.
struct ChosenFor {
  double stitch_width = 0.0, stitch_height = 0.0;
  PairSettings settings;
  [[nodiscard]] auto fields() const {
    return std::tie(stitch_width, stitch_height, settings.turn_cost, settings.turn_step, settings.shortest);
  }
  friend bool operator==(const ChosenFor&, const ChosenFor&) = default;
};

// What decided.
enum class ChosenBy : std::uint8_t {
  settling,     // the least sum
  wales,        // short rows that settled to a lesser sum left wales less even, or a longer one
  no_arc_pays,  // anywhere
  unsettled,    // stitches shall not settle, so that ways cannot be compared
  too_many      // stitches: settling each way would take too long
};

// Of a piece with more each way is not settled.
inline constexpr double most_stitches_to_try = 10000.0;

struct KeptTry {
  std::int32_t kept = no_short_rows;
  std::int32_t pairs = 0;     // that are worked
  std::int32_t stitches = 0;  // of the whole piece
  float wale_cv = 0.0F;       // settled: standard deviation of the wales' lengths / mean
  float sum = 0.0F;           // a stitch, settled; infinite where the run stopped
  float longest_wale = 0.0F;  // settled; in stitch heights
  [[nodiscard]] auto fields() const { return std::tie(kept, pairs, stitches, wale_cv, sum, longest_wale); }
  friend bool operator==(const KeptTry&, const KeptTry&) = default;
};

// A wale that is longer than that is seen, in stitch heights.
inline constexpr float long_wale = 1.2F;
// So much longer (times) and less even (coefficient of variation) is seen at all.
inline constexpr float clearly_longer = 1.03F, clearly_less_even = 0.005F;

// Whether the wales of `with` are as even as those without short rows, and no long one is longer than their longest, but for
// what nobody sees. What can't be worked is worse than anything that can.
bool never_worse(const KeptTry& with, const KeptTry& without);

// Requires one at least, and that the first is without short rows.
const KeptTry& best_of(std::span<const KeptTry> tries);

}  // namespace knit
