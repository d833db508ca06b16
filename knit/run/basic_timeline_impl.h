// The functions of basic_timeline.h, for the one file of each machine that makes its timeline.
#pragma once

#include <algorithm>
#include <limits>

#include "knit/model/bug.h"
#include "knit/run/basic_timeline.h"

namespace knit {

inline constexpr std::size_t first_keyframe_spacing = 128;

template <class Machine>
const typename Machine::Parameters& in_force_at(const typename Machine::Place& place,
                                                const typename Machine::Parameters& base,
                                                const std::vector<BasicEdit<Machine>>& edits) {
  const auto* in_force = &base;
  for (const auto& edit : edits) {
    if (edit.at <= place) in_force = &edit.parameters;
  }
  return *in_force;
}

template <class Machine>
BasicTimeline<Machine>::BasicTimeline(std::shared_ptr<const Input> input, const Parameters& parameters,
                                      std::size_t keyframe_budget_bytes)
    : input_(std::move(input)),
      base_(Machine::resolved(parameters, *input_)),
      budget_bytes_(keyframe_budget_bytes),
      spacing_(first_keyframe_spacing) {
  steps_.reserve(Machine::steps_expected(*input_));
  keep_keyframe(0, frontier_);
}

template <class Machine>
bool BasicTimeline<Machine>::extend(std::size_t steps) {
  return extend_while(steps, true, {});
}
template <class Machine>
bool BasicTimeline<Machine>::extend_briefly(std::size_t steps) {
  return extend_while(steps, false, {});
}

template <class Machine>
bool BasicTimeline<Machine>::extend_while(std::size_t steps, bool take_long, const Heard& heard) {
  if (wish_ && !take_long) return true;
  take_wish();
  for (; steps > 0 && !complete_; --steps) {
    if (Machine::finished(frontier_)) {
      complete_ = true;
      break;
    }
    const Place from = Machine::next(frontier_);
    if (!take_long && next_is_long()) break;
    const Parameters& parameters = parameters_at(from);
    const bool swept = Machine::sweeps(*input_, parameters, frontier_);
    const Step step = Machine::advance(*input_, parameters, frontier_, heard);
    take_frontier_step(step, from, swept);
  }
  if (complete_ && sought_) return_to(*sought_);
  return !complete_;
}

// `frontier_` has taken the step already; it came from the place `from`.
template <class Machine>
void BasicTimeline<Machine>::take_frontier_step(const Step& step, const Place& from, bool swept) {
  if (Machine::is_stop(step)) {
    stop_ = step;
    complete_ = true;
    return;
  }
  steps_.push_back(step);
  // A stage's first step may be long (levels are sorted); no replay should have to cross it.
  const bool entered = Machine::enters(from, Machine::next(frontier_));
  if (steps_.size() % spacing_ == 0 || entered || swept) keep_keyframe(steps_.size(), frontier_);
  if (sought_ && Machine::place_of(step) >= *sought_) return_to(*sought_);
}

template <class Machine>
bool BasicTimeline<Machine>::next_is_long() const {
  return !complete_ && !wish_ && !Machine::finished(frontier_) &&
         Machine::is_long(*input_, parameters_at(Machine::next(frontier_)), frontier_);
}

template <class Machine>
auto BasicTimeline<Machine>::next_job() const -> Job {
  return {input_, parameters_at(Machine::next(frontier_)), frontier_};
}

template <class Machine>
auto BasicTimeline<Machine>::work(Job job, const Heard& heard) -> Outcome {
  const Step step = Machine::advance(*job.input, job.parameters, job.state, heard);
  return {step, std::move(job.state)};
}

template <class Machine>
void BasicTimeline<Machine>::accept(const Job& job, const Outcome& outcome) {
  const bool current = job.input == input_ && !complete_ && !wish_ && job.state == frontier_ &&
                       job.parameters == parameters_at(Machine::next(frontier_));
  if (!current) return;
  const Place from = Machine::next(frontier_);
  frontier_ = outcome.state;
  take_frontier_step(outcome.step, from, true);
  if (!sought_) return;
  if (complete_) return return_to(*sought_);
  state_ = frontier_;
  position_ = known();
}

template <class Machine>
void BasicTimeline<Machine>::extend_to_end() {
  extend(std::numeric_limits<std::size_t>::max());
}

template <class Machine>
void BasicTimeline<Machine>::extend_to(const Place& place, const Heard& heard) {
  const Heard any = part_of(heard, 0.0, 0.0);
  while (!complete_ && Machine::next(frontier_) < place) {
    hear(any, 0.0);
    extend_while(1, true, any);
  }
}

template <class Machine>
void BasicTimeline<Machine>::step_state() {
  // What was long is not done twice.
  if (const auto kept = keyframes_.find(position_ + 1); kept != keyframes_.end()) {
    state_ = kept->second;
    ++position_;
    return;
  }
  const Step step = Machine::advance(*input_, parameters_at(Machine::next(state_)), state_, {});
  if (step != steps_[position_]) throw Bug("a replayed step differs from the recorded one");
  ++position_;
}

template <class Machine>
bool BasicTimeline<Machine>::forward() {
  sought_.reset();
  if (position_ == known() && (complete_ || wish_ || (!extend(1) && position_ == known()))) return false;
  step_state();
  return true;
}

template <class Machine>
bool BasicTimeline<Machine>::back() {
  if (position_ == 0) return false;
  seek(position_ - 1);
  return true;
}

template <class Machine>
void BasicTimeline<Machine>::seek(std::size_t position) {
  sought_.reset();
  position = std::min(position, known());
  if (position == known()) {
    state_ = frontier_;
    position_ = position;
    return;
  }
  const auto keyframe = std::prev(keyframes_.upper_bound(position));
  if (position < position_ || keyframe->first > position_) {
    state_ = keyframe->second;
    position_ = keyframe->first;
  }
  while (position_ < position) step_state();
}

template <class Machine>
std::size_t BasicTimeline<Machine>::position_of(const Place& place) const {
  const auto after =
      std::upper_bound(steps_.begin(), steps_.end(), place,
                       [](const Place& p, const Step& step) { return p < Machine::place_of(step); });
  return static_cast<std::size_t>(after - steps_.begin());
}

template <class Machine>
auto BasicTimeline<Machine>::place() const -> Place {
  return position_ == 0 ? Place{} : Machine::place_of(steps_[position_ - 1]);
}

// The index of the first step at or after the place.
template <class Machine>
std::size_t BasicTimeline<Machine>::first_step_at(const Place& place) const {
  const auto first =
      std::lower_bound(steps_.begin(), steps_.end(), place,
                       [](const Step& step, const Place& p) { return Machine::place_of(step) < p; });
  return static_cast<std::size_t>(first - steps_.begin());
}

template <class Machine>
auto BasicTimeline<Machine>::parameters_at(const Place& place) const -> const Parameters& {
  return in_force_at(place, base_, edits_);
}

template <class Machine>
auto BasicTimeline<Machine>::parameters() const -> const Parameters& {
  return in_force_at(Machine::next(state_), wished_parameters(), wished_edits());
}

template <class Machine>
auto BasicTimeline<Machine>::parameters_of_step(std::size_t index) const -> const Parameters& {
  return parameters_at(Machine::place_of(steps_[index]));
}

// Only what was wished is carried over; what follows from it follows anew in each. Returns the first reader.
template <class Machine>
auto BasicTimeline<Machine>::change_everywhere(const Parameters& before, const Parameters& parameters,
                                               Wish& knobs) const -> Place {
  const auto change = [&](Parameters& kept) {
    const Parameters old = kept;
    kept = Machine::resolved(Machine::with_change(old, before, parameters), *input_);
    return Machine::first_reader(old, kept);
  };
  Place first = change(knobs.base);
  for (Edit& edit : knobs.edits) first = std::min(first, change(edit.parameters));
  return first;
}

template <class Machine>
auto BasicTimeline<Machine>::change_everywhere(const Parameters& before, const Parameters& parameters)
    -> Place {
  Wish knobs{std::move(base_), std::move(edits_)};
  const Place first = change_everywhere(before, parameters, knobs);
  base_ = std::move(knobs.base);
  edits_ = std::move(knobs.edits);
  return first;
}

template <class Machine>
void BasicTimeline<Machine>::tune(const Parameters& parameters) {
  take_wish();
  const Parameters before = this->parameters();
  if (before == Machine::resolved(parameters, *input_)) return;
  const Place reader = change_everywhere(before, parameters);
  const Place here = sought_.value_or(place());
  const bool at_start = position_ == 0 && !sought_;
  rerun_from(first_step_at(reader));
  if (at_start) {
    seek(0);
  } else {
    return_to(here);
  }
}

template <class Machine>
void BasicTimeline<Machine>::tune_beside(const Parameters& parameters) {
  if (!whole()) return tune(parameters);
  Wish knobs{wished_parameters(), wished_edits()};
  change_everywhere(this->parameters(), parameters, knobs);
  wish_.reset();
  if (knobs != Wish{base_, edits_}) wish_ = std::move(knobs);
}

template <class Machine>
auto BasicTimeline<Machine>::awaited_run() const -> BasicTimeline {
  if (!wish_) throw Bug("no run is waited for");
  BasicTimeline run(input_, wish_->base, budget_bytes_);
  run.base_ = wish_->base;
  run.edits_ = wish_->edits;
  const std::size_t first = first_step_to_differ(wish_->base, wish_->edits);
  run.steps_.assign(steps_.begin(), steps_.begin() + static_cast<std::ptrdiff_t>(first));
  run.spacing_ = spacing_;
  run.keyframes_ = {keyframes_.begin(), keyframes_.upper_bound(first)};
  run.rerun_from(first);
  return run;
}

template <class Machine>
bool BasicTimeline<Machine>::take_over(BasicTimeline run) {
  if (!wish_ || run.input_ != input_ || !run.whole()) return false;
  const Place here = sought_.value_or(place());
  const bool at_start = position_ == 0 && !sought_;
  Wish wish = std::move(*wish_);
  *this = std::move(run);
  if (wish != Wish{base_, edits_}) wish_ = std::move(wish);
  if (at_start) {
    seek(0);
  } else {
    return_to(here);
  }
  return true;
}

// What is wished becomes the run, as far as nothing differs.
template <class Machine>
void BasicTimeline<Machine>::take_wish() {
  if (!wish_) return;
  const Wish wish = std::move(*wish_);
  wish_.reset();
  set_knobs(wish.base, wish.edits);
}

template <class Machine>
void BasicTimeline<Machine>::edit_from_here(const Parameters& parameters) {
  take_wish();
  const Parameters changed = Machine::resolved(parameters, *input_);
  if (this->parameters() == changed) return;
  const Parameters before = this->parameters();
  const Place here = Machine::next(state_);
  const std::size_t position = position_;
  auto next = std::find_if(edits_.begin(), edits_.end(), [&](const Edit& edit) { return edit.at >= here; });
  if (next != edits_.end() && next->at == here) next = edits_.erase(next);
  for (auto later = next; later != edits_.end(); ++later) {
    later->parameters = Machine::resolved(Machine::with_change(later->parameters, before, changed), *input_);
  }
  edits_.insert(next, {here, changed});
  rerun_from(position);
  seek(position);
}

template <class Machine>
void BasicTimeline<Machine>::remove_edit(std::size_t index) {
  take_wish();
  const Place here = sought_.value_or(place());
  const bool at_start = position_ == 0 && !sought_;
  const Place at = edits_[index].at;
  edits_.erase(edits_.begin() + static_cast<std::ptrdiff_t>(index));
  rerun_from(first_step_at(at));
  if (!at_start) return_to(here);
}

template <class Machine>
void BasicTimeline<Machine>::change_input(std::shared_ptr<const Input> input, const Parameters& parameters) {
  take_wish();
  const Parameters before = this->parameters();
  const Place here = sought_.value_or(place());
  const bool at_start = position_ == 0 && !sought_;
  input_ = std::move(input);
  change_everywhere(before, parameters);
  rerun_from(0);
  if (!at_start) return_to(here);
}

// Before it all steps were taken with what `base` and `edits` say too; known() when all were.
template <class Machine>
std::size_t BasicTimeline<Machine>::first_step_to_differ(const Parameters& base,
                                                         const std::vector<Edit>& edits) const {
  std::vector<Place> turns{Place{}};  // from each to the next, nothing changes
  for (const auto* list : {&edits_, &edits}) {
    for (const Edit& edit : *list) turns.push_back(edit.at);
  }
  std::sort(turns.begin(), turns.end());
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const Place reader = Machine::first_reader(parameters_at(turns[i]), in_force_at(turns[i], base, edits));
    const std::size_t first = std::max(first_step_at(turns[i]), first_step_at(reader));
    const std::size_t end = i + 1 < turns.size() ? first_step_at(turns[i + 1]) : known();
    if (first < end) return first;
  }
  return known();
}

