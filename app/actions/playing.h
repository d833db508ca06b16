// How playing moves: how many steps a stretch of time brings, and where they lead.
#pragma once

#include <cstddef>
#include <optional>

#include "app/session/session.h"
#include "app/session/travel.h"
#include "knit/run/timeline.h"

namespace app {

// "As fast as it goes" is as many a tick; the run is worked out ahead by as many.
inline constexpr std::size_t steps_per_tick = 40000;

// Slow motion: what is worth slowing down for beside the hits of break conditions: an unusual step, or one
// that finishes a row.
bool is_interesting(const knit::Step& step, const knit::Parameters& parameters);
// Steps a second so many steps before or after the nearest such: a few there, `full` far away, and in
// proportion to the one before from step to step.
double slow_pace(double full, std::size_t distance);

// What comes before the first stitch, the times and the tubes, has a step a vertex: it is played in strides, so that it
// takes at most a tenth of the playing time, and about two seconds at the usual speed. By hand a step stays a step.
struct Prelude {
  std::size_t steps = 0;  // positions up to here are in it
  double stride = 1.0;    // steps in the time of one
  // Its part of the timeline's bar, by the time that it takes; `known`: steps of the whole run so far.
  [[nodiscard]] double share(std::size_t known) const;
};
Prelude prelude_of(const knit::Timeline& timeline);

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
