#include "knit/stitches/faces.h"

#include "knit/fabric/edges.h"

namespace knit {

namespace {

Label triangle_label(const Join& t, std::size_t cell, std::size_t next) {
  const auto works_with = [&](std::size_t a, std::size_t b) {
    return is_shaping(t.labels[a]) && t.partner[a] == static_cast<std::int32_t>(b);
  };
  return works_with(cell, next) ? t.labels[cell] : t.labels[next];
}

}  // namespace

Strip build_strip(const Join& join, std::span<const std::uint32_t> below,
                  std::span<const std::uint32_t> above,
                  const std::optional<std::array<std::uint32_t, 2>>& beside) {
  const bool larger_above = cells_above(join);
  const auto larger = larger_above ? above : below;
  const auto smaller = larger_above ? below : above;
  const auto hangs_on = [&](std::size_t cell) { return smaller[static_cast<std::size_t>(join.link[cell])]; };
  Strip strip;
  strip.to = join.to;
  const std::size_t cells = join.labels.size();
  strip.faces.reserve(cells);
  strip.column_edges.reserve(cells);
  for (std::size_t cell = 0; cell < cells; ++cell) {
    const std::uint32_t b = larger[cell], s = hangs_on(cell);
    strip.column_edges.push_back(larger_above ? std::array{s, b} : std::array{b, s});
  }
  for (const auto& [cell, next] : Edges(cells, join.from.closed)) {
    const std::uint32_t b = larger[cell], b_next = larger[next];
    const std::uint32_t s = hangs_on(cell), s_next = hangs_on(next);
    Face face;
    face.cell = static_cast<std::int32_t>(cell);
    if (s == s_next) {
      face.corner_count = 3;
      face.label = triangle_label(join, cell, next);
      face.corners = larger_above ? std::array{s, b, b_next, 0U} : std::array{b, s, b_next, 0U};
    } else {
      face.label = join.labels[cell] == Label::main ? Label::main : Label::knit;
      face.corners = larger_above ? std::array{s, b, b_next, s_next} : std::array{b, s, s_next, b_next};
    }
    strip.faces.push_back(face);
  }
  if (beside) {
    const auto last = static_cast<std::int32_t>(cells) - 1;
    strip.faces.push_back({{below.back(), above.back(), beside->back(), 0U}, 3, last, Label::turn_left});
    strip.faces.push_back({{beside->front(), above.front(), below.front(), 0U}, 3, 0, Label::turn_right});
  }
  return strip;
}

Strip build_strip(const Fabric& fabric, const Join& join) {
  const Row& row = fabric.row(join.to);
  std::optional<std::array<std::uint32_t, 2>> beside;
  if (is_short(row))
    beside = std::array{fabric.path_index(row.turned->before), fabric.path_index(row.turned->after)};
  return build_strip(join, fabric.path_indices(join.from), fabric.path_indices(all_of(row)), beside);
}

}  // namespace knit
