#include "knit/import/check.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <optional>

#include "knit/import/obj.h"
#include "knit/mesh/shapes.h"
#include "tests/support/catch.h"

using namespace knit;

namespace {

const Finding* find(const CheckResult& result, FindingKind kind) {
  const auto found = std::find_if(result.findings.begin(), result.findings.end(),
                                  [&](const Finding& finding) { return finding.kind == kind; });
  return found == result.findings.end() ? nullptr : &*found;
}

std::vector<FindingKind> kinds(const CheckResult& result) {
  std::vector<FindingKind> all;
  for (const Finding& finding : result.findings) all.push_back(finding.kind);
  return all;
}

std::string sentences(const CheckResult& result) {
  std::string all;
  for (const Finding& finding : result.findings) all += finding.sentence + "\n";
  return all;
}

using Kinds = std::vector<FindingKind>;

Mesh tetrahedron() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

void append(Mesh& mesh, const Mesh& other, glm::dvec3 offset) {
  const auto base = static_cast<VertexId>(mesh.positions.size());
  for (const glm::dvec3& p : other.positions) mesh.positions.push_back(p + offset);
  for (const Triangle& t : other.triangles) mesh.triangles.push_back({base + t[0], base + t[1], base + t[2]});
}

// A band of n quads; half turns decide whether it is one-sided.
Mesh band(unsigned n, bool twisted) {
  Mesh mesh;
  for (unsigned i = 0; i < n; ++i) {
    const TurnPoint around = turn_point(i, n);
    const TurnPoint tilt = twisted ? turn_point(i, 2ul * n) : TurnPoint{};
    for (const double side : {-0.3, 0.3}) {
      const double r = 1.0 + side * tilt.cosine;
      mesh.positions.push_back({r * around.sine, side * tilt.sine, r * around.cosine});
    }
  }
  if (!twisted)
    for (unsigned i = 0; i < n; ++i) mesh.positions[2 * i].y = 0.5;
  for (unsigned i = 0; i < n; ++i) {
    const VertexId a = 2 * i;
    const bool swapped = twisted && i + 1 == n;
    const VertexId c = swapped ? 1 : (a + 2) % (2 * n);
    const VertexId d = swapped ? 0 : (a + 3) % (2 * n);
    mesh.triangles.push_back({a, c, a + 1});
    mesh.triangles.push_back({a + 1, c, d});
  }
  return mesh;
}

std::filesystem::path shared_mesh(const char* name) {
#ifdef KNIT_SHARED_MESHES
  return std::filesystem::path(KNIT_SHARED_MESHES) / name;
#else
  return name;
#endif
}

// Nothing, with a warning, where the meshes by others are not there.
std::optional<Mesh> shared(const char* name) {
  if (!std::filesystem::exists(shared_mesh(name))) {
    WARN("skipped: " << name << " is not there");
    return std::nullopt;
  }
  auto read = read_obj_file(shared_mesh(name));
  REQUIRE(std::holds_alternative<Mesh>(read));
  return std::get<Mesh>(std::move(read));
}

}  // namespace

TEST_CASE("check: closed shapes are fit and without a finding", "[check]") {
  for (const Mesh& mesh : {tetrahedron(), sphere(12, 7), icosphere(2), torus(12, 8, 0.7, 0.3)}) {
    const CheckResult result = check(mesh);
    INFO(mesh.name << ": " << sentences(result));
    CHECK(result.findings.empty());
    CHECK(result.fit());
  }
}

TEST_CASE("check: a seam of coincident vertices counts as closed", "[check]") {
  const CheckResult result = check(sphere(128, 65, true));
  CHECK(kinds(result) == Kinds{FindingKind::coincident});
  CHECK(result.fit());
  CHECK(result.findings[0].count == 64);
  CHECK(result.findings[0].severity == Severity::warning);
  CHECK(result.findings[0].where.front() == 129);
  CHECK(result.findings[0].where.size() == 8);
  CHECK(result.findings[0].sentence.find("vertex 129 (") != std::string::npos);
  CHECK(result.findings[0].sentence.find("--weld on") != std::string::npos);
  CHECK(check(weld(sphere(128, 65, true))).findings.empty());
}

TEST_CASE("check: no faces", "[check]") {
  CHECK(kinds(check({})) == Kinds{FindingKind::no_triangles});
  CHECK_FALSE(check({}).fit());
}

