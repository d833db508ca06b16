#include "app/core/keep_place.h"

#include <limits>

namespace app {

namespace {

template <class... Kinds>
bool is_one_of(const Action& action) {
  return (action.is<Kinds>() || ...);
}

bool is_move(const Action& action) {
  return is_one_of<OpenExample, OpenFile, CloseMesh, OpenSession, StepBy, SeekTo, SeekPlace, ToFirst, ToLast,
                   SetPlaying, EditFromHere, ShowWhy, ToTouch, GoBack, GoForward, StepDeep, RunToBreak,
                   StartLesson, LeaveLesson, TurnLesson, Guess, MendAndOpen, UndoMend>(action);
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
  auto& kept = session.travel.kept;
  const knit::Timeline& timeline = *session.timeline;
  if (!kept || timeline.sought()) return;
  if (kept->shown == timeline.place()) return;
  kept->shown = timeline.place();
  session.place_note = place_note(kept->wanted, *kept->shown, timeline.state().next);
}

}  // namespace

std::string place_note(const knit::Place& wanted, const knit::Place& shown, const knit::Place& next) {
  if (wanted == shown || !is_of_a_step(wanted)) return {};
  const bool other_stage = wanted.stage != shown.stage;
  std::string text = words_of_row(wanted, other_stage) + ", item " + std::to_string(wanted.item) +
                     ", is not in this run; showing " + words_of_row(shown, other_stage) + ", ";
  text.front() = wanted.row == 0 ? 'T' : 'R';
  const bool last = next.stage != shown.stage || next.row != shown.row;
  return text + (last ? "its last step." : "item " + std::to_string(shown.item) + ".");
}

void forget_place(Session& session) {
  session.travel.kept.reset();
  session.travel.running_to = 0;
  session.place_note.clear();
}

Whereabouts before_action(Session& session, const Action& action) {
  if (is_move(action)) {
    forget_place(session);
    return {{}, {}, true};
  }
  if (!session.timeline) return {};
  const knit::Timeline& timeline = *session.timeline;
  Whereabouts before{run_key(timeline), timeline.sought(), false};
  if (!before.place && timeline.position() > 0) before.place = timeline.place();
  return before;
}

void after_action(Session& session, const Whereabouts& before) {
  if (before.moved || !session.timeline) return;
  knit::Timeline& timeline = *session.timeline;
  auto& kept = session.travel.kept;
  if (before.run && before.place && run_key(timeline) != *before.run) {
    // What was shown instead of a place is not what was wanted.
    const bool still = kept && (!kept->shown || kept->shown == before.place);
    if (!still) kept = KeptPlace{*before.place, {}};
    kept->shown.reset();
    session.place_note.clear();
    const bool under_way = timeline.sought() == kept->wanted;
    if (!under_way && (timeline.position() == 0 || timeline.place() != kept->wanted))
      timeline.await(kept->wanted);
  }
  settle(session);
}

}  // namespace app
