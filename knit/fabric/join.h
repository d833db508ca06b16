// From the stitches that a row is worked on to the row: a label and a link for each stitch of the larger side.
//
// The cells of a join are the stitches of its larger side: of the row when it grows, of what it is worked on when
// it shrinks. Every cell has one link, to a stitch of the smaller side; links rise, and every stitch of the smaller
// side has one or two. So the takes of all stitches made add up to what was live, and there are as many shaping
// labels as the row grows or shrinks by. A short row takes and makes one stitch a cell.
#pragma once

#include <optional>
#include <vector>

#include "knit/fabric/live_stitches.h"
#include "knit/model/label.h"

namespace knit {

struct PlacedLabel {
  std::int32_t cell = 0;
  Label label = Label::knit;
  [[nodiscard]] auto fields() const { return std::tie(cell, label); }
  friend bool operator==(const PlacedLabel&, const PlacedLabel&) = default;
};

struct Join {
  TubeId tube = 0;
  RowId to = 2;                       // the row it makes
  LiveStitches from;                  // what it takes; none where only sizes were planned
  std::int32_t below = 0, above = 0;  // stitches taken and made
  Rule rule = Rule::plain;
  std::optional<Rule> tried;  // the rule that would have applied, had its sections had room
  std::int32_t spacing = 0, remainder = 0;
  std::vector<Label> labels;          // max(below, above) cells
  std::vector<PlacedLabel> placed;    // mains and shaping in the order of placing
  std::vector<std::int32_t> mains;    // stitches of the row made that are mains
  std::vector<std::int32_t> partner;  // per cell: the cell a shaping label works with, else the cell itself
  std::vector<std::int32_t> link;     // per cell: its stitch in the smaller side
  double sum_of_squares = 0.0;        // nearest: of the lengths of its wale edges
  double longest_square = 0.0;
  [[nodiscard]] std::int32_t change() const { return above - below; }
  [[nodiscard]] auto fields() const {
    return std::tie(tube, to, from, below, above, rule, tried, spacing, remainder, labels, placed, mains,
                    partner, link, sum_of_squares, longest_square);
  }
  friend bool operator==(const Join&, const Join&) = default;
};

// Cells are of the row made, not of what it is worked on.
inline bool cells_above(const Join& join) { return join.above >= join.below; }

// The stitches that a cell's column edge joins: one of those below, one of the row.
struct CellEnds {
  std::int32_t below = -1, above = -1;
};
inline CellEnds ends_of(const Join& join, std::int32_t cell) {
  const std::int32_t link = join.link[static_cast<std::size_t>(cell)];
  return cells_above(join) ? CellEnds{link, cell} : CellEnds{cell, link};
}

// The cell that a face of the strip stands beside; a short row's last is the turn at its first stitch.
inline std::int32_t cell_of_face(const Join& join, std::int32_t face) {
  return face < static_cast<std::int32_t>(join.link.size()) ? face : 0;
}

// The cell beside it, round and round; at the end of a short row, the cell itself.
inline std::int32_t next_cell(const Join& join, std::int32_t cell) {
  const auto cells = static_cast<std::int32_t>(join.link.size());
  if (!join.from.closed && cell + 1 == cells) return cell;
  return (cell + 1) % cells;
}

}  // namespace knit
