// A ray from the eye through a place on the screen, and what it meets. Part of pick and pick_thing.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "app/core/session.h"

namespace app {

struct Ray {
  glm::dvec3 origin, direction;  // the direction has length 1
};

// `place`: [-1, 1], up positive.
Ray ray_through(const Session& session, const glm::dvec2& place);

// Distance along the ray to the triangle, from either side.
std::optional<double> meets(const Ray& ray, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

// Where the ray first meets the mesh; the vertex is the nearest corner of the triangle there.
struct SurfaceHit {
  double depth = 0.0;  // along the ray
  knit::VertexId vertex = knit::no_vertex;
};
std::optional<SurfaceHit> hit_surface(const Session& session, const Ray& ray);

}  // namespace app
