#include "app/session/break_hits.h"

#include <algorithm>

namespace app {

void BreakHits::refresh(const knit::Timeline& timeline, const std::vector<knit::BreakCondition>& conditions,
                        std::size_t steps) {
  RunKey key = run_key(timeline);
  const bool stale = scanner_.conditions() != conditions || key != key_ ||
                     timeline.known() < scanner_.taken() || (complete_ && !timeline.complete());
  if (stale) {
    *this = BreakHits();
    key_ = std::move(key);
    scanner_ = knit::BreakScanner(conditions);
  }
  if (conditions.empty()) return;
  const knit::Fabric& fabric = timeline.furthest().fabric;
  for (; steps > 0 && scanner_.taken() < timeline.known(); --steps) {
    const std::size_t i = scanner_.taken();
    scanner_.take(timeline.step(i), timeline.parameters_of_step(i), fabric);
  }
  complete_ = timeline.complete() && scanner_.taken() == timeline.known();
  if (complete_ && timeline.stop() != nullptr && !stop_taken_) {
    scanner_.take_stop(*timeline.stop());
    stop_taken_ = true;
  }
}

std::size_t BreakHits::reach() const { return scanner_.conditions().empty() ? all : scanner_.taken(); }

bool BreakHits::whole() const { return scanner_.conditions().empty() || complete_; }

// The stop is shown where the run ends.
std::size_t BreakHits::position_of(const knit::BreakHit& hit) const {
  return std::min(hit.step + 1, scanner_.taken());
}

std::size_t BreakHits::count(std::size_t condition) const {
  return condition < scanner_.conditions().size() ? scanner_.count(condition) : 0;
}

std::vector<knit::BreakHit>::const_iterator BreakHits::first_from(std::size_t position) const {
  return std::partition_point(hits().begin(), hits().end(),
                              [&](const knit::BreakHit& hit) { return position_of(hit) < position; });
}

std::optional<std::size_t> BreakHits::from(std::size_t position) const {
  const auto hit = first_from(position);
  return hit == hits().end() ? std::nullopt : std::optional(position_of(*hit));
}

std::optional<std::size_t> BreakHits::before(std::size_t position) const {
  const auto hit = first_from(position);
  return hit == hits().begin() ? std::nullopt : std::optional(position_of(*std::prev(hit)));
}

const knit::BreakCondition* BreakHits::condition_at(std::size_t position) const {
  const auto hit = first_from(position);
  const bool there = hit != hits().end() && position_of(*hit) == position;
  return there ? &scanner_.conditions()[hit->condition] : nullptr;
}

bool BreakHits::holds(std::size_t condition, std::size_t position) const {
  for (auto hit = first_from(position); hit != hits().end() && position_of(*hit) == position; ++hit) {
    if (hit->condition == condition) return true;
  }
  return false;
}

}  // namespace app
