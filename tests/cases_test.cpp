// What people met with meshes in the wild, each as a small mesh of its kind: what is read, what is refused with which way
// out, and that the way out works.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <iterator>
#include <sstream>

#include "app/files/load.h"
#include "app/script/pieces.h"
#include "knit/import/check.h"
#include "knit/import/check_topology.h"
#include "knit/import/obj.h"
#include "knit/import/repair.h"
#include "knit/mesh/shapes.h"
#include "knit/run/timeline.h"
#include "tests/support/bodies.h"
#include "tests/support/catch.h"
#include "tests/support/corpus.h"
#include "tests/support/run.h"
#include "tests/support/session.h"

using namespace knit;
using test_support::contains;

namespace {

Mesh read(const std::string& text) {
  std::istringstream in(text);
  auto result = read_obj(in, "case.obj");
  REQUIRE(std::holds_alternative<Mesh>(result));
  return std::get<Mesh>(std::move(result));
}

std::string refusal(const Mesh& mesh) {
  const CheckResult result = check(mesh);
  return result.fit() ? "" : result.findings.front().sentence;
}

// Stitches of each row, from contours.
std::vector<int> rows_from_contours(const Mesh& mesh, TimingKind timing = TimingKind::linear) {
  const auto input = make_input(mesh);
  Parameters parameters = default_parameters(input->bounds);
  parameters.timing.kind = timing;
  parameters.rows.source = RowSource::contours;
  parameters.stitches.placement = PlacementPolicy::nearest;
  Timeline timeline(input, resolved(parameters, *input));
  timeline.extend_to_end();
  REQUIRE(timeline.stop() == nullptr);
  return test_support::row_sizes(timeline.furthest());
}

Mesh two_balls() {
  Mesh mesh = sphere(16, 9);
  const Mesh other = icosphere(1);
  const auto base = static_cast<VertexId>(mesh.positions.size());
  for (const glm::dvec3& p : other.positions) mesh.positions.push_back(p + glm::dvec3(5.0, 0.0, 0.0));
  for (const Triangle& t : other.triangles) mesh.triangles.push_back({base + t[0], base + t[1], base + t[2]});
  mesh.name = "two";
  return mesh;
}

// A cylinder on a wider one, of 16 corners. The ledge between them is a strip of quads, or one polygon that goes round
// the outside, across a bridge at a corner, and back round the inside, as CAD programs write it.
std::string stepped(bool keyhole, int bridge = 0) {
  constexpr int n = 16;
  std::ostringstream text;
  for (const auto& [radius, height] : {std::pair(1.0, 0.0), {1.0, 1.0}, {0.5, 1.0}, {0.5, 3.0}}) {
    for (int i = 0; i < n; ++i) {
      const double angle = 6.283185307179586 * i / n;
      text << "v " << radius * std::sin(angle) << ' ' << height << ' ' << radius * std::cos(angle) << '\n';
    }
  }
  const auto corner = [](int ring, int i) { return " " + std::to_string(1 + n * ring + i % n); };
  for (const int ring : {0, 1, 2}) {
    for (int i = 0; i < n && !(keyhole && ring == 1); ++i)
      text << 'f' << corner(ring, i) << corner(ring, i + 1) << corner(ring + 1, i + 1) << corner(ring + 1, i)
           << '\n';
  }
  if (keyhole) {
    text << 'f';
    for (int i = 0; i <= n; ++i) text << corner(1, bridge + i);
    for (int i = n; i >= 0; --i) text << corner(2, bridge + i);
    text << '\n';
  }
  text << 'f';
  for (int i = n - 1; i >= 0; --i) text << corner(0, i);
  text << "\nf";
  for (int i = 0; i < n; ++i) text << corner(3, i);
  text << '\n';
  return text.str();
}

std::string file_of(const test_support::Folder& folder, const Mesh& mesh) {
  const auto path = folder.path() / (mesh.name + ".obj");
  std::ofstream(path) << corpus::obj_of(mesh);
  return path.string();
}

}  // namespace

