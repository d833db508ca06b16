// A turntable camera: it looks at a target from a yaw and a pitch, with the y axis up.
//
// Angles in radians, lengths in mesh units, screen positions in [-1, 1] from the view's centre, up and right
// positive.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "knit/mesh/mesh.h"

namespace app {

struct Sight;  // scene.h

struct Camera {
  glm::dvec3 target{0.0};
  double distance = 4.0;
  // 0: seen from +z; rising turns the viewer towards +x. Rows begin at -z, so one sees them begin.
  double yaw = 3.65;
  // 0: level; pi / 2: from above. Knitting begins below, so one looks up at it.
  double pitch = -0.42;
  double field_of_view = 0.7;  // vertical

  [[nodiscard]] glm::dvec3 eye() const;
  [[nodiscard]] Sight view(double aspect) const;

  void orbit(double yaw_change, double pitch_change);
  // Moves the target so that the point under the cursor stays there.
  void pan(const glm::dvec2& move, double aspect);
  // factor < 1 comes nearer; the place under the cursor keeps its place on the screen.
  void zoom(double factor, const glm::dvec2& cursor, double aspect);
  void frame(const knit::Bounds& bounds, double aspect);

  friend bool operator==(const Camera&, const Camera&) = default;
};

}  // namespace app
