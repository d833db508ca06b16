// What became of a vertex of the mesh: part of why.
#include <algorithm>

#include "knit/insight/why.h"
#include "knit/insight/why_tubes.h"

namespace knit {

namespace {

std::int32_t level_of(const Timing& timing, VertexId vertex) {
  const std::vector<double>& times = timing.levels.times;
  const auto above = std::upper_bound(times.begin(), times.end(), timing.times[vertex]);
  return static_cast<std::int32_t>(above - times.begin()) - 1;
}

bool rows_are_cut(const State& state) {
  if (std::holds_alternative<ContourWork>(state.work)) return true;
  const Row* first = state.fabric.find_row(1);
  return first != nullptr && first->ring->ordered_by == OrderedBy::cut;
}

// The first level that makes a row; -1: not known yet.
std::int32_t first_level(const State& state) {
  if (const Row* first = state.fabric.find_row(1)) return first->level;
  const auto* work = std::get_if<CastOnWork>(&state.work);
  return work != nullptr ? work->level : -1;
}

struct Taken {
  VertexId candidate = no_vertex;
  bool refused = false, by_band = true;
};
std::optional<Taken> measured_in(const Event& what) {
  if (const auto* s = get_if<CandidateMeasured>(what))
    return Taken{s->candidate, s->verdict != Verdict::accepted, true};
  if (const auto* s = get_if<BandMissed>(what)) return Taken{s->taken, false, false};
  return std::nullopt;
}

// Its level makes the row `story.row`, from the second on.
void follow_walk(const Timeline& timeline, VertexId vertex, VertexStory& story) {
  const auto ring = ring_of_row(timeline.furthest(), story.row);
  if (!ring) return;
  const std::vector<VertexId>& in_ring = ring->vertices;
  const std::vector<VertexId>& twin = timeline.input().twin;
  // Of copies at one place mostly a single one stands in the ring.
  VertexId meant = vertex;
  if (std::find(in_ring.begin(), in_ring.end(), vertex) == in_ring.end()) {
    const auto other =
        std::find_if(in_ring.begin(), in_ring.end(), [&](VertexId v) { return twin[v] == twin[vertex]; });
    if (other == in_ring.end()) return;
    meant = *other;
  }
  const StepRange steps = steps_of_row(timeline, Stage::rows, story.row);
  for (std::size_t i = steps.begin; i < steps.end; ++i) {
    const Event& what = timeline.step(i).what;
    const auto* ordered = get_if<CycleOrdered>(what);
    if (ordered != nullptr && ordered->first == meant) {
      story.fate = Fate::begins_row;
      story.decided = i;
    }
    const auto taken = measured_in(what);
    if (!taken || taken->candidate != meant) continue;
    story.measured.push_back(i);
    if (story.fate == Fate::begins_row) continue;  // against itself
    story.fate = taken->refused ? Fate::refused : taken->by_band ? Fate::accepted : Fate::taken;
    story.decided = i;
  }
}

}  // namespace

std::optional<std::size_t> timed_by(const Timeline& timeline, VertexId vertex) {
  const std::size_t known = timeline.known();
  std::size_t first = 0;  // a few solves stand before
  while (first < known && !is<VertexTimed>(timeline.step(first))) {
    if (timeline.step(first).place.stage != Stage::timing) return std::nullopt;
    ++first;
  }
  const std::size_t step = first + vertex;
  const auto* timed = step < known ? get_if<VertexTimed>(timeline.step(step)) : nullptr;
  return timed != nullptr && timed->vertex == vertex ? std::optional(step) : std::nullopt;
}

namespace {

// The tube of the plan that a tube of the graph is part of; -1: it is left out.
TubeId planned_tube(const TubePlan& plan, std::int32_t part) {
  for (std::size_t id = 0; id < plan.tubes.size(); ++id) {
    const auto& parts = plan.tubes[id].parts;
    if (std::find(parts.begin(), parts.end(), part) != parts.end()) return static_cast<TubeId>(id);
  }
  return -1;
}

// A piece that has the vertex as a corner and its rank inside lies in the vertex's tube; of a node, in each that meets it.
TubeId tube_of_vertex(const TubeGraph& graph, const TubePlan& plan, VertexId vertex) {
  for (std::size_t tube = 0; tube < graph.tubes.size(); ++tube) {
    for (std::uint32_t i = graph.first_piece[tube]; i < graph.first_piece[tube + 1]; ++i) {
      const TubePiece& piece = graph.pieces[i];
      for (const VertexId corner : graph.surface.triangles[piece.triangle]) {
        const std::uint32_t rank = graph.surface.rank[corner];
        const bool inside = piece.low <= rank && rank <= piece.high;
        if (graph.surface.origin[corner] != vertex || !inside) continue;
        const TubeId found = planned_tube(plan, static_cast<std::int32_t>(tube));
        if (found >= 0) return found;
      }
    }
  }
  return -1;
}

double value_at_vertex(const TubeGraph& graph, VertexId vertex) {
  const auto& origin = graph.surface.origin;
  const auto found = std::find(origin.begin(), origin.end(), vertex);
  return graph.surface.values[static_cast<std::size_t>(found - origin.begin())];
}

}  // namespace

std::optional<OnTube> on_tube(const Timeline& timeline, VertexId vertex) {
  const State& run = timeline.furthest();
  if (!run.tubes || !run.graph) return std::nullopt;
  const std::vector<VertexId>& twin = timeline.input().twin;
  const VertexId meant = twin[vertex];
  OnTube on;
  for (std::size_t i = 0; i < run.tubes->events.size(); ++i) {
    const VertexId at = run.tubes->events[i].vertex;
    if (at < twin.size() && twin[at] == meant) on.event = static_cast<std::int32_t>(i);
  }
  on.tube = tube_of_vertex(*run.graph, *run.tubes, meant);
  if (on.tube < 0) return on;
  const double value = value_at_vertex(*run.graph, meant);
  for (const auto& row : run.fabric.rows()) {
    if (row->tube != on.tube) continue;
    if (run.tubes->tube(on.tube).values[static_cast<std::size_t>(row->level)] <= value)
      on.below = row->id;
    else if (on.above == 0)
      on.above = row->id;
  }
  return on;
}

std::shared_ptr<const Ring> ring_of_row(const State& state, std::int32_t row) {
  if (row < 2 || row > state.fabric.next_row()) return nullptr;
  if (const Row* finished = state.fabric.find_row(row)) {
    const auto ring = finished->ring.pointer();
    return ring && !ring->vertices.empty() ? ring : nullptr;
  }
  const auto* work = std::get_if<RowWork>(&state.work);
  return work != nullptr ? work->ring.pointer() : nullptr;
}

VertexStory story_of(const Timeline& timeline, VertexId vertex) {
  const State& run = timeline.furthest();
  VertexStory story;
  story.fate = timeline.complete() ? Fate::never_reached : Fate::not_yet;
  story.decided = timed_by(timeline, vertex);
  if (timeline.input().referenced[vertex] == 0) {
    story.fate = Fate::unused;
    return story;
  }
  if (!run.timing) return story;
  if (const auto critical = critical_story(timeline, vertex)) story.decided = critical->decided();
  if (rows_are_cut(run)) {
    story.fate = Fate::cut_rows;
    return story;
  }
  const std::int32_t first = first_level(run);
  if (first < 0) return story;
  const std::int32_t level = level_of(*run.timing, vertex);
  if (level < first || level > run.last_level) {
    story.fate = Fate::no_row;
    return story;
  }
  story.row = level - first + 1;
  if (story.row == 1) {
    story.fate = Fate::cast_on;
    const StepRange steps = steps_of_row(timeline, Stage::cast_on, 1);
    if (steps.begin < steps.end) story.decided = steps.begin;
    return story;
  }
  follow_walk(timeline, vertex, story);
  return story;
}

}  // namespace knit
