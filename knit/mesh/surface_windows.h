// Windows: bundles of straight ways along a surface, unfolded; and the queue of what a search has yet to do.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "knit/mesh/surface_patch.h"

namespace knit {

// As a part of a length: what is shorter by less is no shorter. Rounding must not decide between equals.
inline constexpr double no_shorter = 1e-12;

// The straight ways that enter a face by `side`. With the side on the x axis from its origin onwards and the
// face above, they cross it from x = low to high and come from (source.x, -source.y), where each is already
// `before` long.
struct Window {
  SurfacePatch::Index side = SurfacePatch::none;
  double low = 0.0, high = 0.0;
  glm::dvec2 source{0.0};  // y >= 0
  double before = 0.0;

  [[nodiscard]] double length_at(double x) const;
  [[nodiscard]] double least_length() const;
  // Not more than any way through the window and on through space to a point, given how far that is from the
  // side's origin and end.
  [[nodiscard]] double least_length_to(double from_origin, double from_end, double side_length) const;
  // The same seen from the side's end.
  [[nodiscard]] Window mirrored(double side_length) const;
};

// Where the line from the window's source to the apex crosses the side.
double crossing_towards(const Window& window, const glm::dvec2& apex);

// What of the window goes on through the next side, which leads from the origin to the apex; measured along
// that side, as of the face that is left.
Window passed_on(const Window& window, const glm::dvec2& apex, double next_length, double apex_crossing);

struct WindowEvent {
  double length = 0.0;  // nothing that comes of it is shorter
  SurfacePatch::Index window = SurfacePatch::none;
  SurfacePatch::Index vertex = SurfacePatch::none;  // instead of a window
  std::size_t number = 0;                           // of equally short ones the earlier comes first
};

// Events, the shortest first.
class EventQueue {
 public:
  void push_window(double length, const Window& window);
  void push_vertex(double length, SurfacePatch::Index vertex);
  // The shortest event, if it is shorter than `limit`.
  std::optional<WindowEvent> pop(double limit);
  [[nodiscard]] const Window& window(const WindowEvent& event) const { return windows_[event.window]; }
  Window take_window(const WindowEvent& event);
  // Measures every event anew.
  template <class Length>
  void reorder(Length length_of) {
    for (WindowEvent& event : events_) event.length = length_of(event);
    make_heap();
  }
  void clear() { *this = {}; }

 private:
  void push(WindowEvent event);
  void make_heap();
  std::vector<WindowEvent> events_;
  std::size_t pushed_ = 0;
  std::vector<Window> windows_;
  std::vector<SurfacePatch::Index> free_;  // of windows_
};

}  // namespace knit
