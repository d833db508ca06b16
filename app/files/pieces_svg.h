// A picture of the pieces of a pattern with limbs, in working order: a box each, lower pieces lower, with its name, its rounds,
// and its stitches at both ends; a line for stitches that go from one piece to another, thick where the yarn goes on with
// them; a holder, with the letter that it goes by, where they wait; thin arrows from each piece to the one worked next.
//
// Boxes stand in layers: a piece above all those that it stands on. Within a layer they are put in order by where their
// neighbours stand, a few times up and down, and then moved towards them without touching. O(pieces^2).
#pragma once

#include <string>
#include <vector>

#include "knit/limbs/limb_plan.h"
#include "knit/pattern/limb_words.h"

namespace app {

struct PieceBox {
  double x = 0.0, y = 0.0;  // of the box's upper left corner, millimetres, y down
  std::int32_t layer = 0;   // from below
};
struct PieceThread {
  std::int32_t from = 0, to = 0;  // pieces
  std::int32_t stitches = 0;
  std::int32_t holder =
      -1;                // the piece that the holder goes by on which they wait; -1: they stay on the needle
  bool goes_on = false;  // with the yarn
  bool grafted = false;  // upper end to upper end
};
struct PiecesLayout {
  std::vector<PieceBox> places;  // of each piece
  std::vector<PieceThread> threads;
  double width = 0.0, height = 0.0;
};
inline constexpr double piece_box_width = 25.0, piece_box_height = 15.0;
PiecesLayout layout_of(const knit::LimbPlan& plan);

// A document of its own, which HTML can also hold as it is.
std::string pieces_svg(const knit::LimbPlan& plan, const knit::LimbNames& names,
                       const std::string& title = {});

}  // namespace app
