// The chart as a drawing: scalable, black on white, for paper.
//
// Rows go bottom to top and from right to left; row numbers stand at the right, stitch counts at the left.
// Strokes lean as the stitches do. Every symbol is a <use> of a shape defined once: #knit-m1r, #knit-m1l,
// #knit-k2tog, #knit-ssk, #knit-cast-on, #knit-bind-off; a rectangle of class "none" is a run
// of grey squares in a row, one of class "main" the tint of a run of main squares in a column. The drawing's
// unit is a millimetre, inside the grid a square.
#pragma once

#include <string>
#include <vector>

#include "knit/pattern/chart.h"

namespace app {

struct ChartLook {
  std::string title;  // empty: none
  bool key = true;
  bool tint_mains = true;
  double largest_square_mm = 5.0;
  // A chart is made smaller to fit into this, but never below the smallest square.
  double fit_width_mm = 180.0;
  double fit_height_mm = 255.0;
  double smallest_square_mm = 1.5;
  // Of several drawings on one page.
  std::vector<const knit::Chart*> all;  // whose symbols this one defines, and its key tells; empty: its own
  bool borrows = false;                 // another drawing of the page defines them
  bool small_title = false;
  // Of a part of a chart: the whole, whose rounds are told; null: it is whole. Counts stand beside the last part.
  const knit::Chart* whole = nullptr;
  bool counts = true;
  bool broken = false;  // some chart of the page is in parts
};

// A document of its own, which HTML can also hold as it is. Without an XML declaration; text is UTF-8.
std::string chart_svg(const knit::Chart& chart, const ChartLook& look);

// Charts of pieces, each under its name, packed on a sheet of that width with one key; squares are equally large on all, and as
// large as the sheet's height lets them be. Where that makes them too small to read, wide charts are broken between columns, and
// their parts, of whole tens where they can be, follow each other.
struct NamedChart {
  std::string name;
  const knit::Chart* chart = nullptr;
};
struct SheetLook {
  std::string title;  // empty: none
  double width_mm = 180.0, height_mm = 246.0;
  double largest_square_mm = 4.0, smallest_square_mm = 1.5;
};
// For a page; where squares are larger on one put sideways, for that.
bool is_wide(const std::vector<NamedChart>& charts);
SheetLook sheet_for(const std::vector<NamedChart>& charts);
// One drawing.
std::string charts_svg(const std::vector<NamedChart>& charts, const SheetLook& look);
// For a page: a drawing for each chart, that lines may be broken between, and the key as the last.
std::vector<std::string> charts_svgs(const std::vector<NamedChart>& charts, const SheetLook& look);

// Whether the chart is easier to read on a sheet put sideways.
bool is_wide(const knit::Chart& chart);

}  // namespace app
