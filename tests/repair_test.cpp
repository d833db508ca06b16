// Repairs: each does what its words say and no more, and a plan is found just where repairs make a mesh fit.
#include "knit/import/repair.h"

#include <algorithm>
#include <limits>
#include <random>
#include <sstream>

#include "knit/import/check.h"
#include "knit/import/obj.h"
#include "knit/mesh/shapes.h"
#include "tests/support/catch.h"
#include "tests/support/corpus.h"
#include "tests/support/session.h"

using namespace knit;
using test_support::contains;

namespace {

Mesh read(const std::string& text) {
  std::istringstream in(text);
  auto result = read_obj(in, "test.obj");
  REQUIRE(std::holds_alternative<Mesh>(result));
  return std::get<Mesh>(std::move(result));
}

Mesh of_case(const std::string& name) {
  for (const corpus::Case& file : corpus::all_cases())
    if (file.name == name) return read(file.bytes());
  FAIL("no case " << name);
  return {};
}

bool same(const Mesh& a, const Mesh& b) {
  return a.positions == b.positions && a.triangles == b.triangles && a.edges == b.edges;
}

std::string keys_of(const RepairPlan& plan) {
  std::string keys;
  for (const RepairStep& step : plan.steps)
    keys += (keys.empty() ? "" : ",") + std::string(key_of(step.kind));
  return keys;
}

constexpr std::array<RepairKind, repair_count> all_kinds{
    RepairKind::unreferenced,  RepairKind::weld,     RepairKind::doubles, RepairKind::fins,
    RepairKind::largest_piece, RepairKind::reorient, RepairKind::holes,   RepairKind::openings};

}  // namespace

TEST_CASE("repair: a whole mesh has nothing to repair", "[repair]") {
  for (const Mesh& mesh : {corpus::ball(), icosphere(2), torus(12, 8, 0.7, 0.3)}) {
    for (const RepairKind kind : all_kinds) {
      CAPTURE(key_of(kind));
      const Repaired repaired = repair(mesh, kind);
      CHECK(repaired.step.count == 0);
      CHECK(same(repaired.mesh, mesh));
    }
    CHECK_FALSE(plan_repairs(mesh));
  }
}

TEST_CASE("repair: the plan for each bad file is the one that the corpus expects", "[repair][corpus]") {
  std::size_t planned = 0;
  for (const corpus::Case& file : corpus::shape_cases()) {
    CAPTURE(file.name);
    const Mesh mesh = read(file.bytes());
    const auto plan = plan_repairs(mesh);
    CHECK((plan ? keys_of(*plan) : "") == file.refused.repairs);
    if (!plan) continue;
    ++planned;
    CHECK(check(plan->mesh).fit());
    for (const RepairStep& step : plan->steps) {
      CAPTURE(step.would, step.did);
      CHECK(step.count > 0);
      CHECK(test_support::is_one_sentence(step.would));
      CHECK(test_support::is_one_sentence(step.did));
    }
    // By their names the same comes out, in whatever order they are given.
    std::vector<RepairKind> kinds = plan->kinds();
    std::reverse(kinds.begin(), kinds.end());
    const RepairPlan again = carry_out(mesh, kinds);
    CHECK(same(again.mesh, plan->mesh));
    CHECK(keys_of(again) == file.refused.repairs);
  }
  CHECK(planned >= 10);
}

TEST_CASE("repair: words have the numbers", "[repair]") {
  const auto would = [](const char* name, RepairKind kind) { return repair(of_case(name), kind).step.would; };
  CHECK(would("two-pieces.obj", RepairKind::largest_piece) ==
        "Keep the largest piece: drops 1 piece of 4 triangles.");
  CHECK(would("two-holes-and-a-flipped-face.obj", RepairKind::reorient) ==
        "Turn faces round: turns 1 face, so that all face outwards.");
  CHECK(would("two-holes-and-a-flipped-face.obj", RepairKind::holes) ==
        "Fill small holes: fills 2 holes of 7 edges with 3 triangles.");
  CHECK(would("stray-vertex.obj", RepairKind::unreferenced) ==
        "Drop stray vertices: drops 1 vertex that belongs to no face.");
  CHECK(would("fin.obj", RepairKind::fins) ==
        "Drop fins: drops 1 sheet of 1 triangle that hangs on an edge of three or more.");
  CHECK(would("every-face-twice.obj", RepairKind::doubles) ==
        "Drop doubled faces: drops 528 faces that stand there twice.");
  CHECK(would("collapsed-faces.obj", RepairKind::doubles) ==
        "Drop doubled faces: drops 24 faces with two corners at one place.");
  CHECK(contains(would("cracked.obj", RepairKind::weld), "merges 1318 vertices with another within 3.5e-05"));
  CHECK(repair(of_case("two-pieces.obj"), RepairKind::largest_piece).step.did ==
        "Kept the largest piece: dropped 1 piece of 4 triangles.");
}

