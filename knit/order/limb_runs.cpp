#include "knit/order/limb_runs.h"

#include <algorithm>
#include <set>

namespace knit {

namespace {

class Needle {
 public:
  Needle(const LimbTubes& tubes, const std::vector<std::int32_t>& order) : tubes_(tubes) {
    runs_.order = order;
  }

  std::optional<LimbRuns> run() {
    for (const std::int32_t tube : runs_.order) {
      steps_.clear();
      const std::int32_t before = on_;
      bring(tube);
      if (!possible_) return std::nullopt;
      if (!runs_.steps.empty()) runs_.goes_on.push_back(goes_on_from(before) ? 1 : 0);
      runs_.steps.push_back(steps_);
      on_ = tube;
      done_.insert(tube);
      runs_.held_most = std::max(runs_.held_most, static_cast<std::int32_t>(held_.size()));
      end(tube);
    }
    runs_.goes_on.push_back(0);
    return std::move(runs_);
  }

 private:
  void end(std::int32_t tube) {
    const std::int32_t top = tubes_.tube(tube).top;
    const bool graft = tubes_.grafts(top) && is_ready(tubes_.other_of_ring(top, tube)) &&
                       held_.erase(tubes_.other_of_ring(top, tube)) > 0;
    runs_.grafted.push_back(graft ? 1 : 0);
    if (top < 0 || graft) on_ = -1;
  }
  [[nodiscard]] bool goes_on_from(std::int32_t before) const {
    const LimbStep& first = steps_.front();
    if (before < 0) return false;
    if (first.kind == LimbStepKind::join) return first.other == before;
    return first.kind == LimbStepKind::divide && parent_of(first.tube) == before;
  }
  [[nodiscard]] std::int32_t parent_of(std::int32_t tube) const {
    return tubes_.fork(tubes_.tube(tube).bottom).from.front();
  }

  void add(LimbStepKind kind, std::int32_t tube, std::int32_t other = -1) {
    steps_.push_back({kind, tube, other});
  }

  // What a piece before has left is held at its end; what was dealt for this one goes aside among its deals.
  void put_by() {
    if (on_ < 0) return;
    if (!steps_.empty()) add(LimbStepKind::set_aside, on_);
    held_.insert(on_);
    on_ = -1;
  }
  // Of a split the loop that is held waits to be worked, if its tube has rows: nothing else can be made of it before.
  [[nodiscard]] bool is_ready(std::int32_t tube) const {
    return held_.count(tube) > 0 && (!tubes_.tube(tube).has_rows() || done_.count(tube) > 0);
  }
  void take_up(std::int32_t tube) {
    if (held_.erase(tube) == 0) {
      possible_ = false;
      return;
    }
    put_by();
    add(LimbStepKind::rejoin, tube);
    on_ = tube;
  }

  void bring(std::int32_t tube) {
    const std::int32_t bottom = tubes_.tube(tube).bottom;
    if (!possible_ || done_.count(tube) > 0) {
      possible_ = false;
    } else if (bottom < 0) {
      put_by();
      add(LimbStepKind::cast_on, tube);
    } else if (tubes_.casts_on_ring(bottom)) {
      bring_ring(bottom, tube);
    } else if (tubes_.splits(bottom)) {
      bring_child(bottom, tube);
    } else {
      bring_joined(tube);
    }
  }

  void bring_ring(std::int32_t bottom, std::int32_t tube) {
    const std::int32_t other = tubes_.other_of_ring(bottom, tube);
    put_by();
    const bool second = done_.count(other) > 0;
    if (second && !tubes_.fork(bottom).on_loops[tubes_.side(bottom, tube)].possible) possible_ = false;
    add(second ? LimbStepKind::loops : LimbStepKind::provisional, tube, second ? other : -1);
  }

  void bring_child(std::int32_t bottom, std::int32_t tube) {
    if (dealt_.count(bottom) > 0) return take_up(tube);
    const std::int32_t parent = parent_of(tube);
    if (on_ != parent) {
      if (is_ready(parent))
        take_up(parent);
      else if (!tubes_.tube(parent).has_rows())
        bring(parent);
      else
        possible_ = false;
    }
    if (!possible_) return;
    dealt_.insert(bottom);
    held_.insert(tubes_.sibling(tube));
    add(LimbStepKind::divide, tube, tubes_.sibling(tube));
    on_ = tube;
  }

  // The loops that a join takes, those of joins without rows before it too.
  void add_feet(std::int32_t tube, std::vector<std::int32_t>& feet) const {
    feet.push_back(tube);
    const std::int32_t bottom = tubes_.tube(tube).bottom;
    if (tubes_.tube(tube).has_rows() || !tubes_.joins(bottom)) return;
    for (const std::int32_t below : tubes_.fork(bottom).from) add_feet(below, feet);
  }

  [[nodiscard]] bool is_at_hand(std::int32_t tube) const { return on_ == tube || is_ready(tube); }

  void bring_joined(std::int32_t tube) {
    std::vector<std::int32_t> feet;
    for (const std::int32_t below : tubes_.fork(tubes_.tube(tube).bottom).from) add_feet(below, feet);
    for (const std::int32_t foot : feet) {
      const LimbTube& at = tubes_.tube(foot);
      if (!at.has_rows() && tubes_.splits(at.bottom) && !is_at_hand(foot)) bring(foot);
      if (at.has_rows() && !is_at_hand(foot)) possible_ = false;
    }
    if (!possible_) return;
    if (std::find(feet.begin(), feet.end(), on_) == feet.end()) {
      const auto held =
          std::find_if(feet.begin(), feet.end(), [&](std::int32_t foot) { return is_ready(foot); });
      take_up(*held);
    }
    add(LimbStepKind::join, tube, on_);
    for (const std::int32_t foot : feet) held_.erase(foot);
    on_ = tube;
  }

  const LimbTubes& tubes_;
  LimbRuns runs_;
  std::vector<LimbStep> steps_;
  std::set<std::int32_t> held_, dealt_, done_;
  std::int32_t on_ = -1;
  bool possible_ = true;
};

// Whether it may be made first, so that the other is worked on its loops.
bool can_cast_on_ring(const LimbTubes& tubes, std::int32_t tube) {
  const std::int32_t bottom = tubes.tube(tube).bottom;
  return tubes.fork(bottom).on_loops[1 - tubes.side(bottom, tube)].possible;
}

void add_below(const LimbTubes& tubes, std::int32_t tube, std::set<std::int32_t>& found) {
  const std::int32_t bottom = tubes.tube(tube).bottom;
  if (bottom < 0) return;
  if (tubes.casts_on_ring(bottom)) {
    if (!can_cast_on_ring(tubes, tube)) found.insert(tubes.other_of_ring(bottom, tube));
    return;
  }
  for (const std::int32_t below : tubes.fork(bottom).from) {
    if (tubes.tube(below).has_rows())
      found.insert(below);
    else
      add_below(tubes, below, found);
  }
}

}  // namespace

bool LimbRuns::begins_yarn(std::size_t piece) const { return piece == 0 || goes_on[piece - 1] == 0; }

std::optional<LimbRuns> runs_of(const LimbTubes& tubes, const std::vector<std::int32_t>& order) {
  return Needle(tubes, order).run();
}

std::vector<std::int32_t> tubes_below(const LimbTubes& tubes, std::int32_t tube) {
  std::set<std::int32_t> found;
  add_below(tubes, tube, found);
  return {found.begin(), found.end()};
}

}  // namespace knit
