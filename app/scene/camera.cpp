#include "app/scene/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "app/scene/scene.h"

namespace app {

namespace {

constexpr double steepest = 1.55;  // just short of straight up, where the turntable's up is lost

struct Axes {
  glm::dvec3 right, up, back;
};

Axes axes_of(const Camera& camera) {
  const glm::dvec3 back(std::sin(camera.yaw) * std::cos(camera.pitch), std::sin(camera.pitch),
                        std::cos(camera.yaw) * std::cos(camera.pitch));
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), back));
  return {right, glm::cross(back, right), back};
}

// Half the width and height of what is seen at the target's depth.
glm::dvec2 half_extent(const Camera& camera, double aspect) {
  const double half_height = camera.distance * std::tan(0.5 * camera.field_of_view);
  return {half_height * aspect, half_height};
}

}  // namespace

glm::dvec3 Camera::eye() const { return target + axes_of(*this).back * distance; }

Sight Camera::view(double aspect) const {
  const glm::dvec3 from = eye();
  Sight result;
  result.view = glm::mat4(glm::lookAt(from, target, axes_of(*this).up));
  result.projection = glm::mat4(glm::perspective(field_of_view, aspect, distance * 0.02, distance * 20.0));
  result.eye = glm::vec3(from);
  return result;
}

void Camera::orbit(double yaw_change, double pitch_change) {
  yaw += yaw_change;
  pitch = std::clamp(pitch + pitch_change, -steepest, steepest);
}

void Camera::pan(const glm::dvec2& move, double aspect) {
  const Axes axes = axes_of(*this);
  const glm::dvec2 half = half_extent(*this, aspect);
  target -= axes.right * (move.x * half.x) + axes.up * (move.y * half.y);
}

void Camera::zoom(double factor, const glm::dvec2& cursor, double aspect) {
  const Axes axes = axes_of(*this);
  const glm::dvec2 before = half_extent(*this, aspect);
  distance *= factor;
  const glm::dvec2 moved = cursor * (before - half_extent(*this, aspect));
  target += axes.right * moved.x + axes.up * moved.y;
}

void Camera::frame(const knit::Bounds& bounds, double aspect) {
  target = bounds.centre();
  const double radius = std::max(bounds.radius, 1e-12);
  const double half_angle = std::atan(std::tan(0.5 * field_of_view) * std::min(1.0, aspect));
  distance = 1.08 * radius / std::sin(half_angle);
}

}  // namespace app
