// A camera on its way to another: as one who clicks on a figure sees where it goes.
#pragma once

#include "app/scene/camera.h"

namespace app {

inline constexpr double flight_s = 0.35;

struct CameraFlight {
  Camera from, to;
  double passed_s = 0.0;
  Camera left = from;  // where it has come to; a camera elsewhere was moved by a hand, which ends the flight
  friend bool operator==(const CameraFlight&, const CameraFlight&) = default;

  [[nodiscard]] bool over() const { return passed_s >= flight_s; }
};

// Begins slowly and ends slowly, and turns the short way round. At the end it is `to` to the bit.
Camera camera_at(const CameraFlight& flight);

}  // namespace app
