#include "knit/mesh/box_tree.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "knit/mesh/closest_point.h"

namespace knit {

namespace {

constexpr std::size_t boxes_in_one = 8;

// Squared; 0 within.
double square_beside(const glm::dvec3& point, const glm::dvec3& low, const glm::dvec3& high) {
  const glm::dvec3 beside = glm::max(glm::max(low - point, point - high), glm::dvec3(0.0));
  return glm::dot(beside, beside);
}

}  // namespace

struct BoxTree::Search {
  glm::dvec3 point;
  SurfacePlace found;
  double least = std::numeric_limits<double>::infinity();  // squared
};

BoxTree::BoxTree(const Input& input) : input_(&input), levels_{input.boxes} {
  while (levels_.back().size() > 1) {
    const std::vector<Input::Box>& below = levels_.back();
    std::vector<Input::Box> around;
    around.reserve(below.size() / boxes_in_one + 1);
    for (std::size_t i = 0; i < below.size(); ++i) {
      if (i % boxes_in_one == 0) around.push_back(below[i]);
      Input::Box& box = around.back();
      box = {glm::min(box.low, below[i].low), glm::max(box.high, below[i].high)};
    }
    levels_.push_back(std::move(around));
  }
}

SurfacePlace BoxTree::nearest(const glm::dvec3& point) {
  Search search{point, {}};
  look_below(levels_.size() - 1, 0, search);
  return search.found;
}

// From the nearest box to the farthest that may hold what is as near.
void BoxTree::look_below(std::size_t level, std::size_t box, Search& search) {
  if (level == 0) return look_at_triangles(box, search);
  const std::vector<Input::Box>& below = levels_[level - 1];
  const std::size_t first = box * boxes_in_one, count = std::min(boxes_in_one, below.size() - first);
  struct Near {
    double square;
    std::size_t box;
  };
  std::array<Near, boxes_in_one> order{};
  for (std::size_t i = 0; i < count; ++i) {
    const Near next{square_beside(search.point, below[first + i].low, below[first + i].high), first + i};
    std::size_t at = i;
    for (; at > 0 && next.square < order.at(at - 1).square; --at) order.at(at) = order.at(at - 1);
    order.at(at) = next;
  }
  for (std::size_t i = 0; i < count && order.at(i).square <= search.least; ++i)
    look_below(level - 1, order.at(i).box, search);
}

void BoxTree::look_at_triangles(std::size_t box, Search& search) {
  const Mesh& mesh = input_->mesh;
  const std::size_t end = std::min((box + 1) * Input::boxed, mesh.triangles.size());
  for (std::size_t t = box * Input::boxed; t < end; ++t) {
    const auto& [i, j, k] = mesh.triangles[t];
    const glm::dvec3 &a = mesh.positions[i], &b = mesh.positions[j], &c = mesh.positions[k];
    ++tried_;
    if (square_beside(search.point, glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))) > search.least)
      continue;
    const glm::dvec3 place = closest_on_triangle(search.point, {a, b, c});
    const double square = glm::dot(place - search.point, place - search.point);
    const auto number = static_cast<std::uint32_t>(t);
    if (square > search.least || (square == search.least && number > search.found.triangle)) continue;
    search.found = {number, place};
    search.least = square;
  }
}

}  // namespace knit
