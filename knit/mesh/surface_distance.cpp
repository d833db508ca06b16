#include "knit/mesh/surface_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "knit/mesh/elementary.h"
#include "knit/mesh/surface_windows.h"

namespace knit {

namespace {

using Index = SurfacePatch::Index;

// As parts of a side. What passes a vertex by less than `in_sight` sees it: on a flat mesh straight ways run
// through vertices and along edges, and rounding may put them on either side. The length is then wrong by
// the square of it. A window must be wider than `too_narrow`, or it leads nowhere that others do not.
constexpr double in_sight = 1e-9;
constexpr double too_narrow = 1e-12;
// With more targets than this the search spreads evenly instead of making for each in turn.
constexpr std::size_t a_handful = 32;

// What is known of a vertex.
struct Reached {
  double bound = not_reached;     // the shortest way found, of whatever kind
  double straight = not_reached;  // the shortest of those that windows or sources' edges found
  std::optional<bool> parts_ways;
  // Of the targets, by straight lines through space, which no way undercuts:
  double rest = 0.0;    // to the one that we make for
  double useful = 0.0;  // a way to here that is longer is of no use
  Index known_for = 0;  // which round they are of
};

// Of the windows by one side that see the third corner, the one that has the shortest way there.
struct Holder {
  double length = not_reached;
  double crossing = 0.0;
};

struct Target {
  Index vertex = 0;
  double limit = not_reached;  // the way we look for is no longer
  bool done = false;
};

class Search {
 public:
  Search(const Input& input, VertexId source, std::span<const VertexId> targets, double radius);
  // Shortest ways along edges. As bounds they spare most windows.
  void follow_edges();
  void open_windows();
  double distance_to(VertexId target);

 private:
  // Vertices of a side, its origin first, and of the face's third corner.
  struct Corners {
    Index origin, end, third;
  };
  struct Ways {
    bool by_origin, by_end;
  };
  Reached& reach(Index vertex);
  const Reached& look_ahead(Index vertex);
  bool parts_ways(Index vertex);
  void tighten_limits();
  void make_for(std::size_t target);
  void handle(const WindowEvent& event);
  double total(const Window& window);
  double total(Index vertex);
  void shorten(Index vertex, double length);
  void start_from(Index vertex);
  void cross(const Window& window);
  Ways split(const Window& window, double apex_crossing);
  bool beaten(const Window& window, const Corners& corners, double length, const glm::dvec2& third);
  void pass_on(Window window, Index side, const Corners& corners, const glm::dvec2& third);

