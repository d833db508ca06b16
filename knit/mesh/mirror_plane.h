// Whether a mesh is its own mirror image in a plane along its axis, and in which.
//
// 24,000 samples lie over the surface, each for the same area: sample i stands where the areas of the triangles before it add up
// to (i + 1/2) / 24,000 of all, within its triangle by the additive recurrence of the plastic number. Every twelfth of
// them is reflected in a plane and set against the nearest sample; a plane is as good as the mean of these distances is
// small. Planes hold the samples' middle and the axis and stand every 2 degrees. A first look with every 48th sample leaves
// a few planes to be measured whole; a plane is given up as soon as it is worse than the best. Samples strewn by chance would be
// chance = sqrt(area / samples) / 2 from the nearest, whatever the plane: 1.6 times that still counts as a mirror image.
// Cost: N log N for a tree of the samples, then a few ten thousand searches in it.
// Of planes that are alike within 2 %, as in a solid of revolution, the first.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <tuple>

#include "knit/mesh/mesh.h"

namespace knit {

// A plane along the axis in which a shape is its own mirror image.
struct MirrorPlane {
  glm::dvec3 point{0.0}, normal{1.0, 0.0, 0.0};  // the normal is a unit vector across the axis
  glm::dvec3 back{0.0, 0.0, -1.0};  // within the plane, across the axis: a unit vector; rounds begin there
  [[nodiscard]] double height(const glm::dvec3& p) const { return glm::dot(p - point, normal); }
  [[nodiscard]] glm::dvec3 reflect(const glm::dvec3& p) const { return p - 2.0 * height(p) * normal; }
  [[nodiscard]] auto fields() const { return std::tie(point, normal, back); }
  friend bool operator==(const MirrorPlane&, const MirrorPlane&) = default;
};

struct MirrorMeasure {
  double degrees = 0.0;  // of the normal, from (right x axis) towards right
  double apart = 0.0;    // mean distance from a reflected sample to the nearest, in mesh units
  double chance = 0.0;   // of samples strewn by chance
  MirrorPlane plane;
  [[nodiscard]] bool is_mirror() const { return apart < 1.6 * chance; }
};

// The best plane, a mirror or not. `axis` and `right` are unit vectors at right angles; the plane's back is the side that `right`
// points to. None: the mesh has no area.
std::optional<MirrorMeasure> measure_mirror(const Mesh& mesh, const glm::dvec3& axis,
                                            const glm::dvec3& right);
// None: there is no mirror image.
std::optional<MirrorPlane> find_mirror_plane(const Mesh& mesh, const glm::dvec3& axis,
                                             const glm::dvec3& right);

}  // namespace knit
