// The text forms of cycles: what is read, and that what is written is read as the same curve.
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "knit/curves/cycle.h"
#include "tests/support/catch.h"

using namespace knit;

namespace {

Cycle cycle_read(std::string_view text, CycleEnd as = CycleEnd::start) {
  auto read = parse_cycle(text, as);
  if (const auto* said = std::get_if<std::string>(&read)) FAIL(*said);
  return std::get<Cycle>(std::move(read));
}

std::string cycle_fault(std::string_view text, CycleEnd as = CycleEnd::start) {
  const auto read = parse_cycle(text, as);
  const auto* said = std::get_if<std::string>(&read);
  return said == nullptr ? std::string() : *said;
}

}  // namespace

TEST_CASE("curves text: every kind is read", "[curves]") {
  CHECK(cycle_read("boundary").points.empty());
  CHECK(cycle_read("boundary:1,2,3").points == std::vector{glm::dvec3(1, 2, 3)});
  const Cycle circle = cycle_read("circle:0.5,-1,2e-1,0.25", CycleEnd::end);
  CHECK(circle.as == CycleEnd::end);
  CHECK(circle.kind == CycleKind::circle);
  CHECK(circle.points == std::vector{glm::dvec3(0.5, -1, 0.2)});
  CHECK(circle.radius == 0.25);
  CHECK_FALSE(cycle_read("circle:0,0,0").radius);
  CHECK_FALSE(cycle_read("circle:0,0,0,auto").radius);
  const Cycle band = cycle_read("band:0.5;0,0,0;1,0,0");
  CHECK(band.kind == CycleKind::band);
  CHECK(band.radius == 0.5);
  CHECK(band.points.size() == 2);
  const Cycle plane = cycle_read("plane:0,0,0,0,1,0");
  CHECK(plane.points.size() == 1);
  CHECK(plane.normal == glm::dvec3(0, 1, 0));
  CHECK(cycle_read("plane:0,0,0;1,0,0;0,0,1").points.size() == 3);
  CHECK_FALSE(cycle_read("plane:0,0,0;1,0,0;0,0,1").normal);
  CHECK(cycle_read("path:0,0,0;1,0,0;0,0,1;1,1,1").points.size() == 4);
  CHECK(cycle_read("farthest", CycleEnd::end).kind == CycleKind::farthest);
  CHECK(cycle_read("17").kind == CycleKind::vertex);
  CHECK(cycle_read("17").vertex == 17);
}

TEST_CASE("curves text: what is written is read as the same curve", "[curves]") {
  for (const std::string_view text :
       {"boundary", "boundary:1,2,3", "circle:0.5,-1,0.2,0.25", "circle:0.1,0.2,0.3", "band:0.5;0,0,0;1,0,0",
        "plane:0,0,0,0,1,0", "plane:0,0,0;1,0,0;0,0,1", "path:0,0,0;1,0,0;0,0,1", "farthest", "17"}) {
    INFO(text);
    CHECK(cycle_text(cycle_read(text)) == text);
  }
  Cycle odd = cycle_read("circle:0,0,0,1");
  odd.points[0] = {1.0 / 3.0, 1e-17, -12345678.9};
  odd.radius = 0.1 + 0.2;
  CHECK(cycle_read(cycle_text(odd)) == odd);
}

TEST_CASE("curves text: names, words and times", "[curves]") {
  Cycle cycle = cycle_read("farthest", CycleEnd::end);
  CHECK(called(cycle) == "end");
  CHECK(time_of(cycle) == 1.0);
  CHECK(time_of(cycle_read("boundary")) == 0.0);
  cycle.name = "cuff";
  cycle.value = 0.4;
  CHECK(called(cycle) == "cuff");
  CHECK(time_of(cycle) == 0.4);
  for (const CycleKind kind : {CycleKind::boundary, CycleKind::circle, CycleKind::band, CycleKind::plane,
                               CycleKind::path, CycleKind::farthest, CycleKind::vertex})
    CHECK(cycle_kind(word_of(kind)) == kind);
  CHECK_FALSE(cycle_kind("ring"));
}

TEST_CASE("curves text: what cannot be read is said", "[curves]") {
  const std::vector<std::pair<std::string_view, std::string_view>> cases{
      {"ring:1,2,3",
       "start: \"ring\" is no kind of curve. There are boundary, circle, band, plane, path and farthest, or "
       "the "
       "number of a vertex."},
      {"vertex:3",
       "start: \"vertex\" is no kind of curve. There are boundary, circle, band, plane, path and farthest, "
       "or "
       "the number of a vertex."},
      {"circle", "start: circle needs points, as in circle:X,Y,Z."},
      {"circle:1,2", "start: \"circle:1,2\" should read circle:X,Y,Z,R, a point and a radius."},
      {"circle:1,2,x,3", "start: \"x\" is no number."},
      {"circle:1,2,nan,3", "start: \"nan\" is no number."},
      {"circle:1,2,,3", "start: \"\" is no number."},
      {"band:0.5", "start: \"band:0.5\" should read band:R;X,Y,Z;..., a radius and points."},
      {"band:0.5;1,2", "start: a point has 3 numbers, \"1,2\" has 2."},
      {"plane:0,0,0",
       "start: \"plane:0,0,0\" should read plane:X,Y,Z,NX,NY,NZ, a point and a normal, or 3 points."},
      {"plane:0,0,0;1,0,0",
       "start: \"plane:0,0,0;1,0,0\" should read plane:X,Y,Z;X,Y,Z;X,Y,Z, 3 points, or a point and a "
       "normal."},
      {"farthest:0,0,0", "start: farthest takes no points."},
      {"boundary:0,0", "start: a point has 3 numbers, \"0,0\" has 2."},
      {"99999999999", "start: no mesh has a vertex 99999999999."}};
  for (const auto& [text, sentence] : cases) CHECK(cycle_fault(text) == sentence);
  CHECK(cycle_fault("circle:1", CycleEnd::end).starts_with("end: "));
}
