#include "app/scene/stretch_colour.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

std::uint8_t between(std::uint8_t from, std::uint8_t to, double share) {
  return static_cast<std::uint8_t>(std::lround(from + share * (to - from)));
}

Colour mixed(Colour from, Colour to, double share) {
  return {between(from.r, to.r, share), between(from.g, to.g, share), between(from.b, to.b, share)};
}

}  // namespace

double strain_of(double stretch, double full) {
  if (!(stretch > 0.0)) return -1.0;
  return std::clamp(std::log(stretch) / std::log(full), -1.0, 1.0);
}

Colour strain_colour(const Theme& theme, double strain) {
  return mixed(theme.stretch_even, strain < 0.0 ? theme.stretch_short : theme.stretch_long, std::abs(strain));
}

Colour stretch_colour(const Theme& theme, double stretch, double full) {
  return strain_colour(theme, strain_of(stretch, full));
}

}  // namespace app
