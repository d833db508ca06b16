// A ray from the eye through a place on the screen, and what it meets. Part of pick and pick_thing.
#include "app/describe/pick.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <optional>

#include "app/describe/describe_step.h"
#include "app/describe/state_shown.h"
#include "app/describe/thing_places.h"
#include "app/session/document.h"
#include "app/session/session.h"
#include "app/session/view.h"

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
  const Sight view = session.view->gaze.camera.view(session.view->aspect);
  const glm::dmat4 back = glm::inverse(glm::dmat4(view.projection) * glm::dmat4(view.view));
  const glm::dvec4 far = back * glm::dvec4(place.x, place.y, 1.0, 1.0);
  const glm::dvec3 eye = session.view->gaze.camera.eye();
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
  const knit::Mesh& mesh = session.document->timeline.input().mesh;
  double nearest = std::numeric_limits<double>::infinity();
  const knit::Triangle* hit = nullptr;
  const std::vector<knit::Input::Box>& boxes = session.document->timeline.input().boxes;
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
  if (!session.document) return std::nullopt;
  const auto hit = hit_surface(session, ray_through(session, place));
  return hit ? std::optional(hit->vertex) : std::nullopt;
}

std::optional<StitchAt> pick_stitch(const Session& session, const glm::dvec2& place, double reach) {
  if (!session.document) return std::nullopt;
  const Sight view = session.view->gaze.camera.view(session.view->aspect);
  const glm::dmat4 onto = glm::dmat4(view.projection) * glm::dmat4(view.view);
  std::optional<StitchAt> best;
  double nearest = std::numeric_limits<double>::infinity();
  const StateShown state(session);
  for (const auto& row : state->fabric.rows()) {
    for (std::size_t i = 0; i < row->stitches.size(); ++i) {
      const glm::dvec4 at = onto * glm::dvec4(row->stitches[i].position, 1.0);
      if (at.w <= 0.0 || at.w >= nearest) continue;
      const glm::dvec2 away((at.x / at.w - place.x) * session.view->aspect, at.y / at.w - place.y);
      if (glm::length(away) > reach) continue;
      nearest = at.w;
      best = StitchAt{row->id, static_cast<std::int32_t>(i)};
    }
  }
  return best;
}

