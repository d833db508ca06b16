// Ties fall by rule: a mesh that is moved by less than anybody could measure is knitted the same way.
#include "knit/model/ties.h"

#include <functional>
#include <glm/geometric.hpp>

#include "app/session/presets.h"
#include "knit/model/stitch_size.h"
#include "tests/support/catch.h"
#include "tests/support/repeated.h"
#include "tests/support/rough_sphere.h"
#include "tests/support/run.h"

using namespace knit;
using test_support::Dice;

namespace {

glm::dvec3 step_in(Dice& dice, double reach) {
  const double x = dice.between(-reach, reach), y = dice.between(-reach, reach),
               z = dice.between(-reach, reach);
  return {x, y, z};
}

// Each place by itself; vertices at one place stay together.
Mesh shaken(const Input& input, double reach, unsigned seed) {
  Mesh mesh = input.mesh;
  Dice dice(seed);
  for (glm::dvec3& p : mesh.positions) p += step_in(dice, reach);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) mesh.positions[v] = mesh.positions[input.twin[v]];
  return mesh;
}

// All alike: turned and shifted.
Mesh nudged(const Input& input, double reach, unsigned seed) {
  Mesh mesh = input.mesh;
  Dice dice(seed);
  const glm::dvec3 shift = step_in(dice, reach);
  const glm::dvec3 turn = step_in(dice, reach) / input.bounds.diagonal();
  for (glm::dvec3& p : mesh.positions) p += shift + glm::cross(turn, p);
  return mesh;
}

State knitted(const std::shared_ptr<const Input>& input, const Parameters& parameters) {
  Timeline timeline(input, parameters);
  timeline.extend_to_end();
  REQUIRE(timeline.furthest().fabric.row_count() > 1);  // a shape that parts may stop it later
  return timeline.furthest();
}

// The first thing that differs; empty: the same piece.
std::string difference(const State& one, const State& other, double hair) {
  if (test_support::row_sizes(one) != test_support::row_sizes(other)) return "sizes of rows";
  for (const auto& row : one.fabric.rows()) {
    const Row& twin = other.fabric.row(row->id);
    for (std::size_t j = 0; j < row->stitches.size(); ++j) {
      const Stitch& a = row->stitches[j];
      const Stitch& b = twin.stitches[j];
      if (a.vertex != b.vertex || glm::distance(a.position, b.position) > hair)
        return "stitch " + std::to_string(j) + " of row " + std::to_string(row->id);
    }
  }
  for (const auto& join : one.fabric.joins()) {
    const Join* twin = other.fabric.join_into(join->to);
    const std::string to = " to row " + std::to_string(join->to);
    if (twin == nullptr || join->link != twin->link) return "links" + to;
    if (join->labels != twin->labels || join->partner != twin->partner || join->mains != twin->mains)
      return "labels" + to;
    if (one.fabric.strip_into(join->to)->faces != other.fabric.strip_into(join->to)->faces)
      return "faces" + to;
  }
  return "";
}

struct Shape {
  const char* name;
  Mesh mesh;
};

std::vector<Shape> shapes() {
  std::vector<Shape> all;
  all.push_back({"sphere with a seam", sphere(64, 33, true)});
  all.push_back({"sphere", sphere(64, 24)});
  all.push_back({"egg", egg(64, 0.1)});
  all.push_back({"vase", vase(64, 0.1)});
  all.push_back({"capsule", capsule(64, 0.1)});
  all.erase(all.begin() + test_support::repeated(static_cast<int>(all.size())), all.end());
  return all;
}

void check_moved(const Shape& shape, const std::string& how, const std::function<void(Parameters&)>& set) {
  const auto input = make_input(shape.mesh);
  Parameters parameters = default_parameters(input->bounds);
  set(parameters);
  parameters = resolved(parameters, *input);
  const State still = knitted(input, parameters);
  const double size = input->bounds.diagonal();
  for (unsigned seed = 1; seed <= test_support::repeated(3U); ++seed) {
    CAPTURE(shape.name, how, seed);
    CHECK(difference(still, knitted(make_input(shaken(*input, 1e-13 * size, seed)), parameters),
                     1e-8 * size) == "");
    CHECK(difference(still, knitted(make_input(nudged(*input, 1e-13 * size, seed)), parameters),
                     1e-8 * size) == "");
  }
}

}  // namespace

TEST_CASE("ties: a mesh moved by 1e-13 of its size has the same stitches, links, labels and faces",
          "[ties]") {
  for (const Shape& shape : shapes()) {
    for (const app::Preset& preset : app::presets()) {
      check_moved(shape, std::string(preset.key),
                  [&](Parameters& parameters) { parameters = app::with_preset(preset, parameters); });
    }
  }
}

TEST_CASE("ties: the same where ties are many: other timings, nearest from rings, an axis across", "[ties]") {
  const app::Preset& best = *app::find_preset("best-rows");
  for (const Shape& shape : shapes()) {
    for (const TimingKind timing : {TimingKind::linear, TimingKind::geodesic, TimingKind::harmonic}) {
      check_moved(shape, "timing " + std::to_string(static_cast<int>(timing)), [&](Parameters& parameters) {
        parameters = app::with_preset(best, parameters);
        parameters.timing.kind = timing;
      });
    }
    check_moved(shape, "beside mains", [&](Parameters& parameters) {
      parameters = app::with_preset(best, parameters);
      parameters.stitches.follow_mains = FollowMains::on;
      parameters.stitches.stacking_penalty = 0.5;
    });
    check_moved(shape, "nearest from rings",
                [&](Parameters& parameters) { parameters.stitches.placement = PlacementPolicy::nearest; });
    check_moved(shape, "across", [&](Parameters& parameters) {
      parameters = app::with_preset(best, parameters);
      parameters.timing.axis = {AxisKind::x, {1.0, 0.0, 0.0}};
    });
  }
}

TEST_CASE("ties: what differs by rounding is equal, and equals stay in their order", "[ties]") {
  CHECK_FALSE(clearly_less(1.0, 1.0 + 1e-12, 1.0));
  CHECK(clearly_less(1.0, 1.0 + 1e-6, 1.0));
  CHECK_FALSE(clearly_less(1.0, 1.0 + 1e-6, 1e4));
  CHECK(rounded(2.5) == 3.0);
  CHECK(rounded(2.5 - 1e-13) == 3.0);
  CHECK(rounded(2.5 - 1e-6) == 2.0);
  std::vector<std::pair<double, char>> items{{2.0, 'a'}, {1.0 + 1e-12, 'b'}, {1.0, 'c'}, {0.0, 'd'}};
  sort_by_rule(
      items, [](const auto& item) { return item.first; }, 1.0);
  std::string order;
  for (const auto& item : items) order += item.second;
  CHECK(order == "dbca");
}
