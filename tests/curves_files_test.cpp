// Curves in files: what is written, what is read, and what becomes of them on a mesh of another size.
#include <glm/geometric.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "app/curves/curve_wish.h"
#include "app/curves/curves_file.h"
#include "knit/mesh/shapes.h"
#include "tests/support/cons_bytes.h"
#include "tests/support/cycles.h"
#include "tests/support/session.h"

using namespace app;
using namespace test_support;

namespace {

std::vector<knit::Cycle> brim_and_path() {
  knit::Cycle brim = circle_at({0.59, -0.74, 0.32}, 0.6, knit::CycleEnd::start);
  brim.name = "brim";
  knit::Cycle path =
      through(knit::CycleKind::path,
              {{0.69, 0.70, 0.21}, {0.0, 0.83, 0.56}, {-0.64, 0.76, 0.09}, {-0.09, 0.62, -0.78}},
              knit::CycleEnd::end);
  path.value = 0.9;
  return {brim, path};
}

CurvesFile curves_read(const std::string& text) {
  auto read = read_curves_text(text);
  if (const auto* said = std::get_if<std::string>(&read)) FAIL(*said);
  return std::get<CurvesFile>(std::move(read));
}

std::string curves_fault(const std::string& text) {
  const auto read = read_curves_text(text);
  const auto* said = std::get_if<std::string>(&read);
  return said == nullptr ? std::string() : *said;
}

std::string file_of_one(const std::string& curve) {
  return R"({"format": "knit-mesh curves", "version": 1, "curves": [)" + curve + "]}";
}

}  // namespace

TEST_CASE("curves files: what is written is read as the same", "[curves]") {
  std::vector<knit::Cycle> curves = brim_and_path();
  knit::Cycle band = through(knit::CycleKind::band, {{1, 0, 0}, {0, 1, 0}}, knit::CycleEnd::end);
  band.radius = 0.25;
  knit::Cycle plane = through(knit::CycleKind::plane, {{1, 0, 0}}, knit::CycleEnd::start);
  plane.normal = {0.0, 1.0, 0.5};
  knit::Cycle boundary{.as = knit::CycleEnd::start};
  knit::Cycle farthest{.as = knit::CycleEnd::end};
  farthest.kind = knit::CycleKind::farthest;
  for (const knit::Cycle& cycle : {band, plane, boundary, farthest}) curves.push_back(cycle);
  const CurvesFile file = curves_read(curves_text(curves, knit::icosphere(2)));
  CHECK(file.curves == curves);
  REQUIRE(file.drawn_on);
  CHECK(file.drawn_on->low.y == knit::bounds_of(knit::icosphere(2).positions).low.y);
}

TEST_CASE("curves files: a file as it is written", "[curves]") {
  knit::Mesh mesh;
  mesh.name = "box";
  mesh.positions = {{-1, -1, -1}, {1, 1, 1}};
  CHECK(curves_text(std::vector{circle_at({1, 0, 0}, 0.5, knit::CycleEnd::start)}, mesh) == R"({
  "format": "knit-mesh curves",
  "version": 1,
  "mesh": {
    "name": "box",
    "low": [
      -1.0,
      -1.0,
      -1.0
    ],
    "high": [
      1.0,
      1.0,
      1.0
    ]
  },
  "curves": [
    {
      "as": "start",
      "kind": "circle",
      "points": [
        [
          1.0,
          0.0,
          0.0
        ]
      ],
      "radius": 0.5
    }
  ]
}
)");
}

TEST_CASE("curves files: a vertex is written by its place", "[curves]") {
  const knit::Mesh ball = knit::icosphere(2);
  knit::Cycle vertex{.as = knit::CycleEnd::start};
  vertex.kind = knit::CycleKind::vertex;
  vertex.vertex = 7;
  const CurvesFile file = curves_read(curves_text(std::vector{vertex}, ball));
  REQUIRE(file.curves.size() == 1);
  CHECK(file.curves[0].kind == knit::CycleKind::circle);
  CHECK(file.curves[0].points == std::vector{ball.positions[7]});
  CHECK_FALSE(file.curves[0].radius);
}

