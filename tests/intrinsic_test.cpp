#include "knit/timing/intrinsic.h"

#include <cmath>
#include <map>
#include <numbers>

#include "tests/support/catch.h"
#include "tests/support/rough_sphere.h"

using namespace knit;
using namespace test_support;

namespace {

// What the surface has at each place: the sum of the angles around it.
std::vector<double> angles_around(const IntrinsicMesh& net, std::size_t vertex_count) {
  std::vector<double> angles(vertex_count, 0.0);
  for (std::size_t t = 0; t < net.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      angles[net.triangles[t][k]] += std::atan2(1.0, cotangents_of(net.lengths[t])[k]);
  return angles;
}

bool has_loop(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

double total_area(const IntrinsicMesh& net) {
  double sum = 0.0;
  for (const SideLengths& lengths : net.lengths) sum += area_of(lengths);
  return sum;
}

// The mesh as it is, without a flip.
IntrinsicMesh unflipped(const Mesh& mesh) {
  IntrinsicMesh net{mesh.triangles, {}, 0.0};
  for (const Triangle& t : mesh.triangles) {
    const auto side = [&](std::size_t k) {
      return glm::distance(mesh.positions[t[k]], mesh.positions[t[(k + 1) % 3]]);
    };
    net.lengths.push_back({side(0), side(1), side(2)});
  }
  return net;
}

// An edge by its ends, the lower first.
std::array<VertexId, 2> ends_of(VertexId a, VertexId b) { return {std::min(a, b), std::max(a, b)}; }

std::map<std::array<VertexId, 2>, double> weights_of(const IntrinsicMesh& net) {
  std::map<std::array<VertexId, 2>, double> weights;
  for (std::size_t t = 0; t < net.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      weights[ends_of(net.triangles[t][k], net.triangles[t][(k + 1) % 3])] +=
          0.5 * cotangents_of(net.lengths[t])[(k + 2) % 3];
    }
  }
  return weights;
}

std::map<std::array<VertexId, 2>, int> sides_of(const IntrinsicMesh& net) {
  std::map<std::array<VertexId, 2>, int> sides;
  for (const Triangle& t : net.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++sides[ends_of(t[k], t[(k + 1) % 3])];
  return sides;
}

// Of the edges that have triangles on both sides.
double least_inner_weight(const IntrinsicMesh& net) {
  auto sides = sides_of(net);
  double least = 0.0;
  for (const auto& [edge, weight] : weights_of(net))
    if (sides[edge] % 2 == 0) least = std::min(least, weight);
  return least;
}

double least_weight(const IntrinsicMesh& net) {
  double least = 0.0;
  for (const auto& [edge, weight] : weights_of(net)) least = std::min(least, weight);
  return least;
}

// How far the net is from the surface it was made of, in area (relative) and in the angle around a place.
double change_of(const Mesh& mesh, const IntrinsicMesh& net) {
  const IntrinsicMesh before = unflipped(mesh);
  const std::vector<double> angles = angles_around(net, mesh.positions.size());
  const std::vector<double> wanted = angles_around(before, mesh.positions.size());
  double worst = std::abs(total_area(net) / total_area(before) - 1.0);
  for (std::size_t v = 0; v < angles.size(); ++v) worst = std::max(worst, std::abs(angles[v] - wanted[v]));
  return worst;
}

// Its corners are whole numbers, so that nothing is rounded along its edges.
Mesh tetrahedron() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {16, 0, 0}, {8, 12, 0}, {8, 4, 10}};
  mesh.triangles = {{1, 0, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return mesh;
}

}  // namespace

TEST_CASE("intrinsic: a triangle's area, angles and layout come from its lengths", "[intrinsic]") {
  const SideLengths lengths{4.0, 5.0, 3.0};  // the right angle at corner 0
  CHECK(area_of(lengths) == Approx(6.0));
  CHECK(cotangents_of(lengths)[0] == Approx(0.0).margin(1e-12));
  CHECK(cotangents_of(lengths)[1] == Approx(4.0 / 3.0));
  CHECK(cotangents_of(lengths)[2] == Approx(3.0 / 4.0));
  CHECK(lay_out(lengths, 0).x == Approx(0.0).margin(1e-12));
  CHECK(lay_out(lengths, 0).y == Approx(3.0));
  CHECK(lay_out(lengths, 1).x == Approx(16.0 / 5.0));
  CHECK(lay_out(lengths, 1).y == Approx(12.0 / 5.0));
  for (const SideLengths& flat : {SideLengths{1.0, 2.0, 3.0}, SideLengths{1.0, 1.0, 0.0}})
    for (const double cotangent : cotangents_of(flat)) CHECK(std::isfinite(cotangent));
}

TEST_CASE("intrinsic: flips leave the surface as it is and no weight negative", "[intrinsic]") {
  for (const Mesh& mesh : {rough_sphere(3, 1), placed(rough_sphere(3, 2), {1.0, 20.0, 1.0}),
                           placed(rough_sphere(3, 3), {1.0, 0.05, 1.0})}) {
    REQUIRE(least_weight(unflipped(mesh)) < -1.0);
    const IntrinsicMesh net = make_intrinsic(*make_input(mesh));
    CHECK(least_weight(net) > -1e-7);
    CHECK(change_of(mesh, net) < 1e-6);
  }
}

TEST_CASE("intrinsic: a net of four triangles may be glued to itself in any way", "[intrinsic]") {
  Dice dice(5);
  std::size_t led_back = 0;
  for (int i = 0; i < 300; ++i) {
    Mesh mesh;
    for (int v = 0; v < 4; ++v)
      mesh.positions.emplace_back(dice.between(-1, 1), dice.between(-8, 8), dice.between(-0.1, 0.1));
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
    const IntrinsicMesh net = make_intrinsic(*make_input(mesh));
    CHECK(least_weight(net) > -1e-6);
    CHECK(change_of(mesh, net) < 1e-6);
    if (std::any_of(net.triangles.begin(), net.triangles.end(), has_loop)) ++led_back;
  }
  CHECK(led_back > 10);
}

TEST_CASE("intrinsic: long thin triangles may wrap around the surface", "[intrinsic]") {
  // A ring of three long prisms of 400 sides: Delaunay edges wind around them.
  const Mesh ring = torus(3, 400, 1.0, 0.01);
  REQUIRE(least_weight(unflipped(ring)) < -0.01);
  const IntrinsicMesh net = make_intrinsic(*make_input(ring));
  CHECK(least_weight(net) > -1e-7);
  CHECK(change_of(ring, net) < 1e-6);
  // The doubled triangle: the simplest closed net.
  Mesh pillow;
  pillow.positions = {{0, 0, 0}, {10, 0, 0}, {5, 0.5, 0}};
  pillow.triangles = {{0, 1, 2}, {0, 2, 1}};
  const IntrinsicMesh folded = make_intrinsic(*make_input(pillow));
  CHECK(total_area(folded) == Approx(5.0));
  const bool leads_back =
      std::any_of(folded.triangles.begin(), folded.triangles.end(),
                  [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  CHECK(leads_back);
}

TEST_CASE("intrinsic: four corners on one circle keep their diagonal", "[intrinsic]") {
  const Mesh rings = sphere(32, 16);
  CHECK(make_intrinsic(*make_input(rings)).triangles == rings.triangles);
  const Mesh far_off = placed(rings, glm::dvec3(1.0), glm::dvec3(1e4));
  CHECK(make_intrinsic(*make_input(far_off)).triangles == rings.triangles);
}

TEST_CASE("intrinsic: faces that point the other way are turned", "[intrinsic]") {
  const Mesh right = rough_sphere(2, 4);
  Mesh mixed = right;
  for (std::size_t t = 0; t < mixed.triangles.size(); t += 3)
    std::swap(mixed.triangles[t][0], mixed.triangles[t][1]);
  const IntrinsicMesh net = make_intrinsic(*make_input(mixed));
  CHECK(total_area(net) == Approx(total_area(unflipped(right))).epsilon(1e-9));
  CHECK(least_weight(net) > -1e-7);
}

TEST_CASE("intrinsic: triangles without area vanish into their neighbours, and collapsed ones are left out",
          "[intrinsic]") {
  // Corners along an edge that the triangle on the other side does not have: fifteen triangles on one line.
  Mesh mesh = tetrahedron();
  const double area = total_area(unflipped(mesh));
  const auto [a, b, c] = mesh.triangles[0];
  VertexId last = a;
  mesh.triangles.erase(mesh.triangles.begin());
  for (int i = 1; i <= 16; ++i) {
    VertexId next = b;
    if (i < 16) {
      next = static_cast<VertexId>(mesh.positions.size());
      mesh.positions.push_back(mesh.positions[a] + 0.0625 * i * (mesh.positions[b] - mesh.positions[a]));
    }
    mesh.triangles.push_back({last, next, c});
    if (i > 1) mesh.triangles.push_back({a, next, last});
    last = next;
  }
  const std::size_t count = mesh.triangles.size();
  mesh.triangles.push_back({a, a, c});
  const IntrinsicMesh net = make_intrinsic(*make_input(mesh));
  CHECK(net.triangles.size() == count);
  CHECK(total_area(net) == Approx(area).epsilon(1e-4));
  CHECK(least_weight(net) > -1e-7);
  for (const SideLengths& lengths : net.lengths) CHECK(area_of(lengths) > 1e-4);
}

TEST_CASE("intrinsic: the open edges of a surface stay, all others become Delaunay", "[intrinsic]") {
  Mesh open = rough_sphere(3, 1);
  open.triangles.resize(open.triangles.size() - 40);
  const std::shared_ptr<const Input> input = make_input(open);
  REQUIRE(least_inner_weight(unflipped(open)) < -1.0);
  const IntrinsicMesh net = make_intrinsic(*input);
  CHECK(least_inner_weight(net) > -1e-7);
  CHECK(change_of(open, net) < 1e-6);
  std::size_t around = 0;
  for (const MeshRim& rim : input->rims) around += rim.vertices.size();
  REQUIRE(around > 0);
  auto sides = sides_of(net);
  for (const MeshRim& rim : input->rims)
    for (std::size_t i = 0; i < rim.vertices.size(); ++i)
      CHECK(sides[ends_of(rim.vertices[i], rim.vertices[(i + 1) % rim.vertices.size()])] % 2 == 1);
}
