// The chart's symbols as strokes: one list for the drawing on paper and for the chart in the window.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "knit/pattern/chart.h"

namespace app {

// In a square of side 1, from its upper left corner, y down.
struct ChartPoint {
  double x, y;
  friend bool operator==(const ChartPoint&, const ChartPoint&) = default;
};
// A straight line, or one bent towards a point (a quadratic Bezier curve).
struct ChartStroke {
  ChartPoint from, to;
  std::optional<ChartPoint> bend = std::nullopt;
};

namespace chart_strokes {
inline constexpr std::array<ChartStroke, 2> m1r{{{{.28, .84}, {.80, .18}}, {{.52, .54}, {.24, .20}}}};
inline constexpr std::array<ChartStroke, 2> m1l{{{{.72, .84}, {.20, .18}}, {{.48, .54}, {.76, .20}}}};
inline constexpr std::array<ChartStroke, 1> k2tog{{{{.20, .82}, {.80, .18}}}};
inline constexpr std::array<ChartStroke, 1> ssk{{{{.80, .82}, {.20, .18}}}};
// A loop on the needle, and one drawn over.
inline constexpr std::array<ChartStroke, 4> cast_on{{{{.26, .30}, {.26, .50}},
                                                     {{.26, .50}, {.50, .74}, ChartPoint{.26, .74}},
                                                     {{.50, .74}, {.74, .50}, ChartPoint{.74, .74}},
                                                     {{.74, .50}, {.74, .30}}}};
inline constexpr std::array<ChartStroke, 1> bind_off{{{{.20, .64}, {.80, .64}, ChartPoint{.50, .16}}}};
// Of pieces with limbs: a point; an arrow up; a bar; two waves.
inline constexpr std::array<ChartStroke, 1> kept{{{{.44, .50}, {.56, .50}}}};
inline constexpr std::array<ChartStroke, 3> picked_up{
    {{{.50, .82}, {.50, .20}}, {{.28, .44}, {.50, .20}}, {{.50, .20}, {.72, .44}}}};
inline constexpr std::array<ChartStroke, 1> on_holder{{{{.20, .50}, {.80, .50}}}};
inline constexpr std::array<ChartStroke, 2> grafted{
    {{{.18, .40}, {.82, .40}, ChartPoint{.50, .14}}, {{.18, .66}, {.82, .66}, ChartPoint{.50, .92}}}};
// Of short rows: a V, and a hook from the row's end up and back.
inline constexpr std::array<ChartStroke, 2> marked{{{{.24, .22}, {.50, .80}}, {{.50, .80}, {.76, .22}}}};
inline constexpr std::array<ChartStroke, 3> turn_left{
    {{{.86, .62}, {.52, .62}}, {{.52, .62}, {.52, .16}, ChartPoint{.22, .39}}, {{.52, .16}, {.80, .16}}}};
inline constexpr std::array<ChartStroke, 3> turn_right{
    {{{.14, .62}, {.48, .62}}, {{.48, .62}, {.48, .16}, ChartPoint{.78, .39}}, {{.48, .16}, {.20, .16}}}};
}  // namespace chart_strokes

struct ChartShape {
  knit::ChartSymbol symbol;
  std::string_view id;                   // in SVG; empty: a blank square
  std::span<const ChartStroke> strokes;  // in drawing order
};
// In the key's order.
inline constexpr std::array<ChartShape, 16> chart_shapes{{
    {knit::ChartSymbol::knit, "", {}},
    {knit::ChartSymbol::m1r, "knit-m1r", chart_strokes::m1r},
    {knit::ChartSymbol::m1l, "knit-m1l", chart_strokes::m1l},
    {knit::ChartSymbol::k2tog, "knit-k2tog", chart_strokes::k2tog},
    {knit::ChartSymbol::ssk, "knit-ssk", chart_strokes::ssk},
    {knit::ChartSymbol::cast_on, "knit-cast-on", chart_strokes::cast_on},
    {knit::ChartSymbol::bind_off, "knit-bind-off", chart_strokes::bind_off},
    {knit::ChartSymbol::kept, "knit-kept", chart_strokes::kept},
    {knit::ChartSymbol::held, "", {}},  // a letter
    {knit::ChartSymbol::picked_up, "knit-picked-up", chart_strokes::picked_up},
    {knit::ChartSymbol::on_holder, "knit-on-holder", chart_strokes::on_holder},
    {knit::ChartSymbol::grafted, "knit-grafted", chart_strokes::grafted},
    {knit::ChartSymbol::marked, "knit-marked", chart_strokes::marked},
    {knit::ChartSymbol::turn_left, "knit-turn-left", chart_strokes::turn_left},
    {knit::ChartSymbol::turn_right, "knit-turn-right", chart_strokes::turn_right},
    {knit::ChartSymbol::no_stitch, "", {}},
}};
const ChartShape& shape_of(knit::ChartSymbol symbol);

// As the data of an SVG path: "M.28 .84L.8 .18M.52 .54L.24 .2".
std::string svg_path(std::span<const ChartStroke> strokes);

}  // namespace app
