// Tubes with short rows built by hand: rounds on a cylinder, and pairs of short rows over arcs that may be turned at.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "knit/run/state.h"
#include "knit/stitches/below_joins.h"
#include "knit/stitches/faces.h"
#include "knit/stitches/index_stage.h"
#include "knit/stitches/short_join.h"

namespace test_support {

// Stitches of the round below, from first to last round and round; first < 0: over the beginning of the round.
struct ShortArc {
  std::int32_t first = 0, last = 0;
  [[nodiscard]] std::int32_t size() const { return last - first + 1; }
};

struct ShortTube {
  std::vector<std::int32_t> sizes;           // of the rounds
  std::vector<std::vector<ShortArc>> pairs;  // on round i, before round i + 1, in working order
};

inline knit::Stitch on_cylinder(double turn, double height) {
  const double angle = 2.0 * std::numbers::pi * turn;
  return {{std::sin(angle), height, -std::cos(angle)}, knit::no_vertex};
}

inline knit::Row round_at(const knit::Fabric& fabric, std::int32_t size, double height) {
  knit::Row row;
  row.id = fabric.next_row();
  row.on = fabric.live(0);
  for (std::int32_t i = 0; i < size; ++i) row.stitches.push_back(on_cylinder(double(i) / size, height));
  return row;
}

// Plans the join into a row as the stage does.
inline knit::Join planned(const knit::Fabric& fabric, const knit::Row& row) {
  knit::StitchSettings settings;
  settings.placement = knit::PlacementPolicy::nearest;
  const knit::JoinGround ground = knit::ground_of(fabric, row);
  const knit::JoinAt at{
      row.id, ground.from, ground.below, ground.joins.mains, ground.joins.shaped, ground.joins.cast_on, &row,
      false,  {},          false,        ground.marked};
  knit::Join join = knit::plan_row_join(settings, {0.3, 0.3}, at);
  join.from = ground.from;
  return join;
}

// Where each short-row stitch stands: between the round below and the next, evenly.
class ShortRowPlaces {
 public:
  ShortRowPlaces(std::int32_t size, std::span<const ShortArc> arcs, double low, double high)
      : all_(static_cast<std::size_t>(size), 0), made_(all_), low_(low), high_(high) {
    for (const ShortArc& arc : arcs) {
      for (std::int32_t i = arc.first; i <= arc.last; ++i) all_[at(i)] += 2;
    }
  }
  knit::Stitch next(std::int32_t place) {
    const std::size_t i = at(place);
    ++made_[i];
    const double part = double(made_[i]) / (all_[i] + 1);
    return on_cylinder(double(i) / double(all_.size()), low_ + (high_ - low_) * part);
  }

 private:
  [[nodiscard]] std::size_t at(std::int32_t place) const {
    const auto size = static_cast<std::int32_t>(all_.size());
    return static_cast<std::size_t>(((place % size) + size) % size);
  }
  std::vector<std::int32_t> all_, made_;
  double low_, high_;
};

inline knit::Row short_row_at(const knit::Fabric& fabric, const ShortArc& arc, bool back,
                              ShortRowPlaces& places) {
  const knit::LiveStitches loop = fabric.live(0);
  const std::int32_t all = loop.size(), first = ((arc.first % all) + all) % all;
  knit::Row row;
  row.id = fabric.next_row();
  row.on = knit::arc_of(loop, first, arc.size());
  row.closed = false;
  row.turned = knit::ShortRow{loop.at((first + all - 1) % all), loop.at((first + arc.size()) % all), back};
  for (std::int32_t i = arc.first; i <= arc.last; ++i) row.stitches.push_back(places.next(i));
  return row;
}

// Rows only.
inline knit::Fabric rows_of(const ShortTube& tube) {
  knit::Fabric fabric;
  for (std::size_t k = 0; k < tube.sizes.size(); ++k) {
    if (k > 0 && !tube.pairs.empty()) {
      const std::vector<ShortArc>& arcs = tube.pairs[k - 1];
      ShortRowPlaces places(tube.sizes[k - 1], arcs, double(k) - 1.0, double(k));
      for (const ShortArc& arc : arcs) {
        for (const bool back : {false, true}) fabric.add(short_row_at(fabric, arc, back, places));
      }
    }
    fabric.add(round_at(fabric, tube.sizes[k], double(k)));
  }
  return fabric;
}

inline void join_and_face(knit::Fabric& fabric) {
  for (knit::RowId id = fabric.next_worked(0); id != 0; id = fabric.next_worked(id))
    fabric.add(knit::Shared(planned(fabric, fabric.row(id))));
  for (knit::RowId id = fabric.next_worked(0); id != 0; id = fabric.next_worked(id))
    fabric.add(knit::Shared(knit::build_strip(fabric, *fabric.join_into(id))));
}

inline knit::Fabric fabric_of(const ShortTube& tube) {
  knit::Fabric fabric = rows_of(tube);
  join_and_face(fabric);
  return fabric;
}

// Rounds that grow and shrink, and arcs over the beginning of the round, inside, nested, overlapping and apart.
inline ShortTube random_short_tube(std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto pick = [&](std::int32_t low, std::int32_t high) {
    return low + static_cast<std::int32_t>(random() % static_cast<std::uint32_t>(high - low + 1));
  };
  ShortTube tube;
  tube.sizes.push_back(pick(8, 24));
  for (std::int32_t k = pick(1, 5); k > 0; --k)
    tube.sizes.push_back(std::max(8, tube.sizes.back() + pick(-3, 3)));
  knit::Fabric plain = rows_of(tube);
  join_and_face(plain);
  for (std::size_t k = 0; k + 1 < tube.sizes.size(); ++k) {
    const std::vector<std::uint8_t> works =
        knit::plain_below(*plain.join_into(static_cast<knit::RowId>(k) + 2));
    const std::int32_t size = tube.sizes[k];
    const auto legal = [&](std::int32_t place) {
      return works[static_cast<std::size_t>((place + size) % size)] != 0;
    };
    tube.pairs.emplace_back();
    for (std::int32_t tries = pick(0, 8); tries > 0; --tries) {
      const std::int32_t first = pick(-size / 2, size - 4);
      const ShortArc arc{first, first + pick(2, size - 3)};
      const bool inside = arc.first >= 1 && arc.last <= size - 2;
      const bool over = arc.first < 0 && arc.last >= 0 && arc.last <= size - 2;
      if ((!inside && !over) || arc.size() > size - 2) continue;
      if (legal(arc.first - 1) && legal(arc.first) && legal(arc.last) && legal(arc.last + 1))
        tube.pairs.back().push_back(arc);
    }
  }
  return tube;
}

}  // namespace test_support
