// Short rows in whole runs of shapes that bend: how even their stitches come out, and what holds of every fabric with pairs.
// The table of docs/algorithm.md is printed by: knit_tests "[short-rows-table]"
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "knit/import/obj.h"
#include "knit/model/stitch_size.h"
#include "knit/quality/ease.h"
#include "knit/quality/measures.h"
#include "knit/run/machine.h"
#include "knit/short_rows/kept_choice.h"
#include "knit/stitches/short_join.h"
#include "tests/support/bent_tubes.h"
#include "tests/support/catch.h"
#include "tests/support/repeated.h"

using namespace knit;
using namespace test_support;

namespace {

struct Bounds {
  double wale_cv, longest;    // at most; in h
  std::int32_t fewest, most;  // pairs
};

struct Case {
  std::string name;
  std::shared_ptr<const Input> input;
  TimingKind timing = TimingKind::harmonic;
  double width_percent = 3.0, height_of_width = 1.0;
  VertexId start = no_vertex, end = no_vertex;
  Bounds bounds{};
  void (*change)(Parameters&) = nullptr;
  Settling settle = Settling::on;
};

Case case_of(const BentTube& open, double height_of_width, const Bounds& bounds) {
  const BentTube tube = lidded(open);
  const auto vertices = static_cast<VertexId>(tube.mesh.positions.size());
  return {open.name,       make_input(tube.mesh), TimingKind::harmonic, 3.0,
          height_of_width, vertices - 2,          vertices - 1,         bounds};
}

State run(const Case& of, ShortRows rows) {
  Parameters parameters = default_parameters(of.input->bounds);
  const double width = of.width_percent / 100.0 * of.input->bounds.diagonal();
  give_width(parameters, width);
  give_height(parameters, of.height_of_width * width);
  parameters.timing.kind = of.timing;
  parameters.timing.start = of.start;
  parameters.timing.end = of.end;
  parameters.rows.source = RowSource::contours;
  parameters.stitches.placement = PlacementPolicy::nearest;
  parameters.settle.settling = of.settle;
  parameters.short_rows.rows = rows;
  if (of.change != nullptr) of.change(parameters);
  parameters = resolved(parameters, *of.input);
  State state;
  while (!state.finished()) REQUIRE_FALSE(is_stop(advance(*of.input, parameters, state)));
  return state;
}

std::int32_t pairs_in(const State& state) {
  return static_cast<std::int32_t>(std::count_if(state.fabric.rows().begin(), state.fabric.rows().end(),
                                                 [](const auto& row) { return is_short(*row); })) /
         2;
}

// Of strips: bridges of deals have triangles of their own.
std::size_t triangles_of_strips(const State& state) {
  std::size_t triangles = 0;
  for (const auto& strip : state.fabric.strips())
    triangles += static_cast<std::size_t>(std::count_if(
        strip->faces.begin(), strip->faces.end(), [](const Face& face) { return face.corner_count == 3; }));
  return triangles;
}

struct Ran {
  State with, without;
  double height = 0.0;
};

Ran check_case(const Case& of) {
  CAPTURE(of.name, of.width_percent, of.height_of_width, static_cast<int>(of.timing));
  Ran ran{run(of, ShortRows::automatic), run(of, ShortRows::off),
          of.height_of_width * of.width_percent / 100.0 * of.input->bounds.diagonal()};
  const LengthFigures wales = wale_figures(ran.with), plain = wale_figures(ran.without);
  const std::int32_t pairs = pairs_in(ran.with);
  CHECK(wales.cv <= of.bounds.wale_cv);
  CHECK(wales.high <= of.bounds.longest * ran.height);
  CHECK(wales.cv <= plain.cv + 0.002);
  CHECK(wales.high <= std::max(clearly_longer * plain.high, long_wale * ran.height) + 1e-6 * ran.height);
  CHECK(pairs >= of.bounds.fewest);
  CHECK(pairs <= of.bounds.most);
  if (pairs == 0) CHECK(ran.with.fabric == ran.without.fabric);
  // What holds of any fabric.
  CHECK(euler_characteristic(ran.with) == euler_characteristic(ran.without));
  const ShapingFigures shaping = shaping_figures(ran.with);
  CHECK(triangles_of_strips(ran.with) ==
        static_cast<std::size_t>(shaping.increases + shaping.decreases + 4 * pairs));
  CHECK(measure_turned(*of.input, ran.with).faces <= measure_turned(*of.input, ran.without).faces);
  return ran;
}

std::vector<Case> bent_tubes() {
  return {case_of(half_ring(), 1.0, {0.08, 1.6, 10, 14}),
          case_of(half_ring(), 0.72, {0.07, 1.6, 15, 20}),
          case_of(heel(), 1.0, {0.08, 1.6, 4, 6}),
          case_of(heel(), 0.72, {0.07, 1.6, 6, 9}),
          case_of(banana(), 1.0, {0.08, 1.6, 6, 9}),
          case_of(banana(), 0.72, {0.07, 1.6, 9, 12}),
          case_of(oblique_cone(), 1.0, {0.08, 1.6, 0, 5}),
          case_of(oblique_cone(), 0.72, {0.07, 1.6, 0, 7}),
          case_of(slanted_cylinder(), 1.0, {0.08, 1.6, 0, 5}),
          case_of(slanted_cylinder(), 0.72, {0.07, 1.6, 0, 7})};
}

#ifdef KNIT_SHARED_MESHES
std::vector<Case> others_meshes() {
  const std::filesystem::path folder = KNIT_SHARED_MESHES;
  if (!std::filesystem::exists(folder / "spot.obj")) return {};  // not part of the sources
  const auto of = [&](const std::string& name, TimingKind timing, double percent, double height_of_width,
                      const Bounds& bounds) {
    auto read = read_obj_file(folder / (name + ".obj"));
    REQUIRE(std::holds_alternative<Mesh>(read));
    return Case{name,
                make_input(std::get<Mesh>(std::move(read))),
                timing,
                percent,
                height_of_width,
                no_vertex,
                no_vertex,
                bounds};
  };
  constexpr TimingKind linear = TimingKind::linear, geodesic = TimingKind::geodesic,
                       harmonic = TimingKind::harmonic;
  return {of("simple-elbow", linear, 4, 0.72, {0.055, 1.4, 5, 8}),
          of("simple-elbow", linear, 2, 0.72, {0.04, 1.3, 14, 19}),
          of("simple-elbow", linear, 3, 1.0, {0.08, 1.6, 6, 10}),
          of("simple-elbow", linear, 3, 0.72, {0.07, 1.6, 8, 14}),
          of("simple-elbow", harmonic, 3, 1.0, {0.08, 1.6, 6, 10}),
          of("simple-elbow", harmonic, 3, 0.72, {0.07, 1.6, 8, 14}),
          of("spot", linear, 4, 0.72, {0.09, 1.6, 4, 8}),
          of("bunny", geodesic, 4, 0.72, {0.076, 1.7, 3, 5}),
          of("bunny", linear, 4, 0.72, {0.081, 1.5, 0, 0}),
          of("teddy", geodesic, 4, 0.72, {0.044, 1.3, 0, 0}),
          of("starfish", geodesic, 4, 0.72, {0.050, 1.3, 0, 0})};
}
#else
std::vector<Case> others_meshes() { return {}; }
#endif

// A few of them in every build, all with KNIT_WHOLE.
void check_some(const std::vector<Case>& cases) {
  const std::size_t every = std::getenv("KNIT_WHOLE") != nullptr ? 1 : sanitized ? cases.size() : 5;
  for (std::size_t number = 0; number < cases.size(); number += every) check_case(cases[number]);
}

}  // namespace

