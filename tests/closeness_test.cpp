#include "knit/quality/closeness.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "tests/support/catch.h"
#include "tests/support/run.h"
#include "tests/support/tube.h"

using namespace knit;
using test_support::HandTube;

namespace {

// A square tube as wide as that of 4 stitches in a row with this radius.
HandTube square_tube(double radius) { return {{4, 4}, radius, 1.0, 0.0}; }

Closeness between(const Mesh& mesh, const State& state) {
  const auto closeness = measure_closeness(*make_input(mesh), state);
  REQUIRE(closeness);
  return *closeness;
}

State small_run() {
  Timeline timeline(test_support::small_sphere(), test_support::small_parameters());
  timeline.extend_to_end();
  return timeline.furthest();
}

double longest_in_a_face(const State& state) {
  const std::vector<glm::dvec3> path = knitting_path(state.fabric);
  double longest = 0.0;
  for (const auto& strip : state.fabric.strips()) {
    for (const Face& face : strip->faces) {
      for (int a = 1; a < face.corner_count; ++a) {
        for (int b = 0; b < a; ++b) {
          const glm::dvec3 line = path[face.corners[static_cast<std::size_t>(a)]] -
                                  path[face.corners[static_cast<std::size_t>(b)]];
          longest = std::max(longest, glm::length(line));
        }
      }
    }
  }
  return longest;
}

}  // namespace

TEST_CASE("closeness: a knit mesh is at no distance from itself, however skew its quads", "[closeness]") {
  const State state = test_support::tube_state(HandTube{{12, 16, 16, 13}, 1.0, 0.3, 0.2});
  const Closeness self = between(test_support::mesh_of(state), state);
  CHECK(self.knit_to_mesh.max < 1e-12);
  CHECK(self.mesh_to_knit.max < 1e-12);
  CHECK(self.knit_area == Approx(self.mesh_area));
  // Stitches; edges along 4 rows; 16 + 16 + 16 column edges; faces: 5 samples a quad, 4 a triangle.
  CHECK(self.knit_to_mesh.samples == 57 + 57 + 48 + 5 * (12 + 16 + 13) + 4 * (4 + 3));
  CHECK(self.mesh_to_knit.samples == 57 + 2 * 41 + 7);
}

TEST_CASE("closeness: square tubes one in the other", "[closeness]") {
  const double gap = (1.2 - 1.0) / std::sqrt(2.0);  // between the sides
  const Mesh outer = test_support::mesh_of(test_support::tube_state(square_tube(1.2)));
  const State inner = test_support::tube_state(square_tube(1.0));
  const Closeness closeness = between(outer, inner);
  CHECK(closeness.knit_to_mesh.samples == 8 + 8 + 4 + 20);
  CHECK(closeness.knit_to_mesh.mean == Approx(gap));
  CHECK(closeness.knit_to_mesh.max == Approx(gap));
  CHECK(closeness.mesh_to_knit.samples == 16);  // 8 corners, 8 triangles
  CHECK(closeness.mesh_to_knit.max == Approx(0.2));
  CHECK(closeness.mesh_to_knit.mean == Approx((0.2 + gap) / 2.0));
  CHECK(closeness.mesh_area == Approx(4.0 * 1.2 * std::sqrt(2.0)));
  CHECK(closeness.knit_area == Approx(4.0 * std::sqrt(2.0)));
  CHECK(closeness.diagonal == Approx(std::hypot(2.4, 2.4, 1.0)));
}

TEST_CASE("closeness: a sphere's knit mesh is a sagitta away, and its open ends show", "[closeness]") {
  const State state = small_run();
  // The mesh that it was knitted from lies within its own sagitta below the unit sphere; the finer one as good
  // as on it.
  const double coarse = 1.0 - std::cos(std::numbers::pi / 16.0) * std::cos(std::numbers::pi / 40.0);
  const double longest = longest_in_a_face(state);
  // Jung: corners at most d apart lie in a ball of radius d sqrt(3 / 8).
  const double sagitta = 1.0 - std::sqrt(1.0 - longest * longest * 3.0 / 8.0);
  const Closeness closeness = between(sphere(200, 101, false), state);
  CHECK(closeness.knit_to_mesh.max < coarse + sagitta);
  CHECK(closeness.knit_to_mesh.max > sagitta / 8.0);
  CHECK(closeness.knit_to_mesh.mean < closeness.knit_to_mesh.max / 2.0);
  // The pole sees the first row: its own height over it, and its radius.
  const glm::dvec3 first = state.fabric.rows().front()->stitches.front().position;
  const double to_first_row = std::hypot(first.z, 1.0 + first.y);
  CHECK(closeness.mesh_to_knit.max > 0.8 * to_first_row);
  CHECK(closeness.mesh_to_knit.max < 1.01 * to_first_row);
  CHECK(closeness.knit_area < closeness.mesh_area);
  CHECK(closeness.knit_area > 0.85 * closeness.mesh_area);
}

TEST_CASE("closeness: copies of a vertex and vertices of no triangle do not count", "[closeness]") {
  const State state = small_run();
  const Closeness plain = between(sphere(40, 16, false), state);
  Mesh copied = sphere(40, 16, true);
  copied.positions.emplace_back(9, 9, 9);
  copied.positions.insert(copied.positions.begin(), copied.positions[5]);  // a twin that nothing uses, first
  for (Triangle& triangle : copied.triangles) {
    for (VertexId& v : triangle) ++v;
  }
  const Closeness seam = between(copied, state);
  CHECK(seam.mesh_to_knit.samples == plain.mesh_to_knit.samples);
  CHECK(seam.mesh_to_knit.mean == Approx(plain.mesh_to_knit.mean));
  CHECK(seam.knit_to_mesh.mean == Approx(plain.knit_to_mesh.mean));
  CHECK(seam.diagonal == plain.diagonal);
}

TEST_CASE("closeness: grown meshes keep their ratios", "[closeness]") {
  const State state = small_run();
  Mesh mesh = sphere(40, 16, false);
  const Closeness small = between(mesh, state);
  for (glm::dvec3& p : mesh.positions) p *= 1000.0;
  const State grown = test_support::moved(state, [](const glm::dvec3& p) { return 1000.0 * p; });
  const Closeness large = between(mesh, grown);
  CHECK(large.diagonal == Approx(1000.0 * small.diagonal));
  CHECK(large.knit_to_mesh.max / large.diagonal == Approx(small.knit_to_mesh.max / small.diagonal));
  CHECK(large.mesh_to_knit.mean / large.diagonal == Approx(small.mesh_to_knit.mean / small.diagonal));
  CHECK(large.knit_area / large.mesh_area == Approx(small.knit_area / small.mesh_area));
}

TEST_CASE("closeness: nothing before there are faces, or without a mesh", "[closeness]") {
  const auto input = test_support::small_sphere();
  CHECK_FALSE(measure_closeness(*input, State{}));
  CHECK_FALSE(measure_closeness(*input, test_support::tube_state(HandTube{{5}})));
  CHECK_FALSE(measure_closeness(*make_input({}), test_support::tube_state(HandTube{})));
  State state = small_run();
  state.fabric = test_support::first_strips(state.fabric, 1);
  const auto begun = measure_closeness(*input, state);
  REQUIRE(begun);
  CHECK(begun->mesh_to_knit.max > 1.0);  // the far pole
}
