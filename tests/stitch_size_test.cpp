// The two views of the stitch size: whatever is set, on whatever mesh, they say the same.
#include "knit/model/stitch_size.h"
#include "knit/model/settings_table.h"

#include <algorithm>
#include <limits>

#include "tests/support/catch.h"
#include "tests/support/rough_sphere.h"
#include "tests/support/run.h"

using namespace knit;
using test_support::Dice;
using test_support::placed;

namespace {

double height_of(const Mesh& mesh, const glm::dvec3& direction) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const glm::dvec3& p : mesh.positions) {
    low = std::min(low, glm::dot(p, direction));
    high = std::max(high, glm::dot(p, direction));
  }
  return high - low;
}

// Both views measured in centimetres, by the axis.
void check_views(const Parameters& p, const Mesh& mesh) {
  const double centimetres = p.size.height_cm / height_of(mesh, p.timing.axis.direction());
  CHECK(p.stitch.width * centimetres * p.stitch.gauge.stitches == Approx(10.0).epsilon(1e-10));
  CHECK(p.stitch.height * centimetres * p.stitch.gauge.rounds == Approx(10.0).epsilon(1e-10));
}

double centimetres_per_unit(const Parameters& p, const Input& input) {
  return resolved(p, input).stitch.centimetres_per_unit;
}

// Of no regular size, so that the axis matters.
Mesh potato(Dice& dice) {
  return placed(sphere(12, 8), {dice.between(0.1, 9.0), dice.between(0.1, 9.0), dice.between(0.1, 9.0)},
                {dice.between(-50.0, 50.0), dice.between(-50.0, 50.0), 0.0});
}

Parameters any_parameters(Dice& dice) {
  Parameters p;
  p.timing.axis.kind = static_cast<AxisKind>(dice.below(4));
  p.timing.axis.custom = {dice.between(-2.0, 2.0), dice.between(0.1, 2.0), dice.between(-2.0, 2.0)};
  const auto given = static_cast<SizesFrom>(dice.below(2));
  give_width(p, dice.between(0.001, 3.0));
  give_height(p, dice.below(3) == 0 ? 0.0 : dice.between(0.001, 3.0));
  give_gauge(p, {dice.between(1.0, 60.0), dice.between(1.0, 60.0)});
  give_sizes(p, given);
  p.size.height_cm = dice.between(0.5, 300.0);
  return p;
}

Parameters turned(Parameters p, SizesFrom sizes, const Input& input) {
  give_sizes(p, sizes);
  return resolved(p, input);
}

void check_agreed(const Timeline& timeline) {
  const Input& input = timeline.input();
  CHECK(timeline.base_parameters() == resolved(timeline.base_parameters(), input));
  check_views(timeline.base_parameters(), input.mesh);
  for (const Edit& edit : timeline.edits()) {
    CHECK(edit.parameters == resolved(edit.parameters, input));
    check_views(edit.parameters, input.mesh);
  }
  CHECK(timeline.parameters() == resolved(timeline.parameters(), input));
}

// Goes through the whole run again; a step that comes out otherwise than recorded would throw.
void check_replay(Timeline& timeline) {
  timeline.extend_to_end();
  const std::uint64_t end = hash_of(timeline.furthest());
  timeline.seek(0);
  CHECK_NOTHROW([&] {
    while (timeline.forward()) {
    }
  }());
  CHECK(hash_of(timeline.state()) == end);
}

}  // namespace

TEST_CASE("a ball 12 cm high at 22 stitches and 32 rounds: sizes by hand, and back") {
  const auto ball = make_input(sphere(40, 16));  // radius 1: 6 cm a unit
  Parameters p;
  give_sizes(p, SizesFrom::gauge);
  give_gauge(p, {22.0, 32.0});
  p.size.height_cm = 12.0;
  CHECK(centimetres_per_unit(p, *ball) == Approx(6.0).epsilon(1e-14));
  p = resolved(p, *ball);
  CHECK(p.stitch.width == Approx(10.0 / 22.0 / 6.0).epsilon(1e-14));
  CHECK(p.stitch.height == Approx(10.0 / 32.0 / 6.0).epsilon(1e-14));

  Parameters back;
  give_width(back, 5.0 / 66.0);
  give_height(back, 5.0 / 96.0);
  back.size.height_cm = 12.0;
  back = resolved(back, *ball);
  CHECK(back.stitch.gauge.stitches == Approx(22.0).epsilon(1e-14));
  CHECK(back.stitch.gauge.rounds == Approx(32.0).epsilon(1e-14));
  CHECK(back.stitch.width == 5.0 / 66.0);
  CHECK(back.stitch.height == 5.0 / 96.0);
}

