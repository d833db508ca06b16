// The pipeline as a state machine: one smallest step at a time, on a value.
//
// `advance` is deterministic and reads nothing but its arguments: the same input, parameters and state give
// the same bits. When the mesh cannot be knitted on, the step says so (`Stopped`) and the state stays as it
// was; the same holds when the state is finished, which must be asked first. Steps that may be long are heard.
#pragma once

#include "knit/mesh/mesh.h"
#include "knit/model/heard.h"
#include "knit/model/settings.h"
#include "knit/run/state.h"
#include "knit/run/step.h"

namespace knit {

// Requires !state.finished().
Step advance(const Input& input, const Parameters& parameters, State& state, const Heard& heard = {});

// Whether the step to come works through the whole surface: no replay should have to cross it. Requires !state.finished().
bool step_sweeps(const Input& input, const Parameters& parameters, const State& state);

// Whether it may take longer than a frame besides: the surface is large.
bool step_is_long(const Input& input, const Parameters& parameters, const State& state);

// Whether a run that ended so, or has come to settling, takes longer than a part of a frame up to there with a stitch, or
// a limb, of another size, and yet less than a blink: it is worked out beside the run that is shown, and shown when it is whole. What takes longer shall be seen
// on its way. About a microsecond a triangle and two a stitch.
bool change_takes_a_moment(const Input& input, const Parameters& before, const Parameters& after,
                           const State& end);

// With each `auto` as the run has chosen, as far as it has.
Parameters as_chosen(Parameters parameters, const State& state);

}  // namespace knit
