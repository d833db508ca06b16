// Short rows in the tubes of shapes that branch: which rows a tube keeps, and what its chart lies between.
#include <algorithm>
#include <filesystem>
#include <glm/geometric.hpp>

#include "knit/import/obj.h"
#include "knit/mesh/branching_shapes.h"
#include "knit/model/stitch_size.h"
#include "knit/run/timeline.h"
#include "knit/short_rows/branch_pairs.h"
#include "tests/support/catch.h"

using namespace knit;

namespace {

struct Tubes {
  std::shared_ptr<const Input> input;
  Shared<TubeGraph> graph;
  Shared<TubePlan> plan;
  [[nodiscard]] std::vector<BranchPairsOrNot> pairs(std::int32_t kept) const {
    return plan_branch_pairs(*input, *graph, *plan, kept, {});
  }
};

Tubes tubes_of(Mesh mesh, TimingKind kind, double width_percent) {
  Tubes tubes{make_input(std::move(mesh)), {}, {}};
  Parameters parameters = default_parameters(tubes.input->bounds);
  give_width(parameters, width_percent / 100.0 * tubes.input->bounds.diagonal());
  parameters.timing.kind = kind;
  parameters.rows.source = RowSource::contours;
  parameters = resolved(parameters, *tubes.input);
  Timeline timeline(tubes.input, parameters);
  while (!timeline.furthest().tubes) REQUIRE(timeline.extend(1));
  tubes.graph = timeline.furthest().graph;
  tubes.plan = timeline.furthest().tubes;
  return tubes;
}

std::size_t count_pairs(const std::vector<BranchPairsOrNot>& all) {
  std::size_t count = 0;
  for (const BranchPairsOrNot& one : all)
    if (const auto* pairs = std::get_if<BranchPairs>(&one)) count += pairs->search.arcs.size();
  return count;
}

// How far a curve is from another at most, by points.
double farthest(const Ring& from, const Ring& to) {
  double far = 0.0;
  for (const glm::dvec3& point : from.points)
    far = std::max(far, glm::distance(point, point_at(to, nearest_arc(to, point))));
  return far;
}

}  // namespace

TEST_CASE("tube pairs: charts lie between the rows that are kept beside events") {
  const Tubes tubes = tubes_of(letter_y(0.08), TimingKind::linear, 3.0);
  const double hair = 0.05 * tubes.plan->stitch_width;
  std::size_t charts = 0;
  for (const std::int32_t kept : {0, 2}) {
    const std::vector<BranchPairsOrNot> all = tubes.pairs(kept);
    REQUIRE(all.size() == tubes.plan->tubes.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto* pairs = std::get_if<BranchPairs>(&all[i]);
      CHECK((pairs != nullptr) == sentence_of(all[i]).empty());
      if (pairs == nullptr) continue;
      ++charts;
      const Tube& tube = tubes.plan->tubes[i];
      CHECK(pairs->below == (tubes.plan->event(tube.bottom).kind == EventKind::cast_on ? 0 : kept));
      CHECK(pairs->above == (tubes.plan->event(tube.top).kind == EventKind::bind_off ? 0 : kept));
      CHECK(pairs->chart->residual < greatest_residual);
      const auto last = static_cast<std::size_t>(tube.rows() - 1 - pairs->above);
      CHECK(farthest(ring_at(*pairs->chart, 0.0, 0.0), *tube.curves[static_cast<std::size_t>(pairs->below)]) <
            hair);
      CHECK(farthest(ring_at(*pairs->chart, pairs->chart->last_level(), 0.0), *tube.curves[last]) < hair);
      // The chart's rounds are about as many as the rows whose place they take.
      CHECK(std::abs(pairs->rounds.gaps() - (tube.rows() - 1 - pairs->above - pairs->below)) <= 2);
    }
  }
  CHECK(charts >= 5);
}

TEST_CASE("tube pairs: a tube of few rows says how many it has") {
  const Tubes tubes = tubes_of(letter_y(0.08), TimingKind::linear, 12.0);
  const std::vector<BranchPairsOrNot> all = tubes.pairs(2);
  const auto few = std::find_if(all.begin(), all.end(), [](const BranchPairsOrNot& one) {
    return std::holds_alternative<TooFewRows>(one);
  });
  REQUIRE(few != all.end());
  CHECK(sentence_of(*few).find("rows between this tube's ends, and 4 are needed") != std::string::npos);
  CHECK(count_pairs(all) == 0);
}

#ifdef KNIT_SHARED_MESHES
TEST_CASE("tube pairs: meshes by others get as many as worked out apart") {
  const std::filesystem::path folder = KNIT_SHARED_MESHES;
  if (!std::filesystem::exists(folder / "bunny.obj")) return;  // not part of the sources
  const auto mesh = [&](const char* name) { return std::get<Mesh>(read_obj_file(folder / name)); };
  const Tubes bunny = tubes_of(mesh("bunny.obj"), TimingKind::geodesic, 4.0);
  CHECK(count_pairs(bunny.pairs(0)) == 4);
  CHECK(count_pairs(bunny.pairs(2)) == 3);
  const Tubes spot = tubes_of(mesh("spot.obj"), TimingKind::geodesic, 4.0);
  CHECK(count_pairs(spot.pairs(2)) == 2);
  CHECK(count_pairs(tubes_of(mesh("octopus.obj"), TimingKind::linear, 4.0).pairs(2)) == 0);
  // A short tube beside a saddle has no chart.
  const Tubes elbow = tubes_of(mesh("simple-elbow.obj"), TimingKind::geodesic, 4.0);
  const std::vector<BranchPairsOrNot> all = elbow.pairs(0);
  CHECK(std::any_of(all.begin(), all.end(),
                    [](const BranchPairsOrNot& one) { return std::holds_alternative<ChartRefusal>(one); }));
  CHECK(count_pairs(elbow.pairs(2)) == 4);
}
#endif
