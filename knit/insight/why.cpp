#include "knit/insight/why.h"

#include <algorithm>
#include <limits>

namespace knit {

namespace {

// How many stitches of a row there are, and whether it is closed to a ring.
struct Made {
  std::int32_t count = 0;
  bool closed = false;
};

template <class Container>
std::int32_t size_of(const Container& container) {
  return static_cast<std::int32_t>(container.size());
}

bool is_dealt(const State& state, std::int32_t number) {
  return number >= 1 && number <= size_of(state.fabric.deals());
}

// A bridge is no ring: it goes from one side of a gap to the other.
Made bridge_made(const State& state, std::int32_t number) {
  const Deal* deal = deal_numbered(state, number);
  if (deal == nullptr) return {};
  if (is_dealt(state, number)) return {size_of(deal->bridge), false};
  return {std::get<ContourWork>(state.work).bridged, false};
}

Made made_of(const State& state, std::int32_t row) {
  if (row < 0) return bridge_made(state, -row);
  if (row < 1 || row > state.fabric.next_row()) return {};
  if (const Row* finished = state.fabric.find_row(row))
    return {size_of(finished->stitches), finished->closed};
  if (const auto* cast_on = std::get_if<CastOnWork>(&state.work)) return {size_of(cast_on->stitches), false};
  if (const auto* contour = std::get_if<ContourWork>(&state.work)) return {size_of(contour->stitches), false};
  const auto* work = std::get_if<RowWork>(&state.work);
  if (work == nullptr) return {};
  if (!work->closed.stitches.empty()) return {size_of(work->closed.stitches), true};
  return {size_of(work->walk.kept), false};
}

// The same after a step of the row, read from the step; none: the step changes nothing about it.
std::optional<Made> made_after(const Event& what) {
  if (const auto* s = get_if<StitchCastOn>(what)) return Made{s->stitch, s->stitch == s->of};
  if (const auto* s = get_if<StitchPlaced>(what)) return Made{s->stitch, s->stitch == s->of};
  if (const auto* s = get_if<CandidateMeasured>(what))
    return s->verdict == Verdict::accepted ? std::optional(Made{s->stitch, false}) : std::nullopt;
  if (const auto* s = get_if<BandMissed>(what)) return Made{s->stitch, false};
  if (const auto* s = get_if<RowClosed>(what)) return Made{s->stitches, true};
  if (const auto* s = get_if<RowResampled>(what)) return Made{s->to, true};
  return std::nullopt;
}

bool has_stitch(const Made& made, std::int32_t stitch) { return stitch >= 0 && stitch < made.count; }
bool has_edge(const Made& made, std::int32_t stitch) {
  return has_stitch(made, stitch) && (made.closed || stitch + 1 < made.count);
}

template <class Has>
std::optional<std::size_t> first_with(const Timeline& timeline, std::int32_t row, Has has) {
  const StepRange steps = steps_of_row(timeline, stage_of_row(row), row);
  for (std::size_t i = steps.begin; i < steps.end; ++i) {
    const auto made = made_after(timeline.step(i).what);
    if (made && has(*made)) return i;
  }
  return std::nullopt;
}

// The same of a bridge, whose stitches are cast on one after the other.
std::optional<std::size_t> bridge_made_by(const Timeline& timeline, std::int32_t deal, std::int32_t stitch) {
  const StepRange steps = steps_of_deal(timeline, deal);
  for (std::size_t i = steps.begin; i < steps.end; ++i) {
    const auto* cast_on = get_if<BridgeCastOn>(timeline.step(i));
    if (cast_on != nullptr && cast_on->stitch == stitch + 1) return i;
  }
  return std::nullopt;
}

// The step that sewed a deal's faces in: the last of it.
std::optional<std::size_t> dealt_by(const Timeline& timeline, std::int32_t deal) {
  const StepRange steps = steps_of_deal(timeline, deal);
  const bool done = is_dealt(timeline.furthest(), deal) && steps.begin < steps.end;
  return done ? std::optional(steps.end - 1) : std::nullopt;
}

bool is_plan(const Event& what) { return is<SpacingChosen>(what) || is<RowsMatched>(what); }

// The step that places a label, or plans a row in which the cell stays plain.
std::optional<std::size_t> label_made_by(const Timeline& timeline, const LabelElement& label) {
  if (label.cell < 0) return std::nullopt;
  const StepRange steps = steps_of_row(timeline, Stage::stitches, label.row);
  std::optional<std::size_t> plan;
  std::int32_t cells = 0;
  for (std::size_t i = steps.begin; i < steps.end; ++i) {
    const Event& what = timeline.step(i).what;
    if (const auto* counted = get_if<JoinCounted>(what)) cells = std::max(counted->below, counted->above);
    if (is_plan(what)) plan = i;
    const auto* main = get_if<MainPlaced>(what);
    const auto* shaping = get_if<ShapingPlaced>(what);
    if ((main != nullptr && main->cell == label.cell) || (shaping != nullptr && shaping->cell == label.cell))
      return i;
  }
  const bool finished = timeline.furthest().fabric.join_into(label.row) != nullptr;
  const auto* work = std::get_if<IndexWork>(&timeline.furthest().work);
  const bool plain_by_now = finished || (work != nullptr && exists(timeline.furthest(), label));
  return label.cell < cells && plain_by_now ? plan : std::nullopt;
}

std::optional<std::size_t> face_made_by(const Timeline& timeline, std::int32_t row, std::int32_t face) {
  const StepRange steps = steps_of_row(timeline, Stage::faces, row);
  for (std::size_t i = steps.begin; i < steps.end; ++i) {
    const auto* made = get_if<FaceMade>(timeline.step(i));
    if (made != nullptr && made->index == face + 1) return i;
  }
  return std::nullopt;
}

bool face_exists(const State& state, std::int32_t row, std::int32_t face) {
  if (face < 0) return false;
  if (row < 0) return is_dealt(state, -row) && face < size_of(deal_numbered(state, -row)->faces);
  if (const Strip* finished = state.fabric.strip_into(row)) return face < size_of(finished->faces);
  const auto* work = std::get_if<FacesWork>(&state.work);
  return work != nullptr && row == state.next.row && face < work->made;
}

// One a face, but for a deal that is no ring: it has faces and no columns.
bool column_exists(const State& state, std::int32_t row, std::int32_t edge) {
  if (row >= 0) return face_exists(state, row, edge);
  return edge >= 0 && is_dealt(state, -row) && edge < size_of(deal_numbered(state, -row)->column_edges);
}

bool label_exists(const State& state, const LabelElement& label) {
  if (label.cell < 0) return false;
  const auto cell = static_cast<std::size_t>(label.cell);
  if (const Join* finished = state.fabric.join_into(label.row)) return cell < finished->labels.size();
  const auto* work = std::get_if<IndexWork>(&state.work);
  if (work == nullptr || !work->plan || work->plan->to != label.row) return false;
  const Join& plan = *work->plan;
  if (cell >= plan.labels.size()) return false;
  if (plan.labels[cell] == Label::knit) return true;
  return std::any_of(plan.placed.begin(), plan.placed.begin() + work->placed,
                     [&](const PlacedLabel& placed) { return placed.cell == label.cell; });
}

struct Exists {
  const State& state;
  bool operator()(const StitchElement& s) const { return has_stitch(made_of(state, s.row), s.stitch); }
  bool operator()(const RowEdgeElement& e) const { return has_edge(made_of(state, e.row), e.stitch); }
  bool operator()(const ColumnEdgeElement& e) const { return column_exists(state, e.row, e.edge); }
  bool operator()(const FaceElement& f) const { return face_exists(state, f.row, f.face); }
  bool operator()(const LabelElement& l) const { return label_exists(state, l); }
  bool operator()(const VertexElement& v) const { return v.vertex != no_vertex; }
};

struct MadeBy {
  const Timeline& timeline;
  using Found = std::optional<std::size_t>;
  Found operator()(const StitchElement& s) const {
    if (s.row < 0) return s.stitch < 0 ? Found() : bridge_made_by(timeline, -s.row, s.stitch);
    return first_with(timeline, s.row, [&](const Made& made) { return has_stitch(made, s.stitch); });
  }
  Found operator()(const RowEdgeElement& e) const {
    if (e.row < 0) return e.stitch < 0 ? Found() : bridge_made_by(timeline, -e.row, e.stitch + 1);
    return first_with(timeline, e.row, [&](const Made& made) { return has_edge(made, e.stitch); });
  }
  Found operator()(const ColumnEdgeElement& e) const {
    if (e.row >= 0) return face_made_by(timeline, e.row, e.edge);
    return exists(timeline.furthest(), e) ? dealt_by(timeline, -e.row) : std::nullopt;
  }
  Found operator()(const FaceElement& f) const {
    if (f.row >= 0) return face_made_by(timeline, f.row, f.face);
    return exists(timeline.furthest(), f) ? dealt_by(timeline, -f.row) : std::nullopt;
  }
  Found operator()(const LabelElement& l) const { return label_made_by(timeline, l); }
  Found operator()(const VertexElement& v) const {
    if (v.vertex >= timeline.input().mesh.positions.size()) return std::nullopt;
    return story_of(timeline, v.vertex).decided;
  }
};

}  // namespace

const Deal* deal_numbered(const State& state, std::int32_t number) {
  const auto& deals = state.fabric.deals();
  if (number < 1 || number > size_of(deals) + 1) return nullptr;
  if (number <= size_of(deals)) return &*deals[static_cast<std::size_t>(number) - 1];
  const auto* work = std::get_if<ContourWork>(&state.work);
  return work != nullptr && work->deal ? &*work->deal : nullptr;
}
bool exists(const State& state, const Element& thing) { return std::visit(Exists{state}, thing); }

StepRange steps_of_row(const Timeline& timeline, Stage stage, std::int32_t row) {
  return {timeline.position_of({stage, row, -1}),
          timeline.position_of({stage, row, std::numeric_limits<std::int32_t>::max()})};
}

// Several deals may follow one row; their steps count towards the row to come.
StepRange steps_of_deal(const Timeline& timeline, std::int32_t deal) {
  const State& run = timeline.furthest();
  const Deal* meant = deal_numbered(run, deal);
  if (meant == nullptr) return {};
  std::int32_t before = 0;  // deals after the same row
  while (before + 1 < deal && deal_numbered(run, deal - before - 1)->after == meant->after) ++before;
  const StepRange row = steps_of_row(timeline, Stage::rows, meant->after + 1);
  StepRange steps{row.end, row.end};
  for (std::size_t i = row.begin; i < row.end; ++i) {
    if (is<GapsFound>(timeline.step(i)) && before-- == 0) steps.begin = i;
    if (is<LoopsDealt>(timeline.step(i)) && steps.begin < steps.end) return {steps.begin, i + 1};
  }
  return steps;
}

std::optional<std::size_t> made_by(const Timeline& timeline, const Element& thing) {
  return std::visit(MadeBy{timeline}, thing);
}

std::optional<std::size_t> chosen_by(const Timeline& timeline, const StitchElement& stitch) {
  if (stitch.row < 1) return std::nullopt;  // a bridge's stitches are spread, not picked
  const StepRange steps = steps_of_row(timeline, stage_of_row(stitch.row), stitch.row);
  for (std::size_t i = steps.begin; i < steps.end; ++i) {
    const Event& what = timeline.step(i).what;
    const auto* measured = get_if<CandidateMeasured>(what);
    const auto* missed = get_if<BandMissed>(what);
    // Numbers in steps are the anchor's, from 1: the one taken comes next.
    const bool taken = (measured != nullptr && measured->verdict == Verdict::accepted &&
                        measured->stitch == stitch.stitch) ||
                       (missed != nullptr && missed->stitch == stitch.stitch);
    if (taken || (stitch.stitch == 0 && is<CycleOrdered>(what))) return i;
  }
  return std::nullopt;
}

std::optional<std::size_t> moved_by(const Timeline& timeline, const StitchElement& stitch) {
  const auto made = made_by(timeline, stitch);
  if (!made) return std::nullopt;
  const StepRange steps = steps_of_row(timeline, stage_of_row(stitch.row), stitch.row);
  std::optional<std::size_t> moved;
  for (std::size_t i = *made + 1; i < steps.end; ++i) {
    const Event& what = timeline.step(i).what;
    const auto* shared = get_if<GapShared>(what);
    // By the thesis's rule the first stitch stays.
    const bool by_gap =
        shared != nullptr && shared->shared && (shared->how == Closing::arc || stitch.stitch > 0);
    if (by_gap || is<RowResampled>(what)) moved = i;
  }
  return moved;
}

std::optional<std::size_t> settled_by(const Timeline& timeline) {
  const StepRange steps = steps_of_row(timeline, Stage::settle, 0);
  for (std::size_t i = steps.end; i-- > steps.begin;) {
    const auto* settled = get_if<StitchesSettled>(timeline.step(i));
    if (settled != nullptr && settled->taken) return i;
  }
  return std::nullopt;
}

std::optional<std::size_t> count_decided_by(const Timeline& timeline, std::int32_t row) {
  const StepRange steps = steps_of_row(timeline, stage_of_row(row), row);
  std::optional<std::size_t> decided;
  for (std::size_t i = steps.begin; i < steps.end; ++i) {
    const Event& what = timeline.step(i).what;
    const bool decides =
        is<RowClosed>(what) || is<RowResampled>(what) || is<CountChosen>(what) || is<StitchCastOn>(what);
    if (decides) decided = i;
  }
  return decided;
}

}  // namespace knit
