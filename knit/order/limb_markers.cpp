#include "knit/order/limb_markers.h"

#include <algorithm>

namespace knit {

namespace {

constexpr double cost_of_turn_at_marker = 60.0, cost_of_move = 6.0, cost_of_cut_repeats = 4.0,
                 cost_of_late_start = 2.0, cost_of_late_entry = 1.5, cost_of_slip = 1.0;

// A step of a piece, or, with step -1, its rounds.
struct Happening {
  std::size_t piece = 0;
  std::int32_t step = -1;
};
using Run = std::vector<Happening>;

std::vector<Run> yarns_of(const LimbRuns& runs) {
  std::vector<Run> all;
  for (std::size_t piece = 0; piece < runs.order.size(); ++piece) {
    for (std::size_t step = 0; step < runs.steps[piece].size(); ++step) {
      if (begins_yarn(runs.steps[piece][step].kind)) all.emplace_back();
      all.back().push_back({piece, static_cast<std::int32_t>(step)});
    }
    all.back().push_back({piece, -1});
  }
  return all;
}

class Climber {
 public:
  Climber(const LimbTubes& tubes, const LimbRuns& runs) : tubes_(tubes), runs_(runs) {
    const auto none = std::vector<std::int32_t>(static_cast<std::size_t>(tubes.count()), -1);
    found_.base = found_.first = found_.last = aside_ = none;
    for (const auto& steps : runs.steps) {
      found_.entered.emplace_back(steps.size(), -1);
      found_.moved.emplace_back(steps.size(), 0);
    }
  }

  std::optional<LimbMarkers> run() {
    for (const Run& yarn : yarns_of(runs_)) {
      std::optional<Followed> best;
      for (const std::int32_t start : starts_of(step_at(yarn.front()))) {
        std::optional<Followed> followed = follow(yarn, start);
        if (followed && (!best || followed->cost < best->cost)) best = std::move(followed);
      }
      if (!best) return std::nullopt;
      keep(*best);
    }
    return std::move(found_);
  }

 private:
  struct Noted {
    std::vector<std::int32_t>* list;
    std::int32_t tube, gap;
  };
  struct Entered {
    Happening at;
    std::int32_t gap;
    bool moved;
  };
  struct Followed {
    double cost = 0.0;
    std::int32_t slips = 0, moves = 0;
    std::vector<Noted> noted;
    std::vector<Entered> entered;
    const Places* loop = nullptr;
    Places own;  // where the loop is none of the tubes'
    std::int32_t gap = 0;
    [[nodiscard]] const Places& now() const { return loop != nullptr ? *loop : own; }
  };

  [[nodiscard]] const LimbStep& step_at(const Happening& at) const {
    return runs_.steps[at.piece][static_cast<std::size_t>(at.step)];
  }
  [[nodiscard]] bool is_worked(std::int32_t tube) const {
    return found_.last[static_cast<std::size_t>(tube)] >= 0;
  }

  // Where a loop that waits is best entered.
  [[nodiscard]] std::int32_t usual_entry(std::int32_t tube) const {
    const auto t = static_cast<std::size_t>(tube);
    if (is_worked(tube)) return found_.last[t];
    if (aside_[t] >= 0) return aside_[t];
    const LimbTube& at = tubes_.tube(tube);
    const std::int32_t pinch = tubes_.fork(at.bottom).arcs[tubes_.side(at.bottom, tube)].front();
    return static_cast<std::int32_t>(std::find(at.base.begin(), at.base.end(), pinch) - at.base.begin());
  }

  // The usual one first.
  [[nodiscard]] std::vector<std::int32_t> starts_of(const LimbStep& step) const {
    const LimbTube& tube = tubes_.tube(step.tube);
    std::vector<std::int32_t> starts;
    if (step.kind == LimbStepKind::loops) {
      const std::int32_t there = found_.first[static_cast<std::size_t>(step.other)];
      const std::int32_t loops = size_of(tubes_.tube(step.other).places.front());
      return {(loops - there) % loops};
    }
    if (step.kind != LimbStepKind::rejoin) {
      for (std::int32_t i = 0; i < size_of(tube.places.front()); ++i) starts.push_back(i);
      return starts;
    }
    const Places& loop = waiting_loop(tubes_, step.tube, is_worked(step.tube));
    const bool any = is_worked(step.tube) || aside_[static_cast<std::size_t>(step.tube)] >= 0;
    const Places* arc = any ? nullptr : &tubes_.fork(tube.bottom).arcs[tubes_.side(tube.bottom, step.tube)];
    starts.push_back(usual_entry(step.tube));
    for (std::int32_t i = 0; i < size_of(loop); ++i) {
      const std::int32_t place = loop[static_cast<std::size_t>(i)];
      const bool held = arc == nullptr || std::find(arc->begin(), arc->end(), place) != arc->end();
      if (held && i != starts.front()) starts.push_back(i);
    }
    return starts;
  }

  [[nodiscard]] std::optional<Followed> follow(const Run& yarn, std::int32_t start) {
    Followed way;
    way.gap = start;
    for (const Happening& at : yarn) {
      if (at.step < 0)
        work_rows(at, yarn, way);
      else
        take_step(at, way);
      if (way.gap < 0) return std::nullopt;
    }
    way.cost += cost_of_slip * way.slips + cost_of_move * way.moves;
    if (yarn.back().step < 0) way.cost += entry_cost(runs_.order[yarn.back().piece], way);
    return way;
  }

