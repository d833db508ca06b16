// Mirror planes found: of shapes that have one, of shapes that have none, and which one of several.
#include "knit/mesh/mirror_plane.h"

#include <cmath>
#include <filesystem>
#include <string>
#include <variant>

#include "knit/import/obj.h"
#include "knit/mesh/shapes.h"
#include "tests/support/belly.h"
#include "tests/support/catch.h"

using namespace knit;
using namespace test_support;

namespace {

const glm::dvec3 up{0.0, 1.0, 0.0}, towards_back{0.0, 0.0, -1.0};

struct Figure {
  const char* file = "";
  double degrees = 0.0;
  bool mirror = true;
};

}  // namespace

#ifdef KNIT_SHARED_MESHES
TEST_CASE("spot and teddy mirror in the plane across x and the bunny has no mirror image") {
  for (const Figure& figure :
       {Figure{"spot.obj"}, Figure{"teddy.obj"}, Figure{"suzanne.obj"}, Figure{"simple-elbow.obj"},
        Figure{"teapot.obj", 90.0}, Figure{"stanford-bunny.obj", 0.0, false}}) {
    const std::filesystem::path path = std::filesystem::path(KNIT_SHARED_MESHES) / figure.file;
    if (!std::filesystem::exists(path)) {
      WARN("skipped: " << figure.file << " is not there");
      continue;
    }
    const auto mesh = read_obj_file(path);
    REQUIRE(std::holds_alternative<Mesh>(mesh));
    CAPTURE(path);
    const auto found = measure_mirror(std::get<Mesh>(mesh), up, towards_back);
    REQUIRE(found);
    CAPTURE(found->degrees, found->apart, found->chance, found->apart / found->chance);
    CHECK(found->is_mirror() == figure.mirror);
    if (!figure.mirror) continue;
    CHECK(found->degrees == figure.degrees);
    CHECK(found->apart < 1.1 * found->chance);
  }
}
#endif

TEST_CASE("of a ball the first plane is taken with its back where rounds begin") {
  const auto ball = find_mirror_plane(icosphere(2), up, towards_back);
  REQUIRE(ball);
  CHECK(ball->normal.x > 0.999);
  CHECK(ball->back.z < -0.999);
}

TEST_CASE("a belly and a turned one are mirrored in their own plane and a lopsided one in none") {
  Mesh mesh = belly_mesh();
  const auto straight = measure_mirror(mesh, up, towards_back);
  REQUIRE(straight);
  CHECK(straight->is_mirror());
  CHECK(straight->degrees == 0.0);
  const double c = std::sqrt(3.0) / 2.0, s = 0.5;
  for (glm::dvec3& p : mesh.positions) p = {c * p.x + s * p.z, p.y, -s * p.x + c * p.z};
  const auto turned = measure_mirror(mesh, up, towards_back);
  REQUIRE(turned);
  CHECK(turned->is_mirror());
  CHECK(std::abs(turned->plane.normal.x - c) < 1e-9);
  CHECK(std::abs(turned->plane.normal.z + s) < 1e-9);
  for (glm::dvec3& p : mesh.positions) p.x += 0.3 * p.y * p.y * p.y;
  const auto lopsided = measure_mirror(mesh, up, towards_back);
  REQUIRE(lopsided);
  CHECK_FALSE(lopsided->is_mirror());
}
