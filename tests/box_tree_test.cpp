// The nearest place of a mesh by its own boxes is the one that a tree of all triangles finds.
#include "knit/mesh/box_tree.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <random>

#include "knit/mesh/shapes.h"
#include "knit/mesh/triangle_tree.h"
#include "tests/support/catch.h"

using namespace knit;

namespace {

double anywhere(std::mt19937_64& random) {
  return 2.4 * static_cast<double>(random() >> 11U) * 0x1p-53 - 1.2;
}

// Corners, middles of sides and triangles, and points in the air.
std::vector<glm::dvec3> points_about(const Mesh& mesh, std::mt19937_64& random) {
  std::vector<glm::dvec3> points;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 97) {
    const auto& [a, b, c] = mesh.triangles[t];
    const auto& p = mesh.positions;
    points.insert(points.end(), {p[a], 0.5 * (p[b] + p[c]), (p[a] + p[b] + p[c]) / 3.0});
  }
  for (int i = 0; i < 200; ++i) points.push_back({anywhere(random), anywhere(random), anywhere(random)});
  return points;
}

}  // namespace

TEST_CASE("box tree: it finds what a tree of all triangles finds, in whatever order they are") {
  std::mt19937_64 random(7);
  Mesh mesh = sphere(96, 65);
  if (GENERATE(false, true)) {
    for (std::size_t i = mesh.triangles.size(); i > 1; --i)
      std::swap(mesh.triangles[i - 1], mesh.triangles[random() % i]);
  }
  const auto input = make_input(mesh);
  const TriangleTree tree(input->mesh.positions, input->mesh.triangles);
  BoxTree boxes(*input);
  for (const glm::dvec3& point : points_about(input->mesh, random)) {
    const SurfacePlace by_boxes = boxes.nearest(point), by_tree = tree.nearest(point);
    CHECK(by_boxes.triangle == by_tree.triangle);
    CHECK(by_boxes.point == by_tree.point);
  }
}

TEST_CASE("box tree: so do boxes around triangles that move, from whatever triangle a search begins") {
  std::mt19937_64 random(11);
  const Mesh mesh = sphere(48, 33);
  const TriangleTree tree(mesh.positions, mesh.triangles);
  BoxTree boxes(mesh.positions, mesh.triangles);
  for (const glm::dvec3& point : points_about(mesh, random)) {
    const auto guess = static_cast<std::uint32_t>(random() % mesh.triangles.size());
    const SurfacePlace by_boxes = boxes.nearest(point, guess), by_tree = tree.nearest(point);
    CHECK(by_boxes.triangle == by_tree.triangle);
    CHECK(by_boxes.point == by_tree.point);
  }
}

TEST_CASE(
    "box tree: where triangles are listed side by side a search looks at few, else it says at how many") {
  Mesh mesh = sphere(200, 201);
  const auto tried = [](const Mesh& of) {
    const auto input = make_input(of);
    BoxTree boxes(*input);
    for (std::size_t t = 0; t < of.triangles.size(); t += 800)
      CHECK(boxes.nearest(of.positions[of.triangles[t][0]]).point == of.positions[of.triangles[t][0]]);
    return boxes.tried() / (of.triangles.size() / 800);
  };
  CHECK(tried(mesh) < 2000);
  std::mt19937_64 random(7);
  for (std::size_t i = mesh.triangles.size(); i > 1; --i)
    std::swap(mesh.triangles[i - 1], mesh.triangles[random() % i]);
  CHECK(tried(mesh) > mesh.triangles.size() / 4);
}
