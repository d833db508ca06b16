#include "app/panels/kit/run_cache.h"

#include <algorithm>
#include <limits>

namespace app {

namespace {

std::size_t index_of(knit::Label label) { return static_cast<std::size_t>(label); }

LabelTally::Counts counts_of(const knit::Join& join, std::size_t placed) {
  LabelTally::Counts counts{};
  for (std::size_t i = 0; i < placed; ++i) ++counts[index_of(join.placed[i].label)];
  return counts;
}

}  // namespace

void RunCache::refresh(const knit::Timeline& timeline) {
  Key key{timeline.input_pointer(), timeline.base_parameters(), timeline.edits()};
  if (key != key_ || timeline.known() < std::max(known_, scanned_)) {
    *this = RunCache();
    key_ = std::move(key);
  }
  if (timeline.known() != known_) find_rows(timeline);
  find_edits(timeline);
  find_problems(timeline);
}

void RunCache::find_rows(const knit::Timeline& timeline) {
  known_ = timeline.known();
  std::size_t start = row_starts_.empty() ? 0 : row_starts_.back();
  if (row_starts_.empty()) {
    row_starts_.push_back(0);
    stages_.push_back({timeline.step(0).place.stage, 0, known_});
  }
  while (true) {
    knit::Place place = timeline.step(start).place;
    place.item = std::numeric_limits<std::int32_t>::max();
    start = timeline.position_of(place);
    if (start >= known_) break;
    row_starts_.push_back(start);
    const knit::Stage stage = timeline.step(start).place.stage;
    if (stage != stages_.back().stage) {
      stages_.back().end = start;
      stages_.push_back({stage, start, known_});
    }
  }
  stages_.back().end = known_;
}

void RunCache::find_edits(const knit::Timeline& timeline) {
  edits_.clear();
  for (const knit::Edit& edit : timeline.edits()) {
    std::size_t at = timeline.position_of(edit.at);
    if (at > 0 && timeline.step(at - 1).place == edit.at) --at;
    edits_.push_back(at);
  }
}

void RunCache::find_problems(const knit::Timeline& timeline) {
  for (; scanned_ < timeline.known(); ++scanned_) {
    const auto problem =
        knit::problem_of(timeline.step(scanned_), scanned_, timeline.parameters_of_step(scanned_));
    if (!problem) continue;
    problems_.push_back(scanned_);
    ranked_.take(*problem);
    counts_.take(timeline.step(scanned_), timeline.parameters_of_step(scanned_));
  }
  if (timeline.complete()) ranked_.finish();
}

knit::ProblemCounts RunCache::problem_counts(const knit::Timeline& timeline) const {
  knit::ProblemCounts counts = counts_;
  if (const knit::Step* stop = timeline.stop()) counts.take(*stop, timeline.parameters_of_stop());
  return counts;
}

LabelTally::Counts LabelTally::count(const knit::State& state) {
  const auto& made = state.fabric.joins();
  joins_.resize(made.size());
  Counts sum{};
  const auto add = [&](const Counts& counts) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += counts[i];
  };
  for (std::size_t i = 0; i < joins_.size(); ++i) {
    const auto join = made[i].pointer();
    if (joins_[i].first != join) {
      Counts counts = counts_of(*join, join->placed.size());
      const auto knit_cells = std::count(join->labels.begin(), join->labels.end(), knit::Label::knit);
      counts[index_of(knit::Label::knit)] = static_cast<std::size_t>(knit_cells);
      joins_[i] = {join, counts};
    }
    add(joins_[i].second);
  }
  if (const auto* work = std::get_if<knit::IndexWork>(&state.work); work != nullptr && work->plan) {
    add(counts_of(*work->plan, static_cast<std::size_t>(work->placed)));
  }
  std::size_t& cast = sum[index_of(knit::Label::cast)];
  for (const auto& row : state.fabric.rows()) cast += row->on.empty() ? row->stitches.size() : 0U;
  for (const auto& deal : state.fabric.deals()) cast += deal->bridge.size();
  if (const auto* work = std::get_if<knit::CastOnWork>(&state.work)) cast += work->stitches.size();
  if (const auto* work = std::get_if<knit::ContourWork>(&state.work); work != nullptr && state.fabric.empty())
    cast += work->stitches.size();
  if (state.stage() > knit::Stage::stitches && state.fabric.row_count() > 1)
    cast += static_cast<std::size_t>(state.fabric.live().size());
  return sum;
}

}  // namespace app
