#include "knit/quality/knit_surface.h"

namespace knit {

KnitSurface knit_surface(const State& state) {
  KnitSurface surface;
  surface.positions = knitting_path(state.fabric);
  const auto add = [&](const std::vector<Face>& faces) {
    for (const Face& face : faces) {
      const auto& c = face.corners;
      surface.triangles.push_back({c[0], c[1], c[2]});
      if (face.corner_count == 4) surface.triangles.push_back({c[0], c[2], c[3]});
    }
  };
  for (const auto& strip : state.fabric.strips()) add(strip->faces);
  for (const auto& deal : state.fabric.deals()) add(deal->faces);
  return surface;
}

}  // namespace knit
