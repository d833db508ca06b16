// The one table of parameters: text in, text out, ranges, first readers.
#include "knit/model/settings_table.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "knit/model/stitch_size.h"
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
  changed.timing.axis = {AxisKind::custom, {0.1, -2.0, 1e-7}};
  changed.timing.start = 17;
  give_width(changed, 0.1 + 0.2);
  changed.rows.close = Closing::thesis;
  changed.mesh.weld = Weld::on;
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
  p.stitches.placement = PlacementPolicy::even;
  CHECK(first_reader_of_change(base, p) == Stage::stitches);
  give_epsilon(p, 0.01);
  CHECK(first_reader_of_change(base, p) == Stage::rows);
  give_width(p, 0.2);
  CHECK(first_reader_of_change(base, p) == Stage::tubes);
  p.timing.end = 3;
  CHECK(first_reader_of_change(base, p) == Stage::timing);
  p.mesh.weld = Weld::on;
  CHECK(first_reader_of_change(base, p) == Stage::import);
}

TEST_CASE("with contours all that makes stitches is read where tubes get their order") {
  for (const RowSource source : {RowSource::rings, RowSource::contours, RowSource::by_itself}) {
    Parameters base;
    base.rows.source = source;
    Parameters p = base;
    p.stitches.placement = PlacementPolicy::even;
    const bool rings = source == RowSource::rings;
    CHECK(first_reader_of_change(base, p) == (rings ? Stage::stitches : Stage::tubes));
    p = base;
    p.rows.cast_on = 9;
    CHECK(first_reader_of_change(base, p) == (rings ? Stage::cast_on : Stage::tubes));
    p = base;
    p.settle.settling = Settling::on;
    CHECK(first_reader_of_change(base, p) == Stage::faces);
    p = base;
    p.relax.stuffing = stuffing_firm;
    CHECK(first_reader_of_change(base, p) == Stage::done);  // nobody stuffs it
    p.relax.relaxing = Relaxing::on;
    CHECK(first_reader_of_change(base, p) == Stage::faces);
    Parameters firm = p, settled = base;
    firm.relax.stuffing = stuffing_hard;
    CHECK(first_reader_of_change(p, firm) == Stage::relax);
    settled.settle.settling = Settling::on;
    p.settle.settling = Settling::on;
    CHECK(first_reader_of_change(settled, p) == Stage::settle);
  }
  // Only `nearest` reads it, and so does nothing here.
  Parameters base;
  base.rows.source = RowSource::contours;
  Parameters p = base;
  p.stitches.stacking_penalty = 1.0;
  CHECK(first_reader_of_change(base, p) == Stage::done);
}

TEST_CASE("a change is carried over without touching the rest") {
  Parameters base;
  base.rows.cast_on = 9;
  Parameters from;
  Parameters to;
  give_epsilon(to, 0.02);
  const Parameters result = with_change(base, from, to);
  CHECK(result.rows.cast_on == 9);
  CHECK(result.epsilon() == 0.02);
}

TEST_CASE("what does not fit together or the mesh is said") {
  const Mesh mesh = sphere(16, 8);
  Parameters p;
  CHECK_FALSE(fault_of(p, *make_input(mesh)));
  p.timing.start = 1000;
  CHECK(fault_of(p, *make_input(mesh))->find("--start 1000 is not a vertex") == 0);
  p.timing.start = p.timing.end = 5;
  CHECK(fault_of(p, *make_input(mesh))->find("both vertex 5") != std::string::npos);
  p = Parameters{};
  give_epsilon(p, p.stitch.width);
  CHECK(fault_of(p, *make_input(mesh))->find("must be smaller than the stitch width") != std::string::npos);
}