TEST_CASE("check: faces that are all lines are no surface, though they lie far apart", "[check]") {
  Mesh mesh = tetrahedron();
  mesh.triangles = {{1, 2, 1}, {3, 2, 3}, {0, 0, 3}};
  const CheckResult result = check(mesh);
  CHECK_FALSE(result.fit());
  CHECK(kinds(result) == Kinds{FindingKind::no_extent});
  CHECK(result.findings[0].count == 3);
  CHECK_FALSE(check(weld(mesh)).fit());
  mesh.positions[3] = mesh.positions[0];  // three corners that are two places
  mesh.triangles = {{0, 1, 3}, {3, 2, 0}};
  CHECK_FALSE(check(mesh).fit());
}

TEST_CASE("check: a face that is a line does not thicken a flat mesh nor stretch a solid one", "[check]") {
  Mesh flat;
  flat.positions = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}};
  flat.triangles = {{0, 2, 1}, {3, 1, 1}, {1, 2, 0}};
  CHECK(find(check(flat), FindingKind::no_extent) != nullptr);

  Mesh spiked = tetrahedron();
  spiked.positions.push_back({0, 1e6, 0});
  spiked.triangles.push_back({2, 4, 4});
  CHECK(check(spiked).fit());
  const auto input = make_input(spiked);
  CHECK(input->referenced[4] == 0);
  CHECK(input->bounds.high.y == make_input(tetrahedron())->bounds.high.y);
}

TEST_CASE("check: coordinates that are no numbers, or too large to calculate with", "[check]") {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e308, -1e51}) {
    Mesh mesh = tetrahedron();
    mesh.positions[2].y = bad;
    const CheckResult result = check(mesh);
    CHECK(kinds(result) == Kinds{FindingKind::not_finite});
    CHECK(result.findings[0].where == std::vector<VertexId>{2});
    CHECK_FALSE(result.fit());
  }
}

TEST_CASE("check: indices out of range", "[check]") {
  Mesh mesh = tetrahedron();
  mesh.triangles.push_back({1, 4, no_vertex});
  const CheckResult result = check(mesh);
  CHECK(kinds(result) == Kinds{FindingKind::index_out_of_range});
  CHECK(result.findings[0].where == std::vector<VertexId>{1});
  CHECK(check(weld(mesh)).findings[0].kind == FindingKind::index_out_of_range);
}

TEST_CASE("check: several pieces", "[check]") {
  Mesh mesh = tetrahedron();
  append(mesh, tetrahedron(), {3, 0, 0});
  append(mesh, tetrahedron(), {6, 0, 0});
  const CheckResult result = check(mesh);
  CHECK(kinds(result) == Kinds{FindingKind::several_pieces});
  CHECK(result.findings[0].count == 3);
  CHECK(result.findings[0].where == std::vector<VertexId>{0, 4, 8});
  CHECK(result.findings[0].sentence.find("4, 4, 4 triangles") != std::string::npos);
}

TEST_CASE("check: holes are counted, not edges", "[check]") {
  Mesh mesh = sphere(48, 32);
  mesh.triangles.erase(mesh.triangles.begin(), mesh.triangles.begin() + 48);  // the bottom cap
  mesh.triangles.pop_back();
  const CheckResult result = check(mesh);
  const Finding* const open = find(result, FindingKind::open_edges);
  REQUIRE(open != nullptr);
  CHECK(open->severity == Severity::error);
  CHECK(open->count == 2);
  CHECK(open->where.size() == 2);
  CHECK(open->where.front() == 1);
  CHECK(open->sentence.find("2 holes (51 open edges)") != std::string::npos);
  CHECK(open->sentence.find("vertex 1 (") != std::string::npos);
}

TEST_CASE("check: an edge of three triangles", "[check]") {
  Mesh mesh = tetrahedron();
  mesh.positions.push_back({1, 1, 1});
  mesh.triangles.push_back({1, 2, 4});
  const CheckResult result = check(mesh);
  const Finding* const edge = find(result, FindingKind::edge_not_manifold);
  REQUIRE(edge != nullptr);
  CHECK(edge->count == 1);
  CHECK(edge->where == std::vector<VertexId>{1, 2});
  CHECK(find(result, FindingKind::vertex_not_manifold) == nullptr);
  CHECK(find(result, FindingKind::not_orientable) == nullptr);
  CHECK(find(result, FindingKind::several_pieces) == nullptr);
}

