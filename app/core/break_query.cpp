#include "app/core/queries.h"

namespace app {

std::optional<std::string> fault_of_break(const std::string& condition) {
  const auto parsed = knit::parse_break(condition);
  const auto* error = std::get_if<std::string>(&parsed);
  return error != nullptr ? std::optional(*error) : std::nullopt;
}

std::vector<knit::BreakCondition> breaks_of(const std::vector<std::string>& texts) {
  std::vector<knit::BreakCondition> conditions;
  for (const std::string& text : texts) {
    const auto parsed = knit::parse_break(text);
    if (const auto* condition = std::get_if<knit::BreakCondition>(&parsed)) conditions.push_back(*condition);
  }
  return conditions;
}

Answer break_answer(Session& session) {
  const knit::Timeline& timeline = *session.timeline;
  const Travel& travel = session.travel;
  const std::size_t here = timeline.position();
  apply(session, PassTime{0.0});  // hits are known as far as the run is
  if (travel.hits.condition_at(here) == nullptr) apply(session, RunToBreak{1});
  const knit::BreakCondition* condition = travel.hits.condition_at(timeline.position());
  if (condition != nullptr)
    return {exit_done, "", "break " + knit::text_of(*condition) + ": " + sentence(session)};
  apply(session, ToLast{});
  return {exit_no_break, "", "no break condition holds from there to the end of the run; showing the end."};
}

}  // namespace app