namespace {

constexpr double nothing = std::numeric_limits<double>::infinity();

// A place under the pointer: on the screen, and along the ray where the first opaque thing is.
class Aim {
 public:
  Aim(const Session& session, const glm::dvec2& place)
      : aspect_(session.view->aspect), ray_(ray_through(session, place)) {
    const Sight view = session.view->gaze.camera.view(session.view->aspect);
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
  std::optional<knit::Element> thing;
  double away = nothing;
  void offer(double distance, double reach, const knit::Element& other) {
    if (distance > reach || distance >= away) return;
    away = distance;
    thing = other;
  }
};

// All rows that have stitches, the one in the making too; behind them bridges, below 0.
std::vector<std::int32_t> rows_and_bridges(const knit::State& state) {
  std::vector<std::int32_t> rows;
  for (knit::RowId row = 1; row <= state.fabric.next_row(); ++row) rows.push_back(row);
  const auto deals = static_cast<std::int32_t>(state.fabric.deals().size());
  for (std::int32_t deal = 1; deal <= deals + 1; ++deal) rows.push_back(knit::bridge_row(deal));
  return rows;
}

Found nearest_point(const Session& session, const knit::State& state, const Aim& aim, double reach) {
  Found found;
  for (const std::int32_t row : rows_and_bridges(state)) {
    if (!session.view->shows(Layer::stitches)) break;
    const auto places = stitch_places(state, row);
    for (std::size_t i = 0; i < places.size(); ++i)
      found.offer(aim.to_point(places[i]), reach, knit::StitchElement{row, static_cast<std::int32_t>(i)});
  }
  // A vertex at a stitch's own place is no nearer than the stitch.
  const auto* work = std::get_if<knit::RowWork>(&state.work);
  if (work == nullptr || !work->ring || !session.view->shows(Layer::cycle)) return found;
  for (std::size_t i = 0; i < work->ring->vertices.size(); ++i)
    found.offer(aim.to_point(work->ring->points[i]), 0.7 * reach,
                knit::VertexElement{work->ring->vertices[i]});
  return found;
}

Found nearest_edge(const Session& session, const knit::State& state, const Aim& aim, double reach) {
  Found found;
  for (const std::int32_t row : rows_and_bridges(state)) {
    if (!session.view->shows(Layer::row_edges)) break;
    const auto places = stitch_places(state, row);
    const knit::RowEdgeElement last{row, static_cast<std::int32_t>(places.size()) - 1};
    for (const auto& [from, to] : knit::Edges(places.size(), knit::exists(state, last))) {
      found.offer(aim.to_segment(places[from], places[to]), reach,
                  knit::RowEdgeElement{row, static_cast<std::int32_t>(from)});
    }
  }
  if (!session.view->shows(Layer::column_edges)) return found;
  const knit::KnittingPath path(state.fabric);
  for (const MadeStrip& strip : made_strips(state)) {
    for (std::size_t i = 0; i < strip.column_edges.size(); ++i) {
      const auto& [lower, upper] = strip.column_edges[i];
      found.offer(aim.to_segment(place_on(path, lower), place_on(path, upper)), reach,
                  knit::ColumnEdgeElement{strip.row, static_cast<std::int32_t>(i)});
    }
  }
  return found;
}

struct FaceHit {
  std::optional<knit::Element> thing;
  double depth = nothing;
};

FaceHit first_face(const Session& session, const knit::State& state, const Ray& ray) {
  FaceHit hit;
  if (!session.view->shows(Layer::faces)) return hit;
  const knit::KnittingPath path(state.fabric);
  for (const MadeStrip& strip : made_strips(state)) {
    for (std::size_t i = 0; i < strip.faces.size(); ++i) {
      const knit::Face& face = strip.faces[i];
      const auto corner = [&](std::size_t k) { return glm::dvec3(place_on(path, face.corners[k])); };
      auto along = meets(ray, corner(0), corner(1), corner(2));
      if (!along && face.corner_count == 4) along = meets(ray, corner(0), corner(2), corner(3));
      if (along && *along < hit.depth)
        hit = {knit::FaceElement{strip.row, static_cast<std::int32_t>(i)}, *along};
    }
  }
  return hit;
}

bool shows_mesh(const Session& session) {
  return session.view->shows(Layer::surface) || session.view->shows(Layer::wire) ||
         session.view->shows(Layer::cycle);
}

}  // namespace

std::optional<knit::Element> pick_thing(const Session& session, const glm::dvec2& place,
                                        const PickReach& reach) {
  if (!session.document) return std::nullopt;
  const StateShown state(session);
  Aim aim(session, place);
  const auto surface = hit_surface(session, aim.ray());
  const FaceHit face = first_face(session, *state, aim.ray());
  // Edges cut a little below the surface, and faces stand off it.
  const double room = 0.75 * session.document->timeline.parameters().stitch.width;
  if (surface && session.view->shows(Layer::surface)) aim.hide_behind(surface->depth + room);
  if (face.thing) aim.hide_behind(face.depth + room);

  if (const Found point = nearest_point(session, *state, aim, reach.point); point.thing) return point.thing;
  const auto& positions = session.document->timeline.input().mesh.positions;
  if (surface && session.view->shows(Layer::wire) &&
      aim.to_point(positions[surface->vertex]) < 0.5 * reach.point)
    return knit::VertexElement{surface->vertex};
  if (const Found edge = nearest_edge(session, *state, aim, reach.edge); edge.thing) return edge.thing;
  if (face.thing && face.depth <= aim.depth()) return face.thing;
  if (surface && shows_mesh(session)) return knit::VertexElement{surface->vertex};
  return std::nullopt;
}

}  // namespace app
