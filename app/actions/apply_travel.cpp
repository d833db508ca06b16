// Break conditions, the loop, slow motion, and steps over, into and out.
#include <algorithm>
#include <utility>
#include <variant>

#include "app/actions/apply_parts.h"
#include "app/actions/navigate.h"
#include "app/actions/playing.h"
#include "app/explain/destination.h"
#include "app/facing/turn_view.h"
#include "app/lessons/predict.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/program.h"
#include "app/session/view.h"

namespace app {

namespace {

void stop_at(Session& session, std::size_t position) {
  session.document->timeline.seek(position);
  const knit::BreakCondition* condition = session.document->travel.hits.condition_at(position);
  if (condition != nullptr) session.document->place_note = "Break: " + knit::words_of(*condition) + ".";
}

// Goes to the hit that is looked for, once it is certain which one it is, or that there is none.
void try_to_run(Session& session) {
  Travel& travel = session.document->travel;
  if (travel.running_to == 0) return;
  const bool forward = travel.running_to > 0;
  const std::size_t position = session.document->timeline.position();
  if (!forward && travel.hits.reach() < position) return;
  const auto hit = forward ? travel.hits.from(position + 1) : travel.hits.before(position);
  const bool all_seen = !forward || (session.document->timeline.complete() && travel.hits.whole());
  if (!hit && !all_seen) return;
  travel.running_to = 0;
  if (hit) return stop_at(session, *hit);
  session.document->place_note = forward ? "No break condition holds from here to the end of the run."
                                         : "No break condition holds before this step.";
}

// Positions follow the places of the loop into another run; a loop whose steps are gone waits for them.
void tend_loop(Session& session) {
  const knit::Timeline& timeline = session.document->timeline;
  Travel& travel = session.document->travel;
  if (!travel.loop_places) {
    if (!travel.loop || travel.loop->end > timeline.known()) return;
    travel.loop_places =
        PlaceStretch{timeline.step(travel.loop->begin).place, timeline.step(travel.loop->end - 1).place};
  }
  travel.loop = stretch_of(timeline, *travel.loop_places);
}

}  // namespace

void fly_on(Session& session, double seconds) {
  std::optional<CameraFlight>& flight = session.jobs->flight;
  if (!flight) return;
  Camera& camera = session.view->gaze.camera;
  if (camera != flight->left) return flight.reset();
  flight->passed_s += std::max(0.0, seconds);
  camera = flight->left = camera_at(*flight);
  if (flight->over()) flight.reset();
}

void tend_travel(Session& session) {
  if (!session.document) return;
  Travel& travel = session.document->travel;
  // In a window as much at a time as is worked out, so that a frame stays short.
  travel.hits.refresh(session.document->timeline, session.view->breaks,
                      session.jobs->beside ? steps_per_tick : BreakHits::all);
  tend_loop(session);
  try_to_run(session);
}

void play(Session& session, double seconds) {
  knit::Timeline& timeline = session.document->timeline;
  Travel& travel = session.document->travel;
  const std::size_t position = timeline.position();
  // Where hits are not known yet, playing waits for them.
  const std::size_t end = std::min(timeline.known(), travel.hits.reach());
  const bool waits = position > end || (travel.loop && travel.loop->end > travel.hits.reach());
  if (waits) return;
  const Due due = steps_due(session, std::clamp(seconds, 0.0, 0.25));
  session.view->playback.owed = due.owed;
  const int direction = session.view->playback.direction;
  const bool loops = travel.loop && travel.loop->end <= end;
  Played now = played({end, direction, loops ? travel.loop : std::nullopt}, travel.hits, position, due.steps);
  const auto asked =
      direction > 0 ? verdict_ahead(session, std::min(end, position + due.steps)) : std::nullopt;
  const bool to_be_guessed = asked && (!now.broke || *asked < now.position);
  if (to_be_guessed) now = {*asked, false};
  if (now.position != position) forget_place(session);
  timeline.seek(now.position);
  const bool at_end =
      direction > 0 ? timeline.complete() && now.position == timeline.known() : now.position == 0;
  if (now.broke || to_be_guessed || (at_end && !loops)) stop_playing(session);
  if (to_be_guessed) wait_for_guess(session);
  if (now.broke) stop_at(session, now.position);
}

void take(Session& session, const StepDeep& action) {
  if (!session.document) return;
  const int direction = action.direction < 0 ? -1 : 1;
  if (const auto unit = unit_of_depth(session.document->timeline, action.depth)) {
    apply(session, StepBy{*unit, direction});
  } else if (direction > 0) {
    apply(session, ToLast{});
  } else {
    apply(session, ToFirst{});
  }
}

void take(Session& session, const SetBreaks& action) {
  std::vector<knit::BreakCondition> conditions;
  for (const knit::BreakCondition& condition : action.conditions) {
    if (std::find(conditions.begin(), conditions.end(), condition) == conditions.end())
      conditions.push_back(condition);
  }
  session.view->breaks = std::move(conditions);
  if (!session.document) return;
  session.document->travel.running_to = 0;
  tend_travel(session);
}

void take(Session& session, const RunToBreak& action) {
  if (!session.document) return;
  session.view->playback.playing = false;
  Travel& travel = session.document->travel;
  if (session.view->breaks.empty()) {
    session.document->place_note = "There is no break condition yet; the list Breaks offers the usual ones.";
    return;
  }
  remember_place(session);
  travel.running_to = action.direction < 0 ? -1 : 1;
  tend_travel(session);
  // In a window the ticks go on with it.
  while (!session.jobs->beside && travel.running_to != 0) apply(session, PassTime{0.0});
}

void take(Session& session, const SetLoop& action) {
  if (!session.document) return;
  session.document->travel.loop_places.reset();
  session.document->travel.loop.reset();
  if (!action.stretch || action.stretch->end <= action.stretch->begin) return;
  session.document->travel.loop = action.stretch;
  tend_loop(session);
}

void take(Session& session, const SetSlowMotion& action) { session.view->slow_motion = action.on; }

namespace {

constexpr std::size_t most_remembered = 200;

// The start stands before the first step's place.
knit::Place here(const knit::Timeline& timeline) {
  if (timeline.sought()) return *timeline.sought();
  return timeline.position() == 0 ? knit::Place{knit::Stage::import, 0, 0} : timeline.place();
}

void push(std::vector<knit::Place>& places, const knit::Place& place) {
  if (!places.empty() && places.back() == place) return;
  places.push_back(place);
  if (places.size() > most_remembered) places.erase(places.begin());
}

// Only to what is known, or as soon as it is; nothing is worked out here.
void go(Session& session, const knit::Place& place) {
  session.view->playback.playing = false;
  session.document->timeline.await(place);
}

void jump_after(Session& session, std::size_t step) {
  remember_place(session);
  session.view->playback.playing = false;
  session.document->timeline.seek(step + 1);
}

// At once without a window, and for whoever wants nothing to move.
void look_from(Session& session, const Camera& camera) {
  Camera& now = session.view->gaze.camera;
  session.jobs->flight.reset();
  if (!session.jobs->beside || !session.program->preferences.motion) {
    now = camera;
  } else if (camera != now) {
    session.jobs->flight = CameraFlight{now, camera};
  }
}

// Takes the nearest place that is another than this one.
void go_along(Session& session, std::vector<knit::Place>& from, std::vector<knit::Place>& onto) {
  const knit::Place now = here(session.document->timeline);
  while (!from.empty() && from.back() == now) from.pop_back();
  if (from.empty()) return;
  push(onto, now);
  const knit::Place place = from.back();
  from.pop_back();
  go(session, place);
}

bool is_of_mesh(const Session& session, const knit::Element& thing) {
  const auto* vertex = std::get_if<knit::VertexElement>(&thing);
  return vertex == nullptr || vertex->vertex < session.document->timeline.input().mesh.positions.size();
}

}  // namespace

void take(Session& session, const Select& action) {
  if (!session.document || (action.thing && !is_of_mesh(session, *action.thing))) return;
  session.document->travel.selected = action.thing;
  session.document->travel.sized.reset();
}

void take(Session& session, const LookAt& action) {
  if (!session.document || !is_of_mesh(session, action.thing)) return;
  take(session, Select{action.thing});
  look_from(session, turned_to(session, action.thing));
}

void take(Session& session, const SelectSized& action) {
  if (!session.document) return;
  take(session, Select{});
  session.document->travel.sized = action.range;
  if (action.range) look_from(session, turned_to(session, *action.range));
}

void take(Session& session, const ShowWhy& action) {
  if (!session.document || !is_of_mesh(session, action.thing)) return;
  take(session, Select{action.thing});
  if (const auto step = knit::made_by(session.document->timeline, action.thing)) jump_after(session, *step);
}

void take(Session& session, const ToTouch& action) {
  if (!session.document || !session.document->travel.selected) return;
  const knit::Timeline& timeline = session.document->timeline;
  const knit::Element& thing = *session.document->travel.selected;
  // The step shown is the last one taken.
  const std::size_t position = timeline.position();
  const auto step = action.direction > 0 ? knit::touch_from(timeline, thing, position)
                    : position > 0       ? knit::touch_before(timeline, thing, position - 1)
                                         : std::nullopt;
  if (step) jump_after(session, *step);
}

void take(Session& session, const GoTo& action) {
  if (!session.document) return;
  const auto found = destination_of(session, action.where);
  if (const auto* none = std::get_if<NoDestination>(&found)) return tell(session, none->why);
  const auto& there = std::get<Destination>(found);
  if (there.thing) session.document->travel.selected = there.thing;
  if (there.place && there.place->stage == knit::Stage::done) {
    apply(session, ToLast{});
  } else if (there.place) {
    apply(session, SeekPlace{*there.place});
  } else if (there.position) {
    session.document->travel.left_by_seek.reset();
    apply(session, SeekTo{*there.position});
  }
  session.view->playback.playing = false;
  // An answer stays until it is put away, what is at a place until one goes on.
  if (there.asks_why) return tell(session, there.words);
  session.document->place_note = there.words;
}

void take(Session& session, const GoBack& /*action*/) {
  if (!session.document) return;
  PlaceHistory& history = session.document->travel.history;
  go_along(session, history.behind, history.ahead);
}

void take(Session& session, const GoForward& /*action*/) {
  if (!session.document) return;
  PlaceHistory& history = session.document->travel.history;
  go_along(session, history.ahead, history.behind);
}

void remember_place(Session& session) {
  if (!session.document) return;
  push(session.document->travel.history.behind, here(session.document->timeline));
  session.document->travel.history.ahead.clear();
  session.document->travel.left_by_seek.reset();
}

}  // namespace app
