// What holds for every run, on bodies, axes and parameters drawn from seeds. A failure names its seed.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "knit/import/check.h"
#include "knit/insight/narrate.h"
#include "knit/model/settings_table.h"
#include "knit/model/stitch_size.h"
#include "knit/run/timeline.h"
#include "tests/support/bodies.h"
#include "tests/support/catch.h"
#include "tests/support/join.h"
#include "tests/support/promises.h"
#include "tests/support/repeated.h"
#include "tests/support/run.h"
#include "tests/support/tube.h"

using namespace knit;
using test_support::Dice;

namespace {

glm::dvec3 vector_in(Dice& dice, double reach) {
  const double x = dice.between(-reach, reach), y = dice.between(-reach, reach),
               z = dice.between(-reach, reach);
  return {x, y, z};
}

// A convex body: a sphere without order in its triangles, cut flat by some planes (each point is drawn in along its
// ray, so that rays and with them the triangles stay), then stretched and sheared.
Mesh random_body(Dice& dice, unsigned subdivisions) {
  Mesh mesh = test_support::rough_sphere(subdivisions, static_cast<unsigned>(dice.below(1000)));
  std::vector<glm::dvec3> planes;  // outward, of the length of their distance
  for (std::size_t count = dice.below(5); count > 0; --count) {
    const glm::dvec3 direction = vector_in(dice, 1.0);
    if (glm::length(direction) > 0.1) planes.push_back(dice.between(0.5, 0.9) * glm::normalize(direction));
  }
  for (glm::dvec3& p : mesh.positions) {
    double reach = 1.0;
    for (const glm::dvec3& plane : planes) {
      const double toward = glm::dot(p, plane);
      if (toward > 0.0) reach = std::min(reach, glm::dot(plane, plane) / toward);
    }
    p *= reach;
  }
  glm::dmat3 map(1.0);
  for (int i = 0; i < 3; ++i) map[i] += vector_in(dice, 0.35);
  for (glm::dvec3& p : mesh.positions) p = map * p;
  return mesh;
}

// Parameters that a person might set. With `contours` alone the outcome does not hang on single vertices.
Parameters random_parameters(Dice& dice, const Input& input, bool contours_only) {
  Parameters p = default_parameters(input.bounds);
  give_width(p, input.bounds.diagonal() * dice.between(0.03, 0.12));
  give_epsilon(p, p.stitch.width * dice.between(0.1, 0.9));
  p.timing.axis = {AxisKind::custom,
                   test_support::random_axes(1, static_cast<unsigned>(dice.below(100000))).front()};
  p.rows.source = contours_only || dice.below(3) != 0 ? RowSource::contours : RowSource::rings;
  p.timing.kind = static_cast<TimingKind>(dice.below(4));
  p.stitches.placement =
      static_cast<PlacementPolicy>(dice.below(static_cast<int>(PlacementPolicy::by_itself)));
  p.rows.close = static_cast<Closing>(dice.below(3));
  p.rows.metric = static_cast<Metric>(dice.below(3));
  p.rows.on_stall = dice.below(4) == 0 ? OnStall::stop : OnStall::continue_;
  p.rows.resample = dice.below(4) == 0 ? Resample::off : Resample::on;
  p.rows.last_anchor = static_cast<LastAnchor>(dice.below(2));
  p.stitches.follow_mains = static_cast<FollowMains>(dice.below(2));
  p.timing.level_tolerance = dice.below(2) == 0 ? 1e-5 : dice.between(0.001, 0.06);
  if (dice.below(3) == 0) p.rows.cast_on = 3 + static_cast<int>(dice.below(12));
  return p;
}

struct Sample {
  std::shared_ptr<const Input> input;
  Parameters parameters;
};
Sample random_run(unsigned seed, bool contours_only) {
  Dice dice(seed);
  Sample run;
  run.input = make_input(random_body(dice, 3));
  run.parameters = random_parameters(dice, *run.input, contours_only);
  return run;
}

Timeline finished(const std::shared_ptr<const Input>& input, const Parameters& parameters) {
  Timeline timeline(input, parameters);
  timeline.extend_to_end();
  return timeline;
}

// The run on the same body after p -> turn * p, with the directions turned alike.
Timeline moved_run(const Sample& run, const glm::dmat3& turn, const glm::dvec3& shift, double scale) {
  Mesh mesh = run.input->mesh;
  for (glm::dvec3& p : mesh.positions) p = scale * (turn * p) + shift;
  if (glm::determinant(turn) < 0.0)
    for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  Parameters parameters = run.parameters;
  parameters.timing.axis.custom = turn * parameters.timing.axis.custom;
  if (parameters.rows.start_direction)
    parameters.rows.start_direction = turn * *parameters.rows.start_direction;
  give_epsilon(parameters, parameters.epsilon() * scale);
  if (!parameters.stitch.height_follows) give_height(parameters, parameters.stitch.height * scale);
  give_width(parameters, parameters.stitch.width * scale);
  return finished(make_input(mesh), parameters);
}

// Rows, and increases and decreases between them.
struct Counts {
  std::vector<int> rows;
  std::vector<int> increases, decreases;
  friend bool operator==(const Counts&, const Counts&) = default;
};
Counts counts_of(const Timeline& timeline) {
  Counts counts{test_support::row_sizes(timeline.furthest()), {}, {}};
  for (const auto& join : timeline.furthest().fabric.joins()) {
    const auto& labels = join->labels;
    counts.increases.push_back(static_cast<int>(std::count_if(labels.begin(), labels.end(), is_increase)));
    counts.decreases.push_back(static_cast<int>(std::count_if(labels.begin(), labels.end(), is_decrease)));
  }
  return counts;
}

glm::dmat3 turn_about(const glm::dvec3& axis, double angle) {
  const glm::dvec3 n = glm::normalize(axis);
  glm::dmat3 turn(1.0);
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3 e = turn[i];
    turn[i] =
        n * glm::dot(n, e) + std::cos(angle) * (e - n * glm::dot(n, e)) + std::sin(angle) * glm::cross(n, e);
  }
  return turn;
}

