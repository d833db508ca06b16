// The pseudo-code of the stitch index by its three placements and of rhythms, of faces and of the pattern.
#pragma once

#include "knit/model/pseudo_code.h"

namespace knit {

extern const PseudoCode thesis_index_code;
extern const PseudoCode even_index_code;
extern const PseudoCode nearest_index_code;
extern const PseudoCode repeat_index_code;
extern const PseudoCode faces_code;
extern const PseudoCode pattern_code;

}  // namespace knit
