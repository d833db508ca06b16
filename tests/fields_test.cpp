#include "knit/timing/fields.h"

#include <cmath>
#include <numbers>

#include "knit/model/bug.h"
#include "tests/support/catch.h"
#include "tests/support/rough_sphere.h"

using namespace knit;
using namespace test_support;

namespace {

struct Surface {
  std::shared_ptr<const Input> input;
  IntrinsicMesh net;
};

Surface surface_of(const Mesh& mesh) {
  Surface surface{make_input(mesh), {}};
  surface.net = make_intrinsic(*surface.input);
  return surface;
}

std::vector<double> distances(const Surface& on, VertexId start) {
  return distance_from(*on.input, on.net, unit_slopes(on.net, spread_heat(*on.input, on.net, start)), start);
}
std::vector<double> distances(const Mesh& mesh, VertexId start) { return distances(surface_of(mesh), start); }

std::vector<double> harmonic(const Mesh& mesh, VertexId start, VertexId end) {
  const Surface on = surface_of(mesh);
  return solve_harmonic(*on.input, on.net, start, end);
}

VertexId farthest_along(const Mesh& mesh, const glm::dvec3& direction) {
  VertexId best = 0;
  for (VertexId v = 0; v < mesh.positions.size(); ++v)
    if (glm::dot(mesh.positions[v], direction) > glm::dot(mesh.positions[best], direction)) best = v;
  return best;
}

struct SphereError {
  double worst = 0.0;     // from the great circle's length, in mean edges
  double antipode = 0.0;  // how far the farthest vertex is from it, in mean edges
};
SphereError sphere_error(const Mesh& mesh, VertexId start) {
  const Surface on = surface_of(mesh);
  const std::vector<double> found = distances(on, start);
  const auto angle = [&](const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
  };
  SphereError error;
  for (std::size_t v = 0; v < found.size(); ++v)
    error.worst = std::max(error.worst, std::abs(found[v] - angle(mesh.positions[v], mesh.positions[start])));
  const auto top = static_cast<std::size_t>(std::max_element(found.begin(), found.end()) - found.begin());
  error.antipode = angle(mesh.positions[top], -mesh.positions[start]) / on.net.mean_edge;
  error.worst /= on.net.mean_edge;
  return error;
}

double worst_difference(const std::vector<double>& a, const std::vector<double>& b, double scale = 1.0) {
  REQUIRE(a.size() == b.size());
  double worst = 0.0;
  for (std::size_t v = 0; v < a.size(); ++v) worst = std::max(worst, std::abs(a[v] / scale - b[v]));
  return worst;
}

struct Neighbourhood {
  double low = HUGE_VAL, high = -HUGE_VAL;
  double flow = 0.0, turnover = 0.0;  // sums of w (u_i - u_j), and of its absolute values
};
std::vector<Neighbourhood> neighbourhoods(const Surface& on, const std::vector<double>& values) {
  std::vector<Neighbourhood> all(values.size());
  for (std::size_t t = 0; t < on.net.triangles.size(); ++t) {
    const std::array<double, 3> cotangents = cotangents_of(on.net.lengths[t]);
    for (std::size_t k = 0; k < 6; ++k) {  // both ways
      const VertexId a = on.net.triangles[t][k < 3 ? k : (k + 1) % 3];
      const VertexId b = on.net.triangles[t][k < 3 ? (k + 1) % 3 : k - 3];
      const double flow = 0.5 * cotangents[(k + 2) % 3] * (values[a] - values[b]);
      all[a].low = std::min(all[a].low, values[b]);
      all[a].high = std::max(all[a].high, values[b]);
      all[a].flow += flow;
      all[a].turnover += std::abs(flow);
    }
  }
  return all;
}

void check_harmonic(const Mesh& mesh, VertexId start, VertexId end) {
  const Surface on = surface_of(mesh);
  const std::vector<double> values = solve_harmonic(*on.input, on.net, start, end);
  CHECK(values[start] == 0.0);
  CHECK(values[end] == 1.0);
  const std::vector<Neighbourhood> around = neighbourhoods(on, values);
  std::size_t out_of_range = 0;
  std::size_t extrema = 0;
  double unbalanced = 0.0;
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (v == start || v == end) continue;
    if (!(values[v] > 0.0 && values[v] < 1.0)) ++out_of_range;
    // A sharp tip may have one neighbour only, and then has its value.
    if (around[v].low == around[v].high && std::abs(values[v] - around[v].low) < 1e-13) continue;
    if (!(around[v].low < values[v] && values[v] < around[v].high)) ++extrema;
    unbalanced = std::max(unbalanced, std::abs(around[v].flow) / around[v].turnover);
  }
  CHECK(out_of_range == 0);
  CHECK(extrema == 0);
  CHECK(unbalanced < 1e-6);
}

}  // namespace

