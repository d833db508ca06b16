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

BoxTree::BoxTree(const Input& input)
    : positions_(input.mesh.positions),
      triangles_(input.mesh.triangles),
      boxed_(Input::boxed),
      levels_{input.boxes} {
  put_boxes_around();
}

BoxTree::BoxTree(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles)
    : positions_(positions), triangles_(triangles), boxed_(boxes_in_one), levels_(1) {
  std::vector<Input::Box>& boxes = levels_.front();
  boxes.reserve(triangles.size() / boxed_ + 1);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    if (t % boxed_ == 0) boxes.push_back({positions[a], positions[a]});
    Input::Box& box = boxes.back();
    box = {glm::min(box.low, glm::min(positions[a], glm::min(positions[b], positions[c]))),
           glm::max(box.high, glm::max(positions[a], glm::max(positions[b], positions[c])))};
  }
  put_boxes_around();
}

void BoxTree::put_boxes_around() {
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

SurfacePlace BoxTree::nearest(const glm::dvec3& point, std::uint32_t guess) {
  Search search{point, {guess, {}}};
  look_at(guess, search);
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
  const std::size_t end = std::min((box + 1) * boxed_, triangles_.size());
  for (std::size_t t = box * boxed_; t < end; ++t) look_at(static_cast<std::uint32_t>(t), search);
}

void BoxTree::look_at(std::uint32_t triangle, Search& search) {
  const auto& [i, j, k] = triangles_[triangle];
  const glm::dvec3 &a = positions_[i], &b = positions_[j], &c = positions_[k];
  ++tried_;
  if (square_beside(search.point, glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))) > search.least)
    return;
  const glm::dvec3 place = closest_on_triangle(search.point, {a, b, c});
  const double square = glm::dot(place - search.point, place - search.point);
  if (square > search.least || (square == search.least && triangle > search.found.triangle)) return;
  search.found = {triangle, place};
  search.least = square;
}

}  // namespace knit
