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

Made made_of(const State& state, std::int32_t row) {
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
  if (const Strip* finished = state.fabric.strip_into(row)) return face < size_of(finished->faces);
  const auto* work = std::get_if<FacesWork>(&state.work);
  return work != nullptr && row == state.next.row && face < work->made;
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
  bool operator()(const ColumnEdgeElement& e) const { return face_exists(state, e.row, e.edge); }
  bool operator()(const FaceElement& f) const { return face_exists(state, f.row, f.face); }
  bool operator()(const LabelElement& l) const { return label_exists(state, l); }
  bool operator()(const VertexElement& v) const { return v.vertex != no_vertex; }
};

struct MadeBy {
  const Timeline& timeline;
  using Found = std::optional<std::size_t>;
  Found operator()(const StitchElement& s) const {
    return first_with(timeline, s.row, [&](const Made& made) { return has_stitch(made, s.stitch); });
  }
  Found operator()(const RowEdgeElement& e) const {
    return first_with(timeline, e.row, [&](const Made& made) { return has_edge(made, e.stitch); });
  }
  Found operator()(const ColumnEdgeElement& e) const { return face_made_by(timeline, e.row, e.edge); }
  Found operator()(const FaceElement& f) const { return face_made_by(timeline, f.row, f.face); }
  Found operator()(const LabelElement& l) const { return label_made_by(timeline, l); }
  Found operator()(const VertexElement& v) const {
    if (v.vertex >= timeline.input().mesh.positions.size()) return std::nullopt;
    return story_of(timeline, v.vertex).decided;
  }
};

}  // namespace

bool exists(const State& state, const Element& thing) { return std::visit(Exists{state}, thing); }

StepRange steps_of_row(const Timeline& timeline, Stage stage, std::int32_t row) {
  return {timeline.position_of({stage, row, -1}),
          timeline.position_of({stage, row, std::numeric_limits<std::int32_t>::max()})};
}

std::optional<std::size_t> made_by(const Timeline& timeline, const Element& thing) {
  return std::visit(MadeBy{timeline}, thing);
}

std::optional<std::size_t> chosen_by(const Timeline& timeline, const StitchElement& stitch) {
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