TEST_CASE("a stitch height left to itself counts as 0.72 of the width in the gauge") {
  const auto ball = make_input(sphere(40, 16));
  Parameters p;
  give_width(p, 0.1);
  give_height(p, 0.0);
  p.size.height_cm = 12.0;
  p = resolved(p, *ball);
  CHECK(p.stitch.height_follows);  // still left to itself
  CHECK(p.stitch.gauge.stitches == Approx(10.0 / 0.6));
  CHECK(p.stitch.gauge.rounds == Approx(10.0 / (0.072 * 6.0)));
}

TEST_CASE("centimetres are counted along the direction of knitting, by what the triangles use") {
  Mesh mesh = placed(sphere(16, 8), {1.0, 2.0, 3.0});
  const VertexId top = static_cast<VertexId>(mesh.positions.size()) - 1;
  mesh.positions.emplace_back(100.0, 100.0, 100.0);  // used by nothing
  const auto input = make_input(mesh);
  Parameters p;
  p.size.height_cm = 12.0;
  for (const auto& [kind, height] : {std::pair{AxisKind::x, 2.0}, {AxisKind::y, 4.0}, {AxisKind::z, 6.0}}) {
    p.timing.axis.kind = kind;
    CHECK(centimetres_per_unit(p, *input) == Approx(12.0 / height));
  }
  p.timing.axis = {AxisKind::custom, {0.0, -7.0, 0.0}};  // its length and sign say nothing
  CHECK(centimetres_per_unit(p, *input) == Approx(3.0));
  p.timing.axis.kind = AxisKind::x;
  p.timing.start = 0;  // of the two poles, at y = -2 and 2
  p.timing.end = top;
  CHECK(centimetres_per_unit(p, *input) == Approx(3.0));
  p.timing.end = no_vertex;
  CHECK(centimetres_per_unit(p, *input) == Approx(6.0));
  const auto flat = make_input(placed(sphere(16, 8), {1.0, 0.0, 1.0}));
  CHECK(centimetres_per_unit(Parameters{}, *flat) == 1.0);
}

TEST_CASE("whatever is set, both views agree, and the given one stays to the bit") {
  Dice dice(4711);
  for (int i = 0; i < 300; ++i) {
    const Mesh mesh = potato(dice);
    const auto input = make_input(mesh);
    const Parameters p = any_parameters(dice);
    const Parameters q = resolved(p, *input);
    check_views(q, mesh);
    CHECK(resolved(q, *input) == q);
    CHECK(q.size == p.size);
    if (p.size.from() == SizesFrom::mesh) {
      CHECK(q.stitch.width == p.stitch.width);
      CHECK(q.stitch.height == p.stitch.height);
    } else {
      CHECK(q.stitch.gauge == p.stitch.gauge);
    }
  }
}

TEST_CASE("the switch turned to and fro changes nothing, to the bit") {
  const bool left_to_itself = GENERATE(false, true);
  Dice dice(815);
  std::size_t wrong = 0;
  for (int i = 0; i < 300; ++i) {
    const auto input = make_input(potato(dice));
    Parameters p = any_parameters(dice);
    const SizesFrom given = p.size.from();
    give_height(p, left_to_itself ? 0.0 : dice.between(0.001, 3.0));
    if (!left_to_itself) give_sizes(p, given);  // the gauge always says a height
    p = resolved(p, *input);
    Parameters q = p;
    for (int turn = 0; turn < 4; ++turn) {
      q = turned(q, p.size.from() == SizesFrom::mesh ? SizesFrom::gauge : SizesFrom::mesh, *input);
      q = turned(q, p.size.from(), *input);
    }
    wrong += q == p ? 0U : 1U;
  }
  CAPTURE(left_to_itself);
  CHECK(wrong == 0);
}

TEST_CASE("setting a size in one view makes that view the given one") {
  const auto ball = make_input(sphere(40, 16));
  for (const SizesFrom before : {SizesFrom::mesh, SizesFrom::gauge}) {
    for (const ParameterInfo& info : parameter_table()) {
      CAPTURE(info.key);
      Parameters p = resolved(turned(Parameters{}, before, *ball), *ball);
      REQUIRE_FALSE(set_value(info, p, value_text(info, p)));
      const SizesFrom after = info.key == keys::sizes ? before : view_of(info).value_or(before);
      CHECK(p.size.from() == after);
      // The same value in the other view is the same stitch.
      CHECK(resolved(p, *ball).stitch == turned(Parameters{}, before, *ball).stitch);
    }
  }
}

TEST_CASE(
    "epsilon goes with the width unless it is set too, before or after, and comes back as it was typed") {
  const auto ball = make_input(sphere(40, 16));
  Dice dice(20);
  for (int i = 0; i < 3000; ++i) {
    const double width = dice.between(0.001, 3.0);
    const double epsilon = dice.between(0.0001, 3.0);
    const double other = dice.between(0.001, 3.0);
    Parameters p;
    give_width(p, width);
    give_epsilon(p, epsilon);
    p = resolved(p, *ball);
    REQUIRE(p.epsilon() == epsilon);
    give_width(p, other);
    REQUIRE(p.epsilon() == epsilon / width * other);
    give_width(p, width);
    REQUIRE(p.epsilon() == epsilon);
    give_epsilon(p, epsilon);
    give_width(p, other);
    REQUIRE(resolved(p, *ball).epsilon() == epsilon);
  }
}

