// The pseudo-code of the stage timing, in its four ways. Algorithm 1 keeps the order in which it is printed.
// Before them the one that chooses, until it has chosen.
#pragma once

#include "knit/model/pseudo_code.h"

namespace knit {

extern const PseudoCode timing_choice_code;
extern const PseudoCode linear_code;
extern const PseudoCode arc_length_code;
extern const PseudoCode geodesic_code;
extern const PseudoCode harmonic_code;

}  // namespace knit
