#include "app/actions/playing.h"

#include "app/session/document.h"
#include "app/session/view.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "knit/quality/measures.h"

namespace app {

namespace {

constexpr double slowest_pace = 3.0;  // steps a second at the interesting step
constexpr double pace_growth = 1.5;   // from one step to the next

// As far as any pace is below the fastest one.
std::size_t slow_reach() {
  return static_cast<std::size_t>(
      std::ceil(std::log(fastest_steps_per_second / slowest_pace) / std::log(pace_growth)));
}

constexpr std::size_t prelude_units = 600;  // of the usual speed's steps: two seconds
constexpr std::size_t least_units = 150;    // however short what follows is: half a second
constexpr std::size_t prelude_part = 10;    // at most one in so many

// How far `seconds` lead from a place between two positions, at `pace` steps a second, `stride` times as fast in the
// prelude. Never past the start.
double moved(double at, const Prelude& prelude, double pace, double seconds, bool forward) {
  const auto border = static_cast<double>(prelude.steps);
  const double inside = pace * prelude.stride;
  if (forward) {
    const double until = at < border ? (border - at) / inside : 0.0;
    if (seconds <= until) return seconds * inside;
    return std::max(0.0, border - at) + (seconds - until) * pace;
  }
  const double until = at > border ? (at - border) / pace : 0.0;
  if (seconds <= until) return seconds * pace;
  return std::max(0.0, at - border) + (seconds - until) * inside;
}

bool unlimited(double steps_per_second) { return steps_per_second >= fastest_steps_per_second; }

// Interesting positions from `low` to `high`, rising.
std::vector<std::size_t> interesting_between(const Session& session, std::size_t low, std::size_t high) {
  const knit::Timeline& timeline = session.document->timeline;
  std::vector<std::size_t> positions;
  std::optional<std::size_t> hit = session.document->travel.hits.from(low);
  for (std::size_t position = low; position <= high; ++position) {
    const bool is_hit = hit && *hit == position;
    if (is_hit) hit = session.document->travel.hits.from(position + 1);
    const bool unusual = position > 0 && is_interesting(timeline.step(position - 1),
                                                        timeline.parameters_of_step(position - 1));
    if (is_hit || unusual) positions.push_back(position);
  }
  return positions;
}

std::size_t distance_to_nearest(const std::vector<std::size_t>& positions, std::size_t position) {
  const auto ahead = std::lower_bound(positions.begin(), positions.end(), position);
  std::size_t nearest = BreakHits::all;
  if (ahead != positions.end()) nearest = *ahead - position;
  if (ahead != positions.begin()) nearest = std::min(nearest, position - *std::prev(ahead));
  return nearest;
}

// Step for step: each takes as long as the pace where it begins.
Due slow_steps_due(const Session& session, double seconds) {
  const Playback& playback = session.view->playback;
  const knit::Timeline& timeline = session.document->timeline;
  const std::size_t position = timeline.position();
  const std::size_t known = timeline.known();
  const double full = playback.steps_per_second;
  const std::size_t most = std::min<std::size_t>(
      steps_per_tick, unlimited(full) ? steps_per_tick : static_cast<std::size_t>(seconds * full) + 1);
  const std::size_t reach = slow_reach();
  const bool forward = playback.direction > 0;
  const std::size_t low = position - std::min(position, reach + (forward ? 0 : most));
  const std::size_t high = std::min(known, position + reach + (forward ? most : 0));
  const auto interesting = interesting_between(session, low, high);
  Due due{0, playback.owed};
  double left = seconds;
  while (due.steps < most) {
    const std::size_t at =
        forward ? std::min(position + due.steps, known) : position - std::min(position, due.steps);
    const double pace = slow_pace(full, distance_to_nearest(interesting, at));
    const bool at_once = unlimited(full) && pace >= full;
    const double needed = at_once ? 0.0 : (1.0 - due.owed) / pace;
    if (left < needed) {
      due.owed += left * pace;
      break;
    }
    left -= needed;
    due = {due.steps + 1, 0.0};
  }
  return due;
}

// Steps from one position of a loop to another, as playing goes.
std::size_t steps_in_loop(const Stretch& loop, std::size_t from, std::size_t to, int direction) {
  if (direction < 0) std::swap(from, to);
  const std::size_t round = loop.end - loop.begin + 1;
  return to >= from ? to - from : round - (from - to);
}

Played played_in_loop(const Stretch& loop, int direction, const BreakHits& hits, std::size_t position,
                      std::size_t steps) {
  if (steps == 0) return {position, false};
  // The first hit after the position, round the loop.
  std::optional<std::size_t> hit = direction > 0 ? hits.from(position + 1) : hits.before(position);
  const auto inside = [&] { return hit && *hit >= loop.begin && *hit <= loop.end; };
  if (!inside()) hit = direction > 0 ? hits.from(loop.begin) : hits.before(loop.end + 1);
  if (inside() && *hit != position && steps_in_loop(loop, position, *hit, direction) <= steps)
    return {*hit, true};
  const std::size_t round = loop.end - loop.begin + 1;
  const std::size_t way = steps % round;
  const std::size_t at = position - loop.begin;
  return {loop.begin + (direction > 0 ? at + way : at + round - way) % round, false};
}

}  // namespace

bool is_interesting(const knit::Step& step, const knit::Parameters& parameters) {
  return knit::is_unusual(step, parameters) || knit::finished_row_size(step).has_value();
}

double slow_pace(double full, std::size_t distance) {
  const double slow =
      slowest_pace * std::pow(pace_growth, static_cast<double>(std::min<std::size_t>(distance, 1000)));
  return std::min(full, slow);
}

double Prelude::share(std::size_t known) const {
  if (known == 0 || steps == 0) return 0.0;
  const double units = static_cast<double>(steps) / stride;
  const auto rest = static_cast<double>(known - std::min(known, steps));
  return units / (units + rest);
}

Prelude prelude_of(const knit::Timeline& timeline) {
  constexpr std::int32_t last = std::numeric_limits<std::int32_t>::max();
  Prelude prelude;
  prelude.steps = timeline.position_of({knit::Stage::tubes, last, last});
  const std::size_t rest = timeline.known() - prelude.steps;
  // While the rest is not known, it is taken to be long.
  const std::size_t part = timeline.complete() ? rest / (prelude_part - 1) : prelude_units;
  const std::size_t most = std::clamp(part, least_units, prelude_units);
  if (prelude.steps > most) prelude.stride = static_cast<double>(prelude.steps) / static_cast<double>(most);
  return prelude;
}

Due steps_due(const Session& session, double seconds) {
  const Playback& playback = session.view->playback;
  if (session.view->slow_motion) return slow_steps_due(session, seconds);
  if (unlimited(playback.steps_per_second)) return {seconds > 0.0 ? steps_per_tick : 0, 0.0};
  const knit::Timeline& timeline = session.document->timeline;
  const bool forward = playback.direction > 0;
  const auto position = static_cast<double>(timeline.position());
  const double at = forward ? position + playback.owed : position - playback.owed;
  const double due =
      playback.owed + moved(at, prelude_of(timeline), playback.steps_per_second, seconds, forward);
  const double whole = std::floor(due);
  return {static_cast<std::size_t>(whole), due - whole};
}

Played played(const Course& course, const BreakHits& hits, std::size_t position, std::size_t steps) {
  const bool forward = course.direction > 0;
  if (course.loop) {
    const bool inside = position >= course.loop->begin && position <= course.loop->end;
    if (inside) return played_in_loop(*course.loop, course.direction, hits, position, steps);
    return {steps == 0 ? position : forward ? course.loop->begin : course.loop->end, false};
  }
  const std::size_t target = forward ? std::max(position, std::min(position + steps, course.end))
                                     : position - std::min(position, steps);
  const auto hit = forward ? hits.from(position + 1) : hits.before(position);
  if (hit && (forward ? *hit <= target : *hit >= target)) return {*hit, true};
  return {target, false};
}

}  // namespace app
