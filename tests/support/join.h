// What must hold for every join from row to row, whatever placed it.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <span>
#include <vector>

#include "knit/stitches/appendix.h"
#include "knit/stitches/faces.h"
#include "knit/stitches/operations.h"

namespace test_support {

using Cells = std::vector<std::int32_t>;

// What a mirror makes of something along a round: the first stays, the others come in the opposite order.
template <class T>
std::vector<T> round_the_other_way(std::vector<T> round) {
  if (!round.empty()) std::reverse(round.begin() + 1, round.end());
  return round;
}
inline std::vector<knit::Label> mirrored_labels(const std::vector<knit::Label>& labels) {
  using knit::Label;
  std::vector<Label> image = round_the_other_way(labels);
  for (Label& label : image) {
    switch (label) {
      case Label::m1r:
        label = Label::m1l;
        break;
      case Label::m1l:
        label = Label::m1r;
        break;
      case Label::k2tog:
        label = Label::ssk;
        break;
      case Label::ssk:
        label = Label::k2tog;
        break;
      default:
        break;
    }
  }
  return image;
}
inline Cells mirrored_links(const knit::Join& t) {
  const std::int32_t small = std::min(t.below, t.above);
  Cells image = round_the_other_way(t.link);
  for (std::int32_t& stitch : image) stitch = (small - stitch) % small;
  return image;
}

// Each stitch has one or two links, in order, first to first and last to last.
inline bool links_sound(const knit::Join& t) {
  const std::int32_t small = std::min(t.below, t.above);
  if (static_cast<std::int32_t>(t.link.size()) != std::max(t.below, t.above)) return false;
  Cells links(static_cast<std::size_t>(small), 0);
  for (std::size_t cell = 0; cell < t.link.size(); ++cell) {
    const std::int32_t step = cell == 0 ? t.link[cell] : t.link[cell] - t.link[cell - 1];
    if (step < 0 || step > 1 || (cell == 0 && step != 0) || t.link[cell] >= small) return false;
    ++links[static_cast<std::size_t>(t.link[cell])];
  }
  return t.link.back() == small - 1 && *std::max_element(links.begin(), links.end()) <= 2;
}

// Shaping stands on one cell of each doubled stitch and works with the other one.
inline bool labels_agree(const knit::Join& t) {
  std::int32_t shaping = 0;
  for (std::size_t cell = 0; cell < t.labels.size(); ++cell) {
    const auto partner = static_cast<std::size_t>(t.partner[cell]);
    if (!knit::is_shaping(t.labels[cell])) {
      if (partner != cell || (t.labels[cell] != knit::Label::knit && t.labels[cell] != knit::Label::main))
        return false;
      continue;
    }
    ++shaping;
    if (partner + 1 != cell && cell + 1 != partner) return false;
    if (t.link[partner] != t.link[cell] || knit::is_shaping(t.labels[partner])) return false;
    if (t.change() > 0 ? !knit::is_increase(t.labels[cell]) : !knit::is_decrease(t.labels[cell]))
      return false;
  }
  return shaping == std::abs(t.change());
}

inline bool placed_agree(const knit::Join& t) {
  std::vector<knit::Label> labels(t.labels.size(), knit::Label::knit);
  bool mains_over = false;
  for (const knit::PlacedLabel& placed : t.placed) {
    mains_over = mains_over || placed.label != knit::Label::main;
    if (mains_over && placed.label == knit::Label::main) return false;
    labels[static_cast<std::size_t>(placed.cell)] = placed.label;
  }
  return labels == t.labels;
}

inline bool mains_sound(const knit::Join& t, const Cells& below) {
  bool good = !t.mains.empty() && t.mains.front() >= 0 && t.mains.back() < t.above;
  for (std::size_t i = 1; i < t.mains.size(); ++i) good = good && t.mains[i - 1] < t.mains[i];
  return good && (below.empty() ? t.mains.size() <= 6 : t.mains.size() <= below.size());
}

// As if its rows were the first of a piece.
inline knit::Strip strip_of(const knit::Join& t) {
  std::vector<std::uint32_t> path(static_cast<std::size_t>(t.below + t.above));
  std::iota(path.begin(), path.end(), 0U);
  const auto below = static_cast<std::size_t>(t.below);
  return knit::build_strip(t, std::span(path).first(below), std::span(path).subspan(below));
}

// What faces and the written line make of it.
inline bool counts_agree(const knit::Join& t) {
  const knit::Strip strip = strip_of(t);
  std::int32_t quads = 0;
  std::int32_t triangles = 0;
  for (const knit::Face& face : strip.faces) {
    ++(face.corner_count == 4 ? quads : triangles);
    if (knit::is_shaping(face.label) != (face.corner_count == 3)) return false;
  }
  const knit::OperationCount counted = knit::count(knit::operations_of(t));
  return quads == std::min(t.below, t.above) && triangles == std::abs(t.change()) &&
         counted.consumed == t.below && counted.produced == t.above;
}

inline Cells shaping_cells(const knit::Join& t) {
  Cells cells;
  for (std::size_t cell = 0; cell < t.labels.size(); ++cell)
    if (knit::is_shaping(t.labels[cell])) cells.push_back(static_cast<std::int32_t>(cell));
  return cells;
}

}  // namespace test_support
