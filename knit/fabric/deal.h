// An event of tubes, done to live stitches: nothing is knitted, loops are dealt otherwise, over a few stitches cast on across
// the gap (the bridge), which are used from both sides.
//
//   split  one loop of n stitches into two of l + g and n - l + g: each child gets one arc and the bridge
//   join   two loops into one of l1 + l2 + 2 g
//   ring   two rows, or two loops, that face each other are joined stitch by stitch: one cast-on edge, or a graft
// A split or join adds exactly -1 to V - E + F: its faces are one quad where g = 0, else two triangles. A ring's strip adds 0.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <tuple>
#include <vector>

#include "knit/fabric/live_stitches.h"
#include "knit/fabric/strip.h"

namespace knit {

enum class DealKind : std::uint8_t { split, join, ring_cast_on, ring_bind_off };

struct Deal {
  DealKind kind = DealKind::split;
  std::int32_t event = 0;        // of the plan of tubes
  RowId after = 0;               // the last row made before it
  std::vector<TubeId> from, to;  // tubes whose loops it takes, and that it gives loops to
  std::vector<LiveStitches>
      taken;  // one a tube of `from`; of a ring cast on, the two first rows, which stay as they are
  std::vector<LiveStitches> given;     // one a tube of `to`
  std::array<std::int32_t, 2> arcs{};  // stitches of the two sides
  glm::dvec3 saddle{0.0};
  double gap = 0.0;            // across the saddle, along the surface, about
  std::vector<Stitch> bridge;  // cast on here; in rows they are {bridge_row(deal), i}
  std::vector<Face> faces;     // corners along the knitting path; cells have no meaning
  std::vector<std::array<std::uint32_t, 2>> column_edges;  // of a ring's strip
  [[nodiscard]] auto fields() const {
    return std::tie(kind, event, after, from, to, taken, given, arcs, saddle, gap, bridge, faces,
                    column_edges);
  }
  friend bool operator==(const Deal&, const Deal&) = default;
};

// Edges that it adds to those of rows and strips: a ring's strip has one a cell; else the bridge's own, if there is one, and
// those that close the loops over it.
inline std::size_t edge_count(const Deal& deal) {
  if (!deal.column_edges.empty()) return deal.column_edges.size();
  return deal.bridge.empty() ? 2 : deal.bridge.size() + 3;
}

// Deals are numbered from 1 in the order of dealing. A bridge's stitches go by a row number of their own, below 0.
constexpr RowId bridge_row(std::int32_t deal) { return -deal; }
constexpr bool is_bridge(const StitchRef& ref) { return ref.row < 0; }
constexpr std::int32_t deal_of(const StitchRef& ref) { return -ref.row; }

}  // namespace knit