TEST_CASE("a picked vertex that is no part of the surface is a fault, whatever the timing") {
  Mesh mesh = sphere(16, 8);
  const auto stray = static_cast<VertexId>(mesh.positions.size());
  mesh.positions.emplace_back(0, 5, 0);
  for (const bool on_a_line : {false, true}) {
    if (on_a_line) mesh.triangles.push_back({0, stray, stray});
    Parameters p;
    p.timing.kind = TimingKind::harmonic;
    p.timing.end = stray;
    REQUIRE(fault_of(p, *make_input(mesh)));
    CHECK(fault_of(p, *make_input(mesh))->find("--end " + std::to_string(stray) + " belongs to no face") ==
          0);
    p.timing.end = stray - 1;
    CHECK_FALSE(fault_of(p, *make_input(mesh)));
  }
  // A copy that no face uses lies on the surface all the same.
  mesh.positions.push_back(mesh.positions[3]);
  Parameters p;
  p.timing.start = stray + 1;
  CHECK_FALSE(fault_of(p, *make_input(mesh)));
}

TEST_CASE("a value that no text could have given is a fault") {
  const Mesh mesh = sphere(16, 9, false);
  const auto fault_with = [&](auto change) {
    Parameters parameters;
    change(parameters);
    return fault_of(parameters, *make_input(mesh)).value_or("");
  };
  CHECK(fault_with([](Parameters&) {}).empty());
  CHECK(fault_with([](Parameters& p) {
          p.rows.source = RowSource::contours;
          give_width(p, 0.0);
        }).starts_with("--stitch-width cannot be \"0\""));
  CHECK(fault_with([](Parameters& p) { give_epsilon(p, std::nan("")); }).starts_with("--epsilon cannot be"));
  CHECK(fault_with([](Parameters& p) { p.rows.cast_on = -1; }).starts_with("--cast-on cannot be"));
  CHECK(fault_with([](Parameters& p) { give_gauge(p, {22.0, -4.0}); }).starts_with("--gauge cannot be"));
  CHECK(fault_with([](Parameters& p) {
          p.timing.axis = {AxisKind::custom, glm::dvec3(0.0)};
        }).starts_with("--axis cannot be"));
}

TEST_CASE("defaults follow the mesh's size") {
  const Parameters p = default_parameters(bounds_of(sphere(16, 8).positions));
  CHECK(p.stitch.width == Approx(0.03 * 2 * std::sqrt(3.0)));
  CHECK(p.epsilon() == Approx(0.5 * p.stitch.width));
}

TEST_CASE("numbers or auto, counts or auto, directions and gauges read back as they were written") {
  struct Case {
    const char* key;
    const char* text;
    const char* written;
  };
  for (const Case& c : {Case{"stitch-height", "auto", "auto"},
                        Case{"stitch-height", "0.072", "0.072"},
                        Case{"stitch-height", "1e-9", "1e-09"},
                        Case{"stacking-penalty", "0", "0"},
                        Case{"stacking-penalty", "2.50", "2.5"},
                        Case{"stacking-penalty", "1000", "1000"},
                        Case{"cast-on", "auto", "auto"},
                        Case{"cast-on", "3", "3"},
                        Case{"cast-on", "1000", "1000"},
                        Case{"start-direction", "auto", "auto"},
                        Case{"start-direction", "-1,0,0.5", "-1,0,0.5"},
                        Case{"start-direction", "0,0,1e-7", "0,0,1e-07"},
                        Case{"gauge", "22,32", "22,32"},
                        Case{"gauge", "21.5,0.1", "21.5,0.1"},
                        Case{"height-cm", "10000", "10000"},
                        Case{"timing", "arc-length", "arc-length"},
                        Case{"timing", "harmonic", "harmonic"},
                        Case{"rows", "contours", "contours"},
                        Case{"sizes", "gauge", "gauge"},
                        Case{"metric", "geodesic", "geodesic"},
                        Case{"follow-mains", "on", "on"},
                        Case{"graft", "three-needle", "three-needle"}}) {
    CAPTURE(c.key, c.text);
    const ParameterInfo& info = *find_parameter(c.key);
    Parameters p;
    give_height(p, 0.3);  // so that auto changes something
    p.rows.cast_on = 7;
    p.rows.start_direction = glm::dvec3(0.0, 0.0, 2.0);
    CHECK_FALSE(set_value(info, p, c.text));
    CHECK(value_text(info, p) == c.written);
    Parameters read;
    CHECK_FALSE(set_value(info, read, value_text(info, p)));
    CHECK(value_text(info, read) == c.written);
  }
  Parameters p;
  p.rows.cast_on = 7;
  p.rows.start_direction = glm::dvec3(0.0, 0.0, 2.0);
  for (const char* key : {"stitch-height", "cast-on", "start-direction"}) CHECK_FALSE(set(p, key, "auto"));
  CHECK(p == Parameters{});  // auto is the default of each
  CHECK_FALSE(set(p, "gauge", "18.25,24"));
  CHECK(p.stitch.gauge == Gauge{18.25, 24.0});
  CHECK_FALSE(set(p, "start-direction", "-1,0,0.5"));
  CHECK(p.rows.start_direction == glm::dvec3(-1.0, 0.0, 0.5));
}

