// What the panels show of a whole run, worked out once and carried on as the run grows: a run may have a
// million steps, and a frame must not walk them.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "knit/insight/problems.h"
#include "knit/run/timeline.h"

namespace app {

// Positions: numbers of steps taken before.
class RunCache {
 public:
  struct Stretch {
    knit::Stage stage = knit::Stage::timing;
    std::size_t begin = 0, end = 0;
  };

  // Once a frame. A rerun is seen by its input, parameters, edits, or by steps that went away.
  void refresh(const knit::Timeline& timeline);

  [[nodiscard]] const std::vector<Stretch>& stages() const { return stages_; }
  [[nodiscard]] const std::vector<std::size_t>& row_starts() const { return row_starts_; }  // rising
  [[nodiscard]] const std::vector<std::size_t>& edits() const { return edits_; }        // in the edits' order
  [[nodiscard]] const std::vector<std::size_t>& problems() const { return problems_; }  // steps, rising
  [[nodiscard]] const knit::ProblemRanking& ranked() const { return ranked_; }          // worst first
  // Of what is worked out, a stop included.
  [[nodiscard]] knit::ProblemCounts problem_counts(const knit::Timeline& timeline) const;

 private:
  struct Key {
    std::shared_ptr<const knit::Input> input;
    knit::Parameters base;
    std::vector<knit::Edit> edits;
    friend bool operator==(const Key&, const Key&) = default;
  };

  void find_rows(const knit::Timeline& timeline);
  void find_edits(const knit::Timeline& timeline);
  void find_problems(const knit::Timeline& timeline);

  Key key_;
  std::size_t known_ = 0;    // steps seen by find_rows
  std::size_t scanned_ = 0;  // and by find_problems
  std::vector<Stretch> stages_;
  std::vector<std::size_t> row_starts_, edits_, problems_;
  knit::ProblemRanking ranked_;
  knit::ProblemCounts counts_;
};

// How often each label has been placed at a state, by Label. Finished joins are counted once.
class LabelTally {
 public:
  using Counts = std::array<std::size_t, 10>;
  Counts count(const knit::State& state);

 private:
  std::vector<std::pair<std::shared_ptr<const knit::Join>, Counts>> joins_;
};

}  // namespace app
