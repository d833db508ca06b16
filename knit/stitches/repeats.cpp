#include "knit/stitches/repeats.h"

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

#include "knit/stitches/links.h"

namespace knit {

namespace {

// A shaping label of a section: its cell, and the cell that it works with.
struct Shaping {
  std::int32_t cell = 0, partner = 0;
  Label label = Label::m1l;
};
using SectionShaping = std::vector<Shaping>;

bool is_odd(std::int32_t turn) { return turn % 2 == 1; }

// An increase that stands after so many of the section's m stitches; it works with the one before it, or with the one after
// it where that leaves the main alone.
Shaping increase_after(std::int32_t stitches, std::int32_t m, Label label) {
  const bool beside_main = stitches == 1 && m > 1;
  const bool ahead = beside_main || (label == Label::m1r && stitches < m);
  return {stitches, ahead ? stitches + 1 : stitches - 1, label};
}

// A decrease of the cells `first` and the next. K2tog takes the one before it in, ssk the one after; neither label stands on
// the main.
Shaping decrease_at(std::int32_t first, Label label) {
  const bool on_first = label == Label::ssk && first > 0;
  return {on_first ? first : first + 1, on_first ? first + 1 : first, label};
}

SectionShaping growing_pair(std::int32_t m) {
  // Of two stitches the second has no room for both new ones.
  const Shaping after = m > 2 ? increase_after(1, m, Label::m1l) : Shaping{1, 0, Label::m1l};
  return {after, {m + 1, m, Label::m1r}};
}

SectionShaping growing(std::int32_t m, RhythmStyle style, std::int32_t turn) {
  const bool odd = is_odd(turn);
  switch (style) {
    case RhythmStyle::pairs:
      return {odd ? increase_after(m, m, Label::m1r) : increase_after(1, m, Label::m1l)};
    case RhythmStyle::centre: {
      const std::int32_t half = (m + (odd ? 1 : 0)) / 2;
      if (half == 0 || half == m) break;
      return {increase_after(half, m, odd ? Label::m1l : Label::m1r)};
    }
    case RhythmStyle::stagger:
      if (odd) return {increase_after((m + 1) / 2, m, Label::m1l)};
      break;
    case RhythmStyle::lines:
      break;
  }
  return {increase_after(m, m, Label::m1l)};
}

SectionShaping shrinking_pair(std::int32_t m) {
  return {decrease_at(m > 4 ? 1 : 0, Label::ssk), decrease_at(m - 2, Label::k2tog)};
}

SectionShaping shrinking(std::int32_t m, RhythmStyle style, std::int32_t turn) {
  const bool odd = is_odd(turn);
  switch (style) {
    case RhythmStyle::pairs:
      if (m > 2 && !odd) return {decrease_at(1, Label::ssk)};
      break;
    case RhythmStyle::centre:
      return {decrease_at(std::min((m - 2 + (odd ? 1 : 0)) / 2, m - 2), odd ? Label::k2tog : Label::ssk)};
    case RhythmStyle::stagger:
      if (odd) return {decrease_at((m - 2) / 2, Label::k2tog)};
      break;
    case RhythmStyle::lines:
      break;
  }
  return {decrease_at(m - 2, Label::k2tog)};
}

SectionShaping shaping_of(const RepeatedRound& round, std::int32_t m, std::int32_t change) {
  if (change == 0) return {};
  if (std::abs(change) == 2) return change > 0 ? growing_pair(m) : shrinking_pair(m);
  return change > 0 ? growing(m, round.style, round.turn) : shrinking(m, round.style, round.turn);
}

// A main and the stitches up to the next one.
struct Section {
  std::int32_t below = 0, above = 0;
  SectionShaping shaping;
};

std::vector<Section> equal_sections(const RepeatedRound& round) {
  const std::int32_t before = round.below / round.sections;
  const std::int32_t after = round.above / round.sections;
  const Section section{before, after, shaping_of(round, before, after - before)};
  return std::vector<Section>(static_cast<std::size_t>(round.sections), section);
}

// One more or fewer, right after the section's own main or right before the next.
SectionShaping one_beside_main(std::int32_t m, std::int32_t change, bool after_main) {
  if (change > 0) return {after_main ? increase_after(1, m, Label::m1l) : increase_after(m, m, Label::m1r)};
  return {after_main && m > 2 ? decrease_at(1, Label::ssk) : decrease_at(m - 2, Label::k2tog)};
}

// Back to side, side to front, and the same the other way round.
std::vector<Section> sections_of_halves(const RepeatedRound& round) {
  std::vector<Section> sections;
  for (const std::int32_t quarter : {0, 1, 2, 3}) {
    const bool front = quarter == 1 || quarter == 2;
    const std::int32_t below = (front ? round.front_below : round.below - round.front_below) / 2;
    const std::int32_t above = (front ? round.front_above : round.above - round.front_above) / 2;
    const std::int32_t change = above - below;
    Section section{below, above, {}};
    if (std::abs(change) == 2)
      section.shaping = shaping_of(round, below, change);
    else if (change != 0)
      section.shaping = one_beside_main(below, change, quarter % 2 == 0);
    sections.push_back(std::move(section));
  }
  return sections;
}

}  // namespace

Join plan_repeats(const RepeatedRound& round) {
  const std::vector<Section> sections =
      round.front_below > 0 ? sections_of_halves(round) : equal_sections(round);
  Join join;
  join.to = round.row;
  join.below = round.below;
  join.above = round.above;
  join.rule = Rule::repeat;
  std::int32_t begin = 0, begin_above = 0;
  for (const Section& section : sections) {
    const std::int32_t cells = std::max(section.below, section.above);
    join.spacing = std::max(join.spacing, cells);
    join.mains.push_back(begin_above);
    join.placed.push_back({begin, Label::main});
    for (std::int32_t cell = 0; cell < cells; ++cell) join.partner.push_back(begin + cell);
    for (const Shaping& shape : section.shaping) {
      join.placed.push_back({begin + shape.cell, shape.label});
      join.partner[static_cast<std::size_t>(begin + shape.cell)] = begin + shape.partner;
    }
    begin += cells;
    begin_above += section.above;
  }
  join.labels.assign(static_cast<std::size_t>(begin), Label::knit);
  for (const PlacedLabel& placed : join.placed)
    join.labels[static_cast<std::size_t>(placed.cell)] = placed.label;
  link_by_partners(join);
  return join;
}

}  // namespace knit
