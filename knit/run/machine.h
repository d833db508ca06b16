// The pipeline as a state machine: one smallest step at a time, on a value.
//
// `advance` is deterministic and reads nothing but its arguments: the same input, parameters and state give
// the same bits. When the mesh cannot be knitted on, the step says so (`Stopped`) and the state stays as it
// was; the same holds when the state is finished, which must be asked first.
#pragma once

#include "knit/mesh/mesh.h"
#include "knit/model/settings.h"
#include "knit/run/state.h"
#include "knit/run/step.h"

namespace knit {

// Requires !state.finished().
Step advance(const Input& input, const Parameters& parameters, State& state);

// Whether the step to come may take longer than a frame: a solve over a large surface. Requires
// !state.finished().
bool step_is_long(const Input& input, const Parameters& parameters, const State& state);

}  // namespace knit
