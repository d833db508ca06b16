// The listings themselves, by the stage that they tell of. Use code_of().
#pragma once

#include "app/explain/pseudo_code.h"

namespace app {

const PseudoCode& timing_code(Listing listing);  // timing_...
const PseudoCode& rows_code(Listing listing);    // cast_on, rows_...
const PseudoCode& stitch_code(Listing listing);  // index_..., faces, pattern

}  // namespace app
