// Algorithm 2 with other rulers: the same walk, measured along the ring or along the surface.
#include <map>

#include "knit/model/stitch_size.h"
#include "knit/quality/measures.h"
#include "knit/rows/rows.h"
#include "knit/run/machine.h"
#include "tests/support/catch.h"
#include "tests/support/run.h"

using namespace knit;

namespace {

Timeline run(std::shared_ptr<const Input> input, Parameters parameters, Metric metric) {
  parameters.rows.metric = metric;
  Timeline timeline(std::move(input), parameters);
  timeline.extend_to_end();
  return timeline;
}

std::vector<std::size_t> sizes_of(const Timeline& timeline) {
  std::vector<std::size_t> sizes;
  for (const auto& row : timeline.furthest().fabric.rows()) sizes.push_back(row->stitches.size());
  return sizes;
}

// Distances by anchor and candidate.
std::map<std::pair<VertexId, VertexId>, double> distances_of(const Timeline& timeline) {
  std::map<std::pair<VertexId, VertexId>, double> distances;
  for (const Step& step : timeline.steps()) {
    if (const auto* measured = knit::get_if<CandidateMeasured>(step))
      distances.emplace(std::pair{measured->anchor, measured->candidate}, measured->distance);
  }
  return distances;
}

// A ball squeezed to a clover: its rings bend inwards four times.
std::shared_ptr<const Input> clover() {
  Mesh mesh = sphere(96, 24, false);
  for (glm::dvec3& p : mesh.positions) {
    const double angle = std::atan2(p.z, p.x);
    const double squeeze = 1.0 + 0.45 * std::cos(4.0 * angle);
    p = {p.x * squeeze, p.y, p.z * squeeze};
  }
  return make_input(std::move(mesh));
}

}  // namespace

TEST_CASE("straight is never longer than along the surface, and that never longer than along the ring") {
  const auto input = clover();
  Parameters parameters = test_support::small_parameters();
  give_width(parameters, 0.35);
  const auto straight = distances_of(run(input, parameters, Metric::euclidean));
  const auto surface = distances_of(run(input, parameters, Metric::geodesic));
  const auto along = distances_of(run(input, parameters, Metric::arc));
  std::size_t compared = 0;
  std::size_t apart = 0;
  for (const auto& [pair, distance] : surface) {
    const auto shorter = straight.find(pair);
    const auto longer = along.find(pair);
    if (shorter != straight.end()) CHECK(shorter->second <= distance + 1e-12);
    if (longer == along.end()) continue;
    CHECK(distance <= longer->second + 1e-12);
    ++compared;
    apart += longer->second > distance + 1e-6 ? 1U : 0U;
  }
  CHECK(compared > 100);
  CHECK(apart > 10);  // between rings, the surface offers shorter ways than the ring itself
}

TEST_CASE("on rings that bend, the ruler decides how many stitches there are") {
  const auto input = clover();
  Parameters parameters;
  give_width(parameters, 0.6);
  give_epsilon(parameters, 0.1);
  const auto straight = sizes_of(run(input, parameters, Metric::euclidean));
  const auto along = sizes_of(run(input, parameters, Metric::arc));
  REQUIRE(straight.size() == along.size());
  CHECK(straight[straight.size() / 2] < along[along.size() / 2]);
}

TEST_CASE("the thesis sphere has the same rows by every metric: the counts come from its mesh") {
  const auto input = test_support::thesis_sphere();
  const auto parameters = test_support::thesis_parameters();
  const auto golden = sizes_of(run(input, parameters, Metric::euclidean));
  CHECK(golden.size() == 64);
  CHECK(sizes_of(run(input, parameters, Metric::arc)) == golden);
  CHECK(sizes_of(run(input, parameters, Metric::geodesic)) == golden);
}

TEST_CASE("a geodesic walk does not depend on the way it is stepped") {
  const auto input = test_support::small_sphere();
  Parameters parameters = test_support::small_parameters();
  parameters.rows.metric = Metric::geodesic;
  Timeline timeline(input, parameters);
  timeline.extend_to_end();
  std::vector<std::uint64_t> hashes;
  timeline.seek(0);
  hashes.push_back(hash_of(timeline.state()));
  while (timeline.forward()) hashes.push_back(hash_of(timeline.state()));
  std::size_t wrong = 0;
  for (std::size_t position = timeline.known(); position > 0;
       position -= std::min<std::size_t>(position, 7)) {
    timeline.seek(position);
    wrong += hash_of(timeline.state()) != hashes[position] ? 1U : 0U;
  }
  CHECK(wrong == 0);
}

TEST_CASE("a stall far from the ring's end is measured however far it is") {
  const auto input = clover();
  Parameters strict;
  give_width(strict, 0.3);
  give_epsilon(strict, 0.001);
  strict.rows.on_stall = OnStall::stop;
  const Timeline timeline = run(input, strict, Metric::geodesic);
  REQUIRE(timeline.stop() != nullptr);
  for (const Step& step : timeline.steps()) {
    if (const auto* measured = knit::get_if<CandidateMeasured>(step)) CHECK(measured->distance < 10.0);
  }
}

// Found by fuzzing: the way on from the ring's last vertex was measured into the state before the row was refused.
TEST_CASE("a row that is refused at its end leaves the state as it was, by every metric") {
  const std::vector<ProfilePoint> profile{{0.0, 0.0}, {0.9, 0.5}, {1.0, 1.0}, {0.9, 1.5}, {0.0, 2.0}};
  const auto input = make_input(revolve("drum", profile, 6, false));
  Parameters parameters;
  parameters.rows.resample = Resample::off;
  parameters.rows.on_stall = OnStall::continue_;
  parameters.rows.cast_on = 13;
  give_width(parameters, 1.0);
  give_epsilon(parameters, 0.3);
  for (const Metric metric : {Metric::euclidean, Metric::arc, Metric::geodesic}) {
    parameters.rows.metric = metric;
    State state;
    State before;
    std::optional<Step> last;
    while (!state.finished() && !(last && is_stop(*last))) {
      before = state;
      last = advance(*input, parameters, state);
    }
    REQUIRE(is_stop(*last));
    CHECK(knit::get_if<Stopped>(*last)->reason == StopReason::changes_too_much);
    CHECK(state == before);
  }
}
