// What differs between the pinned run and the current one, worked out only when either has changed.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "app/compare/compare_runs.h"
#include "app/session/session.h"

namespace app {

class CompareCache {
 public:
  // Once a frame while it is seen; `problems`: of the current whole run. While the current run
  // is being worked out, what was last known stays.
  void refresh(const Session& session, const knit::ProblemCounts& problems);

  // Null while nothing is pinned or its end is not known yet.
  [[nodiscard]] const RunDifference* difference() const { return difference_ ? &*difference_ : nullptr; }
  [[nodiscard]] const RowFigures& pinned_rows() const { return pinned_rows_; }
  [[nodiscard]] const RowFigures& rows() const { return rows_; }
  [[nodiscard]] std::size_t times_compared() const { return times_compared_; }

 private:
  struct Key {
    std::shared_ptr<const knit::Input> input, pinned_input;
    Knobs knobs, pinned_knobs;
    std::uint64_t end = 0, pinned_end = 0;
    friend bool operator==(const Key&, const Key&) = default;
  };
  Key key_;
  std::optional<RunDifference> difference_;
  RowFigures pinned_rows_, rows_;
  std::size_t times_compared_ = 0;
};

}  // namespace app
