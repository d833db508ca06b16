#include "knit/run/machine.h"
#include "knit/stitches/faces.h"

namespace knit {

namespace {

void finish_strip(State& state, const FacesWork& work) {
  state.fabric.add(work.plan);
  if (const RowId row = state.next.row + 1; state.fabric.has_row(row)) {
    state.work = FacesWork{};
    state.next = {Stage::faces, row, 0};
  } else {
    state.work = PatternWork{};
    state.next = {Stage::pattern, 1, 0};
  }
}

}  // namespace

Happening advance_faces(State& state) {
  auto& work = std::get<FacesWork>(state.work);
  if (!work.plan) {
    const Fabric& fabric = state.fabric;
    const Join& join = *fabric.join_into(state.next.row);
    work.plan = Shared(
        build_strip(join, fabric.path_indices(join.from), fabric.path_indices(all_of(fabric.row(join.to)))));
  }
  const Strip& strip = *work.plan;
  const Face& face = strip.faces[static_cast<std::size_t>(work.made)];
  const FaceMade step{work.made + 1, static_cast<std::int32_t>(strip.faces.size()), face.label,
                      face.corner_count};
  ++work.made;
  if (step.index == step.of) finish_strip(state, FacesWork{work});
  return step;
}

}  // namespace knit