TEST_CASE("fields: distance on a sphere is the great circle's", "[fields]") {
  // Measured: 0.34 and 0.39 of the mean edge, at most 0.47 on the rough ones, 0.033 with rings.
  for (const unsigned subdivisions : {3u, 4u}) {
    const SphereError fine = sphere_error(icosphere(subdivisions), 0);
    CAPTURE(subdivisions, fine.worst, fine.antipode);
    CHECK(fine.worst < 0.5);
    CHECK(fine.antipode < 1.0);
  }
  for (const unsigned seed : {1u, 2u, 3u}) {
    const SphereError rough = sphere_error(rough_sphere(4, seed), 17 * seed);
    CAPTURE(seed, rough.worst, rough.antipode);
    CHECK(rough.worst < 0.6);
    CHECK(rough.antipode < 2.0);
  }
  const SphereError rings = sphere_error(sphere(64, 40), 0);
  CAPTURE(rings.worst, rings.antipode);
  CHECK(rings.worst < 0.1);
  CHECK(rings.antipode < 1e-9);
}

TEST_CASE("fields: all of a ring is equally far from the pole", "[fields]") {
  for (const unsigned segments : {7u, 64u}) {
    const Mesh mesh = sphere(segments, 30);
    const std::vector<double> found = distances(mesh, 0);
    CHECK(found[0] == 0.0);
    for (std::size_t first = 1; first + 1 < found.size(); first += segments)
      for (std::size_t v = first; v < first + segments; ++v)
        CHECK(found[v] == Approx(found[first]).margin(1e-6));
    CHECK(std::is_sorted(found.begin(), found.end(), [](double a, double b) { return a < b - 1e-6; }));
  }
}

TEST_CASE("fields: heat falls away from where it was placed and never to nothing", "[fields]") {
  const Surface round = surface_of(rough_sphere(3, 5));
  const std::vector<double> heat = spread_heat(*round.input, round.net, 9);
  CHECK(heat[9] == 1.0);
  const std::vector<Neighbourhood> around = neighbourhoods(round, heat);
  for (std::size_t v = 0; v < heat.size(); ++v) {
    if (v == 9) continue;
    CHECK(heat[v] < around[v].high);
    CHECK(heat[v] > 0.0);
  }
  // 850 mean edges from end to end: exp(-850) is 0.
  const Mesh needle = placed(sphere(12, 600), {0.001, 1.0, 0.001});
  const Surface longest = surface_of(needle);
  const std::vector<double> faint = spread_heat(*longest.input, longest.net, 0);
  CHECK(*std::min_element(faint.begin(), faint.end()) > 1e-230);
  CHECK(distances(longest, 0).back() == Approx(2.0).epsilon(0.01));
}

TEST_CASE("fields: slopes have length 1 and point away from the heat", "[fields]") {
  const IntrinsicMesh net{{{0, 1, 2}}, {{4.0, 5.0, 3.0}}, 4.0};  // (0, 0), (4, 0), (0, 3)
  for (const double scale : {1.0, 1e-250}) {
    const EdgeSlopes across = unit_slopes(net, {3.0 * scale, 2.0 * scale, 3.0 * scale});
    CHECK(across[0][0] == Approx(4.0));
    CHECK(across[0][1] == Approx(-4.0));
    CHECK(across[0][2] == Approx(0.0).margin(1e-12));
    const EdgeSlopes slanting = unit_slopes(net, {7.0 * scale, 3.0 * scale, 4.0 * scale});
    CHECK(slanting[0][0] == Approx(4.0 * std::sqrt(0.5)));
    CHECK(slanting[0][2] == Approx(-3.0 * std::sqrt(0.5)));
  }
  CHECK(unit_slopes(net, {1.0, 1.0, 1.0})[0] == std::array<double, 3>{0.0, 0.0, 0.0});
}

