// The grid of the chart's drawing: symbols, squares, lines. Part of chart_svg.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "knit/chart.h"

namespace app {

// Strokes of a symbol in a square of side 1, y down; empty: a blank square.
struct ChartShape {
  knit::ChartSymbol symbol;
  std::string_view id, path, meaning;
};
inline constexpr std::array<ChartShape, 8> chart_shapes{{
    {knit::ChartSymbol::knit, "", "", "k: knit"},
    {knit::ChartSymbol::m1r, "knit-m1r", "M.28 .84L.8 .18M.52 .54L.24 .2", "m1r: make 1 right"},
    {knit::ChartSymbol::m1l, "knit-m1l", "M.72 .84L.2 .18M.48 .54L.76 .2", "m1l: make 1 left"},
    {knit::ChartSymbol::k2tog, "knit-k2tog", "M.2 .82L.8 .18", "k2tog: knit 2 together"},
    {knit::ChartSymbol::ssk, "knit-ssk", "M.8 .82L.2 .18", "ssk: slip, slip, knit"},
    {knit::ChartSymbol::cast_on, "knit-cast-on", "M.26 .3V.5A.24 .24 0 0 0 .74 .5V.3", "CO: cast on"},
    {knit::ChartSymbol::bind_off, "knit-bind-off", "M.2 .64Q.5 .16 .8 .64", "BO: bind off or close up"},
    {knit::ChartSymbol::no_stitch, "", "", "no stitch: skip it"},
}};

namespace chart_colour {
inline constexpr std::string_view grey = "#dadada";
inline constexpr std::string_view main_tint = "#f9e4f0";
}  // namespace chart_colour

// The squares with what is in them, a square being 1 x 1 and the top left corner 0, 0.
std::string chart_squares(const knit::Chart& chart, bool tint_mains);

}  // namespace app
