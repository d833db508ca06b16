// How well words can be told from what they stand on, as WCAG 2 counts it.
#pragma once

#include "app/scene/colour.h"

namespace app {

// What words of any size need at least.
inline constexpr double readable_contrast = 4.5;

// 1: the same; 21: black on white. Transparency does not count.
double contrast(const Colour& a, const Colour& b);

// The words' colour, opaque, mixed with white or with black, whichever the ground leaves more room for, only as far as it
// takes to be read on it.
Colour readable_on(const Colour& words, const Colour& ground);

}  // namespace app
