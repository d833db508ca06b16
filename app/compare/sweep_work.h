// The runs of a sweep on a pool of threads.
//
// Each run ends in a slot of its own, so that the results are the same whatever the number of threads. What
// comes before the first stage that reads a swept parameter is run once and shared. Whoever drops the work or
// cancels it does not wait: the threads hold what they need, look up every few hundred steps and end.
// After all runs of one axis, the ends of the stretch without problems, and of that without stalls, are narrowed down between
// a value that has some and its neighbour that has none: a sweep of 96 values finds the end to five digits with a dozen more.
#pragma once

#include <memory>
#include <optional>

#include "app/compare/sweep_quiet.h"
#include "app/compare/tube_figures.h"
#include "app/session/sweep.h"

namespace app {

struct SweepRun {
  std::vector<double> values;  // one an axis
  std::string refused;         // why these parameters cannot be, in one sentence; else empty
  RunFigures figures;
  TubeFigures tubes;
  // Share of the surface, of a finished run with rows from contours: rows from rings are worked out so much faster that
  // measuring it would take most of a sweep.
  std::optional<double> uncovered;
};

class SweepWork {
 public:
  // Requires a plan without fault. 0 threads: as many as the machine has.
  SweepWork(SweepBase base, const SweepPlan& plan, unsigned threads = 0);
  ~SweepWork();
  SweepWork(const SweepWork&) = delete;
  SweepWork& operator=(const SweepWork&) = delete;

  void cancel();  // what is done stays
  void wait();    // until no thread is at it

  [[nodiscard]] std::size_t total() const;
  [[nodiscard]] std::size_t done() const;  // rises; when it has not, no slot has changed either
  [[nodiscard]] bool running() const;      // its runs, or the narrowing after them
  [[nodiscard]] bool cancelled() const;
  // The first axis's values are the outer ones. Null while it is not there.
  [[nodiscard]] const SweepRun* run(std::size_t index) const;
  // The narrowed stretch without problems of this kind, or of all kinds. Null: not there yet, two axes, a kind that is not
  // narrowed down, or none.
  [[nodiscard]] const QuietStretch* quiet(std::optional<knit::ProblemKind> kind) const;
  [[nodiscard]] const SweepPlan& plan() const;
  [[nodiscard]] const SweepBase& base() const;
  [[nodiscard]] const std::vector<double>& first_values() const;
  [[nodiscard]] const std::vector<double>& second_values() const;  // empty: one axis

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;
};

// Whether anything else than the swept parameters is another now than it was for the sweep.
bool swept_otherwise(const SweepWork& work, const knit::Timeline& now);

}  // namespace app
