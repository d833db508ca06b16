#include "knit/stitches/faces.h"

namespace knit {

namespace {

Label triangle_label(const Transition& t, std::size_t cell, std::size_t next) {
  const auto works_with = [&](std::size_t a, std::size_t b) {
    return is_shaping(t.labels[a]) && t.partner[a] == static_cast<std::int32_t>(b);
  };
  return works_with(cell, next) ? t.labels[cell] : t.labels[next];
}

}  // namespace

Strip build_strip(const Transition& t, std::uint32_t first_below) {
  const std::uint32_t first_above = first_below + static_cast<std::uint32_t>(t.below);
  const bool larger_above = t.above >= t.below;
  const std::uint32_t larger = larger_above ? first_above : first_below;
  const std::uint32_t smaller = larger_above ? first_below : first_above;
  Strip strip;
  strip.row = t.row;
  const std::size_t cells = t.labels.size();
  strip.faces.reserve(cells);
  strip.column_edges.reserve(cells);
  for (std::size_t cell = 0; cell < cells; ++cell) {
    const std::size_t next = (cell + 1) % cells;
    const std::uint32_t b = larger + static_cast<std::uint32_t>(cell);
    const std::uint32_t b_next = larger + static_cast<std::uint32_t>(next);
    const std::uint32_t s = smaller + static_cast<std::uint32_t>(t.link[cell]);
    const std::uint32_t s_next = smaller + static_cast<std::uint32_t>(t.link[next]);
    strip.column_edges.push_back(larger_above ? std::array{s, b} : std::array{b, s});

    Face face;
    face.cell = static_cast<std::int32_t>(cell);
    if (s == s_next) {
      face.corner_count = 3;
      face.label = triangle_label(t, cell, next);
      face.corners = larger_above ? std::array{s, b, b_next, 0U} : std::array{b, s, b_next, 0U};
    } else {
      face.label = t.labels[cell] == Label::main ? Label::main : Label::knit;
      face.corners = larger_above ? std::array{s, b, b_next, s_next} : std::array{b, s, s_next, b_next};
    }
    strip.faces.push_back(face);
  }
  return strip;
}

}  // namespace knit