TEST_CASE("cases: a large opening is an edge to knit from, and closed flat where that is asked for",
          "[cases]") {
  Mesh cup = sphere(24, 13);
  std::erase_if(cup.triangles, [&](const Triangle& t) {
    return std::min({cup.positions[t[0]].y, cup.positions[t[1]].y, cup.positions[t[2]].y}) < -0.3;
  });
  CHECK(refusal(cup) == "");
  CHECK(rows_from_contours(cup, TimingKind::harmonic).size() > 1);
  CHECK(repair(cup, RepairKind::holes).step.count == 0);
  CHECK_FALSE(plan_repairs(cup));
  const RepairPlan plan = carry_out(cup, {RepairKind::openings});
  REQUIRE(plan.kinds() == std::vector{RepairKind::openings});
  CHECK(contains(plan.steps[0].would, "Close openings flat: closes 1 hole that is too large to be an error"));
  CHECK(refusal(plan.mesh) == "");
  CHECK(make_input(plan.mesh)->rims.empty());
  CHECK(plan.mesh.positions.size() == cup.positions.size() + 1);
  CHECK(rows_from_contours(plan.mesh).size() > 1);
  // A small hole is none of its business.
  Mesh pricked = sphere(24, 13);
  pricked.triangles.pop_back();
  CHECK(repair(pricked, RepairKind::openings).step.count == 0);
}

TEST_CASE("cases: pieces are counted by their triangles and kept by their number", "[cases]") {
  const Mesh mesh = two_balls();
  CHECK(contains(refusal(mesh), "--piece 1 opens that of most triangles"));
  CHECK(contains(refusal(mesh), "--piece all"));
  CHECK(pieces_to_choose(mesh, {}) == 2);
  const std::vector<PieceShare> shares = piece_shares(mesh);
  REQUIRE(shares.size() == 2);
  CHECK(shares[0].triangles == sphere(16, 9).triangles.size());
  CHECK(shares[1].triangles == icosphere(1).triangles.size());
  const Mesh small = repair(mesh, keeping_piece(2)).mesh;
  CHECK(small.triangles.size() == icosphere(1).triangles.size());
  CHECK(refusal(small) == "");
  CHECK(repair(mesh, keeping_piece(1)).mesh.triangles ==
        repair(mesh, RepairKind::largest_piece).mesh.triangles);
  CHECK(repair(mesh, keeping_piece(3)).step.count == 0);
  CHECK(repair(mesh, keeping_piece(2)).step.did ==
        "Kept piece 2: dropped 1 piece of " + std::to_string(sphere(16, 9).triangles.size()) + " triangles.");
  // By its name it goes through session files and links.
  CHECK(key_of(keeping_piece(2)) == "piece-2");
  CHECK(repair_named("piece-2") == keeping_piece(2));
  for (const char* none : {"piece-", "piece-0", "piece-2x", "piece--1", "piece-10000"})
    CHECK_FALSE(repair_named(none));
  // Of equal pieces the one with the lowest vertex comes first.
  Mesh twice = sphere(16, 9);
  const auto base = static_cast<VertexId>(twice.positions.size());
  const std::vector<Triangle> first = twice.triangles;
  for (std::size_t v = 0; v < base; ++v)
    twice.positions.push_back(twice.positions[v] + glm::dvec3(5.0, 0.0, 0.0));
  twice.triangles.clear();
  for (const Triangle& t : first) twice.triangles.push_back({base + t[0], base + t[1], base + t[2]});
  twice.triangles.insert(twice.triangles.end(), first.begin(), first.end());
  CHECK(repair(twice, keeping_piece(1)).mesh.positions[0].x < 2.0);
  CHECK(repair(twice, keeping_piece(2)).mesh.positions[0].x > 2.0);
}

TEST_CASE("cases: a piece by the command line", "[cases]") {
  const test_support::Folder folder;
  const std::string path = file_of(folder, two_balls());
  const auto opened = app::open_mesh(path, {false, {keeping_piece(2)}});
  REQUIRE(std::holds_alternative<app::Loaded>(opened));
  CHECK(std::get<app::Loaded>(opened).original->triangles.size() == icosphere(1).triangles.size());
  const auto astray = app::open_mesh(path, {false, {keeping_piece(3)}});
  REQUIRE(std::holds_alternative<app::NotOpened>(astray));
  CHECK(contains(std::get<app::NotOpened>(astray).sentence, "has no piece 3: it is in 2 pieces"));

  const auto parsed = app::parse_command_line(
      {path, "--headless", "--piece", "all", "--save-mesh", "out.obj", "--save-pattern", "-"},
      KNIT_ASSETS_DIR);
  REQUIRE(std::holds_alternative<app::CommandLine>(parsed));
  const auto lines = app::lines_of_pieces(std::get<app::CommandLine>(parsed));
  REQUIRE(std::holds_alternative<std::vector<app::CommandLine>>(lines));
  const auto& pieces = std::get<std::vector<app::CommandLine>>(lines);
  REQUIRE(pieces.size() == 2);
  CHECK(pieces[1].open.get<app::OpenFile>().repairs.piece() == 2);
  CHECK(pieces[1].saves[0].path == "out-2.obj");
  CHECK(pieces[1].saves[1].path == "-");
  CHECK(pieces[0].pattern.title == "two, piece 1 of 2");
  const auto usage = [&](const std::vector<std::string>& arguments) {
    const auto answer = app::parse_command_line(arguments, KNIT_ASSETS_DIR);
    REQUIRE(std::holds_alternative<app::Answer>(answer));
    return std::get<app::Answer>(answer).error;
  };
  CHECK(contains(usage({path, "--piece", "all"}), "needs --headless"));
  CHECK(contains(usage({path, "--piece", "0"}), "give a number from 1, or all"));
  CHECK(contains(usage({"--example", "egg", "--piece", "1"}), "needs a mesh's file"));
}

