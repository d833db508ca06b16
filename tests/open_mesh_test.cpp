// Meshes with open edges: what is opened and what is refused, and pieces that are cast on and bound off at their edges.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include "app/files/export.h"
#include "app/files/load.h"
#include "knit/import/check.h"
#include "knit/import/check_topology.h"
#include "knit/import/obj.h"
#include "knit/insight/narrate.h"
#include "knit/mesh/edge_table.h"
#include "knit/mesh/shapes.h"
#include "knit/model/stitch_size.h"
#include "knit/pattern/rounds.h"
#include "knit/pattern/written_pattern.h"
#include "knit/quality/quality.h"
#include "knit/reader/checked_pattern.h"
#include "knit/rows/first_choice.h"
#include "knit/run/timeline.h"
#include "tests/support/catch.h"

using namespace knit;

namespace {

// Rings of `segments` vertices, open at both ends.
Mesh open_tube(const std::vector<ProfilePoint>& profile, unsigned segments) {
  Mesh mesh;
  mesh.name = "tube";
  for (const auto& [radius, y] : profile) {
    for (unsigned i = 0; i < segments; ++i) {
      const auto [sine, cosine] = turn_point(i, segments);
      mesh.positions.emplace_back(radius * sine, y, -radius * cosine);
    }
  }
  for (unsigned ring = 0; ring + 1 < profile.size(); ++ring) {
    for (unsigned i = 0; i < segments; ++i) {
      const VertexId a = ring * segments + i, b = ring * segments + (i + 1) % segments;
      mesh.triangles.push_back({a, a + segments, b});
      mesh.triangles.push_back({b, a + segments, b + segments});
    }
  }
  return mesh;
}

Mesh open_cylinder() {
  std::vector<ProfilePoint> profile;
  for (int i = 0; i <= 24; ++i) profile.push_back({1.0, i * 0.125});
  return open_tube(profile, 48);
}

Mesh sleeve() {
  std::vector<ProfilePoint> profile;
  for (int i = 0; i <= 16; ++i) profile.push_back({1.0 - 0.5 * i / 16.0, i * 0.15});
  return open_tube(profile, 40);
}

// The triangles of a ball whose middles lie above y = 0; `cut` puts the edge's vertices on that plane.
Mesh half_ball(bool cut) {
  Mesh whole = icosphere(4), mesh;
  mesh.name = "hat";
  std::vector<VertexId> number(whole.positions.size(), no_vertex);
  for (const Triangle& t : whole.triangles) {
    const double height = whole.positions[t[0]].y + whole.positions[t[1]].y + whole.positions[t[2]].y;
    if (height <= 0.0) continue;
    Triangle moved{};
    for (std::size_t k = 0; k < 3; ++k) {
      VertexId& at = number[t[k]];
      if (at == no_vertex) {
        at = static_cast<VertexId>(mesh.positions.size());
        mesh.positions.push_back(whole.positions[t[k]]);
      }
      moved[k] = at;
    }
    mesh.triangles.push_back(moved);
  }
  if (!cut) return mesh;
  for (const std::vector<VertexId>& rim : boundary_loops(mesh.triangles, find_twins(mesh.positions))) {
    for (const VertexId v : rim) {
      glm::dvec3& p = mesh.positions[v];
      const double radius = std::hypot(p.x, p.z);
      p = {p.x / radius, 0.0, p.z / radius};
    }
  }
  return mesh;
}

// Stitches as high as wide, all else left to the run.
Parameters square_stitches(const Input& input) {
  Parameters p = first_parameters(input);
  give_height(p, p.stitch.width);
  return resolved(p, input);
}

Timeline knitted(const Mesh& mesh, SwapEnds swap = SwapEnds::off) {
  const auto input = make_input(mesh);
  Parameters p = square_stitches(*input);
  p.timing.swap_ends = swap;
  Timeline run(input, p);
  run.extend_to_end();
  return run;
}

int stitches_in(const State& state) {
  int count = 0;
  for (const auto& row : state.fabric.rows()) count += size_of(*row);
  return count;
}

std::string pattern_of(const Timeline& run) {
  return pattern_as_text(
      write_pattern(rounds_of(run.furthest()), run.parameters().stitch.gauge, PatternOptions{}, "piece"));
}

Quality quality_of(const Timeline& run) {
  const StitchSize& stitch = run.parameters().stitch;
  return measure_quality(run.input(), run.furthest(), stitch.width, stitch.height);
}

// The edges of the knitted piece, as whoever opens its file finds them.
std::size_t edges_of_knitted(const Timeline& run) {
  const std::string text = app::mesh_text_of(run.furthest().fabric, "");
  std::istringstream in(text);
  Mesh mesh;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      glm::dvec3 p{};
      words >> p.x >> p.y >> p.z;
      mesh.positions.push_back(p);
    } else if (kind == "f") {
      std::vector<VertexId> corners;
      for (std::string corner; words >> corner;)
        corners.push_back(static_cast<VertexId>(std::stoul(corner) - 1));
      for (std::size_t k = 2; k < corners.size(); ++k)
        mesh.triangles.push_back({corners[0], corners[k - 1], corners[k]});
    }
  }
  std::vector<VertexId> itself(mesh.positions.size());
  for (VertexId v = 0; v < itself.size(); ++v) itself[v] = v;
  return boundary_loops(mesh.triangles, itself).size();
}

