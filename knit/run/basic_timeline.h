// A run that can be gone through in both directions: recorded steps, keyframes, and the state at a position.
//
// Position = number of steps taken. Going back is the nearest keyframe and ordinary forward steps from there;
// keyframes stand wider apart when they would not fit their budget. The steps are recorded as far as the run
// has been worked out (`known`), which `extend` moves on; every replayed step must equal the recorded one.
//
// Two wishes change parameters. `tune`: as if they had been so from the start; the same place — stage, row,
// item — is shown in the new run, or the nearest before it. `edit_from_here`: what is past stays, the rest is
// run anew. Edits are kept at their places when the run is tuned; a tuned parameter counts in them too. All
// parameters kept here agree with themselves.
//
// `tune_beside` tunes for whoever has a worker: the run of before stays, whole, until the worker brings the other one.
// A run is whole when it is complete, or when what is still to come only refines what is there. Whatever else changes
// parameters meanwhile, or works the run out, makes what is wished the run first.
//
// It knows no pipeline. A `Machine` has the types Input, Parameters (regular), State (regular), Step (comparable) and
// Place (ordered; Place{} is the first step's), and as static functions
//   Step advance(input, parameters, State&, heard)  one smallest step, deterministic; broken off, the state is as before
//   bool finished(state), Place next(state), Place place_of(step), bool is_stop(step)
//   bool is_whole(state)                         what is to come only refines what is there; so it stays to the end
//   bool sweeps(input, parameters, state)        the step to come works through all there is: a keyframe stands after it
//   bool is_long(input, parameters, state)       it may take longer than a frame besides
//   Place first_reader(before, after)            no step before this place reads what differs between the two
//   Parameters resolved(parameters, input)         what follows from the ones wished, made so
//   Parameters with_change(parameters, before, after)
//   size_t copy_bytes(state)                     what a keyframe costs
//   bool enters(from, to)                        a keyframe stands where the place steps from one to the other
//   bool worth_keeping(state)                    such a keyframe is the last to be dropped
//   size_t steps_expected(input)                 room for so many is made at first
// All that the past depends on goes through them, so `places rise` and `advance is deterministic` is all it needs.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "knit/model/heard.h"

namespace knit {

template <class Machine>
struct BasicEdit {
  typename Machine::Place at;  // the first step that reads these parameters, or the first after it
  typename Machine::Parameters parameters;
  friend bool operator==(const BasicEdit&, const BasicEdit&) = default;
};

template <class Machine>
class BasicTimeline {
 public:
  using Input = typename Machine::Input;
  using Parameters = typename Machine::Parameters;
  using State = typename Machine::State;
  using Step = typename Machine::Step;
  using Place = typename Machine::Place;
  using Edit = BasicEdit<Machine>;

  static constexpr std::size_t default_budget_bytes = std::size_t{64} << 20U;

  BasicTimeline(std::shared_ptr<const Input> input, const Parameters& parameters,
                std::size_t keyframe_budget_bytes = default_budget_bytes);

  // Works out up to `steps` more of the run. True while there is more to come.
  bool extend(std::size_t steps);
  // The same, but stops before a step that may take long.
  bool extend_briefly(std::size_t steps);
  void extend_to_end();
  // Until the step to come is at the place or behind it. Heard all the time, though not how far it has come.
  void extend_to(const Place& place, const Heard& heard = {});
  // The step to come may take long (a solve on a large mesh). Whoever must stay responsive takes it elsewhere,
  // on copies of next_job(), and hands the outcome to `accept`; `extend` takes it itself. None while a run is waited for.
  struct Job {
    std::shared_ptr<const Input> input;
    Parameters parameters;
    State state;
  };
  struct Outcome {
    Step step;
    State state;
  };
  [[nodiscard]] bool next_is_long() const;
  [[nodiscard]] Job next_job() const;
  static Outcome work(Job job, const Heard& heard = {});
  // Nothing happens when the run has been changed since the job was given out. While a place is sought, as far as the run
  // has come is shown.
  void accept(const Job& job, const Outcome& outcome);
  [[nodiscard]] bool complete() const { return complete_ && !wish_; }
  [[nodiscard]] bool whole() const { return complete_ || Machine::is_whole(frontier_); }
  [[nodiscard]] std::size_t known() const { return steps_.size(); }
  [[nodiscard]] const Step& step(std::size_t index) const { return steps_[index]; }
  [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }
  // Why the run ended before the last stage did; null while it goes on or when it finished.
  [[nodiscard]] const Step* stop() const { return stop_ ? &*stop_ : nullptr; }
  // In force where the run stopped, or for what is to come next.
  [[nodiscard]] const Parameters& parameters_of_stop() const {
    return parameters_at(Machine::next(frontier_));
  }
  [[nodiscard]] const State& furthest() const { return frontier_; }  // the state at position known()

