#include "app/panels/report/card_cache.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "knit/model/hash.h"

namespace app {

CardCache::Key CardCache::key_of(const knit::Timeline& timeline) {
  const knit::State& state = timeline.state();
  knit::Hasher products;
  products.add(state.timing.content_hash());
  const auto add = [&](const auto& list) {
    products.add(list.size());
    for (const auto& product : list) products.add(product.content_hash());
  };
  add(state.fabric.rows());
  add(state.fabric.deals());
  add(state.fabric.joins());
  add(state.fabric.strips());
  const knit::Parameters& parameters = timeline.parameters();
  return {timeline.input_pointer(),        parameters.stitch.width,      parameters.stitch.height,
          static_cast<bool>(state.placed), state.relaxed.content_hash(), products.value()};
}

void CardCache::refresh(const knit::Timeline& timeline) {
  owed_ms_ = std::max(0.0, owed_ms_ - budget_ms_);
  Key key = key_of(timeline);
  const bool rests = key == seen_;
  seen_ = key;
  if (timeline.state().fabric.empty()) {
    quality_.reset();
    return;
  }
  const bool other_mesh = key.input != measured_.input;
  if (quality_ && (key == measured_ || (!rests && !other_mesh && owed_ms_ > 0.0))) return;
  measured_ = std::move(key);
  measure(timeline);
}

void CardCache::measure(const knit::Timeline& timeline) {
  const auto start = std::chrono::steady_clock::now();
  both_ = settled_figures(timeline);
  quality_ =
      both_ ? both_->settled
            : knit::measure_quality(timeline.input(), timeline.state(), measured_.width, measured_.height);
  relaxed_.reset();
  if (const knit::State& state = timeline.state(); state.relaxed) {
    knit::State in_the_air = state;
    in_the_air.fabric = state.fabric.moved_to(state.relaxed->relaxed.positions);
    relaxed_ = knit::measure_quality(timeline.input(), in_the_air, measured_.width, measured_.height);
  }
  owed_ms_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  ++times_measured_;
}

}  // namespace app