  const Input& input_;
  SurfacePatch patch_;  // the source is its vertex 0, then come the targets
  double radius_;
  std::vector<Target> targets_;
  double limit_ = 0.0;  // the greatest of the targets'
  bool one_by_one_;     // make for a target at a time
  Index round_ = 1;     // while edges are followed, then 2 and on, one a target
  std::size_t aim_ = 0;
  std::vector<Reached> reached_;  // per vertex of the patch
  std::vector<Holder> holders_;   // per side of the patch
  EventQueue queue_;
};

Search::Search(const Input& input, VertexId source, std::span<const VertexId> targets, double radius)
    : input_(input), patch_(input), radius_(radius), one_by_one_(targets.size() <= a_handful) {
  reach(patch_.vertex(source)).bound = 0.0;
  for (const VertexId target : targets) {
    if (input.neighbours_of(target).empty()) continue;  // no triangle leads there
    targets_.push_back({patch_.vertex(target), radius});
  }
  tighten_limits();
}

double Search::distance_to(VertexId target) {
  const double distance = reach(patch_.vertex(target)).bound;
  return distance <= radius_ ? distance : not_reached;
}

Reached& Search::reach(Index vertex) {
  if (vertex >= reached_.size()) reached_.resize(patch_.vertex_count());
  return reached_[vertex];
}

void Search::tighten_limits() {
  limit_ = 0.0;
  for (Target& target : targets_) {
    if (target.done) continue;
    target.limit = std::min(target.limit, reach(target.vertex).bound);
    limit_ = std::max(limit_, target.limit);
  }
}

// Limits that have got tighter since are let be until the next round.
const Reached& Search::look_ahead(Index vertex) {
  Reached& here = reach(vertex);
  if (here.known_for == round_) return here;
  here.known_for = round_;
  here.useful = one_by_one_ ? -not_reached : limit_;
  if (!one_by_one_) return here;
  const bool any = round_ == 1;
  here.rest = not_reached;
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const Target& target = targets_[i];
    if (target.done) continue;
    const double rest = glm::distance(patch_.position(vertex), patch_.position(target.vertex));
    here.useful = std::max(here.useful, target.limit * (1.0 + in_sight) - rest);
    if (any || i == aim_) here.rest = std::min(here.rest, rest);
  }
  return here;
}

bool Search::parts_ways(Index vertex) {
  std::optional<bool>& known = reach(vertex).parts_ways;
  if (!known) known = patch_.parts_ways(vertex);
  return *known;
}

void Search::follow_edges() {
  queue_.push_vertex(0.0, 0);
  while (const auto event = queue_.pop(limit_)) {
    const double before = reach(event->vertex).bound;
    if (event->length > before + reach(event->vertex).rest) continue;
    const glm::dvec3& from = patch_.position(event->vertex);
    for (const VertexId id : input_.neighbours_of(patch_.id(event->vertex))) {
      const Index next = patch_.vertex(id);
      const double length = before + glm::distance(from, patch_.position(next));
      if (length >= reach(next).bound || length > look_ahead(next).useful) continue;
      reach(next).bound = length;
      if (next <= targets_.size()) tighten_limits();
      queue_.push_vertex(length + reach(next).rest, next);
    }
  }
  queue_.clear();
}

// Nothing that comes of the window, or of ways that start at the vertex, is shorter than this.
double Search::total(const Window& window) {
  if (!one_by_one_) return window.least_length();
  const SurfacePatch::Face& face = patch_.face(window.side / 3);
  const std::size_t k = window.side % 3;
  const double from_origin = look_ahead(face.corner[k]).rest;
  const double from_end = look_ahead(face.corner[(k + 1) % 3]).rest;
  return window.least_length_to(from_origin, from_end, face.length[k]);
}

double Search::total(Index vertex) {
  const Reached& here = look_ahead(vertex);
  return here.straight + here.rest;
}

void Search::open_windows() {
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    aim_ = i;
    ++round_;
    if (i == 0) start_from(0);
    if (one_by_one_) {
      queue_.reorder([&](const WindowEvent& event) {
        return event.vertex == SurfacePatch::none ? total(queue_.window(event)) : total(event.vertex);
      });
    }
    while (const auto event = queue_.pop(one_by_one_ ? targets_[i].limit : limit_)) handle(*event);
    targets_[i].done = true;
    tighten_limits();
    if (!one_by_one_) return;
  }
}

void Search::handle(const WindowEvent& event) {
  if (event.vertex == SurfacePatch::none) {
    cross(queue_.take_window(event));
  } else if (event.length <= total(event.vertex)) {  // else it was reached by a shorter way since
    start_from(event.vertex);
  }
}

// A way to the vertex was found; if it is the shortest, other ways may start there.
void Search::shorten(Index vertex, double length) {
  Reached& here = reach(vertex);
  if (length >= here.straight) return;
  here.straight = length;
  if (length < here.bound) {
    here.bound = length;
    if (vertex <= targets_.size()) tighten_limits();
  }
  if (length > here.bound * (1.0 + no_shorter) || length > look_ahead(vertex).useful) return;
  if (parts_ways(vertex)) queue_.push_vertex(total(vertex), vertex);
}

void Search::start_from(Index vertex) {
  const double before = reach(vertex).bound;
  for (const Index corner : patch_.corners_at(vertex)) {
    const SurfacePatch::Face& face = patch_.face(corner / 3);
    const std::size_t k = corner % 3;
    const std::size_t opposite = (k + 1) % 3;
    const std::size_t last = (k + 2) % 3;
    const glm::dvec2 apex = face.apex[opposite];
    const Window window{SurfacePatch::none, 0.0, face.length[opposite], apex, before};
    const Corners corners{face.corner[opposite], face.corner[last], vertex};
    shorten(corners.origin, before + face.length[k]);
    shorten(corners.end, before + face.length[last]);
    pass_on(window, corner / 3 * 3 + static_cast<Index>(opposite), corners, apex);
  }
}