TEST_CASE("short rows figures: tubes that bend or lean settle evenly", "[short-rows]") {
  check_some(bent_tubes());
}

TEST_CASE("short rows figures: what is straight gets none", "[short-rows]") {
  const Case straight = case_of(slanted_cylinder(0.0), 1.0, {0.02, 1.2, 0, 0});
  check_case(straight);
  const Case hat = case_of(
      turned_tube("hat", [](double up) { return glm::dvec2(up < 0.5 ? 1.0 : 1.8 - 1.6 * up, 3.0 * up); }),
      1.0, {0.06, 1.3, 0, 0});
  check_case(hat);
  if (!whole()) return;
  const Case cut_sphere = case_of(turned_tube("cut sphere",
                                              [](double up) {
                                                const double t = std::numbers::pi * (0.2 + 0.77 * up);
                                                return glm::dvec2(std::sin(t), -std::cos(t));
                                              }),
                                  1.0, {0.06, 1.3, 0, 0});
  check_case(cut_sphere);
}

TEST_CASE("short rows figures: meshes by others never settle worse with them", "[short-rows]") {
  check_some(others_meshes());
}

namespace {

// Of each full round: its stitches, and the pairs under it.
struct RoundPairs {
  std::int32_t stitches = 0;
  std::vector<std::array<std::int32_t, 2>> pairs;
  friend bool operator==(const RoundPairs&, const RoundPairs&) = default;
};

std::vector<RoundPairs> pairs_by_round(const State& state) {
  std::vector<RoundPairs> rounds;
  for (const auto& row : state.fabric.rows()) {
    if (is_short(*row)) continue;
    rounds.push_back({size_of(*row), {}});
    if (!row->on.empty()) rounds.back().pairs = short_arcs_below(state.fabric, row->id);
    std::sort(rounds.back().pairs.begin(), rounds.back().pairs.end());
  }
  return rounds;
}

// Round the other way: stitch 0 stays, stitch i goes to the place of stitch -i.
std::vector<RoundPairs> mirror_of(std::vector<RoundPairs> rounds) {
  for (std::size_t i = 1; i < rounds.size(); ++i) {
    const std::int32_t below = rounds[i - 1].stitches;
    for (auto& [first, last] : rounds[i].pairs) {
      const std::int32_t from = -last, to = -first;
      const std::int32_t turn = to < 0 ? below : 0;
      first = from + turn;
      last = to + turn;
    }
    std::sort(rounds[i].pairs.begin(), rounds[i].pairs.end());
  }
  return rounds;
}

void begin_on_the_high_side(Parameters& parameters) {
  parameters.rows.start_direction = glm::dvec3(1.0, 0.0, 0.0);  // in the mirror plane
}

}  // namespace

