// Relaxing in the air: its parts against figures worked out elsewhere, and sizes of examples against those of another
// solver, on the same knit meshes where rows have changed since.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "app/files/load.h"
#include "app/session/presets.h"
#include "knit/model/stitch_size.h"
#include "knit/relax/knitted.h"
#include "knit/run/timeline.h"
#include "tests/support/catch.h"
#include "tests/support/repeated.h"
#include "tests/support/run.h"
#include "tests/support/tube.h"

using namespace knit;

namespace {

struct Knitted {
  State state;
  StitchSize stitch;
};

Knitted run_of(const std::shared_ptr<const Input>& input, Parameters parameters) {
  parameters = resolved(parameters, *input);
  Timeline timeline(input, parameters);
  timeline.extend_to_end();
  REQUIRE(timeline.stop() == nullptr);
  return {timeline.furthest(), parameters.stitch};
}

// As far as its faces are made and settled.
Knitted faces_of(const std::shared_ptr<const Input>& input, Parameters parameters) {
  parameters = resolved(parameters, *input);
  State state;
  while (!state.finished() && state.stage() != Stage::pattern) advance(*input, parameters, state);
  return {std::move(state), parameters.stitch};
}

Knitted example(const std::string& name, std::string_view preset) {
  const auto loaded = app::load_example(KNIT_ASSETS_DIR, name);
  const auto& made = std::get<app::Loaded>(loaded);
  return run_of(made.input, app::with_preset(*app::find_preset(preset), made.parameters));
}

struct InTheAir {
  RelaxWork work;
  Relaxed relaxed;
  KnittedFigures figures;
};

InTheAir in_the_air(const Knitted& made, const RelaxSettings& settings = {}) {
  InTheAir air;
  begin_relaxing(made.state.fabric, made.stitch, settings, air.work);
  while (!air.work.done) advance_relaxing(settings, air.work);
  air.relaxed = finish_relaxing(air.work);
  air.figures = knitted_figures(made.state.fabric, *air.work.plan, air.relaxed, {0.0, 1.0, 0.0});
  return air;
}

std::size_t crossings(const Fabric& fabric, const InTheAir& air) {
  Joined joined(air.work.plan->net);
  return crossings_of(enclosure_of(fabric), joined, air.relaxed.positions, 1.5 * air.work.plan->width).size();
}

StitchSize square_stitch(double size) {
  StitchSize stitch;
  stitch.width = stitch.height = size;
  return stitch;
}

}  // namespace

TEST_CASE("relax: the volume of a tube is that of its rings and its gradient is exact") {
  const State tube = test_support::tube_state({{20, 24, 20}, 1.0, 0.5, 0.1});
  const Enclosure all = enclosure_of(tube.fabric);
  REQUIRE(all.rims.size() == 2);
  std::vector<glm::dvec3> at = knitting_path(tube.fabric);
  std::vector<glm::dvec3> slope(at.size(), glm::dvec3(0.0));
  add_pressure(all, at, 1.0, slope);
  glm::dvec3 force(0.0), torque(0.0);
  for (std::size_t i = 0; i < at.size(); ++i) {
    force += slope[i];
    torque += glm::cross(at[i], slope[i]);
  }
  CHECK(glm::length(force) < 1e-13);
  CHECK(glm::length(torque) < 1e-13);
  CHECK(std::abs(std::abs(volume_of(all, at)) / (std::acos(-1.0) * 1.0) - 1.0) < 0.03);
  constexpr double small = 1e-6;
  for (const std::size_t stitch : {std::size_t{0}, std::size_t{25}, std::size_t{50}}) {
    for (int axis = 0; axis < 3; ++axis) {
      const double here = at[stitch][axis];
      at[stitch][axis] = here + small;
      const double more = volume_of(all, at);
      at[stitch][axis] = here - small;
      const double less = volume_of(all, at);
      at[stitch][axis] = here;
      CHECK(std::abs((more - less) / (2.0 * small) - slope[stitch][axis]) < 1e-8);
    }
  }
}

TEST_CASE("relax: springs are of the asked lengths and wales beside shaping have room to lean") {
  const State tube = test_support::tube_state({{16, 18, 18, 6}, 1.0, 0.3, 0.0});
  const SpringNet net = make_spring_net(tube.fabric, square_stitch(0.4));
  std::size_t leaning = 0, drawn = 0, halved = 0;
  for (const Spring& spring : net.springs) {
    if (spring.kind == SpringKind::wale && spring.rest > 0.41) ++leaning;
    if (spring.kind == SpringKind::drawn) ++drawn;
    if (spring.kind == SpringKind::course && spring.stiffness < 0.6) ++halved;
    if (spring.kind == SpringKind::wale)
      CHECK((spring.rest == 0.4 || std::abs(spring.rest - std::sqrt(0.2)) < 1e-15));
  }
  CHECK(drawn == 6);
  CHECK(halved == 16);
  CHECK(leaning == 4 + 18);
}

TEST_CASE("relax: laid onto its start a turned piece is where it was") {
  const std::vector<glm::dvec3> start{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}, {1, 1, 1}};
  std::vector<glm::dvec3> turned;
  for (const glm::dvec3& p : start) turned.push_back({p.z + 5.0, p.x - 1.0, p.y + 2.0});
  const std::vector<glm::dvec3> laid = laid_onto(turned, start);
  for (std::size_t i = 0; i < start.size(); ++i) CHECK(glm::distance(laid[i], start[i]) < 1e-12);
}

