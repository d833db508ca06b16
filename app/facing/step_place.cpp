#include "app/facing/step_place.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "app/describe/describe_motion.h"
#include "app/session/document.h"
#include "knit/mesh/triangle_tree.h"

namespace app {

namespace {

constexpr double in_sight = 1.2;       // radians between the normal and the way to the eye
constexpr double near_enough = 0.01;   // radians beyond that
constexpr double turning_s = 0.3;      // in which two thirds of the way are gone
constexpr double fastest_turn = 2.5;   // radians a second
constexpr double steepest_turn = 1.3;  // radians: the turntable's up stays up

double distance_to_box(const glm::dvec3& point, const knit::Input::Box& box) {
  return glm::distance(point, glm::clamp(point, box.low, box.high));
}

// Of the nearest triangle with an area. A box is passed over when it is no nearer than the best so far.
glm::dvec3 normal_at(const knit::Input& input, const glm::dvec3& at) {
  const auto& triangles = input.mesh.triangles;
  double best = std::numeric_limits<double>::infinity();
  glm::dvec3 normal(0.0);
  for (std::size_t box = 0; box < input.boxes.size(); ++box) {
    if (distance_to_box(at, input.boxes[box]) >= best) continue;
    const std::size_t end = std::min(triangles.size(), (box + 1) * knit::Input::boxed);
    for (std::size_t i = box * knit::Input::boxed; i < end; ++i) {
      const auto& corners = triangles[i];
      const glm::dvec3 a = input.mesh.positions[corners[0]];
      const glm::dvec3 b = input.mesh.positions[corners[1]];
      const glm::dvec3 c = input.mesh.positions[corners[2]];
      const double distance = knit::distance_to_triangle(at, {a, b, c});
      const glm::dvec3 across = glm::cross(b - a, c - a);
      if (distance >= best || glm::length(across) <= 0.0) continue;
      best = distance;
      normal = glm::normalize(across);
    }
  }
  return normal;
}

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
}

}  // namespace

// Times are given all over the surface, one after the other.
std::optional<StepPlace> step_place(const Session& session) {
  if (!session.document) return std::nullopt;
  const knit::Step* step = last_step(session);
  if (step == nullptr || knit::is<knit::VertexTimed>(*step)) return std::nullopt;
  const auto at = place_of_step(session, *step);
  if (!at) return std::nullopt;
  const glm::dvec3 place(*at);
  const glm::dvec3 outward = normal_at(session.document->timeline.input(), place);
  return glm::length(outward) > 0.0 ? std::optional(StepPlace{place, outward}) : std::nullopt;
}

// A turntable's turns: about the upright and up or down, both there at once.
Camera turned_to(const Camera& camera, const StepPlace& place, double seconds) {
  const glm::dvec3& out = place.outward;
  const double excess = angle_between(out, glm::normalize(camera.eye() - place.at)) - in_sight;
  if (excess <= near_enough || !(seconds > 0.0)) return camera;
  const double round = 2.0 * std::numbers::pi;
  // Seen from straight above or below any side will do.
  const bool upright = out.x * out.x + out.z * out.z < 0.01;
  double yaw = upright ? 0.0 : std::atan2(out.x, out.z) - camera.yaw;
  yaw -= round * std::round(yaw / round);
  const double most = std::max(steepest_turn, std::abs(camera.pitch));
  const double pitch = std::clamp(std::asin(std::clamp(out.y, -1.0, 1.0)), -most, most) - camera.pitch;
  const double way = std::sqrt(yaw * yaw + pitch * pitch);
  const double by = std::min(excess * (1.0 - std::exp(-seconds / turning_s)), fastest_turn * seconds);
  const double share = way > by ? by / way : 1.0;
  Camera result = camera;
  result.yaw += share * yaw;
  result.pitch += share * pitch;
  return result;
}

}  // namespace app
