#include "knit/run/machine.h"
#include "knit/stitches/faces.h"

namespace knit {

namespace {

// The number along the knitting path of the first stitch of row `row`.
std::uint32_t first_stitch_of(const State& state, std::int32_t row) {
  std::size_t first = 0;
  for (std::int32_t r = 1; r < row; ++r)
    first += state.rows[static_cast<std::size_t>(r) - 1]->stitches.size();
  return static_cast<std::uint32_t>(first);
}

void finish_strip(State& state, const FacesWork& work) {
  state.strips.push_back(work.plan);
  if (state.strips.size() < state.transitions.size()) {
    const std::int32_t row = state.next.row + 1;
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
    const Transition& transition = *state.transitions[static_cast<std::size_t>(state.next.row) - 2];
    work.plan = Shared(build_strip(transition, first_stitch_of(state, transition.row - 1)));
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
