#include "tests/benchmark/cost.h"

#include <algorithm>
#include <ctime>

namespace benchmark {

namespace {

double clock_ms(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

std::vector<double> sorted(const std::vector<Cost>& costs, double Cost::*part) {
  std::vector<double> values;
  values.reserve(costs.size());
  for (const Cost& cost : costs) values.push_back(cost.*part);
  std::sort(values.begin(), values.end());
  return values;
}

}  // namespace

Cost cost_of(const std::function<void()>& work) {
  const double thread = clock_ms(CLOCK_THREAD_CPUTIME_ID);
  const double all = clock_ms(CLOCK_PROCESS_CPUTIME_ID);
  const double wall = clock_ms(CLOCK_MONOTONIC);
  work();
  return {clock_ms(CLOCK_THREAD_CPUTIME_ID) - thread, clock_ms(CLOCK_PROCESS_CPUTIME_ID) - all,
          clock_ms(CLOCK_MONOTONIC) - wall};
}

nlohmann::ordered_json summary_of(const std::vector<Cost>& costs, double Cost::*part) {
  const std::vector<double> values = sorted(costs, part);
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * double(values.size() - 1))];
  };
  return {{"median", at(0.5)}, {"p99", at(0.99)}, {"max", values.back()}};
}

nlohmann::ordered_json sums_of(const std::vector<std::vector<Cost>>& parts, double Cost::*part) {
  std::vector<Cost> sums(parts.front().size());
  for (const auto& costs : parts) {
    for (std::size_t i = 0; i < costs.size(); ++i) sums[i].*part += costs[i].*part;
  }
  return summary_of(sums, part);
}

double median_of(const std::vector<Cost>& costs, double Cost::*part) {
  const std::vector<double> values = sorted(costs, part);
  return values[values.size() / 2];
}

app::FrameShape shape_of(int width, int height) {
  app::FrameShape shape;
  shape.width = static_cast<float>(width);
  shape.height = static_cast<float>(height);
  shape.width_px = width;
  shape.height_px = height;
  shape.samples = 1;  // as the window does while things move on a slow machine
  return shape;
}

}  // namespace benchmark
