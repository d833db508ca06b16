// Where a run's break conditions hold, carried on as the run grows and thrown away when it changes.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "app/session/run_key.h"
#include "knit/insight/breaks.h"

namespace app {

// Positions: numbers of steps taken. A hit's position shows the step at which its condition holds.
class BreakHits {
 public:
  static constexpr std::size_t all = std::numeric_limits<std::size_t>::max();

  // Looks through up to `steps` more of what is known of the run.
  void refresh(const knit::Timeline& timeline, const std::vector<knit::BreakCondition>& conditions,
               std::size_t steps);

  // Up to this position every hit is known; without conditions up to any.
  [[nodiscard]] std::size_t reach() const;
  [[nodiscard]] bool whole() const;  // of a complete run

  [[nodiscard]] const std::vector<knit::BreakHit>& hits() const { return scanner_.hits(); }  // rising
  [[nodiscard]] std::size_t position_of(const knit::BreakHit& hit) const;
  [[nodiscard]] std::size_t count(std::size_t condition) const;
  [[nodiscard]] std::optional<std::size_t> from(std::size_t position) const;    // the nearest there or after
  [[nodiscard]] std::optional<std::size_t> before(std::size_t position) const;  // the nearest before
  // Of the conditions that hold there, the first.
  [[nodiscard]] const knit::BreakCondition* condition_at(std::size_t position) const;
  [[nodiscard]] bool holds(std::size_t condition, std::size_t position) const;

 private:
  // The first hit at or after a position.
  [[nodiscard]] std::vector<knit::BreakHit>::const_iterator first_from(std::size_t position) const;

  RunKey key_;
  bool stop_taken_ = false;
  bool complete_ = false;
  knit::BreakScanner scanner_;
};

}  // namespace app
