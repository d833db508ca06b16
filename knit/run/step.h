// What one smallest step did, as plain data: where it stands and the numbers that decided.
//
// Each stage's events stand in its room; here they become one type of two levels. Sentences, highlighted
// pseudo-code, the candidate table and the list of problems are functions of steps; nothing is said twice. A
// step is at most 64 bytes, so that a run can be recorded whole.
#pragma once

#include <cstddef>
#include <type_traits>
#include <variant>

#include "knit/model/stage.h"
#include "knit/model/stopped.h"
#include "knit/relax/relax_events.h"
#include "knit/rows/cast_on_events.h"
#include "knit/rows/choice.h"
#include "knit/rows/contour_events.h"
#include "knit/rows/ring_events.h"
#include "knit/settle/settle_events.h"
#include "knit/short_rows/short_row_events.h"
#include "knit/stitches/faces_events.h"
#include "knit/stitches/index_events.h"
#include "knit/stitches/pattern_events.h"
#include "knit/timing/timing_events.h"
#include "knit/tubes/tubes_events.h"

namespace knit {

using Event =
    std::variant<TimingEvent, ChoiceEvent, TubesEvent, CastOnEvent, RingEvent, ContourEvent, ShortRowEvent,
                 IndexEvent, FacesEvent, SettleEvent, RelaxEvent, PatternEvent, Stopped>;

struct Step {
  Place place;
  Event what;
  friend bool operator==(const Step&, const Step&) = default;
};
static_assert(sizeof(void*) < 8 || sizeof(Step) <= 64);  // a library of 32 bits may lay it out otherwise

// --- A kind of event, wherever it stands ---------------------------------------------------------------------

namespace event_parts {

template <class What, class StageEvent>
inline constexpr bool has = false;
template <class What, class... Kinds>
inline constexpr bool has<What, std::variant<Kinds...>> = (std::is_same_v<What, Kinds> || ...);

template <class What, class... Stages>
const What* find(const std::variant<Stages...>& event) {
  static_assert(((has<What, Stages> || std::is_same_v<What, Stages>) || ...), "no stage has this event");
  return std::visit(
      [](const auto& stage) -> const What* {
        using StageEvent = std::remove_cvref_t<decltype(stage)>;
        if constexpr (std::is_same_v<What, StageEvent>) return &stage;
        if constexpr (has<What, StageEvent>) return std::get_if<What>(&stage);
        return nullptr;
      },
      event);
}

template <class StageEvent>
inline constexpr std::size_t count = 1;
template <class... Parts>
inline constexpr std::size_t count<std::variant<Parts...>> = (count<Parts> + ...);

}  // namespace event_parts

// Null when something else happened.
template <class What>
const What* get_if(const Event& event) {
  return event_parts::find<What>(event);
}
template <class What>
const What* get_if(const Step& step) {
  return get_if<What>(step.what);
}
template <class What>
bool is(const Event& event) {
  return get_if<What>(event) != nullptr;
}
template <class What>
bool is(const Step& step) {
  return is<What>(step.what);
}
inline bool is_stop(const Step& step) { return is<Stopped>(step); }

// How many kinds of event there are.
inline constexpr std::size_t event_count = event_parts::count<Event>;

// Calls `see` with what happened, a kind of event.
template <class See>
decltype(auto) visit_event(See&& see, const Event& event) {
  return std::visit(
      [&](const auto& stage) -> decltype(auto) {
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(stage)>, Stopped>) {
          return see(stage);
        } else {
          return std::visit(see, stage);
        }
      },
      event);
}

inline AnyEvent any_event(const Step& step) {
  return visit_event(
      [&](const auto& event) {
        return AnyEvent{step.place, std::remove_cvref_t<decltype(event)>::kind, &event};
      },
      step.what);
}

}  // namespace knit
