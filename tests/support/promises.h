// What holds for the state of any run: rows, joins, strips and lines that fit together. Each function gives
// the first thing that does not as a sentence, empty where all does; property tests and the fuzz target share them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "knit/pattern/rounds.h"
#include "knit/quality/measures.h"
#include "knit/run/state.h"
#include "knit/stitches/faces.h"

namespace test_support {

inline std::string at_row(const char* what, knit::RowId row) {
  return std::string(what) + " (row " + std::to_string(row) + ")";
}

// Rows of three stitches or more, numbered from 1, times rising in each tube, every stitch at a finite place. A short row has
// the time of the round that it stands on.
inline std::string broken_rows(const knit::State& state) {
  std::map<knit::TubeId, double> before;
  knit::RowId number = 0;
  for (const auto& shared : state.fabric.rows()) {
    const knit::Row& row = *shared;
    if (row.id != ++number) return at_row("rows are numbered from 1", number);
    if (row.stitches.size() < 3) return at_row("a row has three stitches at least", row.id);
    if (!(row.time >= 0.0 && row.time <= 1.0)) return at_row("a row's time lies in 0 to 1", row.id);
    const auto last = before.find(row.tube);
    if (knit::is_short(row)) {
      if (last == before.end() || row.time != last->second)
        return at_row("a short row stands on a round of its tube", row.id);
    } else if (last != before.end() && !(row.time > last->second)) {
      return at_row("a tube's times rise", row.id);
    }
    before[row.tube] = row.time;
    for (const knit::Stitch& stitch : row.stitches) {
      const glm::dvec3& p = stitch.position;
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
        return at_row("a stitch has a place", row.id);
    }
  }
  return {};
}

// A row is worked on live stitches, each stitch is taken once, a bridge's twice, and what nobody has taken is live. Deals
// conserve stitches: what they give is what they take and each side of their bridge.
inline std::string broken_live(const knit::State& state) {
  const knit::Fabric& fabric = state.fabric;
  std::multiset<knit::StitchRef> live;
  const auto take = [&](const knit::LiveStitches& stitches) {
    for (std::int32_t i = 0; i < stitches.size(); ++i) {
      const auto found = live.find(stitches.at(i));
      if (found == live.end()) return false;
      live.erase(found);
    }
    return true;
  };
  const auto give = [&](const knit::LiveStitches& stitches) {
    for (std::int32_t i = 0; i < stitches.size(); ++i) live.insert(stitches.at(i));
  };
  std::size_t deal = 0;
  for (const auto& row : fabric.rows()) {
    if (!take(row->on)) return at_row("a row takes what is live", row->id);
    give(knit::all_of(*row));
    for (; deal < fabric.deals().size() && fabric.deals()[deal]->after == row->id; ++deal) {
      const knit::Deal& dealt = *fabric.deals()[deal];
      if (dealt.kind == knit::DealKind::ring_cast_on) continue;
      std::int32_t taken = 0, given = 0;
      for (const knit::LiveStitches& loop : dealt.taken) {
        taken += loop.size();
        if (!take(loop)) return at_row("a deal takes what is live", row->id);
      }
      for (const knit::LiveStitches& loop : dealt.given) {
        given += loop.size();
        give(loop);
        if (loop.size() < 3) return at_row("a loop has three stitches", row->id);
      }
      const auto bridge = static_cast<std::int32_t>(dealt.bridge.size());
      const std::int32_t wanted = dealt.kind == knit::DealKind::ring_bind_off ? 0 : taken + 2 * bridge;
      if (given != wanted) return at_row("a deal gives what it takes and its bridge twice", row->id);
    }
  }
  for (const knit::LiveLoop& loop : fabric.live()) {
    if (!take(loop.stitches)) return "what hangs on a needle is taken by no row";
  }
  return live.empty() ? "" : "what no row takes hangs on a needle";
}

// Each stitch of the smaller side has one or two links, in order, first to first and last to last.
inline bool links_in_order(const knit::Join& join) {
  const std::int32_t small = std::min(join.below, join.above);
  std::int32_t before = 0, there = 0;
  for (const std::int32_t link : join.link) {
    if (link < before || link > before + 1) return false;
    there = link == before ? there + 1 : 1;
    if (there > 2) return false;
    before = link;
  }
  return !join.link.empty() && join.link.front() == 0 && join.link.back() == small - 1;
}

// What a join takes is what its row is worked on; its cells are the stitches of the larger side, each with a label, a
// partner and a link. Stitches are conserved: what it makes is what was there, and one for each increase, less one
// for each decrease; and no row more than doubles or halves.
inline std::string broken_joins(const knit::State& state) {
  for (const auto& shared : state.fabric.joins()) {
    const knit::Join& join = *shared;
    const knit::Row* row = state.fabric.find_row(join.to);
    if (row == nullptr || row->on.empty()) return at_row("a join makes a row that is no cast on", join.to);
    if (join.from != row->on) return at_row("a join takes what its row is worked on", join.to);
    if (join.below != join.from.size() || join.above != knit::size_of(*row))
      return at_row("a join has the sizes of its sides", join.to);
    if (join.above > 2 * join.below || join.below > 2 * join.above)
      return at_row("no row more than doubles or halves", join.to);
    const auto cells = static_cast<std::size_t>(state.fabric.larger(join).size());
    if (join.labels.size() != cells || join.partner.size() != cells || join.link.size() != cells)
      return at_row("the larger side has a label, a partner and a link a stitch", join.to);
    if (!links_in_order(join)) return at_row("links rise, one or two a stitch of the smaller side", join.to);
    std::int32_t change = 0;
    for (const knit::Label label : join.labels)
      change += knit::is_increase(label) ? 1 : knit::is_decrease(label) ? -1 : 0;
    if (change != join.change()) return at_row("shaping makes up the change", join.to);
    for (const std::int32_t main : join.mains)
      if (main < 0 || main >= join.above) return at_row("mains are stitches of the row made", join.to);
  }
  return {};
}

// A strip has a column edge for each cell of its join, between the cell's two ends, and a face beside each; as many
// triangles as there is shaping, and one at each end of a short row.
inline std::string broken_strips(const knit::State& state) {
  const knit::Fabric& fabric = state.fabric;
  const knit::KnittingPath path(fabric);
  for (const auto& strip : fabric.strips()) {
    const knit::Join* join = fabric.join_into(strip->to);
    if (join == nullptr) return at_row("a strip follows its join", strip->to);
    if (strip->column_edges.size() != join->link.size()) return at_row("a cell has a column edge", strip->to);
    for (std::size_t cell = 0; cell < join->link.size(); ++cell) {
      const knit::CellEnds ends = knit::ends_of(*join, static_cast<std::int32_t>(cell));
      const auto& [lower, upper] = strip->column_edges[cell];
      if (path.at(lower) != join->from.at(ends.below) ||
          path.at(upper) != knit::StitchRef{join->to, ends.above})
        return at_row("a column edge stands between its cell's ends", strip->to);
    }
    const std::size_t turns = knit::is_short(fabric.row(strip->to)) ? 2 : 0;
    if (strip->faces.size() != knit::Edges(join->link.size(), join->from.closed).size() + turns)
      return at_row("there is a face between two cells", strip->to);
    const auto triangles = std::count_if(strip->faces.begin(), strip->faces.end(),
                                         [](const knit::Face& face) { return face.corner_count == 3; });
    if (triangles != std::abs(join->change()) + static_cast<std::ptrdiff_t>(turns))
      return at_row("shaping makes triangles", strip->to);
  }
  return {};
}

// Every edge has one face on each side, which run along it in opposite directions; the edges of one face alone are those of
// the cast ons and the bind offs, one loop each, and V - E + F is 2 - 2 genus less their number: of a tube 0.
inline std::string broken_faces(const knit::State& state) {
  const knit::Fabric& fabric = state.fabric;
  const auto cast_on = [](const auto& row) { return row->on.empty(); };
  const auto cast_ons =
      static_cast<std::size_t>(std::count_if(fabric.rows().begin(), fabric.rows().end(), cast_on));
  const bool whole = state.stage() > knit::Stage::faces && !fabric.strips().empty();
  if (!whole || fabric.strips().size() + cast_ons != fabric.rows().size()) return {};
  std::vector<std::array<std::uint32_t, 2>> sides;
  const auto add = [&](const std::vector<knit::Face>& faces) {
    for (const knit::Face& face : faces) {
      const auto corners = static_cast<std::size_t>(face.corner_count);
      for (std::size_t k = 0; k < corners; ++k)
        sides.push_back({face.corners.at(k), face.corners.at((k + 1) % corners)});
    }
  };
  for (const auto& strip : fabric.strips()) add(strip->faces);
  for (const auto& deal : fabric.deals()) add(deal->faces);
  std::sort(sides.begin(), sides.end());
  if (std::adjacent_find(sides.begin(), sides.end()) != sides.end())
    return "no two faces run along an edge in the same direction";
  const std::size_t all = fabric.stitch_count();
  std::vector<std::uint32_t> after(all, UINT32_MAX);  // along the rims
  for (const auto& [from, to] : sides) {
    if (from >= all || to >= all) return "a face's corners are stitches";
    if (std::binary_search(sides.begin(), sides.end(), std::array{to, from})) continue;
    if (after[from] != UINT32_MAX) return "a rim passes a stitch once";
    after[from] = to;
  }
  std::size_t rims = 0;
  std::vector<std::uint8_t> seen(all, 0);
  for (std::uint32_t first = 0; first < all; ++first) {
    if (after[first] == UINT32_MAX || seen[first] != 0) continue;
    ++rims;
    for (std::uint32_t at = first; seen[at] == 0; at = after[at]) {
      seen[at] = 1;
      if (after[at] == UINT32_MAX) return "a rim is a loop";
    }
  }
  std::size_t rings = 0;
  for (const auto& deal : fabric.deals()) rings += deal->kind == knit::DealKind::ring_cast_on ? 2 : 0;
  if (rims != cast_ons - rings + fabric.live().size()) return "there is a rim for each cast on and bind off";
  const std::int32_t genus = state.tubes ? knit::genus_of(*state.tubes) : 0;
  const auto euler = knit::euler_characteristic(state);
  return euler == 2 - 2 * genus - static_cast<std::int64_t>(rims) ? "" : "V - E + F is 2 - 2 genus - rims";
}

// Lines and operations take what the row before made.
inline std::string broken_pattern(const knit::State& state) {
  for (const auto& line : state.lines) {
    const knit::Row* row = state.fabric.find_row(line->row);
    const bool bind_off = line->produced == 0;
    if (row == nullptr || line->consumed != (bind_off ? knit::size_of(*row) : row->on.size()) ||
        (!bind_off && line->produced != knit::size_of(*row)))
      return at_row("a line takes what its row is worked on and makes its row", line->row);
  }
  if (!state.fabric.deals().empty()) return {};
  if (state.fabric.empty() || state.fabric.joins().size() + 1 != state.fabric.rows().size()) return {};
  const knit::Rounds rounds = knit::rounds_of(state);
  std::vector<const knit::Row*> whole;  // the rows that are no short rows
  for (const auto& row : state.fabric.rows())
    if (!knit::is_short(*row)) whole.push_back(&*row);
  if (rounds.rounds.size() + 1 != whole.size()) return "there is a round for each row but the cast on";
  std::int32_t there = rounds.cast_on;
  for (std::size_t i = 0; i < rounds.rounds.size(); ++i) {
    std::int32_t taken = 0, made = 0;
    for (const knit::Operation& operation : rounds.rounds[i].operations) {
      taken += knit::consumed_by(operation.hand);
      made += knit::made_by(operation.hand);
    }
    const knit::Row& row = *whole[i + 1];
    if (taken != there || made != knit::size_of(row))
      return at_row("a round takes what is there and makes its row", row.id);
    there = made;
  }
  if (knit::graph_of(rounds) != knit::graph_of(state)) return "the operations make the graph of the labels";
  return {};
}

inline std::string broken_promise(const knit::State& state) {
  for (const auto& check :
       {broken_rows, broken_live, broken_joins, broken_strips, broken_faces, broken_pattern}) {
    if (std::string broken = check(state); !broken.empty()) return broken;
  }
  return {};
}

}  // namespace test_support
