#include "knit/stitches/stitch_index.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <utility>

#include "knit/stitches/links.h"

namespace knit {

namespace {

struct Sizes {
  std::int32_t small, big, shaping, wanted;  // wanted: mains
  bool grows;
};

Sizes sizes_of(std::int32_t below, std::int32_t above) {
  return {std::min(below, above), std::max(below, above), std::abs(above - below), mains_wanted(below, above),
          above > below};
}

// A spacing rule's result: the cells of the mains.
struct Spacing {
  Rule rule = Rule::plain;
  std::vector<std::int32_t> mains;
  std::int32_t step = 0, remainder = 0;
};

// Shaping that main i brings with it: two, but the last main's M1L (in the section before) is left out when
// id is odd.
std::int32_t own_shaping(const Sizes& sizes, std::int32_t i) {
  return sizes.shaping % 2 == 1 && i == std::max(sizes.wanted - 2, 0) ? 1 : 2;
}

Spacing space_equal(const Sizes& s) {
  Spacing spacing{Rule::equal, {}, s.big / s.wanted, s.big % s.wanted};
  for (std::int32_t cell = 0; cell < s.big; cell += spacing.step) spacing.mains.push_back(cell);
  return spacing;
}

Spacing space_follow(const Sizes& s, std::span<const std::int32_t> mains) {
  const std::int32_t every = static_cast<std::int32_t>(mains.size()) / s.wanted;
  Spacing spacing{Rule::follow, {}, every, static_cast<std::int32_t>(mains.size()) % s.wanted};
  std::int32_t moved = 0;
  for (std::int32_t i = 0; i < s.wanted; ++i) {
    spacing.mains.push_back(mains[static_cast<std::size_t>(i * every)] + moved);
    if (s.grows) moved += own_shaping(s, i);
  }
  return spacing;
}

Spacing space_remainder_last(const Sizes& s) {
  Spacing spacing{Rule::remainder_last, {}, s.small / s.wanted + 2, s.small % s.wanted};
  for (std::int32_t i = 0; i < s.wanted; ++i) spacing.mains.push_back(i * spacing.step);
  if (s.wanted > 1) spacing.mains.back() += spacing.remainder;
  return spacing;
}

Spacing space_even(const Sizes& s) {
  Spacing spacing{Rule::even, {}, s.small / s.wanted, s.small % s.wanted};
  std::int32_t cell = 0;
  for (std::int32_t i = 0; i < s.wanted; ++i) {
    spacing.mains.push_back(cell);
    cell += (i + 1) * s.small / s.wanted - i * s.small / s.wanted + own_shaping(s, i);
  }
  return spacing;
}

std::pair<Label, Label> labels_after_and_before(bool grows) {
  return grows ? std::pair{Label::m1r, Label::m1l} : std::pair{Label::ssk, Label::k2tog};
}

// Mains, then the labels after each of them, then those before, until the shaping is used up.
std::vector<PlacedLabel> place_around(const Spacing& spacing, const Sizes& s) {
  std::vector<PlacedLabel> placed;
  std::vector<std::uint8_t> taken(static_cast<std::size_t>(s.big), 0);
  for (const std::int32_t cell : spacing.mains) {
    if (cell < 0 || cell >= s.big) return {};
    placed.push_back({cell, Label::main});
    taken[static_cast<std::size_t>(cell)] = 1;
  }
  const auto [after, before] = labels_after_and_before(s.grows);
  std::int32_t count = 0;
  const auto place = [&](std::int32_t cell, Label label) {
    const std::int32_t wrapped = (cell + s.big) % s.big;
    if (count == s.shaping || taken[static_cast<std::size_t>(wrapped)] != 0) return;
    taken[static_cast<std::size_t>(wrapped)] = 1;
    placed.push_back({wrapped, label});
    ++count;
  };
  for (const std::int32_t cell : spacing.mains) place(cell + 1, after);
  for (const std::int32_t cell : spacing.mains) place(cell - 1, before);
  return placed;
}

// R0: a main for each stitch of the smaller row, the shaping spread among them, leaning in turn.
std::vector<PlacedLabel> place_dense(const Sizes& s) {
  const auto [after, before] = labels_after_and_before(s.grows);
  std::vector<PlacedLabel> placed;
  std::int32_t cell = 0;
  std::int32_t count = 0;
  for (std::int32_t i = 0; i < s.small; ++i) {
    placed.push_back({cell++, Label::main});
    const std::int32_t here = (i + 1) * s.shaping / s.small - i * s.shaping / s.small;
    for (std::int32_t j = 0; j < here; ++j) placed.push_back({cell++, count++ % 2 == 0 ? after : before});
  }
  return placed;
}

// Mains rise, all shaping is placed, and every section has two cells for each label in it.
bool has_room(const Spacing& spacing, const std::vector<PlacedLabel>& placed, const Sizes& s) {
  if (placed.size() != spacing.mains.size() + static_cast<std::size_t>(s.shaping)) return false;
  const auto& mains = spacing.mains;
  if (std::adjacent_find(mains.begin(), mains.end(), std::greater_equal<>()) != mains.end()) return false;
  std::vector<std::int32_t> shaping(spacing.mains.size(), 0);
  for (const PlacedLabel& p : placed) {
    if (p.label == Label::main) continue;
    const auto after = std::upper_bound(spacing.mains.begin(), spacing.mains.end(), p.cell);
    if (after == spacing.mains.begin()) return false;
    ++shaping[static_cast<std::size_t>(after - spacing.mains.begin()) - 1];
  }
  for (std::size_t i = 0; i < spacing.mains.size(); ++i) {
    const std::int32_t end = i + 1 < spacing.mains.size() ? spacing.mains[i + 1] : s.big;
    if (end - spacing.mains[i] < 2 * shaping[i]) return false;
  }
  return true;
}

Spacing first_choice(const Sizes& s, const RowBelow& below, PlacementPolicy policy) {
  if (policy == PlacementPolicy::even) return space_even(s);
  const auto mains = static_cast<std::int32_t>(below.mains.size());
  if (s.grows && mains > s.wanted && mains % s.wanted == 0) return space_equal(s);
  if (mains >= s.wanted) return space_follow(s, below.mains);
  return space_remainder_last(s);
}

void fill_labels(Join& t, std::vector<PlacedLabel> placed, const Sizes& s) {
  t.placed = std::move(placed);
  t.labels.assign(static_cast<std::size_t>(s.big), Label::knit);
  for (const PlacedLabel& p : t.placed) t.labels[static_cast<std::size_t>(p.cell)] = p.label;
}

void place_shaping(Join& t, const Sizes& s, const RowBelow& below, PlacementPolicy policy) {
  if (below.is_cast_on && s.grows && policy == PlacementPolicy::thesis) {
    t.rule = Rule::from_cast_on;
    fill_labels(t, place_dense(s), s);
    return;
  }
  Spacing spacing = first_choice(s, below, policy);
  std::vector<PlacedLabel> placed = place_around(spacing, s);
  if (!has_room(spacing, placed, s) && spacing.rule != Rule::remainder_last && spacing.rule != Rule::even) {
    t.tried = spacing.rule;
    spacing = space_remainder_last(s);
    placed = place_around(spacing, s);
  }
  if (!has_room(spacing, placed, s)) {
    if (!t.tried) t.tried = spacing.rule;
    spacing = Spacing{Rule::dense, {}, 0, 0};
    placed = place_dense(s);
  }
  t.rule = spacing.rule;
  t.spacing = spacing.step;
  t.remainder = spacing.remainder;
  fill_labels(t, std::move(placed), s);
}

// Where the mains stand in the row above: in their cells, less the stitches that a decrease takes away before
// them.
std::vector<std::int32_t> mains_above(const Join& t, bool grows) {
  std::vector<std::int32_t> mains;
  std::int32_t gone = 0;
  for (std::size_t cell = 0; cell < t.labels.size(); ++cell) {
    if (t.labels[cell] == Label::main) mains.push_back(static_cast<std::int32_t>(cell) - (grows ? 0 : gone));
    if (is_decrease(t.labels[cell])) ++gone;
  }
  return mains;
}

}  // namespace

std::int32_t mains_wanted(std::int32_t below, std::int32_t above) {
  return (std::abs(above - below) + 1) / 2;
}

Join plan_join(const RowBelow& below, std::int32_t above, std::int32_t row, PlacementPolicy policy) {
  Join t;
  t.to = row;
  t.below = below.size;
  t.above = above;
  const Sizes s = sizes_of(below.size, above);
  if (s.shaping == 0) {
    std::vector<PlacedLabel> kept;
    for (const std::int32_t cell : below.mains) kept.push_back({cell, Label::main});
    fill_labels(t, std::move(kept), s);
  } else {
    place_shaping(t, s, below, policy);
  }
  t.mains = mains_above(t, s.grows || s.shaping == 0);
  link_cells(t);
  return t;
}

}  // namespace knit
