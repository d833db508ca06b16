// The pseudo-code of settling.
#pragma once

#include "knit/model/pseudo_code.h"

namespace knit {

extern const PseudoCode settle_code;

}  // namespace knit
