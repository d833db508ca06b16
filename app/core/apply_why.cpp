#include <algorithm>
#include <utility>

#include "app/core/apply_parts.h"

namespace app {

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
  session.playback.playing = false;
  session.timeline->await(place);
}

void jump_after(Session& session, std::size_t step) {
  remember_place(session);
  session.playback.playing = false;
  session.timeline->seek(step + 1);
}

// Takes the nearest place that is another than this one.
void go_along(Session& session, std::vector<knit::Place>& from, std::vector<knit::Place>& onto) {
  if (!session.timeline) return;
  const knit::Place now = here(*session.timeline);
  while (!from.empty() && from.back() == now) from.pop_back();
  if (from.empty()) return;
  push(onto, now);
  const knit::Place place = from.back();
  from.pop_back();
  go(session, place);
}

bool is_of_mesh(const Session& session, const knit::Thing& thing) {
  const auto* vertex = std::get_if<knit::VertexThing>(&thing);
  return vertex == nullptr || vertex->vertex < session.timeline->input().mesh.positions.size();
}

}  // namespace

void take(Session& session, const Select& action) {
  if (action.thing && (!session.timeline || !is_of_mesh(session, *action.thing))) return;
  session.travel.selected = action.thing;
}

void take(Session& session, const ShowWhy& action) {
  if (!session.timeline || !is_of_mesh(session, action.thing)) return;
  session.travel.selected = action.thing;
  if (const auto step = knit::made_by(*session.timeline, action.thing)) jump_after(session, *step);
}

void take(Session& session, const ToTouch& action) {
  if (!session.timeline || !session.travel.selected) return;
  const knit::Timeline& timeline = *session.timeline;
  const knit::Thing& thing = *session.travel.selected;
  // The step shown is the last one taken.
  const std::size_t position = timeline.position();
  const auto step = action.direction > 0 ? knit::touch_from(timeline, thing, position)
                    : position > 0       ? knit::touch_before(timeline, thing, position - 1)
                                         : std::nullopt;
  if (step) jump_after(session, *step);
}

void take(Session& session, const GoBack& /*action*/) {
  PlaceHistory& history = session.travel.history;
  go_along(session, history.behind, history.ahead);
}

void take(Session& session, const GoForward& /*action*/) {
  PlaceHistory& history = session.travel.history;
  go_along(session, history.ahead, history.behind);
}

void remember_place(Session& session) {
  if (!session.timeline) return;
  push(session.travel.history.behind, here(*session.timeline));
  session.travel.history.ahead.clear();
  session.travel.left_by_seek.reset();
}

}  // namespace app
