#include "knit/insight/narrate.h"

#include <type_traits>

#include "knit/rows/stop_words.h"

namespace knit {

namespace {

struct Sentence {
  Telling at;

  std::string operator()(const Stopped& stop) const {
    if (stop.reason == StopReason::no_extent || stop.reason == StopReason::open_edge)
      return timing_stop_sentence(stop);
    return at.place.stage == Stage::tubes ? tubes_stop_sentence(stop) : rows_stop_sentence(stop, at);
  }
  std::string operator()(const auto& event) const { return event.sentence(at); }
};

}  // namespace

std::string narrate(const Step& step, const Parameters& parameters) {
  return visit_event(Sentence{{step.place, parameters}}, step.what);
}

std::string_view work_ahead(const State& state) {
  if (const auto* tubes = std::get_if<TubesWork>(&state.work)) return work_ahead(*tubes);
  if (std::holds_alternative<SettleWork>(state.work)) return "settling the stitches";
  if (std::holds_alternative<RelaxWork>(state.work)) return "relaxing the piece";
  const auto* timing = std::get_if<TimingWork>(&state.work);
  return timing != nullptr ? work_ahead(*timing) : "working";
}

std::string_view kind_name(const Step& step) {
  return visit_event([](const auto& event) { return std::remove_cvref_t<decltype(event)>::kind; }, step.what);
}

}  // namespace knit