  [[nodiscard]] std::size_t position() const { return position_; }
  [[nodiscard]] const State& state() const { return state_; }
  [[nodiscard]] const Input& input() const { return *input_; }
  [[nodiscard]] std::shared_ptr<const Input> input_pointer() const { return input_; }

  // False at the end of the run (or its start). Forward works the run out as needed.
  bool forward();
  bool back();
  void seek(std::size_t position);  // clamped to what is known
  // The position just after the last step at or before `place`.
  [[nodiscard]] std::size_t position_of(const Place& place) const;
  // The place of the last step taken; the machine's first place at position 0.
  [[nodiscard]] Place place() const;

  // In force for the next step at the position, as wished.
  [[nodiscard]] const Parameters& parameters() const;
  // Of the run that is shown: what tells it from another.
  [[nodiscard]] const Parameters& base_parameters() const { return base_; }
  [[nodiscard]] const std::vector<Edit>& edits() const { return edits_; }
  // What it is to be: another only while a run is waited for.
  [[nodiscard]] const Parameters& wished_parameters() const { return wish_ ? wish_->base : base_; }
  [[nodiscard]] const std::vector<Edit>& wished_edits() const { return wish_ ? wish_->edits : edits_; }
  // In force for the step at an index.
  [[nodiscard]] const Parameters& parameters_of_step(std::size_t index) const;

  void tune(const Parameters& parameters);
  // As tune, later: until `take_over` brings the run that is waited for, all but the wish is of the run of before, and
  // that is neither complete nor goes on. Where that is not whole yet, as tune.
  void tune_beside(const Parameters& parameters);
  [[nodiscard]] bool is_waiting() const { return wish_.has_value(); }
  // The run that is waited for, as far as it equals this one. Requires is_waiting().
  [[nodiscard]] BasicTimeline awaited_run() const;
  // Shows the same place of it. One of an earlier wish is shown too, and the wish stays. Nothing happens, and false, when
  // none is waited for, or it is of another mesh or not whole.
  bool take_over(BasicTimeline run);
  void edit_from_here(const Parameters& parameters);
  void remove_edit(std::size_t index);
  // Exactly these parameters and edits, as undoing and opening want them; shows the same place, as tune does.
  // Edits are by place, rising. `input`: another form of the same mesh; null: as it is.
  void set_knobs(const Parameters& base, const std::vector<Edit>& edits,
                 std::shared_ptr<const Input> input = nullptr);
  // As tune, on another form of the same mesh (welded, or not).
  void change_input(std::shared_ptr<const Input> input, const Parameters& parameters);
  // Shows the place, or the nearest before it, as soon as the run has come so far; until then its end.
  void await(const Place& place);
  // A place that is awaited, or that a tune wants to return to, and the run has not reached yet.
  [[nodiscard]] const std::optional<Place>& sought() const { return sought_; }

  [[nodiscard]] std::size_t keyframe_count() const { return keyframes_.size(); }
  [[nodiscard]] std::size_t keyframe_bytes() const { return keyframe_bytes_; }

 private:
  [[nodiscard]] const Parameters& parameters_at(const Place& place) const;
  [[nodiscard]] std::size_t first_step_at(const Place& place) const;
  struct Wish {
    Parameters base;
    std::vector<Edit> edits;
    friend bool operator==(const Wish&, const Wish&) = default;
  };
  void take_wish();
  bool extend_while(std::size_t steps, bool take_long, const Heard& heard);
  void take_frontier_step(const Step& step, const Place& from, bool swept);
  [[nodiscard]] std::size_t first_step_to_differ(const Parameters& base,
                                                 const std::vector<Edit>& edits) const;
  Place change_everywhere(const Parameters& before, const Parameters& parameters, Wish& knobs) const;
  Place change_everywhere(const Parameters& before, const Parameters& parameters);
  void rerun_from(std::size_t position);
  void return_to(const Place& place);
  void keep_keyframe(std::size_t position, const State& state);
  void thin_keyframes();
  void count_keyframe_bytes();
  void step_state();

  std::shared_ptr<const Input> input_;
  Parameters base_;
  std::vector<Edit> edits_;  // by place, rising

  std::vector<Step> steps_;
  State frontier_;
  bool complete_ = false;
  std::optional<Step> stop_;

  std::size_t position_ = 0;
  State state_;
  std::optional<Place> sought_;
  std::optional<Wish> wish_;  // other than the run's; only of a whole one

  std::size_t budget_bytes_;
  std::size_t spacing_;
  std::map<std::size_t, State> keyframes_;  // position 0 is always there
  std::size_t keyframe_bytes_ = 0;
};

}  // namespace knit
