// What `auto` chooses: the timing by the shape, rows by the levels, placement by the rows. Each choice is a step.
#include "knit/timing/choice.h"

#include "knit/insight/narrate.h"
#include "knit/mesh/shapes.h"
#include "knit/rows/choice.h"
#include "knit/rows/first_choice.h"
#include "knit/run/timeline.h"
#include "tests/support/bodies.h"
#include "tests/support/catch.h"

using namespace knit;

namespace {

Parameters by_itself(const Input& input, RowSource rows = RowSource::by_itself) {
  Parameters parameters = first_parameters(input);
  parameters.rows.source = rows;
  return parameters;
}

bool contains(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

template <class What>
std::string told(const Timeline& timeline) {
  for (std::size_t i = 0; i < timeline.known(); ++i)
    if (get_if<What>(timeline.step(i)) != nullptr)
      return narrate(timeline.step(i), timeline.parameters_of_step(i));
  return "";
}

Timeline run_of(const Mesh& mesh, RowSource rows = RowSource::by_itself) {
  const auto input = make_input(mesh);
  Timeline timeline(input, by_itself(*input, rows));
  timeline.extend_to_end();
  return timeline;
}

// The half sphere's flat base lies across the axis.
Mesh dome() {
  std::vector<ProfilePoint> profile{{0.0, 0.0}, {0.5, 0.0}};
  for (unsigned j = 20; j <= 40; ++j) {
    const TurnPoint at = turn_point(j, 80);
    profile.push_back({at.sine, -at.cosine});
  }
  return revolve("dome", profile, 48, false);
}

}  // namespace

TEST_CASE("choice: what lies flat across the axis is measured exactly") {
  const auto input = make_input(test_support::cylinder(64, 1.0, 3.0, 12));
  const Timeline timeline = run_of(input->mesh);
  const LevelFigures figures = measure_levels(*input, timeline.furthest().timing->ends);
  // Two lids of pi, a wall of 6 pi, but for the polygon of 64 sides.
  CHECK(figures.flat == Approx(0.25).epsilon(0.01));
  CHECK(figures.unevenness == Approx(0.0).margin(1e-9));
  CHECK(is_too_flat(figures));
  REQUIRE(figures.flat_at < input->mesh.positions.size());
  const double y = input->mesh.positions[figures.flat_at].y;
  CHECK((y == 0.0 || y == 3.0));
}

TEST_CASE("choice: a ball leans the same all round, an arch does not") {
  const auto ball = make_input(sphere(64, 33));
  const auto bent = make_input(test_support::arch());
  const auto figures_of = [](const std::shared_ptr<const Input>& input) {
    return measure_levels(*input, test_support::timing_of(*input, default_parameters(input->bounds))->ends);
  };
  CHECK(figures_of(ball).unevenness < 0.1);
  CHECK(figures_of(ball).flat < 0.01);
  CHECK(figures_of(bent).unevenness > most_unevenness);
}

TEST_CASE("choice: the timing is linear where the axis serves, geodesic where it leaves out or stretches") {
  for (const Mesh& mesh : {sphere(64, 33), egg(64, 0.1), capsule(64, 0.1)}) {
    INFO(mesh.name);
    const Timeline timeline = run_of(mesh);
    CHECK(timeline.furthest().timing->kind == TimingKind::linear);
    CHECK(timeline.furthest().rows_from == RowSource::rings);
    CHECK(contains(told<TimingChosen>(timeline), "linear, along the axis"));
    CHECK(contains(told<RowsChosen>(timeline), "from rings"));
    CHECK(as_chosen(timeline.parameters(), timeline.furthest()).stitches.placement ==
          PlacementPolicy::thesis);
  }
  for (const Mesh& mesh : {test_support::cylinder(64, 1.0, 3.0, 12), dome(), test_support::arch()}) {
    INFO(mesh.name);
    const Timeline timeline = run_of(mesh);
    CHECK(timeline.furthest().timing->kind == TimingKind::geodesic);
    CHECK(timeline.furthest().rows_from == RowSource::contours);
    CHECK(contains(told<TimingChosen>(timeline), "geodesic, along the surface"));
    CHECK(contains(told<RowsChosen>(timeline), "from contours"));
    CHECK(as_chosen(timeline.parameters(), timeline.furthest()).stitches.placement ==
          PlacementPolicy::nearest);
    CHECK(timeline.stop() == nullptr);
  }
}

TEST_CASE("choice: rings that are asked for keep the axis") {
  const Timeline timeline = run_of(test_support::cylinder(64, 1.0, 3.0, 12), RowSource::rings);
  CHECK(timeline.furthest().timing->kind == TimingKind::linear);
  CHECK(told<TimingChosen>(timeline).empty());
  CHECK(told<RowsChosen>(timeline).empty());
  CHECK(timeline.stop() == nullptr);
}

TEST_CASE("choice: where rings are missing it says where") {
  const Timeline ball = run_of(icosphere(3));
  CHECK(contains(told<RowsChosen>(ball), "form no closed ring (vertex"));
  Mesh standing = torus(48, 24, 1.0, 0.2);
  for (glm::dvec3& p : standing.positions) p = {p.z, p.x, p.y};
  const auto input = make_input(standing);
  Parameters along = by_itself(*input);
  along.timing.kind = TimingKind::linear;
  Timeline ring(input, along);
  ring.extend_to_end();
  CHECK(contains(told<RowsChosen>(ring), "loops, and rings follow a single one (the saddle is vertex"));
}

// A run that chooses is the run that was told so, but for the steps that choose.
TEST_CASE("choice: chosen and given lead to the same fabric, forward and back") {
  for (const Mesh& mesh : {sphere(32, 17), dome()}) {
    INFO(mesh.name);
    Timeline chosen = run_of(mesh);
    Timeline given(chosen.input_pointer(), as_chosen(chosen.parameters(), chosen.furthest()));
    given.extend_to_end();
    CHECK(given.furthest().fabric == chosen.furthest().fabric);
    CHECK(given.known() + 2 == chosen.known());
    chosen.seek(chosen.known());
    const std::uint64_t end = hash_of(chosen.state());
    chosen.seek(1);
    while (chosen.position() < chosen.known() && chosen.forward()) continue;
    CHECK(hash_of(chosen.state()) == end);
  }
}
