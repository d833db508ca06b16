#include "knit/mesh/shapes.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <sstream>

#include "knit/import/check.h"
#include "knit/import/obj.h"
#include "tests/support/catch.h"

using namespace knit;

namespace {

struct Ringed {
  Mesh mesh;
  unsigned segments;
};

std::vector<Ringed> examples() {
  std::vector<Ringed> all;
  all.push_back({sphere(128, 65, true), 128});
  all.push_back({sphere(128, 45), 128});
  all.push_back({stretched_sphere(128, 0.07), 128});
  all.push_back({egg(128, 0.07), 128});
  all.push_back({capsule(128, 0.07), 128});
  all.push_back({cone(128, 0.07), 128});
  all.push_back({vase(128, 0.07), 128});
  return all;
}

double radius_of(const glm::dvec3& p) { return std::hypot(p.x, p.z); }

}  // namespace

TEST_CASE("shapes: every shape is closed and faces outwards", "[shapes]") {
  std::vector<Ringed> all = examples();
  all.push_back({torus(64, 20, 0.7, 0.3), 64});
  all.push_back({icosphere(3), 0});
  all.push_back({sphere(7, 5), 7});
  all.push_back({sphere(6, 2), 6});
  for (const auto& [mesh, segments] : all) {
    for (const Finding& finding : check(mesh).findings) {
      INFO(mesh.name << ": " << finding.sentence);
      CHECK(finding.kind == FindingKind::coincident);
    }
  }
}

TEST_CASE("shapes: the thesis sphere has 64 rings of 129 entries and two poles", "[shapes]") {
  const Mesh mesh = sphere(128, 65, true);
  REQUIRE(mesh.positions.size() == 64 * 129 + 2);
  CHECK(mesh.triangles.size() == 128 * 63 * 2 + 2 * 128);
  CHECK(mesh.positions.front() == glm::dvec3(0, -1, 0));
  CHECK(mesh.positions.back() == glm::dvec3(0, 1, 0));
  for (std::size_t j = 1; j <= 64; ++j) {
    const glm::dvec3* const ring = &mesh.positions[1 + (j - 1) * 129];
    CHECK(ring[0] == ring[128]);
    CHECK(ring[0].x == 0.0);
    CHECK(ring[0].z < 0.0);
    const double angle = M_PI * static_cast<double>(j) / 65.0;
    CHECK(ring[0].y == Approx(-std::cos(angle)).margin(1e-15));
    CHECK(-ring[0].z == Approx(std::sin(angle)).margin(1e-15));
    for (std::size_t i = 0; i < 129; ++i) CHECK(ring[i].y == ring[0].y);
  }
  const auto input = make_input(mesh);
  CHECK(input->twin[129] == 1);
  CHECK(input->centroid.y == Approx(0.0).margin(1e-15));
}

TEST_CASE("shapes: rings start at -z, go counter-clockwise seen along +y, equally spaced", "[shapes]") {
  const Mesh mesh = sphere(12, 5);
  for (std::size_t j = 0; j < 4; ++j) {
    const glm::dvec3* const ring = &mesh.positions[1 + j * 12];
    const double step = glm::length(ring[1] - ring[0]);
    CHECK(ring[1].x > 0.0);  // -z to +x is a left turn for who looks along +y with -z up
    for (std::size_t i = 0; i < 12; ++i) {
      CHECK(glm::length(ring[(i + 1) % 12] - ring[i]) == Approx(step));
      CHECK(glm::cross(ring[(i + 1) % 12], ring[i]).y > 0.0);
    }
  }
}

TEST_CASE("shapes: what mirrors is mirrored to the bit", "[shapes]") {
  for (const unsigned segments : {128u, 12u, 10u, 7u}) {
    const Mesh mesh = sphere(segments, 9);
    for (std::size_t j = 0; j < 8; ++j) {
      for (std::size_t i = 0; i < segments; ++i) {
        const glm::dvec3& p = mesh.positions[1 + j * segments + i];
        const glm::dvec3& across = mesh.positions[1 + j * segments + (segments - i) % segments];
        const glm::dvec3& above = mesh.positions[1 + (7 - j) * segments + i];
        CHECK(across == glm::dvec3(-p.x, p.y, p.z));
        CHECK(above == glm::dvec3(p.x, -p.y, p.z));
        if (segments % 2 == 0 && i <= segments / 2) {
          CHECK(mesh.positions[1 + j * segments + segments / 2 - i] == glm::dvec3(p.x, p.y, -p.z));
        }
        CHECK_FALSE((p.x == 0.0 && std::signbit(p.x)));
        CHECK_FALSE((p.z == 0.0 && std::signbit(p.z)));
      }
    }
  }
}

