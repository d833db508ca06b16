#include "knit/rows/first_choice.h"

#include <algorithm>
#include <variant>

#include "knit/model/stitch_size.h"
#include "knit/rows/ring.h"
#include "knit/timing/critical.h"
#include "knit/timing/levels.h"
#include "knit/timing/timing.h"

namespace knit {

namespace {

constexpr std::int32_t fewest_rings = 3;

}  // namespace

bool has_rings(const Input& input, const TimingSettings& timing) {
  if (input.mesh.triangles.size() > most_ringed_triangles) return false;
  const auto found = find_ends(input, timing);
  const auto* ends = std::get_if<Ends>(&found);
  if (ends == nullptr) return false;
  std::vector<double> times;
  times.reserve(input.mesh.positions.size());
  for (const glm::dvec3& position : input.mesh.positions)
    times.push_back(std::clamp(time_of(*ends, position), 0.0, 1.0));
  const Levels levels = group_levels(input, times, find_criticals(input, times), timing.level_tolerance);
  if (levels.split) return false;
  // The first and the last may be a point.
  std::int32_t rings = 0;
  for (std::int32_t level = 1; level + 1 < levels.count(); ++level) {
    const auto ring = order_ring(input, *ends, levels.level(level));
    if (!std::holds_alternative<Ring>(ring)) return false;
    ++rings;
  }
  return rings >= fewest_rings;
}

Parameters first_parameters(const Input& input) {
  Parameters parameters = default_parameters(input.bounds);
  if (!has_rings(input, parameters.timing)) {
    parameters.rows.source = RowSource::contours;
    parameters.stitches.placement = PlacementPolicy::nearest;
  }
  return resolved(parameters, input);
}

}  // namespace knit