TEST_CASE("of several settings, sizes has the last word and epsilon stands, in whatever order they come") {
  const auto ball = make_input(sphere(40, 16));
  std::vector<Setting> settings{{find_parameter("sizes"), "mesh"},
                                {find_parameter("stitch-width"), "0.2"},
                                {find_parameter("epsilon"), "0.03"},
                                {find_parameter("gauge"), "20,28"}};
  std::sort(settings.begin(), settings.end());
  do {
    Parameters p;
    REQUIRE_FALSE(set_values(settings, p));
    p = resolved(p, *ball);
    CHECK(p.size.given == std::variant<MeshSize, GaugeSize>(MeshSize{0.2, 0.0}));
    CHECK(p.epsilon() == 0.03);
  } while (std::next_permutation(settings.begin(), settings.end()));
}

TEST_CASE(
    "a mesh twice as large has stitches twice as large at the same gauge, and the gauge of half of them") {
  for (const double scale : {4.0, 0.37}) {
    Parameters p;
    give_sizes(p, SizesFrom::gauge);
    const Parameters small = resolved(p, *make_input(sphere(40, 16)));
    const Parameters large = resolved(p, *make_input(placed(sphere(40, 16), glm::dvec3(scale))));
    CHECK(large.stitch.width == Approx(scale * small.stitch.width).epsilon(1e-14));
    CHECK(large.stitch.height == Approx(scale * small.stitch.height).epsilon(1e-14));
    give_sizes(p, SizesFrom::mesh);
    const Parameters wide = resolved(p, *make_input(placed(sphere(40, 16), glm::dvec3(scale))));
    CHECK(wide.stitch.gauge.stitches ==
          Approx(scale * resolved(p, *make_input(sphere(40, 16))).stitch.gauge.stitches));
  }
}

TEST_CASE("a timeline keeps base and edits agreed, whatever is tuned or edited") {
  Timeline timeline(make_input(placed(sphere(40, 16), {1.0, 1.3, 0.8})), test_support::small_parameters());
  timeline.extend_to_end();
  check_agreed(timeline);
  timeline.seek(timeline.position_of({Stage::rows, 5, 4}));
  const auto change = [&](const char* key, const char* value) {
    Parameters p = timeline.parameters();
    REQUIRE_FALSE(set_value(*find_parameter(key), p, value));
    return p;
  };
  timeline.edit_from_here(change("gauge", "6,8"));
  REQUIRE(timeline.edits().size() == 1);
  CHECK(timeline.base_parameters().size.from() == SizesFrom::mesh);
  check_agreed(timeline);
  timeline.extend_to_end();
  timeline.seek(timeline.known());
  for (const auto& [key, value] : {std::pair{"height-cm", "15"},
                                   {"axis", "0,-1,0.2"},
                                   {"stitch-height", "auto"},
                                   {"sizes", "gauge"},
                                   {"axis", "y"},
                                   {"gauge", "5,7"},
                                   {"stitch-width", "0.31"}}) {
    CAPTURE(key, value);
    timeline.tune(change(key, value));
    check_agreed(timeline);
    check_replay(timeline);
  }
  timeline.change_input(make_input(placed(sphere(40, 16), {1.0, 2.0, 0.8})), timeline.parameters());
  check_agreed(timeline);
}

TEST_CASE("a height tuned where the mesh gives the sizes still reaches what came before by gauge") {
  Parameters p = test_support::small_parameters();
  give_sizes(p, SizesFrom::gauge);
  give_gauge(p, {6.0, 8.0});
  Timeline timeline(test_support::small_sphere(), p);
  timeline.extend_to_end();
  timeline.seek(timeline.position_of({Stage::rows, 5, 4}));
  Parameters by_mesh = timeline.parameters();
  give_sizes(by_mesh, SizesFrom::mesh);
  give_width(by_mesh, 0.3);
  timeline.edit_from_here(by_mesh);
  timeline.extend_to_end();
  timeline.seek(timeline.known());
  Parameters taller = timeline.parameters();
  taller.size.height_cm = 10.0;  // 5 cm a unit
  timeline.tune(taller);
  check_agreed(timeline);
  CHECK(timeline.edits()[0].parameters.stitch.width == 0.3);
  CHECK(timeline.base_parameters().stitch.gauge == Gauge{6.0, 8.0});  // only the height was tuned
  CHECK(timeline.base_parameters().stitch.width == Approx(10.0 / 6.0 / 5.0));
  check_replay(timeline);
}
