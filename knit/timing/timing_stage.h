// Stage 1, timing, one smallest step at a time.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <tuple>
#include <vector>

#include "knit/mesh/mesh.h"
#include "knit/model/event.h"
#include "knit/model/growing.h"
#include "knit/model/heard.h"
#include "knit/model/products.h"
#include "knit/timing/fields.h"
#include "knit/timing/timing_events.h"

namespace knit {

struct TimingWork {
  std::optional<Ends> ends;
  TimingKind kind = TimingKind::linear;  // once the ends are found; by_itself until it is chosen
  // Of the timings that are solved for on the surface, each once it is there.
  Shared<IntrinsicMesh> net;
  Shared<std::vector<double>> heat;
  Shared<EdgeSlopes> slopes;
  Shared<std::vector<double>> field;  // what the times are read from, in [0, 1] at the referenced vertices
  Shared<HeightScale> scale;
  Growing<double> times;
  std::int32_t outside = 0;
  Shared<Criticals> criticals;
  // Roughly, beside its own size.
  [[nodiscard]] std::size_t copy_bytes() const { return times.copy_bytes(); }
  [[nodiscard]] auto fields() const {
    return std::tie(ends, kind, net, heat, slopes, field, scale, times, outside, criticals);
  }
  friend bool operator==(const TimingWork&, const TimingWork&) = default;
};

// `timing`: the product, once the stage has ended.
Advanced<TimingEvent> advance_timing(const Input& input, const TimingSettings& settings, TimingWork& work,
                                     Shared<Timing>& timing, const Heard& heard = {});

// Whether the step to come solves something over the whole surface.
bool next_is_a_solve(const Input& input, const TimingSettings& settings, const TimingWork& work);
// What it is about, for a person who waits: "solving for the distance".
std::string_view work_ahead(const TimingWork& work);

}  // namespace knit
