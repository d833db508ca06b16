// Where tubes and their events stand in a drawing that goes upward: pure numbers, from 0 to 1 both ways.
//
// A tube is an upright band from the event that begins it to the one that ends it. All that cross one height have an order
// from left to right and keep it: the tubes of a split take their parent's place, that of a join the place of one of its two,
// and one that is cast on may stand anywhere. A join's line crosses what stands between its two; of the choices those are
// taken that cross the least, by trying each choice anew until none is better. Where nothing is crossed the drawing is an
// upward planar embedding of the graph of tubes.
#pragma once

#include <cstdint>
#include <vector>

#include "knit/tubes/plan.h"

namespace app {

struct TubePlace {
  double x = 0.5;                // its middle
  double low = 0.0, high = 1.0;  // from below
  std::int32_t yarn = -1;        // from 0, in the order of taking up; -1: an edge at a ring, which has none
  knit::RowId first_row = 0;     // over the whole piece; 0: it has no row
};

struct EventPlace {
  double x = 0.5, y = 0.0;
};

struct TubesLayout {
  std::vector<TubePlace> tubes;
  std::vector<EventPlace> events;  // rising
  double column = 1.0;             // the middles of two tubes at one height are at least so far apart
  double longest = 0.0;            // of all rows' curves
  std::int64_t crossings = 0;
  std::int32_t yarns = 0;
  std::int32_t rounds = 0;
};
TubesLayout lay_out(const knit::TubePlan& plan);

// None (-1): there is no such row.
knit::TubeId tube_of_row(const knit::TubePlan& plan, const TubesLayout& layout, knit::RowId row);

// Of the plan's graph, which is connected.
std::int32_t loops_of(const knit::TubePlan& plan);

// Whether a knitting machine could make it: that asks for an upward planar embedding (J. McCann et al., "A Compiler for 3D
// Machine Knitting", 2016). Sufficient tests; what none of them settles is not known.
enum class MachineVerdict : std::uint8_t {
  tree,             // always has one
  drawn,            // the drawing is one
  series_parallel,  // with a source below all cast ons, a sink above all bind offs and an edge between the two
  not_known
};
MachineVerdict machine_verdict(const knit::TubePlan& plan, const TubesLayout& layout);

}  // namespace app
