// Files that are sound OBJ of meshes that are not.
#include <algorithm>
#include <cmath>
#include <limits>

#include "knit/mesh/shapes.h"
#include "tests/support/corpus.h"

namespace corpus {

namespace {

using knit::Mesh;
using knit::Triangle;
using knit::VertexId;

Mesh tetrahedron() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

Mesh with(Mesh mesh, const Mesh& other, glm::dvec3 offset, double scale = 1.0) {
  const auto base = static_cast<VertexId>(mesh.positions.size());
  for (const glm::dvec3& p : other.positions) mesh.positions.push_back(scale * p + offset);
  for (const Triangle& t : other.triangles) mesh.triangles.push_back({base + t[0], base + t[1], base + t[2]});
  return mesh;
}

// Without triangles [first, last).
Mesh without(Mesh mesh, std::size_t first, std::size_t last) {
  const auto begin = mesh.triangles.begin();
  mesh.triangles.erase(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last));
  return mesh;
}

Mesh with_triangle(Mesh mesh, Triangle triangle) {
  mesh.triangles.push_back(triangle);
  return mesh;
}

Mesh with_vertex(Mesh mesh, glm::dvec3 position) {
  mesh.positions.push_back(position);
  return mesh;
}

Mesh flipped(Mesh mesh, std::size_t first, std::size_t last) {
  for (std::size_t t = first; t < last; ++t) std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
  return mesh;
}

// A band of 12 quads with a half turn in it.
Mesh moebius() {
  constexpr unsigned n = 12;
  Mesh mesh;
  for (unsigned i = 0; i < n; ++i) {
    const knit::TurnPoint around = knit::turn_point(i, n);
    const knit::TurnPoint tilt = knit::turn_point(i, 2ul * n);
    for (const double side : {-0.3, 0.3}) {
      const double r = 1.0 + side * tilt.cosine;
      mesh.positions.push_back({r * around.sine, side * tilt.sine, r * around.cosine});
    }
  }
  for (unsigned i = 0; i < n; ++i) {
    const bool last = i + 1 == n;
    const VertexId a = 2 * i;
    const VertexId c = last ? 1 : a + 2;
    const VertexId d = last ? 0 : a + 3;
    mesh.triangles.push_back({a, c, a + 1});
    mesh.triangles.push_back({a + 1, c, d});
  }
  return mesh;
}

Mesh disc() {
  Mesh mesh;
  mesh.positions.push_back({0, 0, 0});
  for (unsigned i = 0; i < 12; ++i) {
    const knit::TurnPoint at = knit::turn_point(i, 12);
    mesh.positions.push_back({at.sine, at.cosine, 0});
    mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % 12});
  }
  return mesh;
}

Mesh all_at(Mesh mesh, glm::dvec3 place) {
  std::fill(mesh.positions.begin(), mesh.positions.end(), place);
  return mesh;
}

Mesh scaled(Mesh mesh, glm::dvec3 by) {
  for (glm::dvec3& p : mesh.positions) p *= by;
  return mesh;
}

// Poles apart meet at one point: there the surface pierces itself.
Mesh pinched() {
  Mesh mesh = ball();
  mesh.positions.front() = mesh.positions.back();
  return mesh;
}

// Every triangle has corners of its own, shaken by less than any stitch: cracks everywhere.
Mesh shaken() {
  const Mesh whole = ball();
  Mesh mesh;
  unsigned turn = 0;
  for (const Triangle& t : whole.triangles) {
    const auto base = static_cast<VertexId>(mesh.positions.size());
    for (const VertexId v : t) {
      turn = (turn + 7) % 11;
      mesh.positions.push_back(whole.positions[v] + glm::dvec3(1e-7 * turn, -1e-7 * turn, 0));
    }
    mesh.triangles.push_back({base, base + 1, base + 2});
  }
  return mesh;
}

// A triangle of no area that stands between its two neighbours: on the edge 0-1.
Mesh with_sliver() {
  Mesh mesh = with_vertex(tetrahedron(), {0.5, 0, 0});
  mesh.triangles[1] = {0, 4, 3};
  mesh.triangles.push_back({4, 1, 3});
  mesh.triangles.push_back({0, 1, 4});
  return mesh;
}

// Each pole quad with the pole's corners apart: triangles that collapse by position.
Mesh with_collapsed() {
  Mesh mesh = ball();
  const auto count = static_cast<VertexId>(mesh.positions.size());
  for (VertexId i = 0; i < 24; ++i) mesh.positions.push_back(mesh.positions[0]);
  for (VertexId i = 0; i < 24; ++i) {
    mesh.triangles[i][0] = count + i;
    mesh.triangles.push_back({count + i, 1 + (i + 1) % 24, count + (i + 1) % 24});
  }
  return mesh;
}

Case refused(std::string name, const Mesh& mesh, std::vector<std::string> words, std::string repairs = "") {
  Case made{std::move(name), [mesh] { return obj_of(mesh); }};
  made.refused = {std::move(words), std::move(repairs)};
  return made;
}

