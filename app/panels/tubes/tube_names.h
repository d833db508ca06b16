// Which tubes of a drawing get their name, and where: as many as have room, the larger tubes first, none on another or on a line.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/panels/kit/layout.h"
#include "knit/tubes/plan.h"

namespace app {

// The places that would do for each name, the best first; names in the order in which they choose. A place is taken where it lies
// wholly within `ground` and on nothing that is `taken`, by names before it either. Without one: no place is free.
// O(names x their places x what is taken).
std::vector<std::optional<Box>> place_names(const std::vector<std::vector<Box>>& names,
                                            std::vector<Box> taken, const Box& ground);

// "B, D to I" for a narrow column: three or more in a row by the first and the last. In the order of their letters; "" of none.
std::string short_names(std::vector<knit::TubeId> tubes);

}  // namespace app
