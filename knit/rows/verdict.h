// Whether a distance lies in the band; where rounding alone keeps it out, it is within.
#pragma once

#include "knit/model/ties.h"
#include "knit/rows/rows.h"

namespace knit {

inline Verdict verdict_on(double distance, const Band& band) {
  if (clearly_less(distance, band.low, band.high)) return Verdict::too_near;
  return clearly_less(band.high, distance, band.high) ? Verdict::too_far : Verdict::accepted;
}

}  // namespace knit