template <class Machine>
void BasicTimeline<Machine>::set_knobs(const Parameters& base, const std::vector<Edit>& edits,
                                       std::shared_ptr<const Input> input) {
  wish_.reset();
  const Place here = sought_.value_or(place());
  const bool at_start = position_ == 0 && !sought_;
  const bool other_mesh = input != nullptr && input != input_;
  if (other_mesh) input_ = std::move(input);
  const Parameters new_base = Machine::resolved(base, *input_);
  std::vector<Edit> new_edits = edits;
  for (Edit& edit : new_edits) edit.parameters = Machine::resolved(edit.parameters, *input_);
  if (!other_mesh && new_base == base_ && new_edits == edits_) return;
  const std::size_t first = other_mesh ? 0 : first_step_to_differ(new_base, new_edits);
  base_ = new_base;
  edits_ = std::move(new_edits);
  rerun_from(first);
  if (at_start) {
    seek(0);
  } else {
    return_to(here);
  }
}

// Every keyframe after the first step that could read a change is stale, whatever its stage.
template <class Machine>
void BasicTimeline<Machine>::rerun_from(std::size_t position) {
  keyframes_.erase(keyframes_.upper_bound(position), keyframes_.end());
  count_keyframe_bytes();
  const auto& [nearest, state] = *std::prev(keyframes_.end());
  frontier_ = state;
  if (position_ > position) {
    state_ = state;
    position_ = nearest;
  }
  for (std::size_t i = nearest; i < position; ++i)
    Machine::advance(*input_, parameters_at(Machine::next(frontier_)), frontier_, {});
  steps_.resize(position);
  complete_ = false;
  stop_.reset();
  sought_.reset();
}