TEST_CASE("repair: what is dropped leaves the rest as it was", "[repair]") {
  const Mesh ball = read(corpus::obj_of(corpus::ball()));
  CHECK(same(repair(of_case("two-pieces.obj"), RepairKind::largest_piece).mesh, ball));
  CHECK(same(repair(of_case("doubled-face.obj"), RepairKind::doubles).mesh, ball));
  CHECK(same(repair(of_case("every-face-twice.obj"), RepairKind::doubles).mesh, ball));
  CHECK(same(repair(of_case("fin.obj"), RepairKind::fins).mesh, ball));
  CHECK(same(repair(of_case("stray-vertex.obj"), RepairKind::unreferenced).mesh, ball));
  CHECK(same(repair(of_case("inside-out.obj"), RepairKind::reorient).mesh, ball) ==
        false);  // starts elsewhere
  CHECK(check(repair(of_case("inside-out.obj"), RepairKind::reorient).mesh).findings.empty());
  CHECK(check(repair(of_case("flipped-face.obj"), RepairKind::reorient).mesh).findings.empty());
}

TEST_CASE("repair: a crack closes and nothing moves further than the reach", "[repair]") {
  const Mesh cracked = of_case("cracked.obj");
  const Repaired repaired = repair(cracked, RepairKind::weld);
  CHECK(repaired.mesh.positions.size() == 266);
  CHECK(repaired.mesh.triangles.size() == 528);
  CHECK(check(repaired.mesh).findings.empty());
  // Two vertices further apart than the reach stay two.
  Mesh near = corpus::ball();
  near.positions.push_back(near.positions[50] +
                           glm::dvec3(2.0 * weld_reach * bounds_of(near.positions).diagonal(), 0, 0));
  near.triangles.push_back({50, 51, 266});
  CHECK(repair(near, RepairKind::weld).step.count == 0);
}

TEST_CASE("repair: a stray far away does not widen what counts as near or small", "[repair]") {
  Mesh mesh = of_case("open-bowl.obj");
  mesh.positions.push_back({1e40, 0, 0});
  CHECK(repair(mesh, RepairKind::weld).step.count == 0);
  CHECK(repair(mesh, RepairKind::holes).step.count == 0);
}

TEST_CASE("repair: a filled hole is closed and faces the way of its neighbours", "[repair]") {
  const Mesh whole = icosphere(3);
  std::size_t filled = 0;
  for (std::size_t first = 0; first + 12 < whole.triangles.size(); first += 11) {
    Mesh mesh = whole;
    const auto begin = mesh.triangles.begin() + static_cast<std::ptrdiff_t>(first);
    mesh.triangles.erase(begin, begin + static_cast<std::ptrdiff_t>(1 + first % 12));
    if (check(mesh).findings.size() != 1) continue;  // more than open edges: rims touch, pieces fall off
    const Repaired repaired = repair(mesh, RepairKind::holes);
    CAPTURE(first, repaired.step.would);
    for (const Finding& finding : check(repaired.mesh).findings) CHECK(finding.sentence.empty());
    ++filled;
  }
  CHECK(filled > 30);
}

TEST_CASE("repair: a hole across which there is an edge already is filled from its middle", "[repair]") {
  // Two faces on either side of an edge: it is the shorter way across their common rim.
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0.2}, {0.5, -1, 0.2}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 1}};
  for (glm::dvec3& p : mesh.positions) p *= 0.01;
  const auto base = static_cast<VertexId>(4);
  const Mesh far = corpus::ball();  // so that the hole is small
  for (const glm::dvec3& p : far.positions) mesh.positions.push_back(p + glm::dvec3(3));
  for (const Triangle& t : far.triangles) mesh.triangles.push_back({base + t[0], base + t[1], base + t[2]});
  const Repaired repaired = repair(mesh, RepairKind::holes);
  REQUIRE(repaired.step.count == 1);
  CHECK(repaired.mesh.positions.size() == mesh.positions.size() + 1);
  const CheckResult checked = check(repaired.mesh);
  for (const Finding& finding : checked.findings) {
    CAPTURE(finding.sentence);
    CHECK(finding.kind == FindingKind::several_pieces);
  }
}

TEST_CASE("repair: a rim that touches another is left alone", "[repair]") {
  Mesh mesh = corpus::ball();
  const auto has = [](const Triangle& t, VertexId v) { return t[0] == v || t[1] == v || t[2] == v; };
  const auto first = std::find_if(mesh.triangles.begin(), mesh.triangles.end(),
                                  [&](const Triangle& t) { return has(t, 0); });
  const Triangle one = *first;
  mesh.triangles.erase(first);
  const auto opposite = std::find_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
    return has(t, 0) && has(t, one[0]) + has(t, one[1]) + has(t, one[2]) == 1;
  });
  REQUIRE(opposite != mesh.triangles.end());
  mesh.triangles.erase(opposite);
  CHECK(repair(mesh, RepairKind::holes).step.count == 0);
  CHECK_FALSE(plan_repairs(mesh));
}