TEST_CASE("check: a bow-tie vertex", "[check]") {
  Mesh mesh = tetrahedron();
  append(mesh, tetrahedron(), {0, 0, 1});  // its corner 4 is at the place of corner 3
  const CheckResult result = check(mesh);
  const Finding* const pinched = find(result, FindingKind::vertex_not_manifold);
  REQUIRE(pinched != nullptr);
  CHECK(pinched->count == 1);
  CHECK(pinched->where == std::vector<VertexId>{3});
}

TEST_CASE("check: open and closed fans, whichever triangle comes first, are no bow-tie", "[check]") {
  Mesh mesh = band(8, false);
  for (std::size_t turn = 0; turn < mesh.triangles.size(); ++turn) {
    std::rotate(mesh.triangles.begin(), mesh.triangles.begin() + 1, mesh.triangles.end());
    CHECK(find(check(mesh), FindingKind::vertex_not_manifold) == nullptr);
  }
}

TEST_CASE("check: a Moebius strip is refused, a plain band is not one-sided", "[check]") {
  const CheckResult twisted = check(band(12, true));
  const Finding* const one_sided = find(twisted, FindingKind::not_orientable);
  REQUIRE(one_sided != nullptr);
  CHECK(one_sided->severity == Severity::error);
  CHECK(find(twisted, FindingKind::open_edges)->count == 1);
  const CheckResult plain = check(band(12, false));
  CHECK(find(plain, FindingKind::not_orientable) == nullptr);
  CHECK(find(plain, FindingKind::flipped_faces) == nullptr);
  CHECK(find(plain, FindingKind::open_edges)->count == 2);
}

TEST_CASE("check: flipped faces are a warning with the smaller number", "[check]") {
  Mesh mesh = sphere(12, 7);
  for (const std::size_t t : {0u, 1u, 2u, 40u}) std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
  CheckResult result = check(mesh);
  CHECK(kinds(result) == Kinds{FindingKind::flipped_faces});
  CHECK(result.findings[0].count == 4);
  CHECK(result.fit());
  for (Triangle& t : mesh.triangles) std::swap(t[0], t[1]);
  result = check(mesh);
  CHECK(result.findings.at(0).count == 4);
}

TEST_CASE("check: a mesh turned inside out is a warning", "[check]") {
  Mesh mesh = sphere(12, 7);
  for (Triangle& t : mesh.triangles) std::swap(t[0], t[1]);
  for (glm::dvec3& p : mesh.positions) p += glm::dvec3(100, 100, 100);
  const CheckResult result = check(mesh);
  CHECK(kinds(result) == Kinds{FindingKind::inside_out});
  CHECK(result.fit());
}

TEST_CASE("check: triangles that collapse by position do not break the topology", "[check]") {
  // A UV sphere with the pole's vertices kept apart: each pole quad has a triangle of no area.
  Mesh mesh = sphere(8, 5);
  const auto count = static_cast<VertexId>(mesh.positions.size());
  for (VertexId i = 0; i < 8; ++i) mesh.positions.push_back(mesh.positions[0]);
  for (VertexId i = 0; i < 8; ++i) {
    mesh.triangles[i][0] = count + i;
    mesh.triangles.push_back({count + i, 1 + (i + 1) % 8, count + (i + 1) % 8});
  }
  const CheckResult result = check(mesh);
  INFO(sentences(result));
  CHECK(kinds(result) == Kinds{FindingKind::zero_area, FindingKind::unreferenced, FindingKind::coincident});
  CHECK(result.findings[0].count == 8);
  CHECK(result.fit());
}

TEST_CASE("check: a sliver of three distinct places is a warning, at any size", "[check]") {
  for (const double scale : {1e-20, 1.0, 1e20}) {
    Mesh mesh = tetrahedron();
    mesh.positions.push_back({0.5, 0, 0});  // on the edge 0-1, and no longer on the face below
    mesh.triangles[1] = {0, 4, 3};
    mesh.triangles.push_back({4, 1, 3});
    mesh.triangles.push_back({0, 1, 4});
    for (glm::dvec3& p : mesh.positions) p *= scale;
    const CheckResult result = check(mesh);
    INFO(scale << ": " << sentences(result));
    CHECK(kinds(result) == Kinds{FindingKind::zero_area});
    CHECK(result.findings.at(0).count == 1);
  }
}