void Search::cross(const Window& window) {
  const SurfacePatch::Face face = patch_.face(window.side / 3);  // a copy: the patch grows
  const std::size_t k = window.side % 3;
  const std::size_t next = (k + 1) % 3;
  const std::size_t last = (k + 2) % 3;
  const double base = face.length[k];
  const double apex_crossing = crossing_towards(window, face.apex[k]);
  const Ways ways = split(window, apex_crossing);
  const auto pass = [&](const Window& from, const glm::dvec2& apex, double crossing, std::size_t side,
                        const Corners& corners) {
    const double length = face.length[side];
    pass_on(passed_on(from, apex, length, crossing), window.side / 3 * 3 + static_cast<Index>(side), corners,
            apex * (base / length));
  };
  if (ways.by_origin)
    pass(window, face.apex[k], apex_crossing, last, {face.corner[k], face.corner[last], face.corner[next]});
  if (ways.by_end) {
    pass(window.mirrored(base), {base - face.apex[k].x, face.apex[k].y}, base - apex_crossing, next,
         {face.corner[next], face.corner[last], face.corner[k]});
  }
}

// By which of the two further sides the window goes on; the third corner, if the window sees it, learns of a
// way. One angle, one split (Chen and Han): of two windows that see that corner, the one with the longer way
// serves only the side from which it comes.
Search::Ways Search::split(const Window& window, double apex_crossing) {
  const SurfacePatch::Face& face = patch_.face(window.side / 3);
  const std::size_t k = window.side % 3;
  Ways ways{window.low<apex_crossing, window.high> apex_crossing};
  const glm::dvec2 line{face.apex[k].x - window.source.x, face.apex[k].y + window.source.y};
  const double length = window.before + hypotenuse(line.x, line.y);
  const double tolerance =
      in_sight * face.length[k] + no_shorter * length;  // short sides: by the way's digits
  if (apex_crossing < window.low - tolerance || apex_crossing > window.high + tolerance) return ways;
  shorten(face.corner[(k + 2) % 3], length);
  if (!ways.by_origin || !ways.by_end) return ways;
  Holder& holder = holders_[window.side];
  if (length < holder.length) {
    holder = {length, apex_crossing};
  } else if (apex_crossing > holder.crossing + tolerance) {
    ways.by_origin = false;
  } else if (apex_crossing < holder.crossing - tolerance) {
    ways.by_end = false;
  }
  return ways;
}

// Whether a way known to one of the corners and straight on from there is shorter to every point of the
// window (Xin and Wang). The third corner is at `third`.
bool Search::beaten(const Window& window, const Corners& corners, double length, const glm::dvec2& third) {
  const double to_low = window.length_at(window.low) * (1.0 - no_shorter);
  const double to_high = window.length_at(window.high) * (1.0 - no_shorter);
  return reach(corners.origin).bound + window.high < to_high ||
         reach(corners.end).bound + (length - window.low) < to_low ||
         reach(corners.third).bound + hypotenuse(third.x - window.low, third.y) < to_low;
}

// Through the side into the face beyond, if that can be of use.
void Search::pass_on(Window window, Index side, const Corners& corners, const glm::dvec2& third) {
  const double length = patch_.face(side / 3).length[side % 3];
  if (!(window.high - window.low > too_narrow * length)) return;
  // What is useful changes from point to point by no more than their distance.
  const double useful = 0.5 * (look_ahead(corners.origin).useful + look_ahead(corners.end).useful + length);
  if (window.least_length() > std::min(limit_, useful) || beaten(window, corners, length, third)) return;
  window.side = patch_.across(side);
  if (window.side == SurfacePatch::none) return;
  if (window.side >= holders_.size()) holders_.resize(3 * std::size_t{patch_.face_count()});
  const bool same_way = patch_.face(window.side / 3).corner[window.side % 3] == corners.origin;
  if (!same_way) window = window.mirrored(length);
  queue_.push_window(total(window), window);
}

}  // namespace

std::vector<double> surface_distances(const Input& input, VertexId source, std::span<const VertexId> targets,
                                      double radius) {
  Search search(input, source, targets, std::max(0.0, radius));
  search.follow_edges();
  search.open_windows();
  std::vector<double> distances;
  distances.reserve(targets.size());
  for (const VertexId target : targets) distances.push_back(search.distance_to(target));
  return distances;
}

}  // namespace knit