TEST_CASE("repair: what cannot be calculated with is left alone", "[repair]") {
  Mesh mesh = of_case("two-pieces.obj");
  mesh.positions[7].x = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(plan_repairs(mesh));
  CHECK(carry_out(mesh, {all_kinds.begin(), all_kinds.end()}).steps.empty());
  Mesh astray = corpus::ball();
  astray.triangles[3][1] = 4000;
  CHECK_FALSE(plan_repairs(astray));
  CHECK(carry_out(astray, {all_kinds.begin(), all_kinds.end()}).steps.empty());
  CHECK(carry_out({}, {all_kinds.begin(), all_kinds.end()}).steps.empty());
  CHECK_FALSE(plan_repairs({}));
}

TEST_CASE("repair: where none alone makes it better, those that do together are found, and no more",
          "[repair]") {
  // A fin that stands there twice: dropping one of the two leaves as much wrong as before.
  Mesh mesh = corpus::ball();
  const auto [a, b, c] = mesh.triangles[40];
  const auto tip = static_cast<VertexId>(mesh.positions.size());
  mesh.positions.push_back(1.3 * mesh.positions[a]);
  mesh.triangles.push_back({a, b, tip});
  mesh.triangles.push_back({b, a, tip});
  for (const RepairKind kind : all_kinds) CHECK_FALSE(check(carry_out(mesh, {kind}).mesh).fit());
  const auto plan = plan_repairs(mesh);
  REQUIRE(plan);
  CHECK(keys_of(*plan) == "doubles,fins");
  CHECK(check(plan->mesh).fit());
  CHECK(plan->mesh.triangles.size() == corpus::ball().triangles.size());
  CHECK(plan->pieces.empty());
  // Beside another piece, which is left out too.
  Mesh two = mesh;
  const Mesh other = corpus::moved(corpus::ball(), 0.2, 5.0);
  const auto first = static_cast<VertexId>(two.positions.size());
  two.positions.insert(two.positions.end(), other.positions.begin(), other.positions.end());
  for (const auto& triangle : other.triangles)
    two.triangles.push_back({triangle[0] + first, triangle[1] + first, triangle[2] + first});
  const auto of_two = plan_repairs(two);
  REQUIRE(of_two);
  CHECK(keys_of(*of_two) == "doubles,fins,largest-piece");
  CHECK(of_two->pieces.size() == 2);
}

TEST_CASE("repair: names lead back to their kind", "[repair]") {
  for (const RepairKind kind : all_kinds) CHECK(repair_named(key_of(kind)) == kind);
  CHECK_FALSE(repair_named("all"));
  CHECK_FALSE(repair_named(""));
}

TEST_CASE("repair: whatever is done to a mesh a plan makes it fit or there is none", "[repair]") {
  std::mt19937 random(7);  // seeded: the same meshes each time
  std::size_t planned = 0;
  for (int round = 0; round < 400; ++round) {
    Mesh mesh = sphere(8, 5);
    const auto any = [&](std::size_t count) { return static_cast<VertexId>(random() % count); };
    for (auto changes = 1 + random() % 5; changes > 0; --changes) {
      const VertexId t = any(mesh.triangles.size());
      switch (random() % 7) {
        case 0:
          mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(t));
          break;
        case 1:
          mesh.triangles.push_back(mesh.triangles[t]);
          break;
        case 2:
          std::swap(mesh.triangles[t][0], mesh.triangles[t][2]);
          break;
        case 3:
          mesh.triangles[t][any(3)] = any(mesh.positions.size());
          break;
        case 4:
          mesh.positions[any(mesh.positions.size())] = mesh.positions[any(mesh.positions.size())];
          break;
        case 5:
          mesh.positions.push_back(mesh.positions[mesh.triangles[t][0]] + glm::dvec3(1e-7));
          mesh.triangles[t][0] = static_cast<VertexId>(mesh.positions.size() - 1);
          break;
        default:
          mesh.triangles.push_back({any(mesh.positions.size()), any(mesh.positions.size()), 0});
      }
    }
    CAPTURE(round);
    const RepairPlan all = carry_out(mesh, {all_kinds.begin(), all_kinds.end()});
    CHECK(all.mesh.positions.size() <= mesh.positions.size() + mesh.triangles.size());
    const auto plan = plan_repairs(mesh);
    if (!plan) continue;
    ++planned;
    CHECK_FALSE(check(mesh).fit());
    CHECK(check(plan->mesh).fit());
    CHECK(same(carry_out(mesh, plan->kinds()).mesh, plan->mesh));
  }
  CHECK(planned > 100);
}
