// The pseudo-code of the stage tubes.
#pragma once

#include "knit/model/pseudo_code.h"

namespace knit {

extern const PseudoCode tubes_code;

}  // namespace knit
