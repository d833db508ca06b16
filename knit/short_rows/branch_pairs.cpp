#include "knit/short_rows/branch_pairs.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace knit {

namespace {

constexpr std::int32_t fewest_rows = 4;

// The rows of a tube between those that are kept.
struct RowsBetween {
  std::int32_t first = 0, last = 0;  // both included
  [[nodiscard]] std::int32_t rows() const { return last - first + 1; }
};

RowsBetween rows_between(const TubePlan& plan, const Tube& tube, std::int32_t kept) {
  RowsBetween between{plan.event(tube.bottom).kind == EventKind::cast_on ? 0 : kept,
                      tube.rows() - 1 - (plan.event(tube.top).kind == EventKind::bind_off ? 0 : kept)};
  const auto short_at = [&](std::int32_t row) {
    return too_short(*tube.curves[static_cast<std::size_t>(row)], plan.stitch_width);
  };
  while (between.rows() > 1 && short_at(between.first)) ++between.first;
  while (between.rows() > 1 && short_at(between.last)) --between.last;
  return between;
}

// What the graph's tubes were found in, by the mesh's vertices.
std::vector<double> field_of(const Input& input, const TubeGraph& graph) {
  std::vector<double> field(input.mesh.positions.size(), 0.0);
  for (std::size_t v = 0; v < graph.surface.origin.size(); ++v)
    field[graph.surface.origin[v]] = graph.surface.values[v];
  return field;
}

// The numbers of a tube's two loops in the cutter.
struct Loops {
  std::optional<std::size_t> low, high;
};

BranchPairsOrNot plan_one(TubeCutter& cutter, const Loops& loops, const TubePlan& plan, TubeId id,
                          const RowsBetween& between, const PairSettings& settings, const Heard& heard) {
  if (between.rows() < fewest_rows) return TooFewRows{between.rows()};
  if (!loops.low || !loops.high) return NoPart::no_loop;
  const std::variant<TubePart, NoPart> part = cutter.part(*loops.low, *loops.high, plan.stitch_width);
  if (const auto* why = std::get_if<NoPart>(&part)) return *why;
  std::variant<TubeChart, ChartRefusal> chart =
      make_tube_chart(std::get<TubePart>(part), plan.stitch_height, chart_columns, heard);
  if (const auto* refusal = std::get_if<ChartRefusal>(&chart)) return *refusal;
  BranchPairs pairs;
  pairs.tube = id;
  pairs.below = between.first;
  pairs.above = plan.tube(id).rows() - 1 - between.last;
  pairs.chart = Shared<TubeChart>(std::move(std::get<TubeChart>(chart)));
  pairs.rounds = full_rounds(*pairs.chart, plan.stitch_height);
  pairs.search = choose_arcs(*pairs.chart, pairs.rounds, plan.stitch_width, settings);
  pairs.beginning = middle_of_arcs(pairs.search);
  return pairs;
}

}  // namespace

std::string sentence_of(const BranchPairsOrNot& pairs) {
  if (const auto* few = std::get_if<TooFewRows>(&pairs)) {
    return "no short rows: " + std::to_string(std::max(0, few->rows)) +
           " rows between this tube's ends, and " + std::to_string(fewest_rows) + " are needed";
  }
  if (const auto* why = std::get_if<NoPart>(&pairs)) return sentence_of(*why);
  if (const auto* refusal = std::get_if<ChartRefusal>(&pairs)) return sentence_of(*refusal);
  return {};
}

std::vector<BranchPairsOrNot> plan_branch_pairs(const Input& input, const TubeGraph& graph,
                                                const TubePlan& plan, std::int32_t kept,
                                                const PairSettings& settings, const Heard& heard) {
  TubeCutter cutter(input, field_of(input, graph));
  std::vector<RowsBetween> between;
  std::vector<Loops> loops;
  for (const Tube& tube : plan.tubes) {
    hear(heard, 0.0);
    between.push_back(rows_between(plan, tube, kept));
    loops.emplace_back();
    if (between.back().rows() < fewest_rows) continue;
    const auto first = static_cast<std::size_t>(between.back().first),
               last = static_cast<std::size_t>(between.back().last);
    loops.back().low = cutter.cut({tube.values[first], &*tube.curves[first]});
    loops.back().high = cutter.cut({tube.values[last], &*tube.curves[last]});
  }
  std::vector<BranchPairsOrNot> planned;
  const auto count = static_cast<double>(plan.tubes.size());
  for (std::size_t i = 0; i < plan.tubes.size(); ++i) {
    const auto at = static_cast<double>(i);
    planned.push_back(plan_one(cutter, loops[i], plan, static_cast<TubeId>(i), between[i], settings,
                               part_of(heard, at / count, (at + 1.0) / count)));
  }
  return planned;
}

}  // namespace knit