TEST_CASE("each kind of value is refused with what it takes") {
  struct Kind {
    const char* key;
    const char* gives;
    std::vector<const char*> refused;
  };
  const std::vector<Kind> kinds{
      {"stitch-height", "a number above 0, or auto", {"0", "-1", "Auto", "inf", "", "1,2"}},
      {"stacking-penalty", "a number from 0 up to 1000", {"-0.001", "1000.1", "auto", "nan"}},
      {"height-cm", "a number above 0 up to 10000", {"0", "10001", "auto", "12cm"}},
      {"cast-on", "a whole number from 3 to 1000, or auto", {"0", "2", "1001", "-6", "6.0", "Auto", ""}},
      {"start-direction",
       "a direction X,Y,Z that is not 0,0,0, or auto",
       {"0,0,0", "x", "1,2", "1,2,3,4", "1,,2", "nan,0,0", "", "1e308,1e308,1e308"}},
      {"gauge",
       "two numbers above 0, as 22,32",
       {"22", "22,", ",32", "0,32", "22,0", "-22,32", "22,32,1", "22 32", "inf,32", "auto", ""}},
      {"timing", "linear, arc-length, geodesic, harmonic or auto", {"Linear", "arc_length", "0", ""}},
      {"rows", "rings, contours or auto", {"ring", "contour"}},
      {"sizes", "mesh or gauge", {"auto"}},
      {"metric", "euclidean, arc or geodesic", {"straight"}},
      {"follow-mains", "off or on", {"yes"}}};
  for (const Kind& kind : kinds) {
    for (const char* text : kind.refused) {
      CAPTURE(kind.key, text);
      Parameters p;
      give_height(p, 0.3);
      p.rows.cast_on = 7;
      p.rows.start_direction = glm::dvec3(0.0, 0.0, 2.0);
      const Parameters before = p;
      const auto error = set(p, kind.key, text);
      REQUIRE(error);
      CHECK(*error == std::string("--") + kind.key + " cannot be \"" + text + "\"; give " + kind.gives + ".");
      CHECK(p == before);
    }
  }
}

