#include "tests/benchmark/sweeps.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <vector>

#include "app/compare/sweep_work.h"
#include "knit/run/timeline.h"

namespace {

using Clock = std::chrono::steady_clock;

template <class Work>
double milliseconds_of(const Work& work) {
  const auto start = Clock::now();
  work();
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

}  // namespace

nlohmann::ordered_json benchmark::measure_sweep(const app::Loaded& loaded) {
  const double epsilon = loaded.parameters.epsilon();
  const app::SweepPlan plan{{"epsilon", 0.5 * epsilon, 1.5 * epsilon, 200}, std::nullopt};
  const knit::Timeline timeline(loaded.input, loaded.parameters);
  std::vector<double> single;
  std::vector<double> sweep;
  std::vector<double> ratio;
  for (int round = 0; round < 9; ++round) {
    std::vector<double> runs;
    for (int i = 0; i < 11; ++i) {
      runs.push_back(milliseconds_of([&] {
        knit::Timeline run(loaded.input, loaded.parameters);
        run.extend_to_end();
      }));
    }
    single.push_back(median(runs));
    sweep.push_back(milliseconds_of([&] {
      app::SweepWork work(app::sweep_base_of(timeline), plan);
      work.wait();
    }));
    ratio.push_back(sweep.back() / single.back());
  }
  return {{"values", plan.axis.count},
          {"threads", std::max(1U, std::thread::hardware_concurrency())},
          {"single_ms", median(single)},
          {"sweep_ms", median(sweep)},
          {"over_single", median(ratio)}};
}
