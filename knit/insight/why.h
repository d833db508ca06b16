// Why is this here, why is that not: from a thing on the knit mesh to the steps that had to do with it.
#pragma once

#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

#include "knit/run/timeline.h"

namespace knit {

// Rows count from 1, everything else from 0. A row below 0 is a deal (knit/fabric/deal.h): stitches and row edges are its
// bridge's, faces those at its saddle, faces and column edges of a ring those of its strip.
struct StitchElement {
  std::int32_t row = 1, stitch = 0;
  friend bool operator==(const StitchElement&, const StitchElement&) = default;
};
struct RowEdgeElement {
  std::int32_t row = 1, stitch = 0;  // from this stitch to the next of its row
  friend bool operator==(const RowEdgeElement&, const RowEdgeElement&) = default;
};
struct ColumnEdgeElement {
  std::int32_t row = 2, edge = 0;  // of the strip below this row
  friend bool operator==(const ColumnEdgeElement&, const ColumnEdgeElement&) = default;
};
struct FaceElement {
  std::int32_t row = 2, face = 0;  // of the strip below this row
  friend bool operator==(const FaceElement&, const FaceElement&) = default;
};
struct LabelElement {
  std::int32_t row = 2, cell = 0;  // of the join that makes this row
  friend bool operator==(const LabelElement&, const LabelElement&) = default;
};
struct VertexElement {
  VertexId vertex = no_vertex;  // of the mesh
  friend bool operator==(const VertexElement&, const VertexElement&) = default;
};
using Element =
    std::variant<StitchElement, RowEdgeElement, ColumnEdgeElement, FaceElement, LabelElement, VertexElement>;

// Whether it is there. In a row in the making a stitch is there once it is kept; a label once it is placed, a
// plain one once the row's labels are planned; a column edge with its face; a vertex of the mesh always.
bool exists(const State& state, const Element& thing);

// Indices of a timeline's steps, as far as it is known.
struct StepRange {
  std::size_t begin = 0, end = 0;
  [[nodiscard]] bool holds(std::size_t step) const { return begin <= step && step < end; }
};
StepRange steps_of_row(const Timeline& timeline, Stage stage, std::int32_t row);
// The deal of this number, from 1, done or in progress; null: neither. Of one in progress the bridge is planned whole.
const Deal* deal_numbered(const State& state, std::int32_t number);
// Of a deal, by its number: from the gaps that are found to the loops that are dealt. None: begin is end.
StepRange steps_of_deal(const Timeline& timeline, std::int32_t deal);
// The stage that makes a row's stitches.
inline Stage stage_of_row(std::int32_t row) { return row <= 1 ? Stage::cast_on : Stage::rows; }

// The step after which it exists and before which it does not; of a vertex: the step that decided on it. None:
// there is no such thing, or not yet.
std::optional<std::size_t> made_by(const Timeline& timeline, const Element& thing);
// The step that picked the vertex of a stitch, before the stitch was kept; none where it was not picked.
std::optional<std::size_t> chosen_by(const Timeline& timeline, const StitchElement& stitch);
// The last step that moved a stitch after it was made: by resampling the row, or by sharing its gap.
std::optional<std::size_t> moved_by(const Timeline& timeline, const StitchElement& stitch);
// The last step that moved stitches, all at once, to where they are at ease. None: they stay where they were placed.
std::optional<std::size_t> settled_by(const Timeline& timeline);
// The step that gave a row its number of stitches.
std::optional<std::size_t> count_decided_by(const Timeline& timeline, std::int32_t row);

// What became of a vertex of the mesh.
enum class Fate : std::uint8_t {
  unused,         // no triangle has it
  no_row,         // its level makes no row
  cut_rows,       // rows are cut through the surface; vertices are no candidates
  cast_on,        // on the cast on's level, whose stitches are spread evenly
  not_yet,        // not worked out so far
  begins_row,     // the first of its ring
  accepted,       // in the band
  taken,          // nothing was in the band, and it was nearest to it
  refused,        // too near or too far
  never_reached,  // the run ended before
};
struct VertexStory {
  Fate fate = Fate::not_yet;
  std::int32_t row = 0;               // that it was a candidate of; 0: none
  std::vector<std::size_t> measured;  // steps that measured it, or took it, rising
  std::optional<std::size_t> decided;
};
// Requires a vertex of the mesh. A copy at the same place that stands in no ring shares its twin's story.
VertexStory story_of(const Timeline& timeline, VertexId vertex);
// Where a vertex stands among tubes, with rows from contours.
struct OnTube {
  TubeId tube = -1;            // -1: on none; it is left out, or on no surface that is knitted
  std::int32_t event = -1;     // of the plan, that stands at it; -1: none
  RowId below = 0, above = 0;  // rows of the tube beside it, as far as they are made; 0: none
};
// None where no tubes are planned. Cost: the pieces of the graph of tubes.
std::optional<OnTube> on_tube(const Timeline& timeline, VertexId vertex);
// The step that gave a vertex its time.
std::optional<std::size_t> timed_by(const Timeline& timeline, VertexId vertex);
// The ring of a row that was picked from the mesh's vertices; null: not yet known, or there is none.
std::shared_ptr<const Ring> ring_of_row(const State& state, std::int32_t row);

// Whether a step had to do with a thing: made, measured, moved or labelled it, or built on it.
bool touches(const Timeline& timeline, const Element& thing, std::size_t step);
// The first such step from `step` on, and the last before it.
std::optional<std::size_t> touch_from(const Timeline& timeline, const Element& thing, std::size_t step);
std::optional<std::size_t> touch_before(const Timeline& timeline, const Element& thing, std::size_t step);

}  // namespace knit
