#include "app/scene/flight.h"

#include <cmath>
#include <glm/common.hpp>
#include <numbers>

namespace app {

Camera camera_at(const CameraFlight& flight) {
  if (flight.over()) return flight.to;
  constexpr double round = 2.0 * std::numbers::pi;
  const Camera& from = flight.from;
  const Camera& to = flight.to;
  const double t = flight.passed_s / flight_s;
  const double share = t * t * (3.0 - 2.0 * t);
  const double turn = to.yaw - from.yaw;
  Camera camera = to;
  camera.target = from.target + share * (to.target - from.target);
  camera.distance = from.distance + share * (to.distance - from.distance);
  camera.yaw = from.yaw + share * (turn - round * std::round(turn / round));
  camera.pitch = from.pitch + share * (to.pitch - from.pitch);
  return camera;
}

}  // namespace app