const Finding* open_finding(const CheckResult& result) {
  for (const Finding& finding : result.findings)
    if (finding.kind == FindingKind::open_edges) return &finding;
  return nullptr;
}

}  // namespace

TEST_CASE("open mesh: rims are found, in order round the edge", "[open]") {
  const auto input = make_input(open_cylinder());
  REQUIRE(input->rims.size() == 2);
  for (const MeshRim& rim : input->rims) {
    CHECK(rim.vertices.size() == 48);
    CHECK(rim.length == Approx(96.0 * std::sin(std::numbers::pi / 48.0)));
    for (std::size_t i = 0; i < rim.vertices.size(); ++i)
      CHECK(input->adjacent(rim.vertices[i], rim.vertices[(i + 1) % rim.vertices.size()]));
  }
  CHECK(input->rims[0].vertices.front() == 0);
  CHECK(handles_of(*input) == 0);
  CHECK(make_input(icosphere(2))->rims.empty());
}

TEST_CASE("open mesh: long edges are warned of, holes and too many edges refused", "[open]") {
  const CheckResult tube = check(open_cylinder());
  REQUIRE(open_finding(tube) != nullptr);
  CHECK(tube.fit());
  CHECK(open_finding(tube)->sentence.find("The mesh is open at 2 edges (96 open edges)") == 0);
  CHECK(open_finding(tube)->sentence.find("cast on at one and bound off at the other") != std::string::npos);

  Mesh holed = open_cylinder();
  holed.triangles.erase(holed.triangles.begin() + 500);
  const CheckResult hole = check(holed);
  CHECK_FALSE(hole.fit());
  CHECK(open_finding(hole)->sentence.find("The surface has 3 holes") == 0);

  Mesh torn = open_cylinder();
  torn.triangles.erase(torn.triangles.begin() + 960, torn.triangles.begin() + 976);
  const CheckResult three = check(torn);
  CHECK_FALSE(three.fit());
  CHECK(open_finding(three)->sentence.find("close all but two of them") != std::string::npos);
}

TEST_CASE("open mesh: a cylinder is knitted from edge to edge", "[open]") {
  const Timeline run = knitted(open_cylinder());
  REQUIRE(run.furthest().finished());
  REQUIRE(run.furthest().timing->kind == TimingKind::harmonic);
  const Quality quality = quality_of(run);
  const int stitches = stitches_in(run.furthest());
  INFO(stitches << " stitches, wale cv " << quality.wale.cv << ", high " << quality.wale.high);
  CHECK(stitches == Approx(1275).epsilon(0.1));
  CHECK(quality.wale.cv < 0.005);
  CHECK(quality.wale.high < 1.05);
  const Fabric placed = placed_fabric(run.furthest());
  for (const auto& stitch : placed.rows().front()->stitches)
    CHECK(stitch.position.y == Approx(0.0).margin(1e-9));
  for (const auto& stitch : placed.rows().back()->stitches)
    CHECK(stitch.position.y == Approx(3.0).margin(1e-9));
  CHECK(edges_of_knitted(run) == 2);
}

TEST_CASE("open mesh: hats and a sleeve, in words that hold", "[open]") {
  struct Piece {
    const char* name;
    Mesh mesh;
    bool open_above;
    int stitches;
    double wale_cv;
  };
  const std::vector<Piece> pieces{{"sleeve", sleeve(), true, 0, 0.05},
                                  {"hat", half_ball(true), false, 787, 0.045},
                                  {"zigzag hat", half_ball(false), false, 0, 0.06}};
  for (const Piece& piece : pieces) {
    const Timeline run = knitted(piece.mesh);
    REQUIRE(run.furthest().finished());
    const Quality quality = quality_of(run);
    INFO(piece.name << ": " << stitches_in(run.furthest()) << " stitches, wale cv " << quality.wale.cv
                    << ", high " << quality.wale.high);
    if (piece.stitches > 0) CHECK(stitches_in(run.furthest()) == Approx(piece.stitches).epsilon(0.1));
    CHECK(quality.wale.cv < piece.wale_cv);
    const std::string text = pattern_of(run);
    CHECK(check_pattern(text).verdict == PatternVerdict::holds);
    CHECK(text.find("The cast-on edge stays open.") != std::string::npos);
    CHECK((text.find("BO all") != std::string::npos) == piece.open_above);
    CHECK((text.find("pull tightly") == std::string::npos) == piece.open_above);
    CHECK(edges_of_knitted(run) == 2);
  }
}

