// The chart as characters, for the plain documents: one a square, under its key, bottom to top and right to left.
//
// Plain knitting is blank and grey squares are dotted, as on the drawing, so that the shaping stands out. The
// section holds no line that a reader of patterns could take for a round, a cast on or an end.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "knit/chart.h"

namespace knit {

// What a square means: a character and words. The key of every form of the chart speaks these words.
struct ChartSign {
  ChartSymbol symbol;
  char sign;
  std::string_view meaning;
};
inline constexpr std::array<ChartSign, 8> chart_signs{{
    {ChartSymbol::knit, ' ', "k: knit"},
    {ChartSymbol::m1r, 'R', "m1r: make 1 right"},
    {ChartSymbol::m1l, 'L', "m1l: make 1 left"},
    {ChartSymbol::k2tog, '/', "k2tog: knit 2 together"},
    {ChartSymbol::ssk, '\\', "ssk: slip, slip, knit"},
    {ChartSymbol::cast_on, 'o', "CO: cast on"},
    {ChartSymbol::bind_off, '=', "BO: bind off or close up"},
    {ChartSymbol::no_stitch, ':', "no stitch: skip it"},
}};
const ChartSign& sign_of(ChartSymbol symbol);

// A wider chart is no use as text.
inline constexpr std::int32_t widest_text_chart = 100;

// The document's last section, with an empty line before it. Of a chart that is too wide it says where the
// chart is to be had.
std::string chart_as_text(const Chart& chart);
std::string chart_as_markdown(const Chart& chart);

}  // namespace knit
