#include "app/core/pick_thing.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <limits>

#include "app/core/describe_step.h"
#include "app/core/pick.h"
#include "app/core/pick_ray.h"
#include "app/core/thing_places.h"

namespace app {

namespace {

constexpr double nothing = std::numeric_limits<double>::infinity();

// A place under the pointer: on the screen, and along the ray where the first opaque thing is.
class Aim {
 public:
  Aim(const Session& session, const glm::dvec2& place)
      : aspect_(session.aspect), ray_(ray_through(session, place)) {
    const View view = session.camera.view(session.aspect);
    onto_ = glm::dmat4(view.projection) * glm::dmat4(view.view);
    at_ = {place.x * aspect_, place.y};
  }

  [[nodiscard]] const Ray& ray() const { return ray_; }
  // What lies farther than this from the eye is hidden.
  void hide_behind(double depth) { depth_ = std::min(depth_, depth); }
  [[nodiscard]] bool hidden(const glm::dvec3& point) const {
    return glm::distance(point, ray_.origin) > depth_;
  }
  [[nodiscard]] double depth() const { return depth_; }

  // From the pointer, in heights of half the view.
  [[nodiscard]] double to_point(const glm::dvec3& point) const {
    const auto at = on_screen(point);
    return at && !hidden(point) ? glm::distance(*at, at_) : nothing;
  }
  [[nodiscard]] double to_segment(const glm::dvec3& from, const glm::dvec3& to) const {
    const auto a = on_screen(from);
    const auto b = on_screen(to);
    if (!a || !b) return nothing;
    const glm::dvec2 along = *b - *a;
    const double square = glm::dot(along, along);
    const double share = square > 0.0 ? std::clamp(glm::dot(at_ - *a, along) / square, 0.0, 1.0) : 0.0;
    return hidden(from + share * (to - from)) ? nothing : glm::distance(*a + share * along, at_);
  }

 private:
  [[nodiscard]] std::optional<glm::dvec2> on_screen(const glm::dvec3& point) const {
    const glm::dvec4 at = onto_ * glm::dvec4(point, 1.0);
    if (at.w <= 0.0) return std::nullopt;
    return glm::dvec2(at.x / at.w * aspect_, at.y / at.w);
  }

  double aspect_;
  Ray ray_;
  glm::dmat4 onto_{1.0};
  glm::dvec2 at_{0.0};
  double depth_ = nothing;
};

// The nearest so far.
struct Found {
  std::optional<knit::Thing> thing;
  double away = nothing;
  void offer(double distance, double reach, const knit::Thing& other) {
    if (distance > reach || distance >= away) return;
    away = distance;
    thing = other;
  }
};

std::int32_t rows_begun(const knit::State& state) { return static_cast<std::int32_t>(state.rows.size()) + 1; }

Found nearest_point(const Session& session, const Aim& aim, double reach) {
  const knit::State& state = session.timeline->state();
  Found found;
  for (std::int32_t row = 1; session.shows(Layer::stitches) && row <= rows_begun(state); ++row) {
    const auto places = stitch_places(state, row);
    for (std::size_t i = 0; i < places.size(); ++i)
      found.offer(aim.to_point(places[i]), reach, knit::StitchThing{row, static_cast<std::int32_t>(i)});
  }
  // A vertex at a stitch's own place is no nearer than the stitch.
  const auto* work = std::get_if<knit::RowWork>(&state.work);
  if (work == nullptr || !work->ring || !session.shows(Layer::cycle)) return found;
  for (std::size_t i = 0; i < work->ring->vertices.size(); ++i)
    found.offer(aim.to_point(work->ring->points[i]), 0.7 * reach, knit::VertexThing{work->ring->vertices[i]});
  return found;
}

Found nearest_edge(const Session& session, const Aim& aim, double reach) {
  const knit::State& state = session.timeline->state();
  Found found;
  for (std::int32_t row = 1; session.shows(Layer::row_edges) && row <= rows_begun(state); ++row) {
    const auto places = stitch_places(state, row);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const knit::RowEdgeThing edge{row, static_cast<std::int32_t>(i)};
      if (i + 1 == places.size() && !knit::exists(state, edge)) continue;  // not closed yet
      found.offer(aim.to_segment(places[i], places[(i + 1) % places.size()]), reach, edge);
    }
  }
  if (!session.shows(Layer::column_edges)) return found;
  for (const MadeStrip& strip : made_strips(state)) {
    const StripPlaces places = places_of(state, static_cast<std::size_t>(strip.row) - 2);
    for (std::size_t i = 0; i < strip.column_edges.size(); ++i) {
      const auto& [lower, upper] = strip.column_edges[i];
      found.offer(aim.to_segment(places.at(lower), places.at(upper)), reach,
                  knit::ColumnEdgeThing{strip.row, static_cast<std::int32_t>(i)});
    }
  }
  return found;
}

struct FaceHit {
  std::optional<knit::Thing> thing;
  double depth = nothing;
};

FaceHit first_face(const Session& session, const Ray& ray) {
  const knit::State& state = session.timeline->state();
  FaceHit hit;
  if (!session.shows(Layer::faces)) return hit;
  for (const MadeStrip& strip : made_strips(state)) {
    const StripPlaces places = places_of(state, static_cast<std::size_t>(strip.row) - 2);
    for (std::size_t i = 0; i < strip.faces.size(); ++i) {
      const knit::Face& face = strip.faces[i];
      const auto corner = [&](std::size_t k) { return glm::dvec3(places.at(face.corners[k])); };
      auto along = meets(ray, corner(0), corner(1), corner(2));
      if (!along && face.corner_count == 4) along = meets(ray, corner(0), corner(2), corner(3));
      if (along && *along < hit.depth)
        hit = {knit::FaceThing{strip.row, static_cast<std::int32_t>(i)}, *along};
    }
  }
  return hit;
}

bool shows_mesh(const Session& session) {
  return session.shows(Layer::surface) || session.shows(Layer::wire) || session.shows(Layer::cycle);
}

}  // namespace

std::optional<knit::Thing> pick_thing(const Session& session, const glm::dvec2& place,
                                      const PickReach& reach) {
  if (!session.timeline) return std::nullopt;
  Aim aim(session, place);
  const auto surface = hit_surface(session, aim.ray());
  const FaceHit face = first_face(session, aim.ray());
  // Edges cut a little below the surface, and faces stand off it.
  const double room = 0.75 * session.timeline->parameters().stitch_width;
  if (surface && session.shows(Layer::surface)) aim.hide_behind(surface->depth + room);
  if (face.thing) aim.hide_behind(face.depth + room);

  if (const Found point = nearest_point(session, aim, reach.point); point.thing) return point.thing;
  const auto& positions = session.timeline->input().mesh.positions;
  if (surface && session.shows(Layer::wire) && aim.to_point(positions[surface->vertex]) < 0.5 * reach.point)
    return knit::VertexThing{surface->vertex};
  if (const Found edge = nearest_edge(session, aim, reach.edge); edge.thing) return edge.thing;
  if (face.thing && face.depth <= aim.depth()) return face.thing;
  if (surface && shows_mesh(session)) return knit::VertexThing{surface->vertex};
  return std::nullopt;
}

}  // namespace app
