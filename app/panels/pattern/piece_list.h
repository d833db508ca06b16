// The pieces of a pattern at its head, in working order: their names are typed there, and they are dragged to another order.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/panels/kit/widgets.h"
#include "app/panels/pattern/chart_cache.h"

namespace app {

struct PieceList {
  bool open = true;
  std::uint64_t shown = 0;        // ChartCache::key() of what the fields stand for
  std::vector<TextBuffer> names;  // of each piece
  std::int32_t dragged = -1;      // the piece under the hand; -1: none
  std::int32_t focus = -1;        // the piece whose name is to have the keyboard; -1: as it is
  std::string trouble;            // why a name or an order is refused; empty: nothing is
};

// Requires a pattern in pieces.
void draw_piece_list(PanelFrame& frame, const ChartCache& cache);

// The pieces' letters as in PatternPieces, the piece at `from` taken out and put before the one that stood at `to`, or last.
std::vector<std::string> moved_piece(const PlannedPieces& pieces, std::int32_t from, std::int32_t to);

}  // namespace app