TEST_CASE("shapes: points of a turn are exact at the quarters", "[shapes]") {
  for (const unsigned long den : {4ul, 8ul, 128ul}) {
    CHECK(turn_point(0, den).sine == 0.0);
    CHECK(turn_point(den / 4, den).sine == 1.0);
    CHECK(turn_point(den / 4, den).cosine == 0.0);
    CHECK(turn_point(den / 2, den).cosine == -1.0);
    CHECK(turn_point(3 * den / 4, den).sine == -1.0);
  }
  for (unsigned long i = 0; i <= 100; ++i) {
    const double angle = 2.0 * M_PI * static_cast<double>(i) / 100.0;
    CHECK(turn_point(i, 100).sine == Approx(std::sin(angle)).margin(1e-14));
    CHECK(turn_point(i, 100).cosine == Approx(std::cos(angle)).margin(1e-14));
  }
}

TEST_CASE("shapes: the examples' rings suit w 0.1 and epsilon 0.025", "[shapes]") {
  for (const auto& [mesh, segments] : examples()) {
    INFO(mesh.name);
    const std::size_t entries = mesh.name == "sphere" && mesh.positions.size() % 129 == 2 ? 129 : segments;
    const std::size_t rings = (mesh.positions.size() - 2) / entries;
    REQUIRE(rings * entries + 2 == mesh.positions.size());
    for (std::size_t j = 0; j < rings; ++j) {
      const glm::dvec3* const ring = &mesh.positions[1 + j * entries];
      CHECK(glm::length(ring[1] - ring[0]) <= 0.05);
      CHECK(2.0 * radius_of(ring[0]) > 0.075);
      if (j + 1 == rings) continue;
      const glm::dvec3* const above = ring + entries;
      CHECK(above->y > ring->y);
      CHECK(std::hypot(above->y - ring->y, radius_of(*above) - radius_of(*ring)) < 0.075);
    }
  }
}

TEST_CASE("shapes: the vase is not convex, the egg is blunt below, the cone is pointed above", "[shapes]") {
  const auto radii = [](const Mesh& mesh) {
    std::vector<double> all;
    for (std::size_t i = 1; i + 1 < mesh.positions.size(); i += 128)
      all.push_back(radius_of(mesh.positions[i]));
    return all;
  };
  const auto turns = [&](const Mesh& mesh) {
    const std::vector<double> r = radii(mesh);
    int count = 0;
    for (std::size_t i = 2; i < r.size(); ++i) count += (r[i] > r[i - 1]) != (r[i - 1] > r[i - 2]) ? 1 : 0;
    return count;
  };
  CHECK(turns(vase(128, 0.07)) == 3);
  CHECK(turns(egg(128, 0.07)) == 1);
  CHECK(turns(cone(128, 0.07)) == 1);
  const std::vector<double> e = radii(egg(128, 0.07));
  CHECK(e[e.size() / 4] > e[e.size() - 1 - e.size() / 4]);
  const std::vector<double> c = radii(cone(128, 0.07));
  CHECK(c[c.size() / 4] > 2.0 * c[c.size() - 1 - c.size() / 4]);
}

TEST_CASE("shapes: an icosphere has 20 * 4^n triangles on the unit sphere", "[shapes]") {
  for (const unsigned n : {0u, 1u, 3u}) {
    const Mesh mesh = icosphere(n);
    const std::size_t triangles = 20ul << (2 * n);
    CHECK(mesh.triangles.size() == triangles);
    CHECK(mesh.positions.size() == triangles / 2 + 2);
    CHECK(mesh.edges.size() == triangles * 3 / 2);
    for (const glm::dvec3& p : mesh.positions) CHECK(glm::length(p) == Approx(1.0));
  }
}

TEST_CASE("shapes: what write_obj writes is read back", "[shapes]") {
  const Mesh mesh = sphere(32, 17, true);
  std::stringstream text;
  write_obj(text, mesh, "two\nlines");
  CHECK(text.str().substr(0, 16) == "# two\n# lines\nv ");
  const auto read = read_obj(text, "sphere");
  REQUIRE(std::holds_alternative<Mesh>(read));
  const Mesh& back = std::get<Mesh>(read);
  CHECK(back.triangles == mesh.triangles);
  CHECK(back.edges == mesh.edges);
  REQUIRE(back.positions.size() == mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    CHECK(glm::length(back.positions[i] - mesh.positions[i]) < 1e-15);
  }
  CHECK(find_twins(back.positions) == find_twins(mesh.positions));  // the seam stays closed
}
