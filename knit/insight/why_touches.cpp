// Which steps had to do with a thing: part of why.
#include <algorithm>
#include <array>

#include "knit/insight/why.h"

namespace knit {

namespace {

// The cells a step works on, in the join of its row; -1: none.
std::array<std::int32_t, 2> cells_of(const Join& t, const Event& what) {
  if (const auto* s = get_if<MainPlaced>(what)) return {s->cell, -1};
  if (const auto* s = get_if<ShapingPlaced>(what)) return {s->cell, s->partner};
  if (const auto* s = get_if<TurnPlaced>(what)) return {s->cell, -1};
  if (const auto* s = get_if<FaceMade>(what)) {
    const std::int32_t cell = cell_of_face(t, s->index - 1);
    const bool turn = is_turn(s->label);
    return {cell, turn ? -1 : next_cell(t, cell)};
  }
  return {-1, -1};
}

// A row's own steps: measured from the stitch, or to it, made it, moved it. Stitches from 0.
bool makes_stitch(const Event& what, std::int32_t stitch) {
  if (const auto* s = get_if<StitchCastOn>(what)) return s->stitch == stitch + 1;
  if (const auto* s = get_if<StitchPlaced>(what)) return s->stitch == stitch + 1;
  if (const auto* s = get_if<CandidateMeasured>(what))
    return s->stitch == stitch + 1 || (s->verdict == Verdict::accepted && s->stitch == stitch);
  if (const auto* s = get_if<BandMissed>(what)) return s->stitch == stitch + 1 || s->stitch == stitch;
  if (const auto* s = get_if<RowClosed>(what)) return stitch == 0 || stitch + 1 == s->stitches;
  if (is<CycleOrdered>(what)) return stitch == 0;
  if (is<RowResampled>(what)) return true;
  const auto* shared = get_if<GapShared>(what);
  return shared != nullptr && shared->shared && (shared->how == Closing::arc || stitch > 0);
}

// A bridge's own steps: its stitch is cast on; an edge of it is there with its second end; faces come when loops are dealt.
bool makes_bridge_stitch(const Event& what, std::int32_t stitch) {
  const auto* cast_on = get_if<BridgeCastOn>(what);
  return cast_on != nullptr && cast_on->stitch == stitch + 1;
}

// The two ends of a row's or bridge's edge; only rows are rings.
std::array<StitchRef, 2> ends_of(const Fabric& fabric, const RowEdgeElement& edge) {
  const Row* row = fabric.find_row(edge.row);
  const bool wraps = row != nullptr && edge.stitch + 1 == size_of(*row);
  return {StitchRef{edge.row, edge.stitch}, StitchRef{edge.row, wraps ? 0 : edge.stitch + 1}};
}

// From a stitch to the next: measured the way, made its ends, moved them.
bool makes_edge(const Event& what, std::int32_t stitch) {
  const auto placed = [&](std::int32_t made, std::int32_t of) {
    return made == stitch + 2 || (made == of && stitch + 1 == of);
  };
  if (const auto* s = get_if<StitchCastOn>(what)) return placed(s->stitch, s->of);
  if (const auto* s = get_if<StitchPlaced>(what)) return placed(s->stitch, s->of);
  // The one measures the way, the next keeps its end.
  if (const auto* s = get_if<CandidateMeasured>(what))
    return s->verdict == Verdict::accepted && (s->stitch == stitch + 1 || s->stitch == stitch + 2);
  if (const auto* s = get_if<BandMissed>(what)) return s->stitch == stitch + 1 || s->stitch == stitch + 2;
  if (const auto* s = get_if<RowClosed>(what)) return stitch + 2 >= s->stitches;
  if (is<RowResampled>(what)) return true;
  const auto* shared = get_if<GapShared>(what);
  return shared != nullptr && shared->shared;
}

struct Touches {
  const Timeline& timeline;
  std::size_t index;

  [[nodiscard]] const Step& step() const { return timeline.step(index); }
  [[nodiscard]] const Join* join() const {
    const Stage stage = step().place.stage;
    if (stage != Stage::stitches && stage != Stage::faces) return nullptr;
    return planned_join(timeline.furthest(), step().place.row);
  }
  // Whether a cell that the step works on has an end for which `is` holds.
  template <class Is>
  [[nodiscard]] bool any_end(Is is) const {
    const Join* t = join();
    if (t == nullptr) return false;
    const auto cells = cells_of(*t, step().what);
    return std::any_of(cells.begin(), cells.end(),
                       [&](std::int32_t cell) { return cell >= 0 && is(*t, ends_of(*t, cell)); });
  }

