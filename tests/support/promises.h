// What holds for the state of any run: rows, transitions, strips and lines that fit together. Each function gives
// the first thing that does not as a sentence, empty where all does; property tests and the fuzz target share them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "knit/pattern/rounds.h"
#include "knit/quality/measures.h"
#include "knit/run/state.h"
#include "knit/stitches/faces.h"

namespace test_support {

inline std::string at_row(const char* what, std::size_t index) {
  return std::string(what) + " (row " + std::to_string(index + 1) + ")";
}

// Rows of three stitches or more, numbered from 1, times rising, every stitch at a finite place.
inline std::string broken_rows(const knit::State& state) {
  for (std::size_t i = 0; i < state.rows.size(); ++i) {
    const knit::Row& row = *state.rows[i];
    if (row.number != static_cast<std::int32_t>(i) + 1) return at_row("rows are numbered from 1", i);
    if (row.stitches.size() < 3) return at_row("a row has three stitches at least", i);
    if (!(row.time >= 0.0 && row.time <= 1.0)) return at_row("a row's time lies in 0 to 1", i);
    if (i > 0 && !(row.time > state.rows[i - 1]->time)) return at_row("rows' times rise", i);
    for (const knit::Stitch& stitch : row.stitches) {
      const glm::dvec3& p = stitch.position;
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
        return at_row("a stitch has a place", i);
    }
  }
  return {};
}

// Stitches are conserved: what a transition makes is what was there, and one for each increase, less one for each
// decrease; and no row more than doubles or halves.
inline std::string broken_transitions(const knit::State& state) {
  for (std::size_t i = 0; i < state.transitions.size(); ++i) {
    const knit::Transition& made = *state.transitions[i];
    const auto below = static_cast<std::int32_t>(state.rows[i]->stitches.size());
    const auto above = static_cast<std::int32_t>(state.rows[i + 1]->stitches.size());
    if (made.below != below || made.above != above) return at_row("a transition has its rows' sizes", i + 1);
    if (above > 2 * below || below > 2 * above) return at_row("no row more than doubles or halves", i + 1);
    std::int32_t change = 0;
    for (const knit::Label label : made.labels)
      change += knit::is_increase(label) ? 1 : knit::is_decrease(label) ? -1 : 0;
    if (change != above - below) return at_row("shaping makes up the change", i + 1);
    if (made.labels.size() != static_cast<std::size_t>(std::max(below, above)))
      return at_row("the larger row has a label a stitch", i + 1);
  }
  return {};
}

// Every edge has one face on each side, which run along it in opposite directions; the edges of one face alone are
// those of the first and the last row, one loop each.
inline std::string broken_faces(const knit::State& state) {
  if (state.strips.empty() || state.strips.size() + 1 != state.rows.size()) return {};
  std::vector<std::array<std::uint32_t, 2>> sides;
  for (const auto& strip : state.strips) {
    for (const knit::Face& face : strip->faces) {
      const auto corners = static_cast<std::size_t>(face.corner_count);
      for (std::size_t k = 0; k < corners; ++k)
        sides.push_back({face.corners.at(k), face.corners.at((k + 1) % corners)});
    }
  }
  std::sort(sides.begin(), sides.end());
  if (std::adjacent_find(sides.begin(), sides.end()) != sides.end())
    return "no two faces run along an edge in the same direction";
  const std::size_t all = knit::count_stitches(state);
  const std::size_t first = state.rows.front()->stitches.size();
  const std::size_t last = state.rows.back()->stitches.size();
  std::vector<std::uint32_t> after(all, UINT32_MAX);  // along the rim
  std::size_t rim = 0;
  for (const auto& [from, to] : sides) {
    if (from >= all || to >= all) return "a face's corners are stitches";
    if (std::binary_search(sides.begin(), sides.end(), std::array{to, from})) continue;
    if (after[from] != UINT32_MAX) return "the rim passes a stitch once";
    after[from] = to;
    ++rim;
  }
  if (rim != first + last) return "the rim is the first and the last row";
  const auto is_loop = [&](std::size_t begin, std::size_t count) {
    std::size_t steps = 0;
    auto at = static_cast<std::uint32_t>(begin);
    do {
      at = after[at];
      if (at == UINT32_MAX || at < begin || at >= begin + count) return false;
    } while (++steps < count && at != begin);
    return steps == count && at == begin;
  };
  if (!is_loop(0, first)) return "the first row is one loop of the rim";
  if (!is_loop(all - last, last)) return "the last row is one loop of the rim";
  return knit::euler_characteristic(state) == 0 ? "" : "an open tube has Euler characteristic 0";
}

// Lines and operations take what the row before made.
inline std::string broken_pattern(const knit::State& state) {
  for (std::size_t i = 1; i < state.lines.size(); ++i) {
    if (state.lines[i]->consumed != state.lines[i - 1]->produced)
      return at_row("a line takes what the one before made", i);
  }
  if (state.rows.empty() || state.transitions.size() + 1 != state.rows.size()) return {};
  const knit::Rounds rounds = knit::rounds_of(state);
  std::int32_t there = rounds.cast_on;
  for (std::size_t i = 0; i < rounds.rounds.size(); ++i) {
    std::int32_t taken = 0, made = 0;
    for (const knit::Operation& operation : rounds.rounds[i].operations) {
      taken += knit::consumed_by(operation.hand);
      made += knit::made_by(operation.hand);
    }
    if (taken != there || made != static_cast<std::int32_t>(state.rows[i + 1]->stitches.size()))
      return at_row("a round takes what is there and makes its row", i + 1);
    there = made;
  }
  if (knit::graph_of(rounds) != knit::graph_of(state)) return "the operations make the graph of the labels";
  return {};
}

inline std::string broken_promise(const knit::State& state) {
  for (const auto& check : {broken_rows, broken_transitions, broken_faces, broken_pattern}) {
    if (std::string broken = check(state); !broken.empty()) return broken;
  }
  return {};
}

}  // namespace test_support
