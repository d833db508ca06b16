// What a sweep costs beside single runs of the same mesh.
#pragma once

#include <nlohmann/json.hpp>

#include "app/files/load.h"

namespace benchmark {

// 200 values of epsilon, half to one and a half times what it is, on all cores. `over_single`: its wall time
// in those of single recorded runs, taken in turn.
nlohmann::ordered_json measure_sweep(const app::Loaded& loaded);

}  // namespace benchmark
