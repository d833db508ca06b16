#include "knit/yarn/yarn_pen.h"

#include <glm/geometric.hpp>
#include <utility>

namespace knit {

void YarnPen::begin() {
  curves_.emplace_back();
  curves_.back().radius = radius_;
  joined_ = false;
  bars_.clear();
}

void YarnPen::put(const glm::dvec3& point, std::uint32_t stitch, YarnPart part) {
  YarnCurve& curve = curves_.back();
  curve.points.push_back(point);
  curve.stitches.push_back(stitch);
  curve.parts.push_back(part);
}

void YarnPen::add(const std::vector<glm::dvec3>& points, std::uint32_t stitch, YarnPart part) {
  if (joined_ && glm::distance(curves_.back().points.back(), points.front()) > far_) {
    begin();
    ++cuts_;
  }
  if (!joined_) {
    put(points.front(), stitch, part);
  } else if (bars_.empty()) {
    YarnCurve& curve = curves_.back();
    curve.points.back() = 0.5 * (curve.points.back() + points.front());
    curve.stitches.back() = stitch;
    curve.parts.back() = part;
  } else {
    const Bar& bar = bars_.back();
    curves_.back().points.back() -= bar.aside;
    for (std::size_t i = 1; i + 1 < bar.points.size(); ++i) put(bar.points[i], bar.stitch, YarnPart::bar);
    put(points.front() + bar.aside, stitch, part);
  }
  bars_.clear();
  for (std::size_t i = 1; i < points.size(); ++i) put(points[i], stitch, part);
  joined_ = true;
}

void YarnPen::add_bar(std::vector<glm::dvec3> points, const glm::dvec3& aside, std::uint32_t stitch) {
  bars_.push_back({std::move(points), aside, stitch});
}

std::vector<YarnCurve> YarnPen::take() {
  std::erase_if(curves_, [](const YarnCurve& curve) { return curve.points.empty(); });
  return std::move(curves_);
}

}  // namespace knit