TEST_CASE("short rows figures: a mirrored shape gets the mirrored pairs", "[short-rows]") {
  Case one = case_of(lopsided_cylinder(), 1.0, {}), other = case_of(mirrored(lopsided_cylinder()), 1.0, {});
  one.settle = other.settle = Settling::off;
  one.change = other.change = begin_on_the_high_side;
  const std::vector<RoundPairs> rounds = pairs_by_round(run(one, ShortRows::automatic)),
                                mirrors = pairs_by_round(run(other, ShortRows::automatic));
  CHECK(std::any_of(rounds.begin(), rounds.end(), [](const RoundPairs& r) { return !r.pairs.empty(); }));
  CHECK(mirror_of(rounds) == mirrors);
  CHECK(rounds != mirrors);
}

TEST_CASE("short rows figures: a body that is its own mirror image gets pairs that are", "[short-rows]") {
  std::vector<Case> bodies{case_of(half_ring(), 0.72, {}), case_of(oblique_cone(), 1.0, {}),
                           case_of(slanted_cylinder(), 0.72, {}), case_of(heel(), 1.0, {}),
                           case_of(banana(), 1.0, {})};
  for (const Case& other : others_meshes())
    if (other.name == "simple-elbow" && other.width_percent > 2.0) bodies.push_back(other);
  for (std::size_t i = 0; i < bodies.size(); i += sanitized ? 3 : 1) {
    Case& body = bodies[i];
    body.settle = Settling::off;
    CAPTURE(body.name, body.width_percent, body.height_of_width);
    const std::vector<RoundPairs> rounds = pairs_by_round(run(body, ShortRows::automatic));
    CHECK(std::count_if(rounds.begin(), rounds.end(), [](const RoundPairs& r) { return !r.pairs.empty(); }) >=
          2);
    CHECK(mirror_of(rounds) == rounds);
  }
}

TEST_CASE("short rows figures: mains and counts in rhythm go together with them", "[short-rows]") {
  Case wanted = case_of(half_ring({48, 60}), 1.0, {0.13, 1.9, 8, 16});
  wanted.change = [](Parameters& parameters) { parameters.stitches.follow_mains = FollowMains::on; };
  check_case(wanted);
  if (!whole()) return;
  wanted.change = [](Parameters& parameters) { parameters.rhythm.counts = CountPlanning::rhythm; };
  check_case(wanted);
}

TEST_CASE("short rows figures: the table", "[.][short-rows-table]") {
  std::vector<Case> all = bent_tubes();
  for (Case& other : others_meshes()) all.push_back(std::move(other));
  std::printf(
      "| | w, %% | h/w | pairs | wale CV, without | with | longest wale, without | with | course CV, without "
      "| "
      "with |\n|---|---|---|---|---|---|---|---|---|---|\n");
  for (const Case& of : all) {
    const Ran ran = check_case(of);
    const LengthFigures wales = wale_figures(ran.with), plain = wale_figures(ran.without);
    std::printf("| %s%s | %g | %g | %d | %.3f | %.3f | %.2f | %.2f | %.3f | %.3f |\n", of.name.c_str(),
                of.timing == TimingKind::geodesic ? ", geodesic"
                : of.timing == TimingKind::linear ? ", linear"
                                                  : "",
                of.width_percent, of.height_of_width, pairs_in(ran.with), plain.cv, wales.cv,
                plain.high / ran.height, wales.high / ran.height, course_figures(ran.without).cv,
                course_figures(ran.with).cv);
  }
}
