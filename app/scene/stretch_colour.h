// The colour of what is too short, at ease or too long, by the logarithm: half as long is as far from 1 as twice as long.
#pragma once

#include "app/scene/palette.h"

namespace app {

inline constexpr double full_stretch = 1.5;      // from there on, and from its inverse down, colours are full
inline constexpr double full_in_the_air = 1.15;  // where stuffing stretches fabric by some hundredths

// -1 as short as is told, 0 at ease, 1 as long.
double strain_of(double stretch, double full);
Colour strain_colour(const Theme& theme, double strain);
// Of a stretch above 0.
Colour stretch_colour(const Theme& theme, double stretch, double full = full_stretch);

}  // namespace app
