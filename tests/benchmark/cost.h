// What a piece of work costs: this thread's processor time, all threads' (a software rasteriser's too), the wall's.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <vector>

#include "app/window/frame.h"

namespace benchmark {

struct Cost {
  double thread_ms = 0.0, all_ms = 0.0, wall_ms = 0.0;
};

Cost cost_of(const std::function<void()>& work);

// Median, 99th percentile and maximum of one part.
nlohmann::ordered_json summary_of(const std::vector<Cost>& costs, double Cost::*part);
// The same of what several pieces of work come to together, measured as often.
nlohmann::ordered_json sums_of(const std::vector<std::vector<Cost>>& parts, double Cost::*part);
double median_of(const std::vector<Cost>& costs, double Cost::*part);

// A frame of a plain screen, one sample a pixel: as the window draws it on a slow machine while things move.
app::FrameShape shape_of(int width, int height);

}  // namespace benchmark