// Of the knit mesh with both ends closed by fans.
double volume_of(const State& state) {
  const Mesh mesh = test_support::mesh_of(state);
  glm::dvec3 middle(0.0);
  for (const glm::dvec3& p : mesh.positions) middle += p / static_cast<double>(mesh.positions.size());
  const auto tetrahedron = [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return glm::dot(a - middle, glm::cross(b - middle, c - middle)) / 6.0;
  };
  double sum = 0.0;
  for (const Triangle& t : mesh.triangles)
    sum += tetrahedron(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]);
  const auto close = [&](const Row& row, bool upwards) {
    glm::dvec3 centre(0.0);
    for (const Stitch& stitch : row.stitches)
      centre += stitch.position / static_cast<double>(row.stitches.size());
    for (std::size_t i = 0; i < row.stitches.size(); ++i) {
      const glm::dvec3& a = row.stitches[i].position;
      const glm::dvec3& b = row.stitches[(i + 1) % row.stitches.size()].position;
      sum += upwards ? tetrahedron(centre, a, b) : tetrahedron(centre, b, a);
    }
  };
  close(*state.fabric.rows().front(), false);
  close(*state.fabric.rows().back(), true);
  return sum;
}

const unsigned many = test_support::repeated(60U);

}  // namespace

TEST_CASE("property: a run on any convex body ends or says why, and what it made fits together",
          "[property]") {
  std::size_t whole = 0;
  for (unsigned seed = 1; seed <= many; ++seed) {
    INFO("seed " << seed);
    const Sample run = random_run(seed, false);
    REQUIRE(check(run.input->mesh).fit());
    REQUIRE_FALSE(fault_of(run.parameters, *run.input));
    const Timeline timeline = finished(run.input, run.parameters);
    CHECK(test_support::broken_promise(timeline.furthest()).empty());
    if (timeline.stop() != nullptr) {
      CHECK(narrate(*timeline.stop(), timeline.parameters_of_stop()).size() > 40);
      continue;
    }
    REQUIRE(timeline.furthest().finished());
    ++whole;
    CHECK(volume_of(timeline.furthest()) > 0.0);
  }
  CHECK(whole > many / 3);  // the rest stops for a reason; the property would else be an empty one
}

TEST_CASE("property: seeking anywhere shows what stepping there shows", "[property]") {
  for (unsigned seed = 101; seed <= 108; ++seed) {
    INFO("seed " << seed);
    const Sample run = random_run(seed, false);
    Timeline timeline(run.input, run.parameters, seed % 2 == 0 ? 30000 : Timeline::default_budget_bytes);
    std::vector<std::uint64_t> hashes{hash_of(timeline.state())};
    while (timeline.forward()) hashes.push_back(hash_of(timeline.state()));
    REQUIRE(hashes.size() == timeline.known() + 1);
    Dice dice(seed);
    for (int visit = 0; visit < 60; ++visit) {
      const std::size_t position = dice.below(hashes.size());
      timeline.seek(position);
      REQUIRE(hash_of(timeline.state()) == hashes[position]);
      if (timeline.back()) REQUIRE(hash_of(timeline.state()) == hashes[position - 1]);
    }
  }
}

