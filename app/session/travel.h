// Finding one's way in a run: where one was before a jump, what is selected, where it is to stop, what to repeat.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "app/session/break_hits.h"
#include "knit/insight/sized.h"
#include "knit/insight/why.h"

namespace app {

// Of the timeline: positions, `begin` before `end`.
struct Stretch {
  std::size_t begin = 0, end = 0;
  friend bool operator==(const Stretch&, const Stretch&) = default;
};

// The same by the places of its first and its last step, so that it outlives tuning.
struct PlaceStretch {
  knit::Place first, last;
};

// Like a browser's: places, not positions, so that it outlives tuning.
struct PlaceHistory {
  std::vector<knit::Place> behind, ahead;  // the nearest last
};

// The place that changed parameters come back to, however often they change, until one moves.
struct KeptPlace {
  knit::Place wanted;
  std::optional<knit::Place> shown;  // instead or itself; none while the run has not come so far
};

struct Travel {
  PlaceHistory history;
  std::optional<std::size_t> left_by_seek;  // where a SeekTo ended: one from there goes on with the same drag
  std::optional<knit::Element> selected;
  std::optional<knit::SizeRange>
      sized;           // all edges or corners of a size, lit instead; one of the two at most
  BreakHits hits;      // of the view's break conditions
  int running_to = 0;  // looking for the next hit in this direction, as the run is worked out; 0: no
  std::optional<Stretch> loop;
  std::optional<PlaceStretch> loop_places;  // of `loop`; apply keeps the two together
  std::optional<KeptPlace> kept;
};

}  // namespace app
