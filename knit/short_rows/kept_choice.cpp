#include "knit/short_rows/kept_choice.h"

#include <algorithm>
#include <cmath>

namespace knit {

bool never_worse(const KeptTry& with, const KeptTry& without) {
  if (!std::isfinite(without.sum) || !std::isfinite(with.sum)) return std::isfinite(with.sum);
  return with.wale_cv <= without.wale_cv + clearly_less_even &&
         with.longest_wale <= std::max(long_wale, clearly_longer * without.longest_wale);
}

const KeptTry& best_of(std::span<const KeptTry> tries) {
  const KeptTry* best = &tries.front();
  for (const KeptTry& way : tries.subspan(1))
    if (way.sum < best->sum && never_worse(way, tries.front())) best = &way;
  return *best;
}

}  // namespace knit
