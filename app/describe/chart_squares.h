// The grid of the chart's drawing: symbols, squares, lines. Part of chart_svg.
#pragma once

#include <string>
#include <string_view>

#include "app/describe/chart_strokes.h"
#include "knit/pattern/chart.h"

namespace app {

namespace chart_colour {
inline constexpr std::string_view grey = "#dadada";
inline constexpr std::string_view main_tint = "#f9e4f0";
inline constexpr std::string_view laid_tint = "#eef3f8";  // rows that knit nothing
}  // namespace chart_colour

// The squares with what is in them, a square being 1 x 1 and the top left corner 0, 0.
std::string chart_squares(const knit::Chart& chart, bool tint_mains);

}  // namespace app
