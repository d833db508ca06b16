#include "app/facing/turn_view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <vector>

#include "app/describe/thing_places.h"
#include "app/scene/scene.h"
#include "app/session/document.h"
#include "app/session/shown.h"
#include "app/session/view.h"

namespace app {

namespace {

constexpr double faces_viewer = 0.5;   // cosine of the angle between what is outward and the eye's direction
constexpr double steepest_look = 1.2;  // radians: ends are looked at a little from the side
constexpr double inner_screen = 0.9;   // of the view's half: farther out it is brought to the middle

std::optional<glm::dvec3> middle_of_outline(std::span<const glm::dvec3> outline) {
  if (outline.empty()) return std::nullopt;
  glm::dvec3 sum(0.0);
  for (const glm::dvec3& point : outline) sum += point;
  return sum / static_cast<double>(outline.size());
}

// From the middle of the mesh through the point; none at the middle itself.
std::optional<glm::dvec3> outward(const knit::Bounds& bounds, const glm::dvec3& at) {
  const glm::dvec3 way = at - bounds.centre();
  const double length = glm::length(way);
  if (!(length > 1e-9 * bounds.radius)) return std::nullopt;
  return way / length;
}

double facing(const Camera& camera, const glm::dvec3& out) {
  return glm::dot(out, glm::normalize(camera.eye() - camera.target));
}

bool well_on_screen(const Camera& camera, double aspect, const glm::dvec3& at) {
  const Sight sight = camera.view(aspect);
  const glm::vec4 clip = sight.projection * sight.view * glm::vec4(glm::vec3(at), 1.0F);
  if (!(clip.w > 0.0F)) return false;
  const float most = static_cast<float>(inner_screen) * clip.w;
  return std::abs(clip.x) <= most && std::abs(clip.y) <= most;
}

Camera turned_to_place(const Session& session, const glm::dvec3& at) {
  Camera camera = session.view->gaze.camera;
  const auto out = outward(session.document->timeline.input().bounds, at);
  if (out && facing(camera, *out) < faces_viewer) {
    const bool upright = std::abs(out->x) + std::abs(out->z) < 1e-9;
    if (!upright) camera.yaw = std::atan2(out->x, out->z);
    camera.pitch = std::clamp(std::asin(std::clamp(out->y, -1.0, 1.0)), -steepest_look, steepest_look);
  }
  if (!well_on_screen(camera, session.view->aspect, at)) camera.target = at;
  return camera;
}

}  // namespace

Camera turned_to(const Session& session, const knit::Element& thing) {
  const knit::Timeline& timeline = session.document->timeline;
  auto at = middle_of_outline(outline_of(timeline.input(), shown_state(session), thing));
  if (!at) at = middle_of_outline(outline_of(timeline.input(), timeline.furthest(), thing));
  return at ? turned_to_place(session, *at) : session.view->gaze.camera;
}

Camera turned_to(const Session& session, const knit::SizeRange& range) {
  const knit::Timeline& timeline = session.document->timeline;
  const knit::Bounds& bounds = timeline.input().bounds;
  std::optional<glm::dvec3> best;
  double most = -2.0;
  for (const knit::SizedThing& thing :
       knit::things_of_size(shown_state(session), timeline.parameters().stitch, range)) {
    const glm::dvec3 at = *middle_of_outline(thing.outline());
    const auto out = outward(bounds, at);
    const double now = out ? facing(session.view->gaze.camera, *out) : -1.0;
    if (now <= most) continue;
    most = now;
    best = at;
  }
  return best ? turned_to_place(session, *best) : session.view->gaze.camera;
}

}  // namespace app
