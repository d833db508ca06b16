// The written pattern as one page to print: no other file is needed.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "knit/pattern/chart.h"
#include "knit/pattern/written_pattern.h"

namespace app {

// The parts in the order of the written pattern, then the chart, if it has rows. Each round line is one <li class="round">,
// its text exactly RoundLine::text(). `picture_png`: of the finished object; may be empty.
std::string pattern_html(const knit::WrittenPattern& pattern, const knit::Chart& chart,
                         std::span<const std::uint8_t> picture_png = {});

// Of a pattern in pieces: their picture (pieces_svg.h), and their charts with the key (charts_svgs of chart_svg.h).
struct PiecesArt {
  std::string picture_svg;
  std::vector<std::string> chart_svgs;
  bool wide = false;  // on sheets put sideways
};
std::string pattern_html(const knit::WrittenPattern& pattern, const PiecesArt& art,
                         std::span<const std::uint8_t> picture_png = {});

}  // namespace app
