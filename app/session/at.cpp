#include "app/session/at.h"

#include "app/base/text.h"
#include "app/session/action.h"
#include "app/session/document.h"

namespace app {

namespace {

std::string place_text(const knit::Place& place) {
  return std::string(knit::name_of(place.stage)) + ":" + std::to_string(place.row) + ":" +
         std::to_string(place.item);
}

}  // namespace

std::optional<At> parse_at(const std::string& text) {
  if (text == "end") return AtEnd{};
  if (const auto steps = whole_number<std::size_t>(text)) return At(*steps);
  const auto parts = split(text, ':');
  const auto stage = knit::stage_named(parts[0]);
  if (!stage || parts.size() > 3) return std::nullopt;
  if (parts.size() == 1) return AtStage{*stage};
  knit::Place place{*stage, 0, 0};
  const auto row = whole_number<std::int32_t>(parts[1]);
  const auto item = parts.size() == 3 ? whole_number<std::int32_t>(parts[2]) : std::optional<std::int32_t>(0);
  if (!row || !item || *row < 0 || *item < 0) return std::nullopt;
  place.row = *row;
  place.item = *item;
  return place;
}

std::optional<std::string> go_to(Session& session, const At& at) {
  knit::Timeline& timeline = session.document->timeline;
  if (std::holds_alternative<AtEnd>(at)) {
    apply(session, ToLast{});
    return std::nullopt;
  }
  if (const auto* steps = std::get_if<std::size_t>(&at)) {
    apply(session, SeekTo{*steps});
    if (timeline.position() == *steps) return std::nullopt;
    return "the run has only " + std::to_string(timeline.known()) + " steps; showing the last.";
  }
  if (const auto* stage = std::get_if<AtStage>(&at)) {
    // A stage's first row differs: 0, 1 or 2. Its first step is the one after all that stands before it.
    apply(session, SeekPlace{{stage->stage, -1, 0}});
    apply(session, StepBy{Unit::item, 1});
    if (timeline.place().stage == stage->stage) return std::nullopt;
    return "the run does not reach the stage " + std::string(knit::name_of(stage->stage)) +
           "; showing the last step.";
  }
  const auto& place = std::get<knit::Place>(at);
  apply(session, SeekPlace{place});
  if (timeline.place() == place) return std::nullopt;
  return "the run has no place " + place_text(place) + "; showing the nearest before it, " +
         place_text(timeline.place()) + ".";
}

}  // namespace app