TEST_CASE("cases: patterns of pieces become one text", "[cases]") {
  const test_support::Folder folder;
  app::CommandLine line;
  line.saves = {{"pattern", folder.path() / "out.md"}, {"mesh", folder.path() / "out.obj"}};
  std::vector<app::CommandLine> pieces(2, line);
  for (std::size_t i = 0; i < 2; ++i) {
    pieces[i].saves[0].path = folder.path() / ("out-" + std::to_string(i + 1) + ".md");
    std::ofstream(pieces[i].saves[0].path) << "# piece " << i + 1 << "\n";
  }
  CHECK_FALSE(app::join_patterns(line, pieces));
  std::ifstream in(folder.path() / "out.md");
  CHECK(std::string(std::istreambuf_iterator<char>(in), {}) == "# piece 1\n\n\n# piece 2\n");
  CHECK_FALSE(std::filesystem::exists(folder.path() / "out-1.md"));
  CHECK_FALSE(std::filesystem::exists(folder.path() / "out.obj"));
}

TEST_CASE("cases: handles are counted, however the shape lies", "[cases]") {
  CHECK(handles_of(*make_input(icosphere(2))) == 0);
  CHECK(handles_of(*make_input(sphere(16, 9, true))) == 0);
  CHECK(handles_of(*make_input(torus(12, 8, 0.7, 0.3))) == 1);
  CHECK(handles_of(*make_input(test_support::arch())) == 0);
}

TEST_CASE("cases: rows from contours do not depend on how a flat ledge is cut into triangles", "[cases]") {
  const Mesh strip = read(stepped(false));
  const Mesh keyhole = read(stepped(true));
  CHECK(refusal(strip) == "");
  CHECK(refusal(keyhole) == "");
  CHECK(strip.triangles != keyhole.triangles);
  CHECK(rows_from_contours(strip) == rows_from_contours(keyhole));
}

// Their curves run straight over each triangle, and a solved field is not straight over long ones.
TEST_CASE("cases: a flat ledge of one polygon is knitted alike by every timing, wherever its bridge is",
          "[cases]") {
  const Mesh strip = read(stepped(false));
  for (const TimingKind timing :
       {TimingKind::linear, TimingKind::arc_length, TimingKind::harmonic, TimingKind::geodesic}) {
    INFO("timing " << static_cast<int>(timing));
    const std::vector<int> wanted = rows_from_contours(strip, timing);
    for (const int bridge : {0, 5, 11}) {
      INFO("bridge " << bridge);
      const std::vector<int> rows = rows_from_contours(read(stepped(true, bridge)), timing);
      REQUIRE(rows.size() == wanted.size());
      // Corners on one circle may be joined either way.
      for (std::size_t i = 0; i < rows.size(); ++i) CHECK(std::abs(rows[i] - wanted[i]) <= 1);
    }
  }
}

TEST_CASE("cases: a ledge of one polygon gets the triangles of a strip", "[cases]") {
  const Mesh ring = read(stepped(true, 5));
  CHECK(ring.triangles.size() == read(stepped(false)).triangles.size());
  int on_ledge = 0;
  for (const Triangle& t : ring.triangles) {
    if (!std::all_of(t.begin(), t.end(), [](VertexId v) { return v >= 16 && v < 48; })) continue;
    ++on_ledge;
    for (std::size_t k = 0; k < 3; ++k)  // none is longer than a diagonal of the strip's quads
      CHECK(glm::distance(ring.positions[t[k]], ring.positions[t[(k + 1) % 3]]) < 0.62);
  }
  CHECK(on_ledge == 32);
}
