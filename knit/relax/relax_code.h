// The pseudo-code of relaxing in the air.
#pragma once

#include "knit/model/pseudo_code.h"

namespace knit {

extern const PseudoCode relax_code;

}  // namespace knit
