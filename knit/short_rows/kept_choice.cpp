#include "knit/short_rows/kept_choice.h"

#include <algorithm>

namespace knit {

const KeptTry& best_of(std::span<const KeptTry> tries) {
  return *std::min_element(tries.begin(), tries.end(),
                           [](const KeptTry& a, const KeptTry& b) { return a.sum < b.sum; });
}

}  // namespace knit
