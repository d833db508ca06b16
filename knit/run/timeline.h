// The timeline of a knitting run, and what the recorder (basic_timeline.h) has to know of its machine.
#pragma once

#include "knit/run/basic_timeline.h"
#include "knit/run/machine.h"

namespace knit {

struct KnitMachine {
  using Input = knit::Input;
  using Parameters = knit::Parameters;
  using State = knit::State;
  using Step = knit::Step;
  using Place = knit::Place;

  static Step advance(const Input& input, const Parameters& parameters, State& state, const Heard& heard);
  static bool finished(const State& state) { return state.finished(); }
  // All faces are there: from now on stitches only move, and are written down.
  static bool is_whole(const State& state) { return state.stage() >= Stage::settle; }
  static Place next(const State& state) { return state.next; }
  static Place place_of(const Step& step) { return step.place; }
  static bool is_stop(const Step& step) { return knit::is_stop(step); }
  static bool sweeps(const Input& input, const Parameters& parameters, const State& state);
  static bool is_long(const Input& input, const Parameters& parameters, const State& state);
  static Place first_reader(const Parameters& before, const Parameters& after);
  static Parameters resolved(const Parameters& parameters, const Input& input);
  static Parameters with_change(const Parameters& parameters, const Parameters& before,
                                const Parameters& after);
  static std::size_t copy_bytes(const State& state) { return knit::copy_bytes(state); }
  // A stage's first step may be long (levels are sorted); no replay should have to cross it.
  static bool enters(const Place& from, const Place& to) { return from.stage != to.stage; }
  static bool worth_keeping(const State& state);
  static std::size_t steps_expected(const Input& input);
};

using Edit = BasicEdit<KnitMachine>;
using Timeline = BasicTimeline<KnitMachine>;
extern template class BasicTimeline<KnitMachine>;

}  // namespace knit