Case opens(std::string name, const Mesh& mesh, std::vector<std::string> warnings = {}) {
  Case made{std::move(name), [mesh] { return obj_of(mesh); }, true};
  made.opened = {mesh.positions.size(), mesh.triangles.size(), std::move(warnings)};
  return made;
}

void add_topology(std::vector<Case>& all) {
  const Mesh whole = ball();
  const Triangle again = whole.triangles[100];
  all.push_back(refused("doubled-face.obj", with_triangle(whole, again),
                        {"3 edges belong to three or more triangles", "Remove"}, "doubles"));
  all.push_back(refused("every-face-twice.obj", with(whole, whole, {}),
                        {"792 edges belong to three or more triangles", "Remove"}, "doubles"));
  all.push_back(refused("doubled-face-turned-round.obj", with_triangle(whole, {again[0], again[2], again[1]}),
                        {"3 edges belong to three or more triangles", "Remove"}, "doubles"));
  all.push_back(refused("bow-tie.obj", with(tetrahedron(), tetrahedron(), {0, 0, 1}),
                        {"2 pieces", "Join them, or keep only one"}, "largest-piece"));
  all.push_back(refused("pinched.obj", pinched(), {"vertex", "touch only there", "Pull the parts apart"}));
  all.push_back(refused("fin.obj", with_triangle(with_vertex(whole, {3, 0, 0}), {60, 61, 266}),
                        {"1 edge belongs to three or more triangles", "Remove"}, "fins"));
  Mesh finned = without(with_vertex(whole, {3, 0, 0}), 200, 201);
  finned.triangles.push_back({60, 61, 266});
  all.push_back(refused("fin-and-hole.obj", finned, {"1 edge belongs to three or more triangles", "fins"},
                        "fins,holes"));
  all.push_back(refused("small-hole.obj", without(whole, 100, 101),
                        {"1 hole (3 open edges)", "close every hole"}, "holes"));
  all.push_back(refused("two-holes-and-a-flipped-face.obj",
                        flipped(without(without(whole, 300, 302), 100, 101), 50, 51),
                        {"2 holes", "close every hole"}, "reorient,holes"));
  all.push_back(
      opens("open-bowl.obj", without(whole, 264, 528), {"open at 1 edge (24 open edges)", "belong"}));
  all.push_back(refused("two-pieces.obj", with(whole, tetrahedron(), {3, 0, 0}),
                        {"2 pieces", "528, 4 triangles", "Join them, or keep only one"}, "largest-piece"));
  all.push_back(refused("one-inside-another.obj", with(whole, whole, {}, 0.5), {"2 pieces", "528, 528"},
                        "largest-piece"));
  all.push_back(refused("moebius-strip.obj", moebius(), {"only one side", "open a mesh of a solid shape"}));
  all.push_back(refused("cracked.obj", shaken(), {"528 pieces"}, "weld"));
  all.push_back(opens("flipped-face.obj", flipped(whole, 100, 101), {"1 triangle faces the other way"}));
  all.push_back(opens("inside-out.obj", flipped(whole, 0, 528), {"528 triangles face inwards"}));
}

void add_geometry(std::vector<Case>& all) {
  Mesh single = tetrahedron();
  single.triangles.resize(1);
  all.push_back(refused("single-triangle.obj", single, {"in one plane", "solid shape"}));
  all.push_back(refused("flat-disc.obj", disc(), {"in one plane", "solid shape"}));
  all.push_back(refused("flat-ball.obj", scaled(ball(), {1, 1, 0}), {"in one plane", "solid shape"}));
  all.push_back(refused("needle.obj", scaled(ball(), {0, 1, 0}), {"at one place", "solid shape"}));
  all.push_back(refused("all-at-one-place.obj", all_at(ball(), {1, 2, 3}), {"at one place", "solid shape"}));
  all.push_back(refused("all-at-zero.obj", all_at(ball(), {0, 0, 0}), {"at one place", "solid shape"}));
  all.push_back(opens("sliver.obj", with_sliver(), {"1 triangle has no area"}));
  all.push_back(opens(
      "collapsed-faces.obj", with_collapsed(),
      {"24 triangles have no area", "1 vertex belongs to no face", "24 vertices are at the same place"}));
  all.push_back(opens("stray-vertex.obj", with_vertex(ball(), {50, 0, 0}), {"1 vertex belongs to no face"}));
  all.push_back(refused("stray-vertex-beyond-all.obj", with_vertex(ball(), {1e200, 0, 0}),
                        {"1 vertex has a coordinate", "1e50"}, "unreferenced"));
  all.push_back(opens("seam.obj", knit::sphere(24, 12, true), {"11 vertices are at the same place"}));
  all.push_back(opens("scaled-1e-9.obj", moved(ball(), 1e-9, 0)));
  all.push_back(opens("scaled-1e9.obj", moved(ball(), 1e9, 0)));
  all.push_back(opens("moved-1e6.obj", moved(ball(), 1, 1e6)));
}

}  // namespace

std::vector<Case> shape_cases() {
  std::vector<Case> all;
  add_topology(all);
  add_geometry(all);
  return all;
}

}  // namespace corpus
