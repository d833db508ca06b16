// The pseudo-code of short rows.
#pragma once

#include "knit/model/pseudo_code.h"

namespace knit {

extern const PseudoCode short_rows_code;

}  // namespace knit
