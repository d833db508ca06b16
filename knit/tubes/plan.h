// Which tubes are knitted, and with how many rows: the graph of tubes, simplified for one stitch size.
//
// Offsets, in rows: a row beside a minimum or maximum stands 1 from it, the first row above an event 0.25, the last below
// one 0.75, beside a ring 0.5; at an open edge of the mesh a row lies on the edge itself. A tube of height H with n rows has them H / (n - 1 + o1 + o2) apart, so
//   wanted = floor(H / h - (o1 + o2 - 1) + 1/2), at least 0; 0 too if its longest curve is under 2.5 w, if it is a leaf of
//   fewer than `smallest_limb` rows, or a leaf of at most one row that is a plateau (a slope under 6 % of the median).
// A leaf gets its one row from H / h = sqrt(m (1 + m)) on, m = o1 + o2 - 1: there its rows would be as much too near to each
// other, as a ratio, as they are too far without it.
// Leaves without a row are pruned, the least height x girth first; where none is left, a rowless tube from a split to a join
// that closes a ring of rowless tubes, or is under 1.5 w round and not all that holds two parts together, is a handle smaller
// than a row and is left out. What stays rowless is only dealt through (between two events), is a ring (a leaf beside two
// tubes with rows), or is given one row.
// Twins are tubes alike within 5 % in height and 10 % in girth: they get the same rows.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "knit/fabric/stitch.h"
#include "knit/model/products.h"
#include "knit/tubes/graph.h"

namespace knit {

enum class EventKind : std::uint8_t { cast_on, split, join, bind_off, ring_cast_on, ring_bind_off };

// A node that is left. At a ring the rowless leaf is still among `below` (a ring cast on) or `above`.
struct TubeEvent {
  EventKind kind = EventKind::cast_on;
  std::int32_t node = 0;        // of the graph
  VertexId vertex = no_vertex;  // of the mesh
  glm::dvec3 position{0.0};
  double value = 0.0;
  std::vector<TubeId> below, above;
  bool rim = false;  // an open edge of the mesh, which is cast on or bound off; as the graph says
  [[nodiscard]] auto fields() const { return std::tie(kind, node, vertex, position, value, below, above); }
  friend bool operator==(const TubeEvent&, const TubeEvent&) = default;
};

struct Tube {
  std::vector<std::int32_t> parts;   // tubes of the graph that follow each other, from below
  std::int32_t bottom = 0, top = 0;  // events
  double height = 0.0;
  double longest = 0.0;              // of its curves
  double spacing = 0.0;              // from row to row, along the surface; 0: no row
  bool forced = false;               // its one row is given to it, though it is lower than one
  std::vector<TubeId> twins;         // all that are alike, itself too, rising; else itself alone
  std::vector<double> values;        // of its rows, from below
  std::vector<Shared<Ring>> curves;  // of its rows
  std::vector<double> lengths;       // that stitches are counted by: the curve's, or the twins' mean
  // What a split below measures by: the first row's curve, of a tube without rows the one half way up.
  Shared<Ring> lowest;
  bool inner = false;  // its outside faces the middle of its curves
  [[nodiscard]] std::int32_t rows() const { return static_cast<std::int32_t>(curves.size()); }
  [[nodiscard]] auto fields() const {
    return std::tie(parts, bottom, top, height, longest, spacing, forced, twins, values, curves, lengths,
                    lowest, inner);
  }
  friend bool operator==(const Tube&, const Tube&) = default;
};

// Smaller than a row, and so not knitted.
struct LeftOut {
  bool handle = false;  // else a limb
  double height = 0.0, girth = 0.0;
  VertexId from = no_vertex, to = no_vertex;  // of the mesh, at its two ends
  // A limb or handle of this stitch width would be kept.
  double width_that_keeps = 0.0;
  [[nodiscard]] auto fields() const { return std::tie(handle, height, girth, from, to, width_that_keeps); }
  friend bool operator==(const LeftOut&, const LeftOut&) = default;
};

struct TubePlan {
  std::vector<Tube> tubes;        // in working order, those without a row last
  std::vector<TubeEvent> events;  // by rank
  std::vector<LeftOut> left_out;  // in the order of leaving out
  std::vector<TubeId> order;      // in which they are worked, rowless ones too
  std::int32_t held_most = 0;     // holders at once
  std::int32_t yarns = 0;
  bool order_is_exact = true;  // no order has fewer holders, and none with as few has fewer yarns
  std::int32_t orders_tried =
      0;  // stitch by stitch, for the knitter's order; 0: holders and yarns alone decided
  double stitch_width = 0.0, stitch_height = 0.0;  // that it was made for
  [[nodiscard]] const Tube& tube(TubeId id) const { return tubes[static_cast<std::size_t>(id)]; }
  [[nodiscard]] const TubeEvent& event(std::int32_t id) const { return events[static_cast<std::size_t>(id)]; }
  [[nodiscard]] auto fields() const {
    return std::tie(tubes, events, left_out, order, held_most, yarns, order_is_exact, orders_tried,
                    stitch_width, stitch_height);
  }
  friend bool operator==(const TubePlan&, const TubePlan&) = default;
};

// Of the surface that is knitted, handles that are left out not counted: the loops of what is left of the graph.
inline std::int32_t genus_of(const TubePlan& plan) {
  return static_cast<std::int32_t>(plan.tubes.size()) - static_cast<std::int32_t>(plan.events.size()) + 1;
}

struct TubeSettingsNow {
  double width = 0.1, height = 0.072;  // of a stitch
  std::int32_t smallest_limb = 1;      // rows
};
TubePlan plan_tubes(const TubeGraph& graph, const TubeSettingsNow& settings, const Heard& heard = {});
// What a stitch that was changed on the way makes of the rows to come: tubes, events and their order stay. Of each tube the
// first `made` rows stay too; what is left of its height above them is shared out anew.
TubePlan replan_rows(const TubeGraph& graph, const TubePlan& plan, const TubeSettingsNow& settings,
                     std::span<const std::int32_t> made);

// The order of working and what it takes, for any graph of tubes.
struct TubeOrder {
  std::vector<TubeId> order;
  std::int32_t held_most = 0, yarns = 0;
  bool exact = true;
};
// Any order in which a tube comes after those below it can be knitted. Of them the one with the fewest holders at once,
// then the fewest yarns, then the least sum of holders; ties by the lowest tube number. Dynamic programming level by level
// over (tubes done, the last of them); at most 2,000 states a level are kept, the best. Every order that goes on with the
// yarn where it can takes cast ons + splits yarns.
TubeOrder order_tubes(const std::vector<Tube>& tubes, const std::vector<TubeEvent>& events);

// Of an order of the tubes with rows that order of all: those without are taken up right before the first that needs them, the
// edge of a graft after the tubes that it ends. Requires that each comes after those that it stands on.
std::vector<TubeId> with_rowless(const TubePlan& plan, const std::vector<TubeId>& worked);

// The same tubes, worked in another order and numbered by it, and so lettered; those without a row have the last numbers.
TubePlan renumbered(const TubePlan& plan, TubeOrder order);

}  // namespace knit
