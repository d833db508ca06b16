#include "knit/rows/body_halves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "knit/fabric/edges.h"
#include "knit/model/ties.h"

namespace knit {

namespace {

// Where a curve crosses the plane, as arcs: farthest at the back and farthest at the front.
struct Crossings {
  double back = 0.0, front = 0.0;
};

std::optional<Crossings> crossings_of(const Ring& curve, const MirrorPlane& plane) {
  std::optional<Crossings> found;
  double backmost = 0.0, foremost = 0.0;
  for (const auto& [i, next] : Edges(curve.points.size(), true)) {
    const glm::dvec3 &a = curve.points[i], &b = curve.points[next];
    const double from = plane.height(a), to = plane.height(b);
    if ((from < 0.0) == (to < 0.0)) continue;
    const double share = from / (from - to);
    const double arc = curve.arc[i] + share * glm::length(b - a);
    const double towards_back = glm::dot(a + share * (b - a) - plane.point, plane.back);
    if (!found) {
      found = Crossings{arc, arc};
      backmost = foremost = towards_back;
      continue;
    }
    if (clearly_less(backmost, towards_back, curve.length)) {
      backmost = towards_back;
      found->back = arc;
    }
    if (clearly_less(towards_back, foremost, curve.length)) {
      foremost = towards_back;
      found->front = arc;
    }
  }
  if (!found || found->back == found->front) return std::nullopt;
  return found;
}

double ahead_of(double arc, double from, double length) {
  const double ahead = std::fmod(arc - from, length);
  return ahead < 0.0 ? ahead + length : ahead;
}

// The two ways from back to front, ahead and against it.
struct HalfCurves {
  const Ring* curve = nullptr;
  Crossings at;
  std::array<double, 2> length{};
  [[nodiscard]] glm::dvec3 place(std::size_t side, double share) const {
    const double way = share * length[side];
    return point_at(*curve, side == 0 ? at.back + way : at.back - way);
  }
  // How far on its way from back to front the place is that is nearest to `point`.
  [[nodiscard]] double share_of(std::size_t side, const glm::dvec3& point) const {
    const double ahead = ahead_of(nearest_arc(*curve, point), at.back, curve->length);
    const double way = side == 0 ? ahead : curve->length - ahead;
    if (way <= length[side]) return way / length[side];
    // On the other side: as near to the end that it lies beyond as may be.
    return way - length[side] < curve->length - way ? 1.0 : 0.0;
  }
};

std::optional<HalfCurves> sides_of(const Ring& curve, const MirrorPlane& plane) {
  constexpr double alike = 0.1;
  const auto at = crossings_of(curve, plane);
  if (!at) return std::nullopt;
  const double ahead = ahead_of(at->front, at->back, curve.length);
  if (std::abs(2.0 * ahead - curve.length) > alike * curve.length) return std::nullopt;
  return HalfCurves{&curve, *at, {ahead, curve.length - ahead}};
}

// How many stitches the back half gets instead of `back`, so that no half changes by more than a round gives or takes it. Where the
// whole changes by more than both can, they share that.
double within_reach(double back, double whole, double front_before, double back_before) {
  constexpr double most = most_a_half_changes;
  const double least_back = std::max(back_before - most, whole - front_before - most);
  const double most_back = std::min(back_before + most, whole - front_before + most);
  if (least_back > most_back) return back_before + (whole - front_before - back_before) / 2.0;
  return std::clamp(back, least_back, most_back);
}

}  // namespace

std::optional<double> back_arc(const Ring& curve, const MirrorPlane& plane) {
  const auto at = crossings_of(curve, plane);
  return at ? std::optional(at->back) : std::nullopt;
}

std::optional<std::int32_t> back_stitch(std::span<const glm::dvec3> loop, const Ring& curve,
                                        const MirrorPlane& plane) {
  const auto back = back_arc(curve, plane);
  if (!back) return std::nullopt;
  const glm::dvec3 place = point_at(curve, *back);
  std::int32_t nearest = 0;
  for (std::size_t i = 1; i < loop.size(); ++i) {
    const double here = glm::distance(loop[i], place);
    const double least = glm::distance(loop[static_cast<std::size_t>(nearest)], place);
    if (clearly_less(here, least, curve.length)) nearest = static_cast<std::int32_t>(i);
  }
  return nearest;
}

std::optional<HalfIdeals> half_ideals(const Tube& tube, const MirrorPlane& plane, double stitch_width) {
  constexpr double long_enough = 0.15, nearest_to_an_end = 0.06;
  std::array<double, 2> share{0.5, 0.5};
  std::array<glm::dvec3, 2> main{};
  bool carried = false;
  HalfIdeals ideals;
  for (std::size_t row = 0; row < tube.curves.size(); ++row) {
    const auto sides = sides_of(*tube.curves[row], plane);
    if (!sides) return std::nullopt;
    for (const std::size_t side : {0U, 1U}) {
      if (carried)
        share[side] =
            std::clamp(sides->share_of(side, main[side]), nearest_to_an_end, 1.0 - nearest_to_an_end);
    }
    const double whole = tube.lengths[row] / stitch_width;
    const auto behind_now = [&] {
      return (share[0] * sides->length[0] + share[1] * sides->length[1]) / sides->curve->length;
    };
    if (carried) {
      const double kept = within_reach(behind_now() * whole, whole, ideals.front.back(), ideals.back.back());
      const double more = kept / whole - behind_now();
      for (double& one : share) one = std::clamp(one + more, nearest_to_an_end, 1.0 - nearest_to_an_end);
    }
    for (const std::size_t side : {0U, 1U}) main[side] = sides->place(side, share[side]);
    carried = carried || sides->curve->length > long_enough * tube.longest;
    const double behind = behind_now();
    ideals.front.push_back((1.0 - behind) * whole);
    ideals.back.push_back(behind * whole);
  }
  return ideals;
}

}  // namespace knit
