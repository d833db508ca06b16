#include "app/describe/chart_strokes.h"

#include <algorithm>

#include "app/base/text.h"

namespace app {

namespace {

// ".28": SVG needs no zero before the point.
std::string short_text(double value) {
  std::string text = fixed_text(value, 2);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text.size() > 1 && text.front() == '0' ? text.substr(1) : text;
}

std::string text_of(const ChartPoint& point) { return short_text(point.x) + " " + short_text(point.y); }

}  // namespace

const ChartShape& shape_of(knit::ChartSymbol symbol) {
  return *std::find_if(chart_shapes.begin(), chart_shapes.end(),
                       [&](const ChartShape& shape) { return shape.symbol == symbol; });
}

std::string svg_path(std::span<const ChartStroke> strokes) {
  std::string path;
  const ChartStroke* before = nullptr;
  for (const ChartStroke& stroke : strokes) {
    if (before == nullptr || before->to != stroke.from) path += "M" + text_of(stroke.from);
    path += stroke.bend ? "Q" + text_of(*stroke.bend) + " " : "L";
    path += text_of(stroke.to);
    before = &stroke;
  }
  return path;
}

}  // namespace app