TEST_CASE("property: a tuned run is a fresh one, an edited one ends or says why", "[property]") {
  for (unsigned seed = 201; seed <= 230; ++seed) {
    INFO("seed " << seed);
    const Sample run = random_run(seed, false);
    Dice dice(seed + 7);
    const Parameters other = random_parameters(dice, *run.input, false);
    Timeline timeline = finished(run.input, run.parameters);
    timeline.seek(dice.below(timeline.known() + 1));
    timeline.tune(other);
    timeline.extend_to_end();
    const Timeline fresh = finished(run.input, other);
    REQUIRE(timeline.steps() == fresh.steps());
    REQUIRE((timeline.stop() == nullptr) == (fresh.stop() == nullptr));
    timeline.seek(dice.below(timeline.known() + 1));
    timeline.edit_from_here(run.parameters);
    timeline.extend_to_end();
    CHECK(test_support::broken_promise(timeline.furthest()).empty());
    CHECK((timeline.stop() != nullptr || timeline.furthest().finished()));
  }
}

TEST_CASE("property: size and place of a body change no count", "[property]") {
  for (unsigned seed = 301; seed <= 300 + many; ++seed) {
    INFO("seed " << seed);
    const Sample run = random_run(seed, false);
    const Timeline plain = finished(run.input, run.parameters);
    // A power of two changes no bit of a fraction, so that every comparison falls the same way.
    for (const double scale : {std::ldexp(1.0, -20), std::ldexp(1.0, 30)}) {
      const Timeline scaled = moved_run(run, glm::dmat3(1.0), glm::dvec3(0.0), scale);
      CHECK(counts_of(scaled) == counts_of(plain));
      CHECK((scaled.stop() == nullptr) == (plain.stop() == nullptr));
    }
  }
}

TEST_CASE("property: a turned body has the same counts when its rows are contours", "[property]") {
  for (unsigned seed = 401; seed <= 400 + many; ++seed) {
    INFO("seed " << seed);
    Sample run = random_run(seed, true);
    run.parameters.rows.start_direction =
        glm::cross(run.parameters.timing.axis.custom, glm::dvec3(0.3, 0.5, -0.8));
    const Timeline plain = finished(run.input, run.parameters);
    Dice dice(seed);
    const glm::dvec3 axis = vector_in(dice, 1.0) + glm::dvec3(1.1, 0.0, 0.0);
    const glm::dmat3 turn = turn_about(axis, dice.between(0.1, 6.0));
    const Timeline turned = moved_run(run, turn, vector_in(dice, 3.0), 1.0);
    CHECK(counts_of(turned) == counts_of(plain));
  }
}

// What sees only how many stitches there are cannot know right from left: 6 to 7 is one increase to the right, say, and
// so it is in the mirror. What sees where they are must give left there.
TEST_CASE(
    "property: a mirrored body has the same counts, left for right where places decide, else the same words",
    "[property]") {
  glm::dmat3 mirror(1.0);
  mirror[0][0] = -1.0;
  std::ptrdiff_t sides_changed = 0;
  for (unsigned seed = 501; seed <= 500 + many; ++seed) {
    INFO("seed " << seed);
    Sample run = random_run(seed, true);
    run.parameters.rows.start_direction =
        glm::cross(run.parameters.timing.axis.custom, glm::dvec3(0.3, 0.5, -0.8));
    // A round that follows a wale may double its first stitch; in the mirror that would be its last.
    run.parameters.rows.round_start = RoundStart::direction;
    const Timeline plain = finished(run.input, run.parameters);
    const Timeline image = moved_run(run, mirror, glm::dvec3(0.0), 1.0);
    // Tubes that meet are numbered, and their loops begun, as the mesh's vertices are: not as in the mirror.
    if (!plain.furthest().fabric.deals().empty()) continue;
    CHECK(counts_of(image) == counts_of(plain));
    const bool by_place = run.parameters.stitches.placement == PlacementPolicy::nearest;
    const auto& ours = plain.furthest().fabric.joins();
    const auto& theirs = image.furthest().fabric.joins();
    REQUIRE(ours.size() == theirs.size());
    for (std::size_t i = 0; i < ours.size(); ++i) {
      // Where every stitch is doubled, pairs begin at the first stitch on both sides of the mirror; where all are worked
      // in pairs, mains stand elsewhere from there on.
      if (by_place && ours[i]->below == 2 * ours[i]->above) break;
      if (by_place && ours[i]->above == 2 * ours[i]->below) continue;
      INFO("to row " << ours[i]->to << ", " << ours[i]->below << " to " << ours[i]->above);
      CHECK(theirs[i]->labels ==
            (by_place ? test_support::mirrored_labels(ours[i]->labels) : ours[i]->labels));
      sides_changed +=
          by_place ? std::count_if(ours[i]->labels.begin(), ours[i]->labels.end(), is_shaping) : 0;
    }
  }
  if (test_support::whole()) CHECK(sides_changed > 500);
}