TEST_CASE("check: meshes of no volume are refused", "[check]") {
  Mesh flat = sphere(8, 5);
  for (glm::dvec3& p : flat.positions) p = {p.x + 3, p.x + p.z, 2 * p.z};
  CHECK(find(check(flat), FindingKind::no_extent) != nullptr);
  CHECK_FALSE(check(flat).fit());

  Mesh line = sphere(8, 5);
  for (glm::dvec3& p : line.positions) p = {p.y, p.y, p.y};
  CHECK(find(check(line), FindingKind::no_extent) != nullptr);

  Mesh point = sphere(8, 5);
  for (glm::dvec3& p : point.positions) p = {1, 2, 3};
  CHECK(find(check(point), FindingKind::no_extent) != nullptr);

  Mesh thin = sphere(8, 5);
  for (glm::dvec3& p : thin.positions) p.y *= 1e-6;
  CHECK(find(check(thin), FindingKind::no_extent) == nullptr);
}

TEST_CASE("check: unreferenced vertices are a warning and do not stretch the mesh", "[check]") {
  Mesh mesh = tetrahedron();
  mesh.positions.push_back({1e30, 0, 0});
  const CheckResult result = check(mesh);
  CHECK(kinds(result) == Kinds{FindingKind::unreferenced});
  CHECK(result.findings[0].where == std::vector<VertexId>{4});
  CHECK(result.fit());
}

TEST_CASE("check: errors come before warnings, each a full sentence with a place", "[check]") {
  Mesh mesh = tetrahedron();
  mesh.positions.push_back({5, 5, 5});
  append(mesh, tetrahedron(), {0, 0, 1});
  mesh.triangles.pop_back();
  const CheckResult result = check(mesh);
  CHECK(std::is_partitioned(result.findings.begin(), result.findings.end(),
                            [](const Finding& f) { return f.severity == Severity::error; }));
  CHECK(result.findings.size() >= 4);
  for (const Finding& finding : result.findings) {
    INFO(finding.sentence);
    CHECK(finding.count > 0);
    CHECK(std::is_sorted(finding.where.begin(), finding.where.end()));
    CHECK(finding.sentence.find("vertex ") != std::string::npos);
    CHECK(finding.sentence.back() == '.');
    CHECK(finding.sentence.find('\n') == std::string::npos);
  }
}

TEST_CASE("check: closed meshes by others are fit", "[check][shared]") {
  for (const char* name :
       {"simple-sphere.obj", "simple-capsule.obj", "simple-cone.obj", "simple-cylinder.obj",
        "simple-elbow.obj", "simple-torus.obj", "teddy.obj", "bunny.obj", "spot.obj"}) {
    const auto mesh = shared(name);
    if (!mesh) continue;
    const CheckResult result = check(*mesh);
    INFO(name << ": " << sentences(result));
    CHECK(result.fit());
    CHECK(find(result, FindingKind::inside_out) == nullptr);
    CHECK(find(result, FindingKind::flipped_faces) == nullptr);
  }
}

TEST_CASE("check: what people really download is told what is wrong with it", "[check][shared]") {
  if (const auto mesh = shared("stanford-bunny.obj")) {
    const CheckResult result = check(*mesh);
    INFO(sentences(result));
    CHECK(kinds(result) == Kinds{FindingKind::open_edges, FindingKind::unreferenced});
    CHECK(result.findings[0].count == 5);
    CHECK(result.findings[1].count == 1113);
  }
  if (const auto mesh = shared("teapot.obj")) {
    const CheckResult result = check(*mesh);
    INFO(sentences(result));
    REQUIRE(find(result, FindingKind::several_pieces) != nullptr);
    CHECK(find(result, FindingKind::several_pieces)->count == 4);
    CHECK(find(result, FindingKind::open_edges) != nullptr);
  }
  if (const auto mesh = shared("suzanne.obj")) {
    const CheckResult result = check(*mesh);
    INFO(sentences(result));
    REQUIRE(find(result, FindingKind::several_pieces) != nullptr);
    CHECK(find(result, FindingKind::several_pieces)->count == 3);
    CHECK(find(result, FindingKind::open_edges) != nullptr);
  }
}