TEST_CASE("open mesh: a hat as its stitches are placed, before they settle", "[open]") {
  const auto input = make_input(half_ball(true));
  Parameters p = square_stitches(*input);
  p.settle.settling = Settling::off;
  Timeline run(input, p);
  run.extend_to_end();
  const Quality quality = quality_of(run);
  INFO(stitches_in(run.furthest()) << " stitches, wale cv " << quality.wale.cv << ", high "
                                   << quality.wale.high);
  CHECK(stitches_in(run.furthest()) == Approx(787).epsilon(0.1));
  CHECK(quality.wale.cv == Approx(0.039).epsilon(0.1));
  CHECK(quality.wale.high == Approx(1.27).epsilon(0.1));
}

TEST_CASE("open mesh: swapped, a hat begins at its crown", "[open]") {
  const Timeline up = knitted(half_ball(true));
  const Timeline down = knitted(half_ball(true), SwapEnds::on);
  REQUIRE(down.furthest().finished());
  const auto first = [](const Timeline& run) { return size_of(*run.furthest().fabric.rows().front()); };
  const auto last = [](const Timeline& run) { return size_of(*run.furthest().fabric.rows().back()); };
  CHECK(first(down) == last(up));
  CHECK(last(down) == first(up));
  const std::string text = pattern_of(down);
  CHECK(text.find("BO all " + std::to_string(last(down)) + " sts.") != std::string::npos);
  CHECK(check_pattern(text).verdict == PatternVerdict::holds);
}

TEST_CASE("open mesh: a narrow edge is bound off, however few its stitches", "[open]") {
  std::vector<ProfilePoint> profile;
  for (int i = 0; i <= 16; ++i) profile.push_back({1.0 - 0.85 * i / 16.0, i * 0.15});
  const Timeline run = knitted(open_tube(profile, 40));
  REQUIRE(run.furthest().finished());
  const int last = size_of(*run.furthest().fabric.rows().back());
  REQUIRE(last <= most_drawn_in);
  const std::string text = pattern_of(run);
  CHECK(text.find("BO all " + std::to_string(last) + " sts.") != std::string::npos);
  CHECK(text.find("pull tightly") == std::string::npos);
  CHECK(check_pattern(text).verdict == PatternVerdict::holds);
}

TEST_CASE("open mesh: only harmonic time runs from edge to edge", "[open]") {
  const auto input = make_input(open_cylinder());
  for (const TimingKind kind : {TimingKind::linear, TimingKind::arc_length, TimingKind::geodesic}) {
    Parameters p = square_stitches(*input);
    p.timing.kind = kind;
    Timeline run(input, p);
    run.extend_to_end();
    REQUIRE(run.stop());
    CHECK(narrate(*run.stop(), p).find("only harmonic timing runs from edge to edge") != std::string::npos);
  }
}

TEST_CASE("open mesh: roles that the mesh comes with go before heights", "[open]") {
  Input roles = *make_input(open_cylinder());
  roles.rims[0].role = RimRole::end;
  roles.rims[1].role = RimRole::start;
  const auto input = std::make_shared<const Input>(std::move(roles));
  Timeline run(input, square_stitches(*input));
  run.extend_to_end();
  REQUIRE(run.furthest().finished());
  const Fabric placed = placed_fabric(run.furthest());
  CHECK(placed.rows().front()->stitches.front().position.y == Approx(3.0).margin(1e-9));
}

TEST_CASE("open mesh: relaxed, nothing is stuffed into an open piece", "[open]") {
  const auto input = make_input(half_ball(true));
  Parameters p = square_stitches(*input);
  p.relax.relaxing = Relaxing::on;
  std::vector<std::vector<glm::dvec3>> places;
  for (const double stuffing : {0.0, stuffing_hard}) {
    p.relax.stuffing = stuffing;
    Timeline run(input, p);
    run.extend_to_end();
    REQUIRE(run.furthest().finished());
    REQUIRE(relaxed_places(run.furthest()));
    places.push_back(*relaxed_places(run.furthest()));
  }
  CHECK(places[0] == places[1]);
  for (const glm::dvec3& place : places[0]) CHECK(std::isfinite(place.x + place.y + place.z));
}

TEST_CASE("open mesh: a tube is opened from a file, a torn one with the offer to mend", "[open]") {
  const auto folder = std::filesystem::temp_directory_path() / "knit_mesh_open_edges";
  std::filesystem::create_directories(folder);
  const auto write = [&](const char* name, const Mesh& mesh) {
    std::ofstream out(folder / name);
    write_obj(out, mesh, "");
    return folder / name;
  };
  const auto opened = app::open_mesh(write("tube.obj", open_cylinder()));
  REQUIRE(std::holds_alternative<app::Loaded>(opened));
  const auto& loaded = std::get<app::Loaded>(opened);
  CHECK(loaded.input->rims.size() == 2);
  REQUIRE(loaded.findings.size() == 1);
  CHECK(loaded.findings[0].severity == Severity::warning);

  Mesh holed = open_cylinder();
  holed.triangles.erase(holed.triangles.begin() + 500);
  const auto torn = app::open_mesh(write("torn.obj", holed));
  REQUIRE(std::holds_alternative<app::NotOpened>(torn));
  CHECK(std::get<app::NotOpened>(torn).plan != nullptr);
  std::filesystem::remove_all(folder);
}
