// The turntable camera: what is under the cursor stays there, and everything fits when framed.
#include "app/scene/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "app/scene/scene.h"
#include "knit/mesh/shapes.h"
#include "tests/support/catch.h"

using namespace app;

namespace {

// Where a place of the mesh appears: [-1, 1] from the view's centre, up positive.
glm::dvec2 on_screen(const Camera& camera, double aspect, const glm::dvec3& place) {
  const Sight view = camera.view(aspect);
  const glm::dvec4 at = glm::dmat4(view.projection) * glm::dmat4(view.view) * glm::dvec4(place, 1.0);
  REQUIRE(at.w > 0.0);
  return glm::dvec2(at) / at.w;
}

// The place at the target's depth that appears there.
glm::dvec3 place_under(const Camera& camera, double aspect, const glm::dvec2& cursor) {
  const glm::dvec3 back = glm::normalize(camera.eye() - camera.target);
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), back));
  const double half = camera.distance * std::tan(0.5 * camera.field_of_view);
  return camera.target + right * (cursor.x * half * aspect) + glm::cross(back, right) * (cursor.y * half);
}

void check_near(const glm::dvec2& a, const glm::dvec2& b) {
  CHECK(a.x == Approx(b.x).margin(1e-5));
  CHECK(a.y == Approx(b.y).margin(1e-5));
}

Camera some_camera() {
  Camera camera;
  camera.target = {0.3, -0.2, 0.1};
  camera.distance = 5.0;
  camera.yaw = 2.1;
  camera.pitch = -0.4;
  return camera;
}

}  // namespace

TEST_CASE("the target is in the middle of the view, the eye at its distance, and y points up") {
  const Camera camera = some_camera();
  check_near(on_screen(camera, 1.6, camera.target), {0.0, 0.0});
  CHECK(glm::distance(camera.eye(), camera.target) == Approx(5.0));
  CHECK(on_screen(camera, 1.6, camera.target + glm::dvec3(0, 0.5, 0)).y > 0.1);
  CHECK(on_screen(camera, 1.6, camera.target + glm::dvec3(0, 0.5, 0)).x == Approx(0.0).margin(1e-6));
  CHECK(glm::distance(glm::dvec3(camera.view(1.6).eye), camera.eye()) < 1e-5);
}

TEST_CASE("yaw 0 looks from +z, and a rising yaw turns the viewer towards +x") {
  Camera camera;
  camera.yaw = 0.0;
  camera.pitch = 0.0;
  camera.distance = 2.0;
  CHECK(glm::distance(camera.eye(), glm::dvec3(0, 0, 2)) < 1e-12);
  camera.orbit(1.5707963267948966, 0.0);
  CHECK(glm::distance(camera.eye(), glm::dvec3(2, 0, 0)) < 1e-12);
  camera.orbit(0.0, 0.5);
  CHECK(camera.eye().y > 0.9);
}

TEST_CASE("the camera never tips over the pole") {
  Camera camera;
  camera.orbit(0.0, 100.0);
  CHECK(camera.pitch < 1.5707963);
  CHECK(on_screen(camera, 1.0, {0, 0.5, 0}).y > 0.0);
  camera.orbit(0.0, -200.0);
  CHECK(camera.pitch > -1.5707963);
  CHECK(on_screen(camera, 1.0, {0, 0.5, 0}).y > 0.0);
  // Turning round and round keeps the matrix sound.
  for (int i = 0; i < 1000; ++i) camera.orbit(0.7, i % 2 == 0 ? 0.3 : -0.3);
  CHECK(std::isfinite(on_screen(camera, 1.0, {0.1, 0.2, 0.3}).x));
}

TEST_CASE("panning moves the place under the cursor along with the cursor") {
  for (const double aspect : {0.5, 1.0, 1.6, 3.0}) {
    Camera camera = some_camera();
    const glm::dvec2 cursor(0.3, -0.25);
    const glm::dvec2 move(0.2, 0.4);
    const glm::dvec3 held = place_under(camera, aspect, cursor);
    camera.pan(move, aspect);
    check_near(on_screen(camera, aspect, held), cursor + move);
    CHECK(camera.distance == 5.0);
  }
}

TEST_CASE("zooming keeps the place under the cursor") {
  for (const double aspect : {0.5, 1.0, 1.6, 3.0}) {
    for (const double factor : {0.5, 0.88, 1.2, 3.0}) {
      Camera camera = some_camera();
      const glm::dvec2 cursor(-0.6, 0.7);
      const glm::dvec3 held = place_under(camera, aspect, cursor);
      camera.zoom(factor, cursor, aspect);
      CHECK(camera.distance == Approx(5.0 * factor));
      check_near(on_screen(camera, aspect, held), cursor);
    }
  }
}

TEST_CASE("zooming in and out again at one place comes back") {
  Camera camera = some_camera();
  const Camera before = camera;
  const glm::dvec2 cursor(0.4, 0.1);
  for (int i = 0; i < 20; ++i) camera.zoom(0.88, cursor, 1.6);
  for (int i = 0; i < 20; ++i) camera.zoom(1.0 / 0.88, cursor, 1.6);
  CHECK(camera.distance == Approx(before.distance));
  CHECK(glm::distance(camera.target, before.target) < 1e-9);
}

TEST_CASE("framing shows the whole mesh from everywhere, and does not waste the view") {
  std::vector<glm::dvec3> box;
  for (const double x : {4.0, 5.0}) {
    for (const double y : {0.0, 9.0}) {
      for (const double z : {1.0, 2.0}) box.emplace_back(x, y, z);
    }
  }
  const std::vector<glm::dvec3> tiny{{-1e-3, 0, 0}, {1e-3, 0, 0}, {0, 1e-3, 0}, {0, 0, 1e-3}};
  for (const auto& places : {box, tiny, knit::sphere(20, 10).positions}) {
    for (const double aspect : {0.4, 1.0, 1.6, 3.0}) {
      CAPTURE(places.size(), aspect);
      double widest = 0.0;
      for (int turn = 0; turn < 200; ++turn) {
        Camera camera;
        camera.orbit(0.3 * turn, -camera.pitch - 1.5 + 0.015 * turn);
        camera.frame(knit::bounds_of(places), aspect);
        for (const glm::dvec3& place : places) {
          const glm::dvec2 at = on_screen(camera, aspect, place);
          widest = std::max({widest, std::abs(at.x), std::abs(at.y)});
        }
      }
      CHECK(widest <= 1.0);
      CHECK(widest > (aspect < 1.0 ? 0.3 : 0.8));  // a tall shape in a narrow view has room at its sides
    }
  }
}

TEST_CASE("framing a single point gives a camera that can still be used") {
  Camera camera;
  camera.frame(knit::bounds_of({{1, 2, 3}}), 1.6);
  CHECK(camera.distance > 0.0);
  CHECK(std::isfinite(camera.distance));
}
