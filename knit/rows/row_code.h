// The pseudo-code of cast on and rows. Algorithm 2 keeps the order in which it is printed; its vn is vi
// here, because n counts stitches.
#pragma once

#include "knit/model/pseudo_code.h"

namespace knit {

extern const PseudoCode rows_choice_code;
extern const PseudoCode cast_on_code;
extern const PseudoCode ring_code;
extern const PseudoCode contour_code;

}  // namespace knit
