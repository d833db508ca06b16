#include "knit/insight/why_tubes.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "knit/insight/why.h"
#include "knit/tubes/low_limbs.h"

namespace knit {

namespace {

// Copies of a vertex at one place are one.
class SameVertex {
 public:
  SameVertex(const Input& input, VertexId vertex) : twin_(input.twin), meant_(input.twin[vertex]) {}
  [[nodiscard]] bool operator()(VertexId other) const {
    return other < twin_.size() && twin_[other] == meant_;
  }

 private:
  const std::vector<VertexId>& twin_;
  VertexId meant_;
};

StepRange steps_of_tubes(const Timeline& timeline) {
  constexpr std::int32_t least = std::numeric_limits<std::int32_t>::min();
  constexpr std::int32_t most = std::numeric_limits<std::int32_t>::max();
  return {timeline.position_of({Stage::tubes, least, least}),
          timeline.position_of({Stage::tubes, most, most})};
}

// What a limb or hole is told by: its own step, or the one that tells of all low limbs.
bool tells_of(const TubeLeftOut& step, const TubePlan& plan, const LeftOut& left) {
  if (is_low(plan, left)) return step.together > 0;
  return step.together == 0 && step.vertex == left.from && step.handle == left.handle;
}

void follow_plan(const Timeline& timeline, const SameVertex& is_here, CriticalStory& story) {
  const TubePlan& plan = *timeline.furthest().tubes;
  for (std::size_t i = 0; i < plan.events.size(); ++i) {
    if (is_here(plan.events[i].vertex)) story.events.push_back(static_cast<std::int32_t>(i));
  }
  for (std::size_t i = 0; i < plan.left_out.size(); ++i) {
    const LeftOut& left = plan.left_out[i];
    if (is_here(left.from) || is_here(left.to)) story.left_out.push_back(static_cast<std::int32_t>(i));
  }
  const StepRange steps = steps_of_tubes(timeline);
  for (std::size_t i = steps.begin; i < steps.end; ++i) {
    const auto* told = get_if<TubeLeftOut>(timeline.step(i));
    if (told == nullptr) continue;
    const bool here = std::any_of(story.left_out.begin(), story.left_out.end(), [&](std::int32_t left) {
      return tells_of(*told, plan, plan.left_out[static_cast<std::size_t>(left)]);
    });
    if (here) story.leaving_out.push_back(i);
  }
}

void follow_deals(const Timeline& timeline, CriticalStory& story) {
  const auto& deals = timeline.furthest().fabric.deals();
  for (std::size_t d = 0; d < deals.size(); ++d) {
    if (std::find(story.events.begin(), story.events.end(), deals[d]->event) == story.events.end()) continue;
    const auto number = static_cast<std::int32_t>(d) + 1;
    story.deals.push_back(number);
    const StepRange steps = steps_of_deal(timeline, number);
    for (std::size_t i = steps.begin; i < steps.end; ++i) {
      if (is<GapsFound>(timeline.step(i)) || is<LoopsDealt>(timeline.step(i))) story.dealt.push_back(i);
    }
  }
}

}  // namespace

std::optional<std::size_t> CriticalStory::decided() const {
  for (const auto* steps : {&dealt, &leaving_out, &found}) {
    if (!steps->empty()) return steps->front();
  }
  return std::nullopt;
}

std::optional<CriticalStory> critical_story(const Timeline& timeline, VertexId vertex) {
  const SameVertex is_here(timeline.input(), vertex);
  CriticalStory story;
  const StepRange steps = steps_of_tubes(timeline);
  for (std::size_t i = steps.begin; i < steps.end; ++i) {
    const auto* node = get_if<NodeFound>(timeline.step(i));
    if (node != nullptr && is_here(node->vertex)) story.found.push_back(i);
  }
  if (story.found.empty()) return std::nullopt;
  if (timeline.furthest().tubes) follow_plan(timeline, is_here, story);
  follow_deals(timeline, story);
  return story;
}

bool closes_handle(const TubePlan& plan, std::int32_t event) {
  // Of each tube the lowest that it hangs together with: events stand by rank, so those before lie below.
  std::vector<TubeId> together(plan.tubes.size());
  std::iota(together.begin(), together.end(), 0);
  const auto of = [&](TubeId tube) { return together[static_cast<std::size_t>(tube)]; };
  for (std::int32_t i = 0; i < event; ++i) {
    const TubeEvent& before = plan.event(i);
    std::vector<TubeId> all = before.below;
    all.insert(all.end(), before.above.begin(), before.above.end());
    for (const TubeId tube : all) {
      const auto [low, high] = std::minmax({of(all.front()), of(tube)});
      std::replace(together.begin(), together.end(), high, low);
    }
  }
  const std::vector<TubeId>& below = plan.event(event).below;
  return below.size() == 2 && of(below[0]) == of(below[1]);
}

}  // namespace knit
