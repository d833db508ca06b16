// How far up the surface each level lies.
#include "knit/timing/heights.h"

#include <cmath>
#include <numbers>

#include "tests/support/bodies.h"
#include "tests/support/catch.h"
#include "tests/support/repeated.h"

using namespace knit;
using test_support::field_along;

namespace {

constexpr double pi = std::numbers::pi;
const glm::dvec3 up(0.0, 1.0, 0.0);

HeightScale heights_of(const Mesh& mesh, const glm::dvec3& axis = up) {
  const auto input = make_input(mesh);
  return measure_heights(*input, field_along(*input, axis));
}

double longest_edge(const Mesh& mesh) {
  double longest = 0.0;
  for (const auto& [a, b] : mesh.edges)
    longest = std::max(longest, glm::distance(mesh.positions[a], mesh.positions[b]));
  return longest;
}

bool sound(const HeightScale& scale) {
  bool good = scale.values.size() == scale.heights.size() && scale.values.size() > 1;
  good = good && scale.values.front() == 0.0 && scale.values.back() == 1.0 && scale.heights.front() == 0.0;
  for (std::size_t i = 1; i < scale.values.size() && good; ++i)
    good = scale.values[i] > scale.values[i - 1] && scale.heights[i] >= scale.heights[i - 1];
  return good && scale.total() == scale.heights.back();
}

// A cone about y from the tip at 0: `radius` at `height`, where a flat lid closes it.
Mesh lidded_cone(unsigned segments, double radius, double height) {
  std::vector<ProfilePoint> profile{{0.0, 0.0}};
  for (int i = 1; i <= 5; ++i) profile.push_back({radius * i / 5, height * i / 5});
  profile.push_back({0.0, height});
  return revolve("cone", profile, segments, false);
}

}  // namespace

TEST_CASE("heights: half round a sphere is pi", "[heights]") {
  CHECK(heights_of(sphere(128, 65, true)).total() == Approx(pi).margin(1e-3));
  CHECK(heights_of(sphere(200, 120)).total() == Approx(pi).margin(1e-3));
  CHECK(heights_of(sphere(40, 16)).total() == Approx(pi).margin(1e-2));
  CHECK(heights_of(sphere(40, 21)).total() == Approx(pi).margin(1e-2));
}

// A polyhedron's ends are no poles: levels there are polygons round a vertex, whose mean height falls short of
// the way to their corners. So the error is of the first order: 0.006 for icosphere(5), 0.012 for (4), and up
// to 0.013 for sphere(200, 120) along an axis that is not its own.
TEST_CASE("heights: along any axis of any sphere pi is missed by less than half an edge", "[heights]") {
  for (const Mesh& mesh :
       {sphere(16, 8), sphere(128, 65, true), sphere(200, 120), icosphere(3), icosphere(4), icosphere(5)}) {
    INFO(mesh.name << " of " << mesh.triangles.size());
    const double edge = longest_edge(mesh);
    for (const glm::dvec3& axis : test_support::random_axes(test_support::repeated(20U), 7)) {
      const HeightScale scale = heights_of(mesh, axis);
      CHECK(sound(scale));
      CHECK(scale.total() < pi);
      CHECK(scale.total() > pi - 0.5 * edge);
    }
  }
  const double coarse = pi - heights_of(icosphere(4)).total();
  const double fine = pi - heights_of(icosphere(5)).total();
  CHECK(coarse < 0.0125);
  CHECK(fine < 0.5 * coarse);
}

TEST_CASE("heights: a level of a sphere lies as high as its angle from the pole", "[heights]") {
  const HeightScale scale = heights_of(sphere(128, 65, true));
  for (int i = 1; i < 20; ++i) {
    const double angle = pi * i / 20;
    CHECK(height_at(scale, 0.5 * (1.0 - std::cos(angle))) == Approx(angle).margin(3e-3));
  }
}

TEST_CASE("heights: a cylinder's are exact, and its flat lids count nothing", "[heights]") {
  for (const unsigned segments : {3u, 5u, 48u}) {
    const HeightScale scale = heights_of(test_support::cylinder(segments, 1.3, 2.5, 4));
    CHECK(sound(scale));
    CHECK(scale.total() == Approx(2.5).epsilon(1e-12));
    for (const double value : {0.1, 0.25, 0.5, 0.77})
      CHECK(height_at(scale, value) == Approx(2.5 * value).epsilon(1e-12));
  }
}

