// Stage tubes, one smallest step at a time: what is knitted, and in which order, where rows are contours.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <tuple>
#include <vector>

#include "knit/mesh/mesh.h"
#include "knit/model/event.h"
#include "knit/model/heard.h"
#include "knit/model/products.h"
#include "knit/timing/fields.h"
#include "knit/tubes/tubes_events.h"

namespace knit {

enum class TubesPhase : std::uint8_t { graph, smooth, found, nodes, plan };
struct TubesWork {
  TubesPhase phase = TubesPhase::graph;
  Shared<TubeGraph> graph;
  Shared<TubePlan> plan;
  // Until the time is smoothed: what that needs of the surface. Follows from the mesh alone, and so does not count.
  std::optional<FieldSmoother> smoother;
  std::int32_t shown = 0;  // nodes, then tubes left out, that steps have told of
  [[nodiscard]] auto fields() const { return std::tie(phase, graph, plan, shown); }
  friend bool operator==(const TubesWork& a, const TubesWork& b) { return a.fields() == b.fields(); }
};

// What the stage makes: the graph of all tubes, and the plan of those that are knitted.
struct TubesMade {
  Shared<TubeGraph>& graph;
  Shared<TubePlan>& plan;
};
// What becomes of a plan where somebody who knows stitches has a better order for it.
using ReorderTubes = std::function<TubePlan(const TubeGraph&, const TubePlan&)>;
// Without `reorder` the order stays that of fewest holders (order_tubes).
Advanced<TubesEvent> advance_tubes(const Input& input, const Timing& timing, const TubeSettings& settings,
                                   const StitchSize& stitch, TubesWork& work, TubesMade made,
                                   const ReorderTubes& reorder = {}, const Heard& heard = {});

// Whether the step to come works through the whole surface.
bool next_sweeps_surface(const TubesWork& work);
std::string_view work_ahead(const TubesWork& work);

}  // namespace knit
