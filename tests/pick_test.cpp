// Picking: the vertex that appears under the pointer, on the near side of the surface.
#include "app/describe/pick.h"
#include "app/scene/scene.h"
#include "app/session/document.h"
#include "app/session/view.h"

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <set>

#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace app;

namespace {

glm::dvec2 on_screen(const Session& session, const glm::dvec3& place) {
  const Sight view = session.view->gaze.camera.view(session.view->aspect);
  const glm::dvec4 at = glm::dmat4(view.projection) * glm::dmat4(view.view) * glm::dvec4(place, 1.0);
  return glm::dvec2(at) / at.w;
}

// On the unit sphere: whether its place is turned towards the eye, with some room to the rim.
bool faces_eye(const Session& session, const glm::dvec3& place) {
  return glm::dot(glm::normalize(session.view->gaze.camera.eye() - place), glm::normalize(place)) > 0.3;
}

}  // namespace

TEST_CASE("a vertex in sight is picked where it appears, from wherever one looks") {
  Session session = test_support::small_session();
  const std::vector<glm::dvec3>& positions = session.document->timeline.input().mesh.positions;
  for (const double yaw : {0.0, 1.0, 2.5, 4.0}) {
    for (const double pitch : {-1.2, 0.0, 0.7}) {
      session.view->gaze.camera.yaw = yaw;
      session.view->gaze.camera.pitch = pitch;
      std::size_t seen = 0;
      std::size_t right = 0;
      for (knit::VertexId v = 0; v < positions.size(); ++v) {
        if (!faces_eye(session, positions[v])) continue;
        ++seen;
        right += pick_vertex(session, on_screen(session, positions[v])) == v ? 1U : 0U;
      }
      CAPTURE(yaw, pitch);
      CHECK(seen > positions.size() / 8);
      CHECK(right == seen);
    }
  }
}

TEST_CASE("what lies behind the surface is not picked: its near side is") {
  const Session session = test_support::small_session();
  const std::vector<glm::dvec3>& positions = session.document->timeline.input().mesh.positions;
  std::size_t hidden = 0;
  for (const glm::dvec3& place : positions) {
    if (!faces_eye(session, -place)) continue;
    ++hidden;
    const auto picked = pick_vertex(session, on_screen(session, place));
    REQUIRE(picked);
    const glm::dvec3 eye = session.view->gaze.camera.eye();
    CHECK(glm::distance(eye, positions[*picked]) < glm::distance(eye, place));
  }
  CHECK(hidden > positions.size() / 8);
}

TEST_CASE("beside the mesh, and with nothing open, nothing is picked") {
  const Session session = test_support::small_session();
  CHECK_FALSE(pick_vertex(session, {0.999, 0.999}));
  CHECK_FALSE(pick_vertex(session, {-0.999, -0.999}));
  CHECK_FALSE(pick_vertex(Session{}, {0.0, 0.0}));
}

TEST_CASE("picking follows the camera's zoom and pan and the view's shape") {
  Session session = test_support::small_session();
  const auto vertex = pick_vertex(session, {0.0, 0.0});
  REQUIRE(vertex);
  const glm::dvec3 place = session.document->timeline.input().mesh.positions[*vertex];
  for (const Action& change :
       Actions{Pan{{0.3, 0.1}}, Zoom{0.5, {0.3, 0.1}}, SetAspect{0.9}, Orbit{0.2, -0.1}}) {
    const glm::dvec2 before = on_screen(session, place);
    apply(session, change);
    CHECK(glm::distance(on_screen(session, place), before) > 0.01);
    CHECK(pick_vertex(session, on_screen(session, place)) == vertex);
  }
}

TEST_CASE("from inside the mesh, what lies before the eye is picked, not what lies behind it") {
  Session session = test_support::small_session();
  session.view->gaze.camera.distance = 0.5;
  const glm::dvec3 eye = session.view->gaze.camera.eye();
  const auto picked = pick_vertex(session, {0.0, 0.0});
  REQUIRE(picked);
  CHECK(glm::dot(session.document->timeline.input().mesh.positions[*picked] - eye,
                 session.view->gaze.camera.target - eye) > 0.0);
}

TEST_CASE("a place between vertices gives the nearest corner of the triangle hit") {
  const Session session = test_support::small_session();
  const knit::Mesh& mesh = session.document->timeline.input().mesh;
  std::size_t checked = 0;
  for (const knit::Triangle& t : mesh.triangles) {
    const glm::dvec3& a = mesh.positions[t[0]];
    const glm::dvec3& b = mesh.positions[t[1]];
    const glm::dvec3& c = mesh.positions[t[2]];
    const glm::dvec3 place = 0.6 * a + 0.2 * b + 0.2 * c;
    const double to_a = glm::distance(place, a);
    if (!faces_eye(session, place) || to_a > glm::distance(place, b) || to_a > glm::distance(place, c))
      continue;
    ++checked;
    CHECK(pick_vertex(session, on_screen(session, place)) == t[0]);
  }
  CHECK(checked > 100);
}
