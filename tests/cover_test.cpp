// Which places of a mesh are watched while its fabric settles.
#include "knit/settle/cover.h"

#include <glm/geometric.hpp>

#include "knit/mesh/shapes.h"
#include "knit/model/stitch_size.h"
#include "knit/run/timeline.h"
#include "tests/support/catch.h"

using namespace knit;

namespace {

struct Ball {
  double width;
  SettleGraph graph;
  std::vector<glm::dvec3> positions, normals;
};

Ball placed_ball(const std::shared_ptr<const Input>& input) {
  Parameters parameters = default_parameters(input->bounds);
  parameters.rows.source = RowSource::contours;
  parameters = resolved(parameters, *input);
  Timeline timeline(input, parameters);
  timeline.extend_to_end();
  const Fabric& fabric = timeline.furthest().fabric;
  Ball placed{parameters.stitch.width, make_settle_graph(fabric), {}, {}};
  for (const auto& row : fabric.rows()) {
    for (const Stitch& stitch : row->stitches) {
      placed.positions.push_back(stitch.position);
      placed.normals.push_back(glm::normalize(stitch.position));
    }
  }
  return placed;
}

}  // namespace

TEST_CASE("cover: a width far below what was knitted asks for no more places than stitches can tell apart") {
  const auto input = make_input(icosphere(3));
  const Ball ball = placed_ball(input);
  const auto places = [&](double share) {
    return places_to_cover(*input, {ball.graph, ball.positions, ball.normals, share * ball.width, ball.width})
        .size();
  };
  CHECK(places(1e-6) <= 400 * ball.graph.stitches);
  CHECK(places(1e-6) == places(1e-9));
  CHECK(places(1.0) <= ball.graph.stitches);
}
