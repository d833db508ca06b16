// How playing moves: how many steps a stretch of time brings, and where they lead.
#pragma once

#include <cstddef>
#include <optional>

#include "app/session/session.h"
#include "app/session/travel.h"

namespace app {

// "As fast as it goes" is as many a tick; the run is worked out ahead by as many.
inline constexpr std::size_t steps_per_tick = 40000;

// Slow motion: what is worth slowing down for beside the hits of break conditions: an unusual step, or one
// that finishes a row.
bool is_interesting(const knit::Step& step, const knit::Parameters& parameters);
// Steps a second so many steps before or after the nearest such: a few there, `full` far away, and in
// proportion to the one before from step to step.
double slow_pace(double full, std::size_t distance);

struct Due {
  std::size_t steps = 0;
  double owed = 0.0;  // part of a step not yet due
};
// What `seconds` bring from the position on, in the playback's direction.
Due steps_due(const Session& session, double seconds);

// Where `steps` steps lead from a position.
struct Course {
  std::size_t end = 0;  // the last position there is so far
  int direction = 1;
  std::optional<Stretch> loop;  // within it; from outside, playing jumps in
};
struct Played {
  std::size_t position = 0;
  bool broke = false;  // stopped at a hit; one at the position itself does not stop
};
Played played(const Course& course, const BreakHits& hits, std::size_t position, std::size_t steps);

}  // namespace app
