// The one table of parameters: text in, text out, ranges, first readers.
#include "knit/parameters.h"

#include "tests/support/catch.h"
#include "tests/support/run.h"

using namespace knit;

namespace {

std::optional<std::string> set(Parameters& parameters, const char* key, const char* text) {
  const ParameterInfo* info = find_parameter(key);
  REQUIRE(info != nullptr);
  return set_value(*info, parameters, text);
}

}  // namespace

TEST_CASE("every parameter's text reads back as the same value") {
  Parameters changed;
  changed.axis = {AxisKind::custom, {0.1, -2.0, 1e-7}};
  changed.start = 17;
  changed.stitch_width = 0.1 + 0.2;
  changed.close = Closing::thesis;
  changed.weld = Weld::on;
  for (const ParameterInfo& info : parameter_table()) {
    CAPTURE(info.key);
    Parameters read;
    CHECK_FALSE(set_value(info, read, value_text(info, changed)));
    CHECK(value_text(info, read) == value_text(info, changed));
    CHECK_FALSE(std::string(info.help).empty());
    CHECK_FALSE(range_text(info).empty());
  }
}

TEST_CASE("what is refused leaves the value, and the sentence gives the range") {
  Parameters p;
  for (const auto& [key, text] : {std::pair{"stitch-width", "0"},
                                  {"stitch-width", "-1"},
                                  {"stitch-width", "wide"},
                                  {"stitch-width", "nan"},
                                  {"stitch-width", "1e400"},
                                  {"stitch-width", ""},
                                  {"stitch-width", "1 "},
                                  {"epsilon", "0"},
                                  {"cast-on", "2"},
                                  {"cast-on", "6.5"},
                                  {"cast-on", "99999999999"},
                                  {"axis", "w"},
                                  {"axis", "0,0,0"},
                                  {"axis", "1,2"},
                                  {"axis", "1,2,3,4"},
                                  {"axis", "inf,0,0"},
                                  {"start", "-1"},
                                  {"start", "4294967295"},
                                  {"close", "arcs"},
                                  {"placement", ""},
                                  {"level-tolerance", "0.5"}}) {
    CAPTURE(key, text);
    const auto error = set(p, key, text);
    REQUIRE(error);
    CHECK(error->find(std::string("--") + key) == 0);
    CHECK(error->find("; give ") != std::string::npos);
    CHECK(p == Parameters{});
  }
  CHECK(*set(p, "cast-on", "2") == "--cast-on cannot be \"2\"; give a whole number from 3 to 1000, or auto.");
}

TEST_CASE("the first reader of a change is the earliest among what differs") {
  const Parameters base;
  Parameters p = base;
  CHECK(first_reader_of_change(base, p) == Stage::done);
  p.placement = PlacementPolicy::even;
  CHECK(first_reader_of_change(base, p) == Stage::stitches);
  p.epsilon = 0.01;
  CHECK(first_reader_of_change(base, p) == Stage::rows);
  p.stitch_width = 0.2;
  CHECK(first_reader_of_change(base, p) == Stage::cast_on);
  p.end = 3;
  CHECK(first_reader_of_change(base, p) == Stage::timing);
  p.weld = Weld::on;
  CHECK(first_reader_of_change(base, p) == Stage::import);
}

TEST_CASE("a change is carried over without touching the rest") {
  Parameters base;
  base.cast_on = 9;
  Parameters from;
  Parameters to;
  to.epsilon = 0.02;
  const Parameters result = with_change(base, from, to);
  CHECK(result.cast_on == 9);
  CHECK(result.epsilon == 0.02);
}

TEST_CASE("what does not fit together or the mesh is said") {
  const Mesh mesh = sphere(16, 8);
  Parameters p;
  CHECK_FALSE(fault_of(p, mesh));
  p.start = 1000;
  CHECK(fault_of(p, mesh)->find("--start 1000 is not a vertex") == 0);
  p.start = p.end = 5;
  CHECK(fault_of(p, mesh)->find("both vertex 5") != std::string::npos);
  p = Parameters{};
  p.epsilon = p.stitch_width;
  CHECK(fault_of(p, mesh)->find("not below the stitch width") != std::string::npos);
}

TEST_CASE("defaults follow the mesh's size") {
  const Parameters p = default_parameters(bounds_of(sphere(16, 8).positions));
  CHECK(p.stitch_width == Approx(0.03 * 2 * std::sqrt(3.0)));
  CHECK(p.epsilon == Approx(0.5 * p.stitch_width));
}
