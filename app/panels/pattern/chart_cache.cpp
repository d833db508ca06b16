#include "app/panels/pattern/chart_cache.h"

#include "knit/limbs/limb_plan.h"
#include "knit/model/hash.h"

namespace app {

namespace {

std::uint64_t key_of(const knit::State& state, const knit::Gauge& gauge,
                     const knit::PatternOptions& options) {
  knit::Hasher hasher;
  hasher.add(state.fabric.empty() ? 0 : state.fabric.rows().front().content_hash());
  for (const auto& join : state.fabric.joins()) hasher.add(join.content_hash());
  hasher.add(state.fabric.rows().size());
  for (const auto& deal : state.fabric.deals()) hasher.add(deal.content_hash());
  for (const std::string* words : {&options.title, &options.yarn, &options.colour})
    knit::hash_into(hasher, std::string_view(*words));
  for (const double number : {options.needle_mm.value_or(0.0), gauge.stitches, gauge.rounds})
    knit::hash_into(hasher, number);
  for (const auto& [letters, word] : options.piece_names) {
    knit::hash_into(hasher, std::string_view(letters));
    knit::hash_into(hasher, std::string_view(word));
  }
  hasher.add((options.markers ? 1U : 0U) + (options.stars ? 2U : 0U));
  return hasher.value();
}

}  // namespace

void ChartCache::refresh(const knit::Timeline& timeline, const knit::PatternOptions& options) {
  const knit::State& state = timeline.furthest();
  const knit::Gauge& gauge = timeline.parameters().stitch.gauge;  // as for a file
  const std::uint64_t key = key_of(state, gauge, options);
  if (key == key_) return;
  key_ = key;
  chart_ = {};
  pattern_ = {};
  in_pieces_ = knit::has_limbs(state);
  if (in_pieces_ && knit::limbs_are_known(state))
    pattern_ = knit::write_pattern(knit::plan_limbs(state), gauge, options, timeline.input().mesh.name);
  if (in_pieces_ || state.fabric.joins().empty()) return;
  const knit::Rounds rounds = knit::rounds_of(state);
  chart_ = knit::chart_of(rounds);
  pattern_ = knit::write_pattern(rounds, gauge, options, timeline.input().mesh.name);
}

std::string ChartCache::line_of(std::int32_t round) const {
  if (round == 1) return pattern_.start;
  for (const auto& instruction : pattern_.instructions) {
    if (instruction.round && instruction.round->first <= round && round <= instruction.round->last)
      return instruction.round->text();
  }
  return "";
}

}  // namespace app
