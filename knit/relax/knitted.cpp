#include "knit/relax/knitted.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <numbers>

#include "knit/mesh/elementary.h"

namespace knit {

namespace {

using Places = std::span<const glm::dvec3>;

glm::dvec3 mean_place(Places at) {
  glm::dvec3 sum(0.0);
  for (const glm::dvec3& place : at) sum += place;
  return sum / static_cast<double>(std::max<std::size_t>(at.size(), 1));
}

Places stitches_of(const Fabric& fabric, const Row& row, Places at) {
  return at.subspan(fabric.first_on_path(row.id), row.stitches.size());
}

std::vector<glm::dvec3> middles_of(const Fabric& fabric, Places at) {
  std::vector<glm::dvec3> middles;
  for (const auto& row : fabric.rows()) middles.push_back(mean_place(stitches_of(fabric, *row, at)));
  return middles;
}

bool is_one_tube(const Fabric& fabric) { return fabric.deals().empty(); }

// By the power method on the middles' squares; `along` where they lie on one spot.
glm::dvec3 axis_of(const std::vector<glm::dvec3>& middles, const glm::dvec3& along) {
  const glm::dvec3 centre = mean_place(middles);
  glm::dvec3 axis = middles.back() - middles.front();
  if (glm::length(axis) == 0.0) return glm::normalize(along);
  axis = glm::normalize(axis);
  constexpr int turns = 64;
  for (int i = 0; i < turns; ++i) {
    glm::dvec3 next(0.0);
    for (const glm::dvec3& middle : middles) next += glm::dot(middle - centre, axis) * (middle - centre);
    const double length = glm::length(next);
    if (!(length > 0.0)) break;
    axis = next / length;
  }
  return axis;
}

struct Reach {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
};
Reach ends_along(Places at, const glm::dvec3& axis) {
  Reach ends;
  for (const glm::dvec3& place : at) {
    const double t = glm::dot(place, axis);
    ends.low = std::min(ends.low, t);
    ends.high = std::max(ends.high, t);
  }
  return ends;
}

double mean_along(Places at, const glm::dvec3& axis) { return glm::dot(mean_place(at), axis); }

double degrees_between(const glm::dvec3& a, const glm::dvec3& b) {
  if (glm::length(a) == 0.0 || glm::length(b) == 0.0) return 0.0;
  return angle_to(glm::dot(a, b), glm::length(glm::cross(a, b))) * 180.0 / std::numbers::pi;
}

// Between the directions of the first and the last eighth of the rows' middles.
double bend_of(const std::vector<glm::dvec3>& middles) {
  const std::size_t eighth = std::max<std::size_t>(middles.size() / 8, 1);
  if (middles.size() < 2 * eighth + 2) return 0.0;
  return degrees_between(middles[eighth] - middles.front(),
                         middles.back() - middles[middles.size() - 1 - eighth]);
}

double roundness(Places at) {
  const glm::dvec3 centre = mean_place(at);
  double near = std::numeric_limits<double>::infinity(), far = 0.0;
  for (const glm::dvec3& place : at) {
    const double length = glm::length(place - centre);
    near = std::min(near, length);
    far = std::max(far, length);
  }
  return near > 0.0 ? far / near : 1.0;
}

// Of rows that were placed round: where the shape is not, nothing else is wanted.
void find_rounding(const Fabric& fabric, Places placed, Places at, KnittedFigures& made) {
  constexpr std::size_t enough = 20;
  constexpr double round_enough = 1.1;
  std::vector<double> all;
  for (const auto& row : fabric.rows()) {
    if (!row->closed || row->stitches.size() < enough ||
        roundness(stitches_of(fabric, *row, placed)) > round_enough)
      continue;
    const double share = roundness(stitches_of(fabric, *row, at));
    all.push_back(share);
    if (!made.out_of_round || share > made.out_of_round->share) made.out_of_round = RowShare{row->id, share};
  }
  if (all.empty()) return;
  std::sort(all.begin(), all.end());
  made.out_of_round_median = all[all.size() / 2];
}

// The row of each stitch along the path; that before it of a bridge's.
std::vector<RowId> rows_of(const Fabric& fabric) {
  std::vector<RowId> rows(fabric.stitch_count(), 1);
  for (const auto& row : fabric.rows())
    std::fill(rows.begin() + fabric.first_on_path(row->id), rows.end(), row->id);
  return rows;
}

void find_stretch(const Fabric& fabric, const RelaxPlan& plan, Places at, const std::vector<RowId>& row_of,
                  KnittedFigures& made) {
  constexpr double much = 1.1;
  struct Sum {
    double shares = 0.0;
    std::size_t count = 0;
  };
  std::vector<Sum> rows(static_cast<std::size_t>(fabric.row_count()) + 1);
  made.least.share = std::numeric_limits<double>::infinity();
  made.greatest.share = 0.0;
  for (const Spring& spring : plan.net.springs) {
    if (spring.kind == SpringKind::shear || spring.kind == SpringKind::drawn) continue;
    const double share = glm::distance(at[spring.a], at[spring.b]) / spring.rest;
    const RowId row = row_of[spring.b];
    if (share < made.least.share) made.least = {row, share};
    if (share > made.greatest.share) made.greatest = {row, share};
    Sum& sum = rows[static_cast<std::size_t>(row)];
    sum.shares += share;
    ++sum.count;
  }
  for (const auto& row : fabric.rows()) {
    const Sum& sum = rows[static_cast<std::size_t>(row->id)];
    const double mean = sum.count > 0 ? sum.shares / static_cast<double>(sum.count) : 1.0;
    if (mean > much) made.stretched.push_back({row->id, mean});
  }
}

void find_turned(const Fabric& fabric, const std::vector<glm::dvec3>& before,
                 const std::vector<glm::dvec3>& after, KnittedFigures& made) {
  struct Stretch {
    RowId first = 0, last = 0;
  };
  std::map<TubeId, Stretch> tubes;
  for (const auto& row : fabric.rows()) {
    Stretch& stretch = tubes[row->tube];
    if (stretch.first == 0) stretch.first = row->id;
    stretch.last = row->id;
  }
  for (const auto& [tube, rows] : tubes) {
    const auto from = static_cast<std::size_t>(rows.first) - 1, to = static_cast<std::size_t>(rows.last) - 1;
    constexpr std::size_t enough = 3;
    if (to < from + enough) continue;
    const double degrees = degrees_between(before[to] - before[from], after[to] - after[from]);
    if (degrees > turned_from) made.turned.push_back({tube, rows.first, degrees});
  }
}

glm::dvec3 size_of(Places at) {
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
  for (const glm::dvec3& place : at) {
    low = glm::min(low, place);
    high = glm::max(high, place);
  }
  return high - low;
}

}  // namespace

Extent extent_of(const Fabric& fabric, Places at, const glm::dvec3& along) {
  const std::vector<glm::dvec3> middles = middles_of(fabric, at);
  const bool one = is_one_tube(fabric);
  const glm::dvec3 axis = one ? axis_of(middles, along) : glm::normalize(along);
  const Reach ends = ends_along(at, axis);
  Extent extent{ends.high - ends.low, 0.0};
  if (one) {
    const glm::dvec3 centre = mean_place(middles);
    for (const auto& row : fabric.rows()) {
      double sum = 0.0;
      for (const glm::dvec3& place : stitches_of(fabric, *row, at)) {
        const glm::dvec3 out = place - centre;
        sum += glm::length(out - glm::dot(out, axis) * axis);
      }
      extent.width = std::max(extent.width, 2.0 * sum / static_cast<double>(row->stitches.size()));
    }
    return extent;
  }
  // Across: the widest of 36 directions.
  const glm::dvec3 aside = std::abs(axis.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
  const glm::dvec3 u = glm::normalize(glm::cross(axis, aside)), v = glm::cross(axis, u);
  constexpr int directions = 36;
  for (int i = 0; i < directions; ++i) {
    const double angle = std::numbers::pi * i / directions;
    const Reach across = ends_along(at, cosine(angle) * u + sine(angle) * v);
    extent.width = std::max(extent.width, across.high - across.low);
  }
  return extent;
}

KnittedFigures knitted_figures(const Fabric& fabric, const RelaxPlan& plan, const Relaxed& relaxed,
                               const glm::dvec3& along) {
  KnittedFigures made;
  const Places before = plan.start, after = relaxed.positions;
  const std::vector<glm::dvec3> middles_before = middles_of(fabric, before),
                                middles_after = middles_of(fabric, after);
  made.placed = extent_of(fabric, before, along);
  made.knitted = extent_of(fabric, after, along);
  if (is_one_tube(fabric)) {
    const glm::dvec3 axis = axis_of(middles_after, along);
    const Reach ends = ends_along(after, axis);
    const auto row_at = [&](RowId id) {
      return mean_along(stitches_of(fabric, fabric.row(id), after), axis);
    };
    made.sunk = {row_at(1) - ends.low, ends.high - row_at(fabric.row_count())};
    made.bend_placed = bend_of(middles_before);
    made.bend_knitted = bend_of(middles_after);
  } else {
    find_turned(fabric, middles_before, middles_after, made);
  }
  find_rounding(fabric, before, after, made);
  const std::vector<RowId> row_of = rows_of(fabric);
  find_stretch(fabric, plan, after, row_of, made);
  const Enclosure all = enclosure_of(fabric);
  const double volume = volume_of(all, before);
  if (volume != 0.0) made.volume_share = volume_of(all, after) / volume;
  const glm::dvec3 size_before = size_of(before), size_after = size_of(after);
  for (int axis = 0; axis < 3; ++axis) {
    if (size_before[axis] > 0.0) made.extent_share[axis] = size_after[axis] / size_before[axis];
  }
  for (const auto& [a, b] : relaxed.touching) {
    const auto [low, high] = std::minmax(row_of[a], row_of[b]);
    made.touching.push_back({low, high});
  }
  std::sort(made.touching.begin(), made.touching.end());
  made.touching.erase(std::unique(made.touching.begin(), made.touching.end()), made.touching.end());
  return made;
}

}  // namespace knit