TEST_CASE("relax: an edge through a sheet far along the fabric is a crossing") {
  // A tube so bent back that its last row stands across its first ones.
  State tube = test_support::tube_state({std::vector<int>(16, 12), 1.0, 0.5, 0.0});
  const SpringNet net = make_spring_net(tube.fabric, square_stitch(0.5));
  Joined joined(net);
  const Enclosure all = enclosure_of(tube.fabric);
  std::vector<glm::dvec3> at = knitting_path(tube.fabric);
  CHECK(crossings_of(all, joined, at, 0.75).empty());
  for (std::size_t i = at.size() - 12; i < at.size(); ++i) at[i] = {at[i].x + 1.0, 1.1, at[i].z};
  CHECK_FALSE(crossings_of(all, joined, at, 0.75).empty());
}

TEST_CASE("relax: the sphere comes out as another solver has it") {
  struct Asked {
    const char *name, *preset;
    double height, width, sunk;  // mm
  };
  std::vector<Asked> asked{{"sphere", "best-rows", 122.8, 123.7, 1.2},
                           {"sphere", "knitters-gauge", 119.2, 123.6, 0.3}};
  if (test_support::whole()) {
    // Another solver's table; four rows, of shapes whose rows have changed since, are what both have on today's mesh.
    asked.push_back({"egg", "best-rows", 118.0, 93.6, 0.7});
    asked.push_back({"egg", "knitters-gauge", 118.3, 94.2, 0.6});
    asked.push_back({"vase", "best-rows", 120.7, 84.6, 1.1});
    asked.push_back({"vase", "knitters-gauge", 121.0, 83.3, 0.6});
    asked.push_back({"capsule", "best-rows", 118.3, 68.8, 0.8});
    asked.push_back({"capsule", "knitters-gauge", 117.9, 69.3, 0.2});
    asked.push_back({"stretched-sphere", "best-rows", 117.4, 63.2, 0.4});
    asked.push_back({"stretched-sphere", "knitters-gauge", 114.0, 62.9, 0.4});
  }
  for (const Asked& each : asked) {
    CAPTURE(each.name, each.preset);
    const Knitted made = example(each.name, each.preset);
    const InTheAir air = in_the_air(made);
    const double mm = 10.0 * made.stitch.centimetres_per_unit;
    CHECK(air.relaxed.settled);
    CHECK(std::abs(air.figures.knitted.height * mm / each.height - 1.0) < 0.005);
    CHECK(std::abs(air.figures.knitted.width * mm / each.width - 1.0) < 0.005);
    CHECK(std::abs(std::max(air.figures.sunk[0], air.figures.sunk[1]) * mm - each.sunk) < 0.25);
    CHECK(crossings(made.state.fabric, air) == 0);
  }
}

TEST_CASE("relax: the thesis sphere becomes a barrel with ends that sink") {
  Knitted made = example("thesis-sphere", "thesis");
  constexpr double mm = 49.28;  // a radius, at 21 stitches in 10 cm
  struct Asked {
    double share, height, width;
  };
  std::vector<Asked> asked{{0.70, 160.6, 105.0}};
  if (test_support::whole()) asked = {{0.65, 144.3, 105.2}, {0.70, 160.6, 105.0}, {0.72, 167.2, 104.9}};
  for (const Asked& each : asked) {
    made.stitch.width = 0.0966;
    made.stitch.height = each.share * made.stitch.width;
    const InTheAir air = in_the_air(made);
    CAPTURE(each.share);
    CHECK(std::abs(air.figures.knitted.height * mm / each.height - 1.0) < 0.005);
    CHECK(std::abs(air.figures.knitted.width * mm / each.width - 1.0) < 0.005);
    CHECK(std::min(air.figures.sunk[0], air.figures.sunk[1]) * mm > 4.5);
    CHECK(crossings(made.state.fabric, air) == 0);
  }
}

TEST_CASE("relax: the same bits from any iteration on") {
  const Knitted made = run_of(test_support::small_sphere(), test_support::small_parameters());
  const RelaxSettings settings;
  RelaxWork work;
  begin_relaxing(made.state.fabric, made.stitch, settings, work);
  for (int i = 0; i < 17; ++i) advance_relaxing(settings, work);
  RelaxWork kept = work;
  for (int i = 0; i < 25; ++i) advance_relaxing(settings, work);
  kept.memory = KeptMemory<RelaxMemory>();  // what is kept beside is no part of it
  for (int i = 0; i < 25; ++i) advance_relaxing(settings, kept);
  CHECK(kept == work);
  CHECK(content_hash_of(kept) == content_hash_of(work));
}

TEST_CASE("relax: a cup keeps its hollow and limbs do not pass through each other") {
  const auto loaded = app::load_example(KNIT_ASSETS_DIR, "cup");
  const auto& cup = std::get<app::Loaded>(loaded);
  const Parameters parameters = app::with_preset(*app::find_preset("best-rows"), cup.parameters);
  const Knitted made = faces_of(cup.input, parameters);
  const InTheAir air = in_the_air(made);
  CHECK(!air.work.plan->lidded.empty());
  CHECK(crossings(made.state.fabric, air) == 0);
  // What the lids close off: the room inside the walls less that inside all faces.
  const Enclosure all = enclosure_of(made.state.fabric);
  const auto hollow = [&](const std::vector<glm::dvec3>& at) {
    return volume_of(air.work.plan->walls, at) - volume_of(all, at);
  };
  const double before = hollow(air.work.plan->start), after = hollow(air.relaxed.positions);
  CHECK(after / before >= 0.6);
}
