#include "app/core/index_command.h"

#include "app/core/words.h"
#include "knit/pattern.h"
#include "knit/stitch_index.h"

namespace app {

namespace {

Answer bad_usage(const std::string& sentence) { return {exit_usage, "", sentence}; }

}  // namespace

Answer index_answer(const std::string& sizes_text, const std::string& placement) {
  std::vector<std::int32_t> sizes;
  for (const std::string_view part : split(sizes_text, ',')) {
    const auto size = whole_number<std::int32_t>(part);
    if (!size || *size < 1 || *size > 100000) {
      return bad_usage("index: \"" + std::string(part) +
                       "\" is not a row size; give whole numbers from 1 to 100000, like 6,12,17.");
    }
    sizes.push_back(*size);
  }
  if (placement == "nearest") {
    return bad_usage(
        "index: --placement nearest needs to know where stitches stand, and a list of sizes does not say; "
        "give "
        "thesis or even.");
  }
  if (placement != "thesis" && placement != "even") {
    return bad_usage("index: --placement cannot be \"" + placement + "\"; give thesis or even.");
  }
  for (std::size_t i = 1; i < sizes.size(); ++i) {
    if (sizes[i] <= 2 * sizes[i - 1] && 2 * sizes[i] >= sizes[i - 1]) continue;
    return bad_usage("index: row " + std::to_string(i + 1) + " cannot have " + std::to_string(sizes[i]) +
                     " stitches after " + std::to_string(sizes[i - 1]) +
                     "; a row may at most double or halve.");
  }
  const auto policy = placement == "even" ? knit::PlacementPolicy::even : knit::PlacementPolicy::thesis;
  const std::vector<knit::Transition> transitions = knit::plan_transitions(sizes, policy);
  std::vector<const knit::Transition*> view;
  view.reserve(transitions.size());
  for (const knit::Transition& transition : transitions) view.push_back(&transition);
  std::string text;
  for (const knit::LabelRow& row : knit::appendix_view(sizes.front(), view))
    text += knit::text_of(row) + "\n";
  return {exit_done, text, ""};
}

}  // namespace app
