#include "knit/tubes/tubes_stage.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>
#include <utility>

#include "knit/mesh/union_find.h"
#include "knit/model/ties.h"
#include "knit/timing/intrinsic.h"
#include "knit/tubes/low_limbs.h"

namespace knit {

namespace {

// A graph with more tubes than this is noise.
constexpr std::size_t most_raw_tubes = 500;
constexpr std::int32_t most_rows = 20000, most_stitches = 2000000;

Stopped stop_for(StopReason reason, std::int32_t count, std::int32_t other, double value) {
  Stopped stop{};
  stop.reason = reason;
  stop.level = count;
  stop.count = count;
  stop.other = other;
  stop.vertex = no_vertex;
  stop.value = value;
  return stop;
}

GraphFound found(const TubeGraph& graph) {
  return {static_cast<std::int32_t>(graph.tubes.size()), static_cast<std::int32_t>(graph.nodes.size()),
          graph.loops(), graph.surface.unfolded};
}

// Whether level sets form more than one tube, but for what rounding makes of flat parts: nodes with nothing but that between
// them are one place, and no tube branches where each place has one below and one above. O(nodes + tubes).
bool branches(const TubeGraph& graph) {
  const double range = graph.nodes.back().value - graph.nodes.front().value;
  const auto value = [&](std::int32_t node) { return graph.nodes[static_cast<std::size_t>(node)].value; };
  UnionFind places(graph.nodes.size());
  std::vector<const GraphTube*> seen;
  for (const GraphTube& tube : graph.tubes) {
    if (clearly_less(value(tube.bottom), value(tube.top), range))
      seen.push_back(&tube);
    else
      places.join(static_cast<std::uint32_t>(tube.bottom), static_cast<std::uint32_t>(tube.top));
  }
  std::vector<std::uint8_t> below(graph.nodes.size(), 0), above(graph.nodes.size(), 0);
  return std::any_of(seen.begin(), seen.end(), [&](const GraphTube* tube) {
    return std::exchange(above[places.find(static_cast<std::uint32_t>(tube->bottom))], std::uint8_t{1}) > 0 ||
           std::exchange(below[places.find(static_cast<std::uint32_t>(tube->top))], std::uint8_t{1}) > 0;
  });
}

Shared<TubeGraph> graph_of(const Input& input, const std::vector<double>& field, const Heard& heard) {
  return Shared(find_tubes(make_morse(input, field, part_of(heard, 0.0, 0.4)), part_of(heard, 0.4, 1.0)));
}

// The times' own graph; where it is one tube there is nothing to smooth.
Advanced<TubesEvent> find_graph(const Input& input, const Timing& timing, const TubeSettings& settings,
                                TubesWork& work, const Heard& heard) {
  Shared<TubeGraph> graph = graph_of(input, timing.cut_field(), part_of(heard, 0.0, 0.3));
  const bool smooth =
      settings.smoothing == Smoothing::on || (settings.smoothing == Smoothing::by_itself && branches(*graph));
  if (!smooth && graph->tubes.size() > most_raw_tubes) {
    const auto tubes = static_cast<std::int32_t>(graph->tubes.size());
    return stop_for(StopReason::too_many_tubes, tubes, static_cast<std::int32_t>(most_raw_tubes), 0.0);
  }
  if (smooth)
    work.smoother.emplace(input, make_intrinsic(input, part_of(heard, 0.3, 0.4)), part_of(heard, 0.4, 1.0));
  work.graph = std::move(graph);
  work.phase = smooth ? TubesPhase::smooth : TubesPhase::nodes;
  return found(*work.graph);
}

FieldSmoothed smooth(const Input& input, const Timing& timing, const TubeSettings& settings,
                     const StitchSize& stitch, TubesWork& work, const Heard& heard) {
  const FieldSmoothed step{static_cast<std::int32_t>(work.graph->tubes.size()),
                           settings.smoothing_length * stitch.height};
  std::vector<double> field =
      work.smoother->smooth(input, timing.cut_field(), step.length, part_of(heard, 0.0, 0.8));
  // An open edge stays a level curve.
  for (VertexId v = 0; v < field.size() && !input.rims.empty(); ++v) {
    const double before = timing.cut_field()[v];
    if (before <= 0.0 || before >= 1.0) field[v] = before;
  }
  work.graph = graph_of(input, field, part_of(heard, 0.8, 1.0));
  work.smoother.reset();
  work.phase = TubesPhase::found;
  return step;
}

NodeFound next_node(TubesWork& work) {
  const GraphNode& node = work.graph->nodes[static_cast<std::size_t>(work.shown++)];
  if (work.shown == static_cast<std::int32_t>(work.graph->nodes.size())) work.phase = TubesPhase::plan;
  return {node.kind(), work.graph->surface.origin[node.vertex], static_cast<std::int32_t>(node.below.size()),
          static_cast<std::int32_t>(node.above.size()), node.value};
}

TubeLeftOut told(const LeftOut& left, const StitchSize& stitch) {
  return {left.handle, left.from, static_cast<float>(left.height / stitch.height),
          static_cast<float>(left.girth / stitch.width), static_cast<float>(left.width_that_keeps)};
}

// All low limbs by the highest of them; none: there are none.
std::optional<TubeLeftOut> told_together(const StitchSize& stitch, const TubesWork& work) {
  const LowLimbs low = low_limbs(*work.graph, *work.plan);
  if (low.highest == nullptr) return std::nullopt;
  TubeLeftOut all = told(*low.highest, stitch);
  all.together = static_cast<std::uint16_t>(low.count);
  all.at_most = static_cast<std::uint16_t>(std::ceil(1e4 * low.share));
  return all;
}

// One after the other, and those that are low at the end; none: all are told.
std::optional<TubeLeftOut> next_left_out(const StitchSize& stitch, TubesWork& work) {
  const std::vector<LeftOut>& left_out = work.plan->left_out;
  const auto all = static_cast<std::int32_t>(left_out.size());
  while (work.shown < all) {
    const LeftOut& left = left_out[static_cast<std::size_t>(work.shown++)];
    if (!is_low(*work.plan, left)) return told(left, stitch);
  }
  return work.shown++ == all ? told_together(stitch, work) : std::nullopt;
}

// A slip of the stitch size shall not fill the memory.
std::optional<Stopped> too_fine_for(const TubeGraph& graph, const StitchSize& stitch) {
  double area = 0.0;
  glm::dvec3 low = graph.surface.positions.front(), high = low;
  for (const auto& [a, b, c] : graph.surface.triangles) {
    const auto& p = graph.surface.positions;
    area += 0.5 * glm::length(glm::cross(p[b] - p[a], p[c] - p[a]));
  }
  for (const glm::dvec3& p : graph.surface.positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const double stitches = area / (stitch.width * stitch.height),
               rows = glm::distance(low, high) / stitch.height;
  if (rows > most_rows)
    return stop_for(StopReason::too_fine, static_cast<std::int32_t>(std::min(rows, 1e9)), most_rows, 0.0);
  if (stitches > most_stitches) return stop_for(StopReason::too_fine, 0, most_stitches, stitches);
  return std::nullopt;
}

Advanced<TubesEvent> plan(const TubeSettings& settings, const StitchSize& stitch, TubesWork& work,
                          TubesMade made, const ReorderTubes& reorder, const Heard& heard) {
  if (!work.plan) {
    if (const auto stop = too_fine_for(*work.graph, stitch)) return *stop;
    hear(heard, 0.0);
    TubePlan planned = plan_tubes(*work.graph, {stitch.width, stitch.height, settings.smallest_limb}, heard);
    if (planned.tubes.size() == 1 && planned.tubes.front().rows() <= 1)
      return stop_for(StopReason::no_row_levels, planned.tubes.front().rows(), 0, stitch.width);
    work.plan = Shared(reorder ? reorder(*work.graph, planned) : std::move(planned));
    work.shown = 0;
  }
  if (const auto left = next_left_out(stitch, work)) return *left;
  const TubePlan& planned = *work.plan;
  TubesPlanned step{static_cast<std::int32_t>(planned.tubes.size()),
                    0,
                    static_cast<std::int32_t>(planned.events.size()),
                    planned.held_most,
                    planned.yarns,
                    planned.orders_tried,
                    planned.order_is_exact};
  for (const Tube& tube : planned.tubes) step.rows += tube.rows();
  made.graph = work.graph;
  made.plan = work.plan;
  return {step, Ended::stage};
}

}  // namespace

Advanced<TubesEvent> advance_tubes(const Input& input, const Timing& timing, const TubeSettings& settings,
                                   const StitchSize& stitch, TubesWork& work, TubesMade made,
                                   const ReorderTubes& reorder, const Heard& heard) {
  switch (work.phase) {
    case TubesPhase::graph:
      return find_graph(input, timing, settings, work, heard);
    case TubesPhase::smooth:
      return smooth(input, timing, settings, stitch, work, heard);
    case TubesPhase::found:
      if (work.graph->tubes.size() > most_raw_tubes)
        return stop_for(StopReason::too_many_tubes, static_cast<std::int32_t>(work.graph->tubes.size()),
                        static_cast<std::int32_t>(most_raw_tubes), 0.0);
      work.phase = TubesPhase::nodes;
      return found(*work.graph);
    case TubesPhase::nodes:
      return next_node(work);
    case TubesPhase::plan:
      break;
  }
  return plan(settings, stitch, work, made, reorder, heard);
}

bool next_sweeps_surface(const TubesWork& work) {
  return work.phase == TubesPhase::graph || work.phase == TubesPhase::smooth ||
         (work.phase == TubesPhase::plan && !work.plan);
}

std::string_view work_ahead(const TubesWork& work) {
  if (work.phase == TubesPhase::graph) return "finding the tubes";
  return work.phase == TubesPhase::smooth ? "smoothing the time" : "planning the rounds";
}

}  // namespace knit