TEST_CASE("what nothing reads is known: the rings' knobs with contours, those of nearest without it") {
  const std::vector<std::string_view> of_rings{"level-tolerance", "metric",   "epsilon", "on-stall",
                                               "last-anchor",     "resample", "close"};
  const std::vector<std::string_view> of_nearest{"stacking-penalty", "follow-mains"};
  const std::vector<std::string_view> of_contours{
      "field-smoothing", "smoothing-length", "smallest-limb", "round-start", "graft", "counts"};
  const auto among = [](const std::vector<std::string_view>& keys, std::string_view key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
  };
  for (const RowSource rows : {RowSource::rings, RowSource::contours, RowSource::by_itself}) {
    for (std::size_t i = 0; i < placement_names.size(); ++i) {
      const auto placement = static_cast<PlacementPolicy>(i);
      Parameters p;
      p.rows.source = rows;
      p.stitches.placement = placement;
      for (const ParameterInfo& info : parameter_table()) {
        CAPTURE(info.key, rows, placement);
        const bool of_settling = info.key.substr(0, 7) == "settle-";  // it is off, and counts are whole
        const bool of_short_rows = info.key.substr(0, 5) == "turn-" ||
                                   info.key.substr(0, 10) == "short-row-" || info.key == "short-rows-kept" ||
                                   (info.key == "short-rows" && rows == RowSource::rings);
        const bool of_relaxing = info.key == "stuffing" || info.key == "relax-iterations";  // likewise
        const bool idle = of_settling || of_relaxing || of_short_rows || info.key.substr(0, 7) == "rhythm-" ||
                          (among(of_rings, info.key) && rows == RowSource::contours) ||
                          (among(of_contours, info.key) && rows == RowSource::rings) ||
                          (among(of_nearest, info.key) && placement != PlacementPolicy::nearest &&
                           placement != PlacementPolicy::by_itself);
        CHECK(is_read(info, p) == !idle);
      }
    }
  }
}

TEST_CASE("every parameter has its line in the command line's page") {
  std::ifstream file(std::string(KNIT_SOURCE_DIR) + "/docs/command-line.md");
  const std::string page(std::istreambuf_iterator<char>(file), {});
  for (const ParameterInfo& info : parameter_table()) {
    CAPTURE(info.key);
    CHECK(page.find("| `--" + std::string(info.key) + "` |") != std::string::npos);
  }
}

TEST_CASE("rounds cannot begin along the direction of knitting") {
  const Mesh mesh = sphere(16, 8);
  const auto top = static_cast<VertexId>(mesh.positions.size() - 1);
  const auto fault = [&](const Axis& axis, const glm::dvec3& start, bool picked) {
    Parameters p;
    p.timing.axis = axis;
    p.rows.start_direction = start;
    if (picked) {  // the poles: from top to bottom, whatever the axis
      p.timing.start = top;
      p.timing.end = 0;
    }
    return fault_of(p, *make_input(mesh)).value_or("");
  };
  const Axis y{AxisKind::y, {}};
  const Axis x{AxisKind::x, {}};
  CHECK(fault(y, {0, -3, 0}, false) ==
        "--start-direction 0,-3,0 points along the direction of knitting; give one across it.");
  CHECK(fault({AxisKind::custom, {1, 2, 3}}, {-0.5, -1, -1.5}, false).find("-0.5,-1,-1.5") !=
        std::string::npos);
  CHECK_FALSE(fault(x, {0, 1e-9, 0}, true).empty());  // its length says nothing
  CHECK(fault(x, {0, 1e-9, 0}, false).empty());
  CHECK(fault(x, {1, 0, 0}, true).empty());
  CHECK(fault(y, {0.001, 1, 0}, false).empty());  // nearly along is across enough
  CHECK(fault(y, {0, 0, 1}, false).empty());
}

TEST_CASE(
    "auto stands for the stitch's height where it follows from that, and for nothing where the run chooses") {
  Parameters p;
  give_width(p, 0.2);
  const auto value = [&](const char* key) {
    return effective_value(std::get<Number>(find_parameter(key)->kind), p);
  };
  CHECK(value("stitch-height") == p.stitch.height);
  CHECK_FALSE(value("rhythm-simplicity"));
  p.rhythm.dial = 0.4;
  CHECK(value("rhythm-simplicity") == 0.4);
  for (const ParameterInfo& info : parameter_table()) {
    const auto* number = std::get_if<Number>(&info.kind);
    CHECK((number == nullptr || number->zero != Zero::follows || info.key == "stitch-height"));
  }
}

TEST_CASE("an epsilon as wide as the stitch is a fault only where rings are walked") {
  const Mesh mesh = sphere(16, 8);
  Parameters p;
  give_epsilon(p, 3.0 * p.stitch.width);
  CHECK(fault_of(p, *make_input(mesh)));
  p.rows.source = RowSource::contours;
  CHECK_FALSE(fault_of(p, *make_input(mesh)));
}