template <class Machine>
void BasicTimeline<Machine>::await(const Place& place) {
  return_to(place);
}

// Shows the place, or the nearest before it; waits for it while the run has not come that far.
template <class Machine>
void BasicTimeline<Machine>::return_to(const Place& place) {
  if (!complete_ && (steps_.empty() || Machine::place_of(steps_.back()) < place)) {
    seek(known());
    sought_ = place;
    return;
  }
  seek(position_of(place));
}

template <class Machine>
void BasicTimeline<Machine>::keep_keyframe(std::size_t position, const State& state) {
  keyframe_bytes_ += Machine::copy_bytes(state);
  keyframes_.insert_or_assign(position, state);
  if (keyframe_bytes_ > budget_bytes_) thin_keyframes();
}

// Drops every second keyframe until the rest fits; stage entries, before which a long step may lie, go last.
template <class Machine>
void BasicTimeline<Machine>::thin_keyframes() {
  while (keyframe_bytes_ > budget_bytes_ && keyframes_.size() > 1) {
    // At a spacing beyond all steps nothing but entries is left, and those go next; doubled for ever it would be 0 once.
    if (spacing_ <= steps_.size()) spacing_ *= 2;
    const bool only_entries =
        std::all_of(std::next(keyframes_.begin()), keyframes_.end(),
                    [](const auto& keyframe) { return Machine::worth_keeping(keyframe.second); });
    for (auto it = std::next(keyframes_.begin()); it != keyframes_.end();) {
      const bool keep = !only_entries && (it->first % spacing_ == 0 || Machine::worth_keeping(it->second));
      it = keep ? std::next(it) : keyframes_.erase(it);
    }
    count_keyframe_bytes();
  }
}

template <class Machine>
void BasicTimeline<Machine>::count_keyframe_bytes() {
  keyframe_bytes_ = 0;
  for (const auto& [at, state] : keyframes_) keyframe_bytes_ += Machine::copy_bytes(state);
}

}  // namespace knit
