// The written pattern as one page to print: no other file is needed.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "knit/chart.h"
#include "knit/written_pattern.h"

namespace app {

// The parts in the order of the written pattern, then the chart. Each round line is one <li class="round">,
// its text exactly RoundLine::text(). `picture_png`: of the finished object; may be empty.
std::string pattern_html(const knit::WrittenPattern& pattern, const knit::Chart& chart,
                         std::span<const std::uint8_t> picture_png = {});

}  // namespace app