  void take_step(const Happening& at, Followed& way) {
    const LimbStep& step = step_at(at);
    const LimbTube& tube = tubes_.tube(step.tube);
    switch (step.kind) {
      case LimbStepKind::cast_on:
      case LimbStepKind::provisional:
        return;
      case LimbStepKind::loops:
        way.own = tubes_.tube(step.other).places.front();
        std::reverse(way.own.begin(), way.own.end());
        return;
      case LimbStepKind::rejoin:
        way.loop = &waiting_loop(tubes_, step.tube, is_worked(step.tube));
        way.entered.push_back({at, way.gap, false});
        if (way.gap != usual_entry(step.tube)) way.cost += cost_of_late_start;
        return;
      case LimbStepKind::set_aside:
        way.noted.push_back({&aside_, step.tube, way.gap});
        return;
      case LimbStepKind::divide:
        stay_with_child(at, step.tube, way);
        break;
      case LimbStepKind::join:
        break;
    }
    way.gap = same_gap(way.now(), way.gap, tube.base);
    way.loop = &tube.base;
  }

  // Where the yarn hangs at the other child it is broken and rejoined at the pinch.
  void stay_with_child(const Happening& at, std::int32_t tube, Followed& way) const {
    const std::int32_t bottom = tubes_.tube(tube).bottom;
    const Places& arc = tubes_.fork(bottom).arcs[tubes_.side(bottom, tube)];
    const Places& loop = way.now();
    const std::int32_t before = loop[static_cast<std::size_t>((way.gap + size_of(loop) - 1) % size_of(loop))];
    const bool has = std::any_of(arc.begin(), arc.end(), [&](std::int32_t place) {
      return place == before || place == loop[static_cast<std::size_t>(way.gap)];
    });
    if (!has) {
      way.gap = static_cast<std::int32_t>(std::find(loop.begin(), loop.end(), arc.front()) - loop.begin());
      ++way.moves;
    }
    way.entered.push_back({at, way.gap, !has});
  }

  void work_rows(const Happening& at, const Run& yarn, Followed& way) {
    const std::int32_t number = runs_.order[at.piece];
    const LimbTube& tube = tubes_.tube(number);
    const LimbStep& step = step_at(yarn.front());
    std::int32_t first = way.gap;
    if (step.kind == LimbStepKind::loops && at.piece == yarn.front().piece) {
      const HandsRow& hands = tubes_.fork(tube.bottom).on_loops[tubes_.side(tube.bottom, number)];
      way.noted.push_back({&found_.base, number, way.gap});
      way.slips += hands.crosses[static_cast<std::size_t>(way.gap)];
      first = hands.up[static_cast<std::size_t>(way.gap)];
    } else if (!tube.base.empty()) {
      const HandsRow& hands = tube.hands.front();
      way.noted.push_back({&found_.base, number, way.gap});
      way.slips += hands.crosses[static_cast<std::size_t>(way.gap)];
      first = hands.up[static_cast<std::size_t>(way.gap)];
    }
    way.noted.push_back({&found_.first, number, first});
    if (!tube.mains.empty() && std::find(tube.mains.begin(), tube.mains.end(), first) == tube.mains.end())
      way.cost += cost_of_cut_repeats;
    way.slips += tube.slips_of_first[static_cast<std::size_t>(first)];
    way.cost += cost_of_turn_at_marker * tube.turns_of_first[static_cast<std::size_t>(first)];
    way.gap = tube.last_of_first[static_cast<std::size_t>(first)];
    way.noted.push_back({&found_.last, number, way.gap});
    way.loop = &tube.places.back();
  }

  // Of a loop that waits for a join: whether what lies on both sides of its marker stays together there.
  [[nodiscard]] double entry_cost(std::int32_t number, const Followed& way) const {
    const std::int32_t top = tubes_.tube(number).top;
    if (!tubes_.joins(top)) return 0.0;
    const Places& loop = way.now();
    const Places& joined = tubes_.tube(tubes_.fork(top).to.front()).base;
    const std::int32_t after = loop[static_cast<std::size_t>(way.gap)];
    const std::int32_t before = loop[static_cast<std::size_t>((way.gap + size_of(loop) - 1) % size_of(loop))];
    const auto found = std::find(joined.begin(), joined.end(), after);
    if (found == joined.end()) return 0.0;
    const std::int32_t beside = found == joined.begin() ? joined.back() : *(found - 1);
    return beside == before ? cost_of_late_entry : 0.0;
  }

  void keep(const Followed& way) {
    for (const Noted& noted : way.noted) (*noted.list)[static_cast<std::size_t>(noted.tube)] = noted.gap;
    for (const Entered& entered : way.entered) {
      found_.entered[entered.at.piece][static_cast<std::size_t>(entered.at.step)] = entered.gap;
      found_.moved[entered.at.piece][static_cast<std::size_t>(entered.at.step)] = entered.moved ? 1 : 0;
    }
    found_.slips += way.slips;
    found_.moves += way.moves;
  }

  const LimbTubes& tubes_;
  const LimbRuns& runs_;
  LimbMarkers found_;
  std::vector<std::int32_t> aside_;  // of each tube: the gap at which it was set aside
};

}  // namespace

const Places& waiting_loop(const LimbTubes& tubes, std::int32_t tube, bool worked) {
  return worked ? tubes.tube(tube).places.back() : tubes.tube(tube).base;
}

std::optional<LimbMarkers> markers_of(const LimbTubes& tubes, const LimbRuns& runs) {
  return Climber(tubes, runs).run();
}

}  // namespace knit
