// What a mesh is knitted with when nobody has said anything: it must work.
#include "knit/rows/first_choice.h"

#include "knit/mesh/shapes.h"
#include "knit/run/timeline.h"
#include "tests/support/bodies.h"
#include "tests/support/catch.h"
#include "tests/support/promises.h"

using namespace knit;

namespace {

Timeline first_run(const Mesh& mesh) {
  const auto input = make_input(mesh);
  Timeline timeline(input, first_parameters(*input));
  timeline.extend_to_end();
  return timeline;
}

}  // namespace

TEST_CASE("first run: a mesh with rings all the way is knitted from them") {
  for (const Mesh& mesh :
       {sphere(64, 33), sphere(64, 33, true), egg(64, 0.1), vase(64, 0.1), capsule(64, 0.1)}) {
    INFO(mesh.name);
    const Timeline timeline = first_run(mesh);
    CHECK(timeline.parameters().rows.source == RowSource::by_itself);
    CHECK(timeline.furthest().rows_from == RowSource::rings);
    CHECK(timeline.stop() == nullptr);
  }
}

TEST_CASE("first run: what has no rings, branches or has a hole is knitted from contours") {
  Mesh standing = torus(48, 24, 1.0, 0.4);
  for (glm::dvec3& p : standing.positions) p = {p.z, p.x, p.y};
  for (const Mesh& mesh : {icosphere(3), torus(48, 24, 1.0, 0.4), standing, test_support::arch()}) {
    INFO(mesh.name << ", " << mesh.triangles.size() << " triangles");
    const Timeline timeline = first_run(mesh);
    const Parameters chosen = as_chosen(timeline.parameters(), timeline.furthest());
    CHECK(chosen.rows.source == RowSource::contours);
    CHECK(chosen.stitches.placement == PlacementPolicy::nearest);
    REQUIRE(timeline.stop() == nullptr);
    CHECK(timeline.furthest().fabric.row_count() > 1);
    CHECK(test_support::broken_promise(timeline.furthest()) == "");
  }
}
