#include "knit/run/timeline.h"

#include <algorithm>
#include <limits>

#include "knit/model/bug.h"
#include "knit/model/gauge.h"

namespace knit {

namespace {
constexpr std::size_t first_spacing = 128;

const Parameters& in_force_at(const Place& place, const Parameters& base, const std::vector<Edit>& edits) {
  const Parameters* in_force = &base;
  for (const Edit& edit : edits) {
    if (edit.at <= place) in_force = &edit.parameters;
  }
  return *in_force;
}

// Where a keyframe stands just after a long step, or at a stage's beginning.
bool follows_long_work(const State& state) {
  if (const auto* timing = std::get_if<TimingWork>(&state.work))
    return (timing->net || timing->scale) && timing->times.empty();
  const bool first_row = state.next.row <= 1 || (state.next.row == 2 && state.next.stage != Stage::pattern);
  return state.next.item == 0 && first_row;
}
}  // namespace

Timeline::Timeline(std::shared_ptr<const Input> input, const Parameters& parameters,
                   std::size_t keyframe_budget_bytes)
    : input_(std::move(input)),
      base_(agreed(parameters, *input_)),
      budget_bytes_(keyframe_budget_bytes),
      spacing_(first_spacing) {
  // About what a run takes: each vertex timed and measured, and as much again for what is made of them.
  steps_.reserve(3 * input_->mesh.positions.size());
  keep_keyframe(0, frontier_);
}

bool Timeline::extend(std::size_t steps) { return extend_while(steps, true); }
bool Timeline::extend_briefly(std::size_t steps) { return extend_while(steps, false); }

bool Timeline::extend_while(std::size_t steps, bool take_long) {
  for (; steps > 0 && !complete_; --steps) {
    if (frontier_.finished()) {
      complete_ = true;
      break;
    }
    const Stage stage = frontier_.stage();
    const bool was_long = next_is_long();
    if (was_long && !take_long) break;
    const Step step = advance(*input_, parameters_at(frontier_.next), frontier_);
    take_frontier_step(step, stage, was_long);
  }
  if (complete_ && sought_) return_to(*sought_);
  return !complete_;
}

// `frontier_` has taken the step already; it came from `stage`.
void Timeline::take_frontier_step(const Step& step, Stage stage, bool was_long) {
  if (is_stop(step)) {
    stop_ = step;
    complete_ = true;
    return;
  }
  steps_.push_back(step);
  // A stage's first step may be long (levels are sorted); no replay should have to cross it.
  const bool entered = frontier_.stage() != stage;
  if (steps_.size() % spacing_ == 0 || entered || was_long) keep_keyframe(steps_.size(), frontier_);
  if (sought_ && step.place >= *sought_) return_to(*sought_);
}

bool Timeline::next_is_long() const {
  return !complete_ && !frontier_.finished() &&
         step_is_long(*input_, parameters_at(frontier_.next), frontier_);
}

Timeline::Job Timeline::next_job() const { return {input_, parameters_at(frontier_.next), frontier_}; }

Timeline::Outcome Timeline::work(Job job) {
  const Step step = advance(*job.input, job.parameters, job.state);
  return {step, std::move(job.state)};
}

void Timeline::accept(const Job& job, const Outcome& outcome) {
  const bool current = job.input == input_ && !complete_ && job.state == frontier_ &&
                       job.parameters == parameters_at(frontier_.next);
  if (!current) return;
  const Stage stage = frontier_.stage();
  frontier_ = outcome.state;
  take_frontier_step(outcome.step, stage, true);
  if (complete_ && sought_) return_to(*sought_);
}

void Timeline::extend_to_end() { extend(std::numeric_limits<std::size_t>::max()); }

void Timeline::step_state() {
  // What was long is not done twice.
  if (const auto kept = keyframes_.find(position_ + 1); kept != keyframes_.end()) {
    state_ = kept->second;
    ++position_;
    return;
  }
  const Step step = advance(*input_, parameters_at(state_.next), state_);
  if (step != steps_[position_]) throw Bug("a replayed step differs from the recorded one");
  ++position_;
}

bool Timeline::forward() {
  sought_.reset();
  if (position_ == known() && (complete_ || (!extend(1) && position_ == known()))) return false;
  step_state();
  return true;
}

bool Timeline::back() {
  if (position_ == 0) return false;
  seek(position_ - 1);
  return true;
}

void Timeline::seek(std::size_t position) {
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

std::size_t Timeline::position_of(const Place& place) const {
  const auto after = std::upper_bound(steps_.begin(), steps_.end(), place,
                                      [](const Place& p, const Step& step) { return p < step.place; });
  return static_cast<std::size_t>(after - steps_.begin());
}

Place Timeline::place() const { return position_ == 0 ? Place{} : steps_[position_ - 1].place; }

const Parameters& Timeline::parameters_at(const Place& place) const {
  return in_force_at(place, base_, edits_);
}

const Parameters& Timeline::parameters() const { return parameters_at(state_.next); }

const Parameters& Timeline::parameters_of_step(std::size_t index) const {
  return parameters_at(steps_[index].place);
}

// Only what was wished is carried over; what follows from it follows anew in each. Returns the first reader.
Stage Timeline::change_everywhere(const Parameters& before, const Parameters& parameters) {
  Stage first = Stage::done;
  const auto change = [&](Parameters& kept) {
    const Parameters changed = agreed(with_change(kept, before, parameters), *input_);
    first = std::min(first, first_reader_of_change(kept, changed));
    kept = changed;
  };
  change(base_);
  for (Edit& edit : edits_) change(edit.parameters);
  return first;
}

void Timeline::tune(const Parameters& parameters) {
  const Parameters before = this->parameters();
  if (before == agreed(parameters, *input_)) return;
  const Stage reader = change_everywhere(before, parameters);
  const Place here = sought_.value_or(place());
  const bool at_start = position_ == 0 && !sought_;
  rerun_from_reader(reader);
  if (at_start) {
    seek(0);
  } else {
    return_to(here);
  }
}

void Timeline::edit_from_here(const Parameters& parameters) {
  const Parameters changed = agreed(parameters, *input_);
  if (this->parameters() == changed) return;
  const Parameters before = this->parameters();
  const Place here = state_.next;
  const std::size_t position = position_;
  auto next = std::find_if(edits_.begin(), edits_.end(), [&](const Edit& edit) { return edit.at >= here; });
  if (next != edits_.end() && next->at == here) next = edits_.erase(next);
  for (auto later = next; later != edits_.end(); ++later) {
    later->parameters = agreed(with_change(later->parameters, before, changed), *input_);
  }
  edits_.insert(next, {here, changed});
  rerun_from(position);
  seek(position);
}

void Timeline::remove_edit(std::size_t index) {
  const Place here = sought_.value_or(place());
  const bool at_start = position_ == 0 && !sought_;
  const Place at = edits_[index].at;
  edits_.erase(edits_.begin() + static_cast<std::ptrdiff_t>(index));
  const auto first = std::lower_bound(steps_.begin(), steps_.end(), at,
                                      [](const Step& step, const Place& p) { return step.place < p; });
  rerun_from(static_cast<std::size_t>(first - steps_.begin()));
  if (!at_start) return_to(here);
}

void Timeline::change_input(std::shared_ptr<const Input> input, const Parameters& parameters) {
  const Parameters before = this->parameters();
  const Place here = sought_.value_or(place());
  const bool at_start = position_ == 0 && !sought_;
  input_ = std::move(input);
  change_everywhere(before, parameters);
  rerun_from(0);
  if (!at_start) return_to(here);
}

// Before it all steps were taken with what `base` and `edits` say too; known() when all were.
std::size_t Timeline::first_step_to_differ(const Parameters& base, const std::vector<Edit>& edits) const {
  std::vector<Place> turns{Place{Stage::import, 0, 0}};  // from each to the next, nothing changes
  for (const auto* list : {&edits_, &edits}) {
    for (const Edit& edit : *list) turns.push_back(edit.at);
  }
  std::sort(turns.begin(), turns.end());
  const auto index_of = [this](const Place& place) {
    const auto step = std::lower_bound(steps_.begin(), steps_.end(), place,
                                       [](const Step& s, const Place& p) { return s.place < p; });
    return static_cast<std::size_t>(step - steps_.begin());
  };
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const Stage reader = first_reader_of_change(parameters_at(turns[i]), in_force_at(turns[i], base, edits));
    const std::size_t first = std::max(index_of(turns[i]), index_of({reader, 0, 0}));
    const std::size_t end = i + 1 < turns.size() ? index_of(turns[i + 1]) : known();
    if (reader != Stage::done && first < end) return first;
  }
  return known();
}

void Timeline::set_knobs(const Parameters& base, const std::vector<Edit>& edits,
                         std::shared_ptr<const Input> input) {
  const Place here = sought_.value_or(place());
  const bool at_start = position_ == 0 && !sought_;
  const bool other_mesh = input != nullptr && input != input_;
  if (other_mesh) input_ = std::move(input);
  const Parameters new_base = agreed(base, *input_);
  std::vector<Edit> new_edits = edits;
  for (Edit& edit : new_edits) edit.parameters = agreed(edit.parameters, *input_);
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

// Every keyframe after the first step that could read the change is stale, whatever its stage.
void Timeline::rerun_from_reader(Stage reader) {
  const auto first = std::lower_bound(steps_.begin(), steps_.end(), reader,
                                      [](const Step& step, Stage stage) { return step.place.stage < stage; });
  rerun_from(static_cast<std::size_t>(first - steps_.begin()));
}

void Timeline::rerun_from(std::size_t position) {
  keyframes_.erase(keyframes_.upper_bound(position), keyframes_.end());
  count_keyframe_bytes();
  const auto& [nearest, state] = *std::prev(keyframes_.end());
  frontier_ = state;
  if (position_ > position) {
    state_ = state;
    position_ = nearest;
  }
  for (std::size_t i = nearest; i < position; ++i) advance(*input_, parameters_at(frontier_.next), frontier_);
  steps_.resize(position);
  complete_ = false;
  stop_.reset();
  sought_.reset();
}

void Timeline::await(const Place& place) { return_to(place); }

// Shows the place, or the nearest before it; waits for it while the run has not come that far.
void Timeline::return_to(const Place& place) {
  if (!complete_ && (steps_.empty() || steps_.back().place < place)) {
    seek(known());
    sought_ = place;
    return;
  }
  seek(position_of(place));
}

void Timeline::keep_keyframe(std::size_t position, const State& state) {
  keyframe_bytes_ += copy_bytes(state);
  keyframes_.insert_or_assign(position, state);
  if (keyframe_bytes_ > budget_bytes_) thin_keyframes();
}

// Drops every second keyframe until the rest fits; stage entries, before which a long step may lie, go last.
void Timeline::thin_keyframes() {
  while (keyframe_bytes_ > budget_bytes_ && keyframes_.size() > 1) {
    spacing_ *= 2;
    const bool only_entries =
        std::all_of(std::next(keyframes_.begin()), keyframes_.end(),
                    [](const auto& keyframe) { return follows_long_work(keyframe.second); });
    for (auto it = std::next(keyframes_.begin()); it != keyframes_.end();) {
      const bool keep = !only_entries && (it->first % spacing_ == 0 || follows_long_work(it->second));
      it = keep ? std::next(it) : keyframes_.erase(it);
    }
    count_keyframe_bytes();
  }
}

void Timeline::count_keyframe_bytes() {
  keyframe_bytes_ = 0;
  for (const auto& [at, state] : keyframes_) keyframe_bytes_ += copy_bytes(state);
}

}  // namespace knit
