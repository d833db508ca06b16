// The whole pipeline for each of many values of one parameter, or of two, on workers beside the window.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/session/changes.h"
#include "app/session/run_figures.h"
#include "knit/model/settings_table.h"

namespace app {

// `count` values from `from` to `to`, both in.
struct SweepAxis {
  std::string key;  // of the parameter table; a number
  double from = 0.0, to = 1.0;
  int count = 100;
  friend bool operator==(const SweepAxis&, const SweepAxis&) = default;
};
struct SweepPlan {
  SweepAxis axis;
  std::optional<SweepAxis> second;
  friend bool operator==(const SweepPlan&, const SweepPlan&) = default;
};
inline constexpr int least_sweep_values = 2, most_sweep_values = 10000;
inline constexpr std::size_t most_sweep_runs = 100000;  // of a grid

class SweepWork;

struct Sweep {
  SweepPlan plan;
  std::shared_ptr<SweepWork> work;
};

// "epsilon=0.02:0.09:200"; the error is one sentence.
std::variant<SweepAxis, std::string> parse_sweep_axis(const std::string& text);
// What is wrong with the plan whatever the mesh, in one sentence.
std::optional<std::string> fault_of(const SweepPlan& plan);
// Only these can be swept: a number or a count.
bool can_be_swept(const knit::ParameterInfo& info);
// A number as a person would type it, to so many significant digits: 0.03 rather than 0.030000000000000002.
double tidied(double value, int digits);
// Rising; of a count whole and each once. Requires an axis without fault.
std::vector<double> values_of(const SweepAxis& axis);

// What the runs start from: a run with all its knobs, and the parameters that a change now begins with.
struct SweepBase {
  std::shared_ptr<const knit::Input> input;
  Knobs knobs;
  knit::Parameters current;
};
SweepBase sweep_base_of(const knit::Timeline& timeline);
// The current parameters with a run's values set, one an axis: what tuning to them takes.
knit::Parameters with_values(const knit::Parameters& current, const SweepPlan& plan,
                             const std::vector<double>& values);
// The knobs of one run, as tuning now would make them; or why they are refused.
std::variant<Knobs, std::string> swept_knobs(const SweepBase& base, const SweepPlan& plan,
                                             const std::vector<double>& values);
// The first stage in which the plan's runs may differ.
knit::Stage first_reader_of(const SweepPlan& plan, const Knobs& knobs);

}  // namespace app
