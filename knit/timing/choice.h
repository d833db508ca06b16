// `--timing auto`: along the axis, unless too much of the surface lies flat across it, or rows would lie too unevenly.
//
// A row of linear time climbs 1 / s as far on the surface as along the axis, where s is the sine of the angle between the
// surface and the plane across the axis. Two figures say what that does:
//   flat        the share of the area with s < 0.05, where no row comes
//   unevenness  the standard deviation of (1 / s) over its mean, between two levels, over all of them, each piece of
//               level curve counted by its length: what the wales' lengths vary by before anything is knitted
// Either one beyond its limit makes the time geodesic. The limits are where it begins to be the better one over the shapes
// of docs/algorithm.md, Which timing. O(triangles).
#pragma once

#include <tuple>

#include "knit/mesh/mesh.h"
#include "knit/model/products.h"
#include "knit/model/settings.h"

namespace knit {

struct LevelFigures {
  double flat = 0.0;
  VertexId flat_at = no_vertex;  // of the largest flat triangle
  double unevenness = 0.0;
  VertexId uneven_at = no_vertex;  // of the triangle that adds most to it
  [[nodiscard]] auto fields() const { return std::tie(flat, flat_at, unevenness, uneven_at); }
  friend bool operator==(const LevelFigures&, const LevelFigures&) = default;
};

LevelFigures measure_levels(const Input& input, const Ends& ends);

inline constexpr double most_flat = 0.02, most_unevenness = 0.18;
inline bool is_too_flat(const LevelFigures& figures) { return figures.flat > most_flat; }
inline TimingKind better_timing(const LevelFigures& figures) {
  return is_too_flat(figures) || figures.unevenness > most_unevenness ? TimingKind::geodesic
                                                                      : TimingKind::linear;
}

}  // namespace knit
