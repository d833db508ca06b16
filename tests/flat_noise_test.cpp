// A flat ledge, however it is cut into triangles and numbered: rounding alone makes no limb of it.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "knit/model/stitch_size.h"
#include "knit/run/timeline.h"
#include "tests/support/bodies.h"
#include "tests/support/catch.h"

using namespace knit;

namespace {

constexpr int around = 16;

// A cylinder on a wider one. The ledge has `inner` rings of its own, quads cut now one way, now the other, and vertices
// numbered all over the place, so that by (value, index) there are many lowest and highest ones.
Mesh ledge(int inner) {
  std::vector<std::pair<double, double>> profile{{1.0, 0.0}, {1.0, 1.0}};
  for (int i = 1; i <= inner; ++i) profile.emplace_back(1.0 - 0.5 * i / (inner + 1), 1.0);
  profile.insert(profile.end(), {{0.5, 1.0}, {0.5, 3.0}});
  const int rings = static_cast<int>(profile.size());
  const int count = rings * around;
  Mesh mesh;
  mesh.name = "ledge";
  mesh.positions.resize(static_cast<std::size_t>(count) + 2);
  const auto number = [&](int ring, int i) {
    return static_cast<VertexId>((ring * around + i % around) * 37 % count);  // 37 is prime to it
  };
  for (int ring = 0; ring < rings; ++ring) {
    for (int i = 0; i < around; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / around;
      const auto& [radius, height] = profile[static_cast<std::size_t>(ring)];
      mesh.positions[number(ring, i)] = {radius * std::sin(angle), height, radius * std::cos(angle)};
    }
  }
  const auto low = static_cast<VertexId>(count), high = low + 1;
  mesh.positions[high] = {0.0, 3.0, 0.0};
  for (int i = 0; i < around; ++i) {
    mesh.triangles.push_back({low, number(0, i + 1), number(0, i)});
    mesh.triangles.push_back({high, number(rings - 1, i), number(rings - 1, i + 1)});
    for (int ring = 0; ring + 1 < rings; ++ring) {
      const VertexId a = number(ring, i), b = number(ring, i + 1);
      const VertexId c = number(ring + 1, i + 1), d = number(ring + 1, i);
      const bool other = (ring + i) % 2 > 0;
      mesh.triangles.push_back(other ? Triangle{a, b, d} : Triangle{a, b, c});
      mesh.triangles.push_back(other ? Triangle{b, c, d} : Triangle{a, c, d});
    }
  }
  return mesh;
}

Timeline run_of(const Mesh& mesh) {
  const auto input = make_input(mesh);
  Parameters parameters;
  give_width(parameters, 0.15);
  parameters.rows.source = RowSource::contours;
  parameters.stitches.placement = PlacementPolicy::nearest;
  Timeline timeline(input, resolved(parameters, *input));
  timeline.extend_to_end();
  return timeline;
}

bool is_smoothed(const Timeline& timeline) {
  for (std::size_t i = 0; i < timeline.known(); ++i)
    if (is<FieldSmoothed>(timeline.step(i))) return true;
  return false;
}

std::vector<std::int32_t> sizes_of(const Timeline& timeline) {
  std::vector<std::int32_t> sizes;
  for (const auto& row : timeline.furthest().fabric.rows()) sizes.push_back(size_of(*row));
  return sizes;
}

}  // namespace

TEST_CASE("a flat ledge's noise makes no branches: not smoothed, and knitted as without", "[tubes]") {
  const Timeline plain = run_of(ledge(0)), noisy = run_of(ledge(3));
  REQUIRE(noisy.furthest().finished());
  REQUIRE(noisy.furthest().graph->tubes.size() > 10);
  CHECK_FALSE(is_smoothed(noisy));
  CHECK(noisy.furthest().tubes->tubes.size() == 1);
  CHECK(noisy.furthest().tubes->left_out.empty());
  CHECK(sizes_of(noisy) == sizes_of(plain));
}

TEST_CASE("what branches is smoothed still", "[tubes]") { CHECK(is_smoothed(run_of(test_support::arch()))); }
