#include "knit/pattern/rounds.h"

#include <algorithm>
#include "knit/model/bug.h"
#include "knit/pattern/passes.h"
#include "knit/stitches/short_join.h"

namespace knit {

namespace {

std::vector<GraphStitch> grown_row(const Join& t) {
  std::vector<GraphStitch> row;
  std::int32_t before = 0;
  for (const Label label : t.labels) {
    const bool made = is_increase(label);
    row.push_back({hand_of(label), before, made ? 0 : 1});
    before += made ? 0 : 1;
  }
  return row;
}

std::vector<GraphStitch> shrunk_row(const Join& t) {
  std::vector<GraphStitch> row(static_cast<std::size_t>(t.above), {Hand::knit, -1, 0});
  for (std::size_t cell = 0; cell < t.labels.size(); ++cell) {
    GraphStitch& stitch = row[static_cast<std::size_t>(t.link[cell])];
    if (stitch.first < 0) stitch.first = static_cast<std::int32_t>(cell);
    ++stitch.count;
    if (is_decrease(t.labels[cell])) stitch.hand = hand_of(t.labels[cell]);
  }
  return row;
}

void add_short_rows(const Round& round, std::int32_t below, KnitGraph& graph) {
  std::int32_t worked = 0;
  for (const Pass& pass : passes_of(round)) {
    GraphShortRow row{below, 0, 0, pass.wrong_side(), 0};
    for (const PassStitch& stitch : pass.stitches) {
      if (!stitch.in_short_row) {
        ++worked;
        continue;
      }
      if (row.stitches++ == 0) row.first = stitch.column;
      row.worked = worked;
    }
    if (row.stitches > 0) graph.short_rows.push_back(row);
  }
}

}  // namespace

bool knits_plain(const Round& round) {
  return std::all_of(round.operations.begin(), round.operations.end(),
                     [](const Operation& o) { return o.hand == Hand::knit; });
}

Round round_of(const Fabric& fabric, const Join& join) {
  Round round{join.to, operations_of(join), join.below, join.above};
  for (const auto& [first, last] : short_arcs_below(fabric, join.to)) round.pairs.push_back({first, last});
  return round;
}

Rounds rounds_of(const State& state) {
  Rounds rounds;
  rounds.cast_on = size_of(state.fabric.row(1));
  if (state.tubes && !state.tubes->tubes.empty()) {
    const Tube& tube = state.tubes->tubes.front();
    rounds.begins_open = state.tubes->event(tube.bottom).rim;
    rounds.ends_open = state.tubes->event(tube.top).rim;
  }
  for (const auto& join : state.fabric.joins()) {
    if (is_short(state.fabric.row(join->to))) continue;
    rounds.rounds.push_back(round_of(state.fabric, *join));
    rounds.rounds.back().number = static_cast<std::int32_t>(rounds.rounds.size()) + 1;
  }
  return rounds;
}

KnitGraph graph_of(const State& state) {
  KnitGraph graph;
  graph.rows.emplace_back(state.fabric.row(1).stitches.size());
  for (const auto& t : state.fabric.joins()) {
    if (is_short(state.fabric.row(t->to))) continue;
    const Round round = round_of(state.fabric, *t);
    if (!round.pairs.empty()) add_short_rows(round, static_cast<std::int32_t>(graph.rows.size()) - 1, graph);
    graph.rows.push_back(t->change() >= 0 ? grown_row(*t) : shrunk_row(*t));
  }
  return graph;
}

KnitGraph graph_of(const Rounds& rounds) {
  KnitGraph graph;
  graph.rows.emplace_back(static_cast<std::size_t>(rounds.cast_on));
  for (const Round& round : rounds.rounds) {
    std::vector<GraphStitch> row;
    std::int32_t worked = 0;
    for (const Operation& operation : round.operations) {
      row.push_back({operation.hand, worked, consumed_by(operation.hand)});
      worked += consumed_by(operation.hand);
    }
    if (worked != static_cast<std::int32_t>(graph.rows.back().size()))
      throw Bug("a round does not work all its stitches");
    if (!round.pairs.empty()) add_short_rows(round, static_cast<std::int32_t>(graph.rows.size()) - 1, graph);
    graph.rows.push_back(std::move(row));
  }
  return graph;
}

}  // namespace knit