TEST_CASE("curves files: what cannot be read is said", "[curves]") {
  const std::vector<std::pair<std::string, std::string_view>> cases{
      {"cheese", "it is no JSON; give a file that --save-curves wrote."},
      {"{}", "it holds no curves: \"format\": \"knit-mesh curves\" is missing;"},
      {R"({"format": "knit-mesh curves", "version": 2})", "it is of another version, and this program reads"},
      {file_of_one(R"({"as": "middle", "kind": "farthest"})"), "must be one of start, end."},
      {file_of_one(R"({"as": "main", "kind": "line", "points": []})"), "must be one of start, end."},
      {file_of_one(R"({"as": "end", "kind": "ring"})"), "must be one of boundary, circle, band"},
      {file_of_one(R"({"as": "end", "kind": "circle", "points": [[0, 1]]})"),
       "must be three numbers, [x, y, z]."},
      {file_of_one(R"({"as": "end", "kind": "circle"})"), "must be one point."},
      {file_of_one(R"({"as": "end", "kind": "path", "points": [[0,0,1],[0,1,0]]})"),
       "must be three points at least."},
      {file_of_one(R"({"as": "end", "kind": "band", "points": [[0,0,1]]})"), "is missing."},
      {file_of_one(R"({"as": "end", "kind": "circle", "points": [[0,0,1]], "radius": -1})"), "radius"},
      {file_of_one(R"({"as": "end", "kind": "farthest", "value": 2})"), "value"},
      {R"({"format": "knit-mesh curves", "version": 1, "curves": [],
           "mesh": {"low": [0,0,0], "high": [0,0,0]}})",
       "must lie above \"low\"."}};
  for (const auto& [text, words] : cases) {
    INFO(text << "\n" << curves_fault(text));
    CHECK(contains(curves_fault(text), std::string(words)));
  }
}

TEST_CASE("curves files: a mesh of another size is said, never made up for silently", "[curves]") {
  const knit::Mesh ball = knit::icosphere(3);
  const CurvesFile file = curves_read(curves_text(brim_and_path(), ball));
  knit::Bounds bounds = knit::bounds_of(ball.positions);
  CHECK(std::get<0>(fitted(file, bounds, false)) == brim_and_path());
  bounds.low = 10.0 * bounds.low + glm::dvec3(3, 0, 0);
  bounds.high = 10.0 * bounds.high + glm::dvec3(3, 0, 0);
  const auto refused = fitted(file, bounds, false);
  REQUIRE(std::holds_alternative<std::string>(refused));
  CHECK(std::get<std::string>(refused) ==
        "the mesh is 10 times the size it was when the curves were drawn; give --curves-scale auto to scale "
        "them "
        "with it.");
  const auto scaled = std::get<0>(fitted(file, bounds, true));
  REQUIRE(scaled.size() == 2);
  CHECK(*scaled[0].radius == Approx(6.0));
  CHECK(glm::length(scaled[0].points[0] - (10.0 * glm::dvec3(0.59, -0.74, 0.32) + glm::dvec3(3, 0, 0))) <
        1e-9);
  CHECK(scaled[1].points.size() == 4);
  CHECK(scaled[1].value == 0.9);
}

TEST_CASE("curves files: files by their ending, and options over them", "[curves]") {
  const Folder folder;
  const knit::Mesh ball = knit::icosphere(3);
  const knit::Bounds bounds = knit::bounds_of(ball.positions);
  write_text(folder.path() / "ball.curves.json", curves_text(brim_and_path(), ball));
  write_text(folder.path() / "ball.cons",
             cons_bytes({{{{0, 1, 0}}, 1.0F, 0.5F}, {{{0, -1, 0}}, 0.0F, 0.25F}}));
  const auto by_file = curves_for({folder.path() / "ball.curves.json", false, {}}, bounds);
  CHECK(std::get<0>(by_file) == brim_and_path());
  const auto by_cons = std::get<0>(curves_for({folder.path() / "ball.cons", false, {}}, bounds));
  REQUIRE(by_cons.size() == 2);
  CHECK(by_cons[0].as == knit::CycleEnd::end);
  CHECK(by_cons[1].radius == 0.25);
  knit::Cycle other{.as = knit::CycleEnd::end};
  other.kind = knit::CycleKind::farthest;
  const auto over = std::get<0>(curves_for({folder.path() / "ball.curves.json", false, {other}}, bounds));
  REQUIRE(over.size() == 2);
  CHECK(over[0] == brim_and_path()[0]);
  CHECK(over[1] == other);

  for (const auto& [name, words] : {std::pair{"none.json", "does not exist"}, std::pair{"", "is a folder"}}) {
    const auto read = read_curves_file(folder.path() / name);
    REQUIRE(std::holds_alternative<std::string>(read));
    CHECK(contains(std::get<std::string>(read), words));
  }
  write_text(folder.path() / "cut.cons", read_text(folder.path() / "ball.cons").substr(0, 20));
  const auto cut = read_curves_file(folder.path() / "cut.cons");
  CHECK(contains(std::get<std::string>(cut), "ends within its points"));
  CHECK(is_curves_file("a/hat.curves.json"));
  CHECK(is_curves_file("hat.cons"));
  CHECK_FALSE(is_curves_file("hat.json"));
}