TEST_CASE("fields: a harmonic field is everywhere the mean of its neighbours", "[fields]") {
  const Mesh round = rough_sphere(4, 6);
  check_harmonic(round, farthest_along(round, {0, -1, 0}), farthest_along(round, {0, 1, 0}));
  check_harmonic(round, 3, 4);
  const Mesh slivers = placed(rough_sphere(4, 7), {1.0, 25.0, 0.2});
  check_harmonic(slivers, farthest_along(slivers, {0, -1, 0}), farthest_along(slivers, {0, 1, 0}));
  const Mesh ring = torus(48, 20, 0.7, 0.3);
  check_harmonic(ring, farthest_along(ring, {0.1, 0.01, -1}), farthest_along(ring, {0, 0.01, 1}));
}

TEST_CASE("fields: on a torus the distance goes around the hole", "[fields]") {
  const Mesh mesh = torus(120, 40, 0.7, 0.3);
  const VertexId inside = 30 * 120;  // on the innermost circle
  const std::vector<double> found = distances(mesh, inside);
  CHECK(glm::length(mesh.positions[inside]) == Approx(0.4));
  CHECK(found[inside + 60] == Approx(0.4 * std::numbers::pi).epsilon(0.03));
  CHECK(*std::min_element(found.begin(), found.end()) == 0.0);
}

TEST_CASE("fields: size, place and numbering change nothing", "[fields]") {
  const Mesh mesh = rough_sphere(3, 8);
  const std::vector<double> far = distances(mesh, 5);
  const std::vector<double> field = harmonic(mesh, 5, 77);
  for (const double scale : {1e3, 1e-3}) {
    const Mesh other = placed(mesh, glm::dvec3(scale));
    CHECK(worst_difference(distances(other, 5), far, scale) < 1e-9);
    CHECK(worst_difference(harmonic(other, 5, 77), field) < 1e-9);
  }
  const Mesh away = placed(mesh, glm::dvec3(1.0), {1e4, -1e4, 1e4});
  CHECK(worst_difference(distances(away, 5), far) < 1e-7);
  CHECK(worst_difference(harmonic(away, 5, 77), field) < 1e-7);

  const Shuffled other = shuffled(mesh, 9);
  const std::vector<double> moved_far = distances(other.mesh, other.moved[5]);
  const std::vector<double> moved_field = harmonic(other.mesh, other.moved[5], other.moved[77]);
  for (std::size_t v = 0; v < far.size(); ++v) {
    CHECK(moved_far[other.moved[v]] == Approx(far[v]).margin(1e-9));
    CHECK(moved_field[other.moved[v]] == Approx(field[v]).margin(1e-9));
  }
}

TEST_CASE("fields: a seam is no border, and strays get 0", "[fields]") {
  const Mesh welded = sphere(24, 15);
  Mesh seamed = sphere(24, 15, true);
  const std::vector<VertexId> twin = find_twins(seamed.positions);
  const auto copy = static_cast<VertexId>(1 + 24);  // of the first vertex, on the first ring
  REQUIRE(twin[copy] == 1);
  seamed.positions.emplace_back(5.0, 5.0, 5.0);
  const std::vector<double> one = distances(welded, 1);
  const std::vector<double> two = distances(seamed, copy);
  const std::vector<double> field_one = harmonic(welded, 1, 40);
  const std::vector<double> field_two = harmonic(seamed, copy, 41);
  std::size_t place = 0;
  for (std::size_t v = 0; v + 1 < seamed.positions.size(); ++v) {
    if (twin[v] != v) {
      CHECK(two[v] == two[twin[v]]);
      CHECK(field_two[v] == field_two[twin[v]]);
      continue;
    }
    CHECK(two[v] == Approx(one[place]).margin(1e-9));
    CHECK(field_two[v] == Approx(field_one[place]).margin(1e-9));
    ++place;
  }
  CHECK(place == one.size());
  CHECK(two.back() == 0.0);
  CHECK(field_two.back() == 0.0);
  const auto stray = static_cast<VertexId>(seamed.positions.size() - 1);
  CHECK_THROWS_AS(distances(seamed, stray), Bug);
  CHECK_THROWS_AS(harmonic(seamed, 1, copy), Bug);
}