TEST_CASE("heights: a cone's are exact, by the slant of its faces", "[heights]") {
  for (const unsigned segments : {4u, 7u, 64u}) {
    const double apothem = 0.8 * std::cos(pi / segments);
    const double slant = std::hypot(apothem, 1.7);
    const HeightScale scale = heights_of(lidded_cone(segments, 0.8, 1.7));
    CHECK(sound(scale));
    CHECK(scale.total() == Approx(slant).epsilon(1e-9));
    CHECK(height_at(scale, 0.3) == Approx(0.3 * slant).epsilon(1e-9));
  }
}

// What falls on between two levels is no height: the shoulder is flat.
TEST_CASE("heights: a flat shoulder counts nothing", "[heights]") {
  const std::vector<ProfilePoint> profile{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0},
                                          {0.4, 1.0}, {0.4, 2.0}, {0.0, 2.0}};
  const HeightScale scale = heights_of(revolve("step", profile, 32, false));
  CHECK(sound(scale));
  // The one band that touches the shoulder has the wide level below it and the narrow one above.
  CHECK(scale.total() == Approx(2.0).margin(3e-3));
  CHECK(height_at(scale, 0.4) == Approx(0.8).margin(1e-3));
  CHECK(scale.total() - height_at(scale, 0.6) == Approx(0.8).margin(1e-3));
}

TEST_CASE("heights: height_at and value_at are inverse and rise", "[heights]") {
  for (const Mesh& mesh : {sphere(128, 65, true), egg(48, 0.1), vase(48, 0.1), icosphere(3),
                           test_support::rough_sphere(3, 5), torus(48, 24, 1.0, 0.4)}) {
    INFO(mesh.name);
    const HeightScale scale = heights_of(mesh, {0.3, 1.0, 0.1});
    REQUIRE(sound(scale));
    CHECK(height_at(scale, 0.0) == 0.0);
    CHECK(height_at(scale, 1.0) == scale.total());
    CHECK(value_at(scale, 0.0) == 0.0);
    CHECK(value_at(scale, scale.total()) == 1.0);
    double last_height = 0.0;
    double last_value = 0.0;
    for (int i = 1; i <= 3000; ++i) {
      const double at = i / 3000.0;
      const double height = height_at(scale, at);
      const double value = value_at(scale, at * scale.total());
      const bool rises = height > last_height && value > last_value;
      const bool inverse = std::abs(value_at(scale, height) - at) < 1e-12 &&
                           std::abs(height_at(scale, value) - at * scale.total()) < 1e-12;
      if (!rises || !inverse) FAIL_CHECK("at " << at << ": " << height << ", " << value);
      last_height = height;
      last_value = value;
    }
  }
}

TEST_CASE("heights: a field that rises unevenly is measured as finely", "[heights]") {
  const auto input = make_input(sphere(128, 65, true));
  for (const double power : {0.25, 4.0, 8.0}) {
    std::vector<double> field = field_along(*input, up);
    for (double& value : field) value = std::pow(value, power);
    const HeightScale scale = measure_heights(*input, field);
    CHECK(sound(scale));
    CHECK(scale.total() == Approx(pi).margin(3e-3));
    CHECK(height_at(scale, std::pow(0.5, power)) == Approx(0.5 * pi).margin(3e-3));
  }
}

TEST_CASE("heights: twice the size is twice the height, and the mesh's order does not matter", "[heights]") {
  const Mesh mesh = icosphere(3);
  const double total = heights_of(mesh).total();
  CHECK(heights_of(test_support::placed(mesh, glm::dvec3(2.0), {1.0, -5.0, 3.0})).total() ==
        Approx(2.0 * total).epsilon(1e-9));
  CHECK(heights_of(test_support::shuffled(mesh, 3).mesh).total() == Approx(total).epsilon(1e-9));
}

TEST_CASE("heights: beyond both ends of the scale lie its ends", "[heights]") {
  const HeightScale scale{{0.0, 0.25, 1.0}, {0.0, 2.0, 3.0}};
  CHECK(height_at(scale, -1.0) == 0.0);
  CHECK(height_at(scale, 0.125) == 1.0);
  CHECK(height_at(scale, 0.625) == 2.5);
  CHECK(height_at(scale, 2.0) == 3.0);
  CHECK(value_at(scale, 1.0) == 0.125);
  CHECK(value_at(scale, 2.5) == 0.625);
  CHECK(value_at(scale, 9.0) == 1.0);
  CHECK(HeightScale{}.total() == 0.0);
}
