#include "knit/mesh/surface_windows.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "knit/mesh/elementary.h"

namespace knit {

namespace {

bool later(const WindowEvent& a, const WindowEvent& b) {
  return a.length != b.length ? a.length > b.length : a.number > b.number;
}

// Where the line from (from.x, -from.y) to a point above the x axis crosses the axis.
double axis_crossing(const glm::dvec2& from, const glm::dvec2& to, double without_height) {
  const double height = from.y + to.y;
  return height > 0.0 ? from.x + (to.x - from.x) * (from.y / height) : without_height;
}

}  // namespace

double Window::length_at(double x) const { return before + hypotenuse(x - source.x, source.y); }

double Window::least_length() const { return length_at(std::clamp(source.x, low, high)); }

double Window::least_length_to(double from_origin, double from_end, double side_length) const {
  // Beside a far point a short side is itself a point; what follows would lose too many digits.
  if (!(side_length > 1e-3 * from_origin))
    return least_length() + std::max(0.0, 0.5 * (from_origin + from_end - side_length));
  // Turned about the side's line into its plane, the point keeps its distances from the points of the side.
  const double x = 0.5 * (side_length + (from_origin - from_end) * ((from_origin + from_end) / side_length));
  const double squares = from_origin * from_origin - x * x;
  const double rounding = 1e-15 * (from_origin * from_origin + side_length * side_length);
  const glm::dvec2 point{x, std::sqrt(std::max(0.0, squares - rounding))};
  const double through = std::clamp(axis_crossing(source, point, x), low, high);
  return (length_at(through) + hypotenuse(point.x - through, point.y)) * (1.0 - no_shorter);
}

Window Window::mirrored(double side_length) const {
  return {side, side_length - high, side_length - low, {side_length - source.x, source.y}, before};
}

double crossing_towards(const Window& window, const glm::dvec2& apex) {
  // Should all lie on one line, the side that the source lies on has all the ways.
  constexpr double far = std::numeric_limits<double>::infinity();
  return axis_crossing(window.source, apex, apex.x > window.source.x ? far : -far);
}

Window passed_on(const Window& window, const glm::dvec2& apex, double next_length, double apex_crossing) {
  const glm::dvec2 along = apex / next_length;
  const glm::dvec2 source = window.source;
  const auto hit = [&](double x) {
    if (x <= 0.0) return 0.0;
    if (x >= apex_crossing) return next_length;
    const double slope = along.x * source.y + along.y * (source.x - x);
    return slope > 0.0 ? std::min(x * source.y / slope, next_length) : next_length;
  };
  const glm::dvec2 turned{along.x * source.x - along.y * source.y,
                          std::max(0.0, along.x * source.y + along.y * source.x)};
  return {SurfacePatch::none, hit(window.low), hit(window.high), turned, window.before};
}

void EventQueue::push_window(double length, const Window& window) {
  auto at = static_cast<SurfacePatch::Index>(windows_.size());
  if (free_.empty()) {
    windows_.push_back(window);
  } else {
    at = free_.back();
    free_.pop_back();
    windows_[at] = window;
  }
  push({length, at, SurfacePatch::none, 0});
}

void EventQueue::push_vertex(double length, SurfacePatch::Index vertex) {
  push({length, SurfacePatch::none, vertex, 0});
}

void EventQueue::push(WindowEvent event) {
  event.number = pushed_++;
  events_.push_back(event);
  std::push_heap(events_.begin(), events_.end(), later);
}

std::optional<WindowEvent> EventQueue::pop(double limit) {
  if (events_.empty() || !(events_.front().length < limit)) return {};
  std::pop_heap(events_.begin(), events_.end(), later);
  const WindowEvent event = events_.back();
  events_.pop_back();
  return event;
}

Window EventQueue::take_window(const WindowEvent& event) {
  free_.push_back(event.window);
  return windows_[event.window];
}

void EventQueue::make_heap() { std::make_heap(events_.begin(), events_.end(), later); }

}  // namespace knit