  // Of a deal, by its number as a row.
  [[nodiscard]] bool in_deal(std::int32_t row) const {
    return step().place.stage == Stage::rows && steps_of_deal(timeline, -row).holds(index);
  }

  bool operator()(const StitchElement& s) const {
    const Place& at = step().place;
    // Of all that settling did with it, the end is enough.
    if (at.stage == Stage::settle) return settled_by(timeline) == index;
    if (s.row < 0 && in_deal(s.row)) return makes_bridge_stitch(step().what, s.stitch);
    if (at.stage == stage_of_row(s.row) && at.row == s.row) return makes_stitch(step().what, s.stitch);
    return any_end([&](const Join& t, const CellEnds& ends) {
      return (t.to == s.row && ends.above == s.stitch) || t.from.at(ends.below) == StitchRef{s.row, s.stitch};
    });
  }
  // Between two stitches: what measured or moved the way from one to the other, and faces along it.
  bool operator()(const RowEdgeElement& e) const {
    const Place& at = step().place;
    if (e.row < 0 && in_deal(e.row)) return makes_bridge_stitch(step().what, e.stitch + 1);
    if (at.stage == stage_of_row(e.row) && at.row == e.row) return makes_edge(step().what, e.stitch);
    const auto* face = get_if<FaceMade>(step());
    const Join* t = face != nullptr ? join() : nullptr;
    if (t == nullptr) return false;
    if (is_turn(face->label)) return false;
    const CellEnds from = ends_of(*t, face->index - 1);
    const CellEnds to = ends_of(*t, next_cell(*t, face->index - 1));
    if (t->to == e.row) return from.above == e.stitch && to.above != e.stitch;
    // At a gap the stitch beside it is a bridge's; a bridge is met the other way on its other side.
    const auto [one, two] = ends_of(timeline.furthest().fabric, e);
    const StitchRef first = t->from.at(from.below), second = t->from.at(to.below);
    return (first == one && second == two) || (first == two && second == one);
  }
  bool operator()(const ColumnEdgeElement& e) const {
    if (e.row < 0) return in_deal(e.row) && is<LoopsDealt>(step());
    return on_cell(e.row, e.edge);
  }
  bool operator()(const FaceElement& f) const {
    if (f.row < 0) return in_deal(f.row) && is<LoopsDealt>(step());
    const auto* face = get_if<FaceMade>(step());
    if (face != nullptr) return step().place.row == f.row && face->index == f.face + 1;
    const Join* t = join();
    const auto cells = t == nullptr ? 0 : static_cast<std::int32_t>(t->link.size());
    if (t == nullptr || t->to != f.row || f.face >= cells + (t->from.closed ? 0 : 1)) return false;
    const std::int32_t cell = cell_of_face(*t, f.face);
    return on_cell(f.row, cell) || (f.face < cells && on_cell(f.row, next_cell(*t, cell)));
  }
  bool operator()(const LabelElement& l) const {
    if (step().place.row == l.row && (is<SpacingChosen>(step()) || is<RowsMatched>(step()))) return true;
    return on_cell(l.row, l.cell);
  }
  bool operator()(const VertexElement& v) const {
    const std::vector<VertexId>& twin = timeline.input().twin;
    if (v.vertex >= twin.size()) return false;
    const auto is = [&](VertexId other) { return other < twin.size() && twin[other] == twin[v.vertex]; };
    if (const auto* s = get_if<EndsFound>(step())) return is(s->start) || is(s->end);
    if (const auto* s = get_if<VertexTimed>(step())) return s->vertex == v.vertex;
    if (const auto* s = get_if<NodeFound>(step())) return is(s->vertex);
    if (const auto* s = get_if<TubeLeftOut>(step())) return is(s->vertex);
    if (const auto* s = get_if<GapsFound>(step())) return is(s->vertex);
    if (const auto* s = get_if<CycleOrdered>(step())) return is(s->first);
    if (const auto* s = get_if<CandidateMeasured>(step())) return is(s->anchor) || is(s->candidate);
    if (const auto* s = get_if<BandMissed>(step())) return is(s->anchor) || is(s->taken);
    return false;
  }
  [[nodiscard]] bool on_cell(std::int32_t row, std::int32_t cell) const {
    const Join* t = step().place.row == row ? join() : nullptr;
    if (t == nullptr) return false;
    const auto cells = cells_of(*t, step().what);
    return std::find(cells.begin(), cells.end(), cell) != cells.end();
  }
};

// Where a thing's steps can stand: a few rows' stretches, rising, so that a search never walks a whole run.
struct Stretches {
  const Timeline& timeline;
  using Ranges = std::vector<StepRange>;
  [[nodiscard]] StepRange at(Stage stage, std::int32_t row) const {
    return steps_of_row(timeline, stage, row);
  }
  [[nodiscard]] Ranges of_row(std::int32_t row) const {
    const std::vector<RowId> above = timeline.furthest().fabric.rows_on(row);
    Ranges ranges{row < 0 ? steps_of_deal(timeline, -row) : at(stage_of_row(row), row)};
    for (const Stage stage : {Stage::stitches, Stage::faces}) {
      ranges.push_back(at(stage, row));
      for (const RowId on : above) ranges.push_back(at(stage, on));
    }
    return ranges;
  }
  [[nodiscard]] Ranges of_strip(std::int32_t row) const {
    if (row < 0) return {steps_of_deal(timeline, -row)};
    return {at(Stage::stitches, row), at(Stage::faces, row)};
  }
  // Of deals whose saddle it is.
  void add_deals_at(VertexId vertex, Ranges& ranges) const {
    const State& run = timeline.furthest();
    const std::vector<VertexId>& twin = timeline.input().twin;
    for (std::size_t i = 0; run.tubes && i < run.fabric.deals().size(); ++i) {
      const VertexId saddle = run.tubes->event(run.fabric.deals()[i]->event).vertex;
      if (saddle < twin.size() && twin[saddle] == twin[vertex])
        ranges.push_back(steps_of_deal(timeline, static_cast<std::int32_t>(i) + 1));
    }
  }
  Ranges operator()(const StitchElement& s) const {
    Ranges ranges = of_row(s.row);
    ranges.push_back(at(Stage::settle, 0));
    return ranges;
  }
  Ranges operator()(const RowEdgeElement& e) const { return of_row(e.row); }
  Ranges operator()(const ColumnEdgeElement& e) const { return of_strip(e.row); }
  Ranges operator()(const FaceElement& f) const { return of_strip(f.row); }
  Ranges operator()(const LabelElement& l) const { return of_strip(l.row); }
  Ranges operator()(const VertexElement& v) const {
    if (v.vertex >= timeline.input().mesh.positions.size() || timeline.known() == 0) return {};
    Ranges ranges{{0, 1}};  // the ends
    const auto timed = timed_by(timeline, v.vertex);
    if (timed && *timed > 0) ranges.push_back({*timed, *timed + 1});
    ranges.push_back(at(Stage::tubes, 0));
    add_deals_at(v.vertex, ranges);
    const std::int32_t row = story_of(timeline, v.vertex).row;
    if (row > 1) ranges.push_back(at(Stage::rows, row));
    return ranges;
  }
};

}  // namespace

bool touches(const Timeline& timeline, const Element& thing, std::size_t step) {
  return step < timeline.known() && std::visit(Touches{timeline, step}, thing);
}

std::optional<std::size_t> touch_from(const Timeline& timeline, const Element& thing, std::size_t step) {
  for (const StepRange& range : std::visit(Stretches{timeline}, thing)) {
    for (std::size_t i = std::max(range.begin, step); i < range.end; ++i) {
      if (touches(timeline, thing, i)) return i;
    }
  }
  return std::nullopt;
}

std::optional<std::size_t> touch_before(const Timeline& timeline, const Element& thing, std::size_t step) {
  auto ranges = std::visit(Stretches{timeline}, thing);
  std::reverse(ranges.begin(), ranges.end());
  for (const StepRange& range : ranges) {
    for (std::size_t i = std::min(range.end, step); i-- > range.begin;) {
      if (touches(timeline, thing, i)) return i;
    }
  }
  return std::nullopt;
}

}  // namespace knit
