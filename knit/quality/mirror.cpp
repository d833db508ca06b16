#include "knit/quality/mirror.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace knit {

namespace {

struct Plane {
  glm::dvec3 point{0.0}, normal{0.0};
  [[nodiscard]] double height(const glm::dvec3& p) const { return glm::dot(p - point, normal); }
  [[nodiscard]] glm::dvec3 reflect(const glm::dvec3& p) const { return p - 2.0 * height(p) * normal; }
};

std::optional<Plane> mirror_plane(const Input& input, const State& state) {
  // Of one tube: what branches has its mirror image in another tube.
  if (!state.timing || state.fabric.empty() || !state.fabric.deals().empty()) return std::nullopt;
  const auto largest =
      std::max_element(state.fabric.rows().begin(), state.fabric.rows().end(),
                       [](const auto& a, const auto& b) { return a->stitches.size() < b->stitches.size(); });
  const std::vector<Stitch>& stitches = (*largest)->stitches;
  glm::dvec3 middle(0.0);
  for (const Stitch& stitch : stitches) middle += stitch.position;
  middle /= static_cast<double>(stitches.size());
  const glm::dvec3 begin = stitches.front().position - middle;
  const glm::dvec3 axis = state.timing->ends.direction;
  const glm::dvec3 normal = glm::cross(axis, begin);
  const double size = glm::length(normal);
  if (size <= 1e-9 * glm::length(axis) * glm::length(begin)) return std::nullopt;
  return Plane{input.centroid, normal / size};
}

struct Wale {
  double height = 0.0;  // of the lower end, over the plane
  glm::dvec3 lower{0.0}, upper{0.0};
};

double apart(const Wale& a, const Wale& b) {
  return std::max(glm::distance(a.lower, b.lower), glm::distance(a.upper, b.upper));
}

// To the nearest of `wales`, which rise by height. Two are at least as far apart as their heights, which ends
// the search early wherever rows begin.
double nearest(const std::vector<Wale>& wales, const Wale& image) {
  const auto middle = std::lower_bound(wales.begin(), wales.end(), image.height,
                                       [](const Wale& wale, double height) { return wale.height < height; });
  double best = std::numeric_limits<double>::infinity();
  auto up = middle;
  auto down = middle;
  for (bool more = true; more;) {
    more = false;
    if (up != wales.end() && up->height - image.height < best) {
      best = std::min(best, apart(image, *up++));
      more = true;
    }
    if (down != wales.begin() && image.height - std::prev(down)->height < best) {
      best = std::min(best, apart(image, *--down));
      more = true;
    }
  }
  return best;
}

}  // namespace

std::optional<MirrorError> mirror_error(const Input& input, const State& state, double stitch_width) {
  const std::optional<Plane> plane = mirror_plane(input, state);
  if (!plane) return std::nullopt;
  const std::vector<glm::dvec3> path = knitting_path(state.fabric);
  MirrorError error;
  std::size_t count = 0;
  for (const auto& strip : state.fabric.strips()) {
    std::vector<Wale> wales;
    for (const auto& [lower, upper] : strip->column_edges) {
      wales.push_back({plane->height(path[lower]), path[lower], path[upper]});
    }
    std::stable_sort(wales.begin(), wales.end(),
                     [](const Wale& a, const Wale& b) { return a.height < b.height; });
    for (const Wale& wale : wales) {
      const Wale image{-wale.height, plane->reflect(wale.lower), plane->reflect(wale.upper)};
      const double distance = nearest(wales, image) / stitch_width;
      error.mean += distance;
      error.max = std::max(error.max, distance);
    }
    count += wales.size();
  }
  if (count == 0) return std::nullopt;
  error.mean /= static_cast<double>(count);
  return error;
}

}  // namespace knit
