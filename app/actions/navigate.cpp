#include "app/actions/navigate.h"

#include "app/session/document.h"

#include <algorithm>
#include <limits>
#include "knit/model/words.h"

namespace app {

std::optional<std::string> go_to(Session& session, const At& at) {
  knit::Timeline& timeline = session.document->timeline;
  if (std::holds_alternative<AtEnd>(at)) {
    apply(session, ToLast{});
    return std::nullopt;
  }
  if (const auto* steps = std::get_if<std::size_t>(&at)) {
    apply(session, SeekTo{*steps});
    if (timeline.position() == *steps) return std::nullopt;
    return "the run has only " + knit::plural(static_cast<std::int64_t>(timeline.known()), "step", "steps") +
           "; showing the last.";
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
  return "the run has no place " + text_of(place) + "; showing the nearest before it, " +
         text_of(timeline.place()) + ".";
}

namespace {

constexpr std::size_t slice = 4096;

// The first place after everything that belongs with `place`.
knit::Place after(const knit::Place& place, Unit unit) {
  if (unit == Unit::row) return {place.stage, place.row + 1, 0};
  return {static_cast<knit::Stage>(static_cast<int>(place.stage) + 1), 0, 0};
}

// How many known steps stand before `place`.
std::size_t count_before(const knit::Timeline& timeline, const knit::Place& place) {
  const auto& steps = timeline.steps();
  const auto at =
      std::lower_bound(steps.begin(), steps.end(), place,
                       [](const knit::Step& step, const knit::Place& p) { return step.place < p; });
  return static_cast<std::size_t>(at - steps.begin());
}

bool known_beyond(const knit::Timeline& timeline, const knit::Place& place) {
  return timeline.known() > 0 && timeline.step(timeline.known() - 1).place >= place;
}

std::size_t forward(knit::Timeline& timeline, Unit unit) {
  if (timeline.position() == timeline.known() && !timeline.extend(1) &&
      timeline.position() == timeline.known()) {
    return timeline.position();
  }
  const knit::Place beyond = after(timeline.step(timeline.position()).place, unit);
  while (!known_beyond(timeline, beyond) && timeline.extend(slice)) {
  }
  return count_before(timeline, beyond);
}

std::size_t backward(const knit::Timeline& timeline, Unit unit) {
  if (timeline.position() == 0) return 0;
  const knit::Place here = timeline.place();
  return count_before(timeline, {here.stage, unit == Unit::row ? here.row : 0, 0});
}

}  // namespace

std::size_t position_after(knit::Timeline& timeline, Unit unit, int direction) {
  if (unit == Unit::item) {
    if (direction < 0) return timeline.position() - std::min<std::size_t>(timeline.position(), 1);
    if (timeline.position() == timeline.known()) timeline.extend(1);
    return std::min(timeline.position() + 1, timeline.known());
  }
  return direction < 0 ? backward(timeline, unit) : forward(timeline, unit);
}

std::size_t position_at(knit::Timeline& timeline, const knit::Place& place) {
  while (!known_beyond(timeline, place) && timeline.extend(slice)) {
  }
  return timeline.position_of(place);
}

std::optional<knit::Place> place_ahead(const knit::Timeline& timeline, Unit unit) {
  if (timeline.position() < timeline.known() && unit == Unit::item) return std::nullopt;
  const knit::Place next = timeline.state().next;
  if (unit == Unit::item) return next;
  knit::Place last = after(next, unit);
  --last.item;  // the last place before it
  return last;
}

std::optional<Unit> unit_of_depth(const knit::Timeline& timeline, Depth depth) {
  if (depth == Depth::into) return Unit::item;
  const knit::Place last = timeline.place();
  const knit::Place next = timeline.state().next;
  const bool between_stages = timeline.position() == 0 || last.stage != next.stage;
  const bool between_rows = between_stages || last.row != next.row;
  if (depth == Depth::over) return between_stages ? Unit::stage : between_rows ? Unit::row : Unit::item;
  if (between_stages) return std::nullopt;
  return between_rows ? Unit::stage : Unit::row;
}

std::optional<Stretch> stretch_of(const knit::Timeline& timeline, const PlaceStretch& places) {
  const Stretch stretch{count_before(timeline, places.first), timeline.position_of(places.last)};
  return stretch.begin < stretch.end ? std::optional(stretch) : std::nullopt;
}

std::optional<Stretch> stretch_of_row(const Session& session) {
  if (!session.document || session.document->timeline.position() == 0) return std::nullopt;
  const knit::Timeline& timeline = session.document->timeline;
  const knit::Place here = timeline.place();
  return Stretch{count_before(timeline, {here.stage, here.row, 0}),
                 count_before(timeline, after(here, Unit::row))};
}

namespace {

template <class... Kinds>
bool is_one_of(const Action& action) {
  return (action.is<Kinds>() || ...);
}

bool is_move(const Action& action) {
  return is_one_of<OpenExample, OpenFile, CloseMesh, OpenSession, StepBy, SeekTo, SeekPlace, ToFirst, ToLast,
                   SetPlaying, EditFromHere, ShowWhy, ToTouch, GoTo, GoBack, GoForward, StepDeep, RunToBreak,
                   StartLesson, LeaveLesson, TurnLesson, Guess, RepairAndOpen, UndoRepair>(action);
}

// "row 14 of the stage faces", "the stage timing"
std::string words_of_row(const knit::Place& place, bool with_stage) {
  std::string stage = "the stage " + std::string(knit::name_of(place.stage));
  if (place.row == 0) return stage;
  return "row " + std::to_string(place.row) + (with_stage ? " of " + stage : "");
}

// A run is asked for the end of a row, or for what comes before a place, with items that no step has.
bool is_of_a_step(const knit::Place& place) {
  return place.stage != knit::Stage::done && place.row >= 0 && place.item >= 0 &&
         place.item != std::numeric_limits<std::int32_t>::max();
}

void settle(Session& session) {
  auto& kept = session.document->travel.kept;
  const knit::Timeline& timeline = session.document->timeline;
  if (!kept || timeline.sought()) return;
  if (kept->shown == timeline.place()) return;
  kept->shown = timeline.place();
  session.document->place_note = place_note(kept->wanted, *kept->shown, timeline.state().next);
}

}  // namespace

std::string place_note(const knit::Place& wanted, const knit::Place& shown, const knit::Place& next) {
  if (wanted == shown || !is_of_a_step(wanted)) return {};
  const bool other_stage = wanted.stage != shown.stage;
  std::string text = words_of_row(wanted, other_stage) + ", item " + std::to_string(wanted.item + 1) +
                     ", is not in this run; showing " + words_of_row(shown, other_stage) + ", ";
  text.front() = wanted.row == 0 ? 'T' : 'R';
  const bool last = next.stage != shown.stage || next.row != shown.row;
  return text + (last ? "its last step." : "item " + std::to_string(shown.item + 1) + ".");
}

void forget_place(Session& session) {
  if (!session.document) return;
  session.document->travel.kept.reset();
  session.document->travel.running_to = 0;
  session.document->place_note.clear();
}

Whereabouts before_action(Session& session, const Action& action) {
  if (is_move(action)) {
    forget_place(session);
    return {{}, {}, true};
  }
  if (!session.document) return {};
  const knit::Timeline& timeline = session.document->timeline;
  Whereabouts before{run_key(timeline), timeline.sought(), false};
  if (!before.place && timeline.position() > 0) before.place = timeline.place();
  return before;
}

void after_action(Session& session, const Whereabouts& before) {
  if (before.moved || !session.document) return;
  knit::Timeline& timeline = session.document->timeline;
  auto& kept = session.document->travel.kept;
  if (before.run && before.place && run_key(timeline) != *before.run) {
    // What was shown instead of a place is not what was wanted.
    const bool still = kept && (!kept->shown || kept->shown == before.place);
    if (!still) kept = KeptPlace{*before.place, {}};
    kept->shown.reset();
    session.document->place_note.clear();
    const bool under_way = timeline.sought() == kept->wanted;
    if (!under_way && (timeline.position() == 0 || timeline.place() != kept->wanted))
      timeline.await(kept->wanted);
  }
  settle(session);
}

}  // namespace app
