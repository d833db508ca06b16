// Deals of live loops: where rounds begin after a split.
#include "knit/fabric/deal.h"
#include "knit/model/stitch_size.h"
#include "knit/run/timeline.h"
#include "tests/support/bodies.h"
#include "tests/support/catch.h"

using namespace knit;

TEST_CASE(
    "dealing: after a split one tube keeps the beginning of the round, the other begins beside the saddle") {
  Mesh horns = test_support::arch();
  for (glm::dvec3& p : horns.positions) p = {p.x, -p.y, -p.z};
  Parameters parameters;
  parameters.rows.source = RowSource::contours;
  for (const double width : {0.1, 0.15, 0.2}) {
    give_width(parameters, width);
    Timeline timeline(make_input(horns), parameters);
    timeline.extend_to_end();
    REQUIRE(timeline.stop() == nullptr);
    const auto& deals = timeline.furthest().fabric.deals();
    REQUIRE(deals.size() == 1);
    const Deal& deal = *deals.front();
    REQUIRE(deal.kind == DealKind::split);
    const StitchRef beginning = deal.taken.front().at(0);
    int kept = 0;
    for (std::size_t child = 0; child < 2; ++child) {
      const LiveStitches& loop = deal.given[child];
      if (loop.at(0) == beginning) {
        ++kept;
        continue;
      }
      // From a quarter of the arc to its end, over the bridge, and the first quarter.
      const std::int32_t arc = deal.arcs[child], before = arc / 4;
      const auto bridge = static_cast<std::int32_t>(deal.bridge.size());
      REQUIRE(before > 0);
      for (std::int32_t i = 0; i < loop.size(); ++i)
        CHECK(is_bridge(loop.at(i)) == (i >= arc - before && i < arc - before + bridge));
    }
    CHECK(kept == 1);
  }
}
