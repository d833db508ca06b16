#include "app/core/pick.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/vec4.hpp>
#include <limits>

#include "app/core/pick_ray.h"

namespace app {

namespace {

// Whether the ray comes through the box before `nearest`; a hair's breadth more counts, for rounding.
bool may_meet(const Ray& ray, const knit::Input::Box& box, double nearest) {
  const glm::dvec3 room = 1e-9 * (box.high - box.low + glm::abs(box.low) + glm::abs(box.high));
  double from = 0.0;
  double to = nearest;
  for (glm::length_t axis = 0; axis < 3; ++axis) {
    const double low = box.low[axis] - room[axis] - ray.origin[axis];
    const double high = box.high[axis] + room[axis] - ray.origin[axis];
    const double way = ray.direction[axis];
    if (way == 0.0) {
      if (low > 0.0 || high < 0.0) return false;
      continue;
    }
    from = std::max(from, std::min(low / way, high / way));
    to = std::min(to, std::max(low / way, high / way));
  }
  return from <= to * (1.0 + 1e-9);
}

}  // namespace

Ray ray_through(const Session& session, const glm::dvec2& place) {
  const View view = session.camera.view(session.aspect);
  const glm::dmat4 back = glm::inverse(glm::dmat4(view.projection) * glm::dmat4(view.view));
  const glm::dvec4 far = back * glm::dvec4(place.x, place.y, 1.0, 1.0);
  const glm::dvec3 eye = session.camera.eye();
  return {eye, glm::normalize(glm::dvec3(far) / far.w - eye)};
}

// Distance along the ray to the triangle, from either side (Moeller and Trumbore).
std::optional<double> meets(const Ray& ray, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 ab = b - a;
  const glm::dvec3 ac = c - a;
  const glm::dvec3 p = glm::cross(ray.direction, ac);
  const double determinant = glm::dot(ab, p);
  if (determinant == 0.0) return std::nullopt;
  const glm::dvec3 from_a = ray.origin - a;
  const double u = glm::dot(from_a, p) / determinant;
  const glm::dvec3 q = glm::cross(from_a, ab);
  const double v = glm::dot(ray.direction, q) / determinant;
  const double along = glm::dot(ac, q) / determinant;
  if (u < 0.0 || v < 0.0 || u + v > 1.0 || along <= 0.0) return std::nullopt;
  return along;
}

std::optional<SurfaceHit> hit_surface(const Session& session, const Ray& ray) {
  const knit::Mesh& mesh = session.timeline->input().mesh;
  double nearest = std::numeric_limits<double>::infinity();
  const knit::Triangle* hit = nullptr;
  const std::vector<knit::Input::Box>& boxes = session.timeline->input().boxes;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (!may_meet(ray, boxes[i], nearest)) continue;
    const std::size_t end = std::min((i + 1) * knit::Input::boxed, mesh.triangles.size());
    for (std::size_t k = i * knit::Input::boxed; k < end; ++k) {
      const knit::Triangle& t = mesh.triangles[k];
      const auto along = meets(ray, mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]);
      if (!along || *along >= nearest) continue;
      nearest = *along;
      hit = &t;
    }
  }
  if (hit == nullptr) return std::nullopt;
  const glm::dvec3 point = ray.origin + ray.direction * nearest;
  knit::VertexId best = (*hit)[0];
  for (const knit::VertexId v : *hit) {
    if (glm::distance(mesh.positions[v], point) < glm::distance(mesh.positions[best], point)) best = v;
  }
  return SurfaceHit{nearest, best};
}

std::optional<knit::VertexId> pick_vertex(const Session& session, const glm::dvec2& place) {
  if (!session.timeline) return std::nullopt;
  const auto hit = hit_surface(session, ray_through(session, place));
  return hit ? std::optional(hit->vertex) : std::nullopt;
}

std::optional<StitchAt> pick_stitch(const Session& session, const glm::dvec2& place, double reach) {
  if (!session.timeline) return std::nullopt;
  const View view = session.camera.view(session.aspect);
  const glm::dmat4 onto = glm::dmat4(view.projection) * glm::dmat4(view.view);
  std::optional<StitchAt> best;
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& row : session.timeline->state().rows) {
    for (std::size_t i = 0; i < row->stitches.size(); ++i) {
      const glm::dvec4 at = onto * glm::dvec4(row->stitches[i].position, 1.0);
      if (at.w <= 0.0 || at.w >= nearest) continue;
      const glm::dvec2 away((at.x / at.w - place.x) * session.aspect, at.y / at.w - place.y);
      if (glm::length(away) > reach) continue;
      nearest = at.w;
      best = StitchAt{row->number, static_cast<std::int32_t>(i)};
    }
  }
  return best;
}

}  // namespace app
