// What a plan of limbs makes of stitches, worked out from the plan alone, without a word; and held against the fabric's rows,
// labels and links.
#pragma once

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "knit/limbs/limb_plan.h"
#include "knit/reader/limbs_reader.h"
#include "tests/support/catch.h"

namespace test_support {

class PlanHands {
 public:
  explicit PlanHands(const knit::LimbPlan& plan) : plan_(plan) {}
  knit::ReadLimbs run() {
    for (now_ = 0; now_ < plan_.count(); ++now_) {
      made_.limbs.push_back({});
      for (const auto& deal : plan_.piece(now_).deals) take(deal);
      if (!plan_.piece(now_).is_cast_on()) made_.limbs.back().live = needle_;
      for (const auto& round : plan_.piece(now_).rounds) work(round);
      end(plan_.piece(now_).end);
    }
    return std::move(made_);
  }

 private:
  using Loop = std::vector<std::int32_t>;
  std::int32_t add(const knit::ReadStitch& stitch) {
    made_.stitches.push_back(stitch);
    return static_cast<std::int32_t>(made_.stitches.size()) - 1;
  }
  Loop cast_on(std::int32_t count) {
    Loop loop;
    for (std::int32_t i = 0; i < count; ++i) loop.push_back(add({}));
    return loop;
  }
  void take(const knit::LimbDeal& deal) {
    using K = knit::LimbDealKind;
    switch (deal.kind) {
      case K::cast_on:
      case K::provisional:
        needle_ = cast_on(deal.after);
        made_.limbs.back().rows.push_back(needle_);
        made_.cast_on += deal.after;
        return;
      case K::loops:
        needle_ = made_.limbs[static_cast<std::size_t>(deal.piece)].rows.front();
        std::reverse(needle_.begin(), needle_.end());
        return;
      case K::set_aside:
        holders_[{deal.piece, deal.holder}] = std::exchange(needle_, {});
        return;
      case K::move:
        std::rotate(needle_.begin(), needle_.begin() + deal.before, needle_.end());
        return;
      case K::divide: {
        holders_[{deal.piece, deal.holder}] =
            Loop(needle_.begin() + deal.before, needle_.begin() + deal.before + deal.held);
        needle_.erase(needle_.begin() + deal.before, needle_.begin() + deal.before + deal.held);
        if (deal.gap == 0) return;
        made_.gaps.push_back(cast_on(deal.bridge));
        needle_.insert(needle_.begin() + deal.before, made_.gaps.back().begin(), made_.gaps.back().end());
        return;
      }
      case K::rejoin:
      case K::join:
        lay(deal);
        return;
    }
  }
  void lay(const knit::LimbDeal& deal) {
    Loop loop;
    std::size_t kept = 0;
    std::set<std::pair<std::int32_t, std::int32_t>> used;
    for (const auto& item : deal.items) {
      for (std::int32_t i = 0; i < item.count; ++i) {
        switch (item.kind) {
          case knit::LimbItemKind::keep:
            loop.push_back(needle_.at(kept++));
            break;
          case knit::LimbItemKind::take: {
            const Loop& holder = holders_.at({item.piece, item.holder});
            loop.push_back(holder.at(static_cast<std::size_t>((item.first + i) % item.held)));
            used.insert({item.piece, item.holder});
            break;
          }
          case knit::LimbItemKind::cast_on:
            if (i == 0) made_.gaps.push_back(cast_on(item.count));
            loop.push_back(
                made_.gaps.at(static_cast<std::size_t>(item.gap) - 1).at(static_cast<std::size_t>(i)));
            break;
          case knit::LimbItemKind::pick_up:
            loop.push_back(made_.gaps.at(static_cast<std::size_t>(item.gap) - 1)
                               .at(static_cast<std::size_t>(item.first - i)));
            break;
        }
      }
    }
    for (const auto& holder : used) holders_.erase(holder);
    needle_ = loop;
  }
  void work(const knit::LimbRound& round) {
    Loop live = needle_, row;
    if (round.slips_back) std::rotate(live.begin(), live.end() - 1, live.end());
    std::size_t done = 0;
    for (const auto& operation : round.operations) {
      const auto takes = static_cast<std::size_t>(knit::consumed_by(operation.hand));
      knit::ReadStitch stitch{operation.hand, -1, -1};
      stitch.first = takes > 0 ? live.at(done) : live.at((done + live.size() - 1) % live.size());
      if (takes != 1) stitch.second = live.at((takes > 0 ? done + 1 : done) % live.size());
      row.push_back(add(stitch));
      done += takes;
    }
    CHECK(done == live.size());
    const knit::Rounds alone{round.before, {{2, round.operations, round.before, round.after, round.pairs}}};
    for (knit::GraphShortRow short_row : knit::graph_of(alone).short_rows) {
      short_row.row = static_cast<std::int32_t>(made_.limbs.back().rows.size()) - 1;
      made_.limbs.back().short_rows.push_back(short_row);
    }
    needle_ = row;
    made_.limbs.back().rows.push_back(row);
    ++made_.rounds_read;
  }
  void end(const knit::LimbEnd& end) {
    switch (end.kind) {
      case knit::LimbEndKind::goes_on:
        return;
      case knit::LimbEndKind::held:
        holders_[{now_, 0}] = needle_;
        break;
      case knit::LimbEndKind::closed:
        made_.closed.push_back(needle_);
        break;
      case knit::LimbEndKind::grafted: {
        Loop own = needle_;
        std::rotate(own.begin(), own.end() - end.slips_back, own.end());
        const Loop held = holders_.at({end.piece, 0});
        holders_.erase({end.piece, 0});
        std::size_t i = 0;
        std::int32_t k = end.other_first;
        const auto n = static_cast<std::int32_t>(held.size());
        for (const auto& graft : end.grafts) {
          for (std::int32_t a = 0; a < graft.own; ++a)
            for (std::int32_t b = 0; b < graft.others; ++b)
              made_.grafts.push_back({own.at(i + static_cast<std::size_t>(a)),
                                      held.at(static_cast<std::size_t>(((k - b) % n + n) % n))});
          i += static_cast<std::size_t>(graft.own);
          k -= graft.others;
        }
        break;
      }
    }
    needle_.clear();
  }
  const knit::LimbPlan& plan_;
  std::int32_t now_ = 0;
  Loop needle_;
  std::map<std::pair<std::int32_t, std::int32_t>, Loop> holders_;
  knit::ReadLimbs made_;
};

inline bool same_graph(const knit::ReadLimbs& a, const knit::ReadLimbs& b) {
  if (a.stitches != b.stitches || a.gaps != b.gaps || a.grafts != b.grafts || a.closed != b.closed ||
      a.limbs.size() != b.limbs.size())
    return false;
  for (std::size_t i = 0; i < a.limbs.size(); ++i)
    if (a.limbs[i].live != b.limbs[i].live || a.limbs[i].rows != b.limbs[i].rows ||
        a.limbs[i].short_rows != b.limbs[i].short_rows)
      return false;
  return true;
}

// The graph against the fabric: which of its stitches each number is, and what each hangs on. Empty: the same.
class AgainstFabric {
 public:
  AgainstFabric(const knit::LimbPlan& plan, const knit::ReadLimbs& graph, const knit::State& state)
      : plan_(plan), graph_(graph), fabric_(state.fabric) {}
  std::string differs() {
    for (std::int32_t piece = 0; piece < plan_.count(); ++piece) {
      const auto& own = plan_.piece(piece);
      const auto& rows = graph_.limbs[static_cast<std::size_t>(piece)].rows;
      if (rows.size() != own.rows.size()) return "rows of " + std::to_string(piece);
      for (std::size_t r = 0; r < rows.size(); ++r) {
        const auto n = static_cast<std::int32_t>(rows[r].size());
        if (n != knit::size_of(fabric_.row(own.rows[r]))) return "size of a row";
        for (std::int32_t i = 0; i < n; ++i)
          name_[rows[r][static_cast<std::size_t>(i)]] = {own.rows[r], (own.starts[r] + i) % n};
      }
    }
    for (std::int32_t piece = 0; piece < plan_.count(); ++piece) {
      const std::string wrong = piece_differs(piece);
      if (!wrong.empty()) return "piece " + std::to_string(piece) + ": " + wrong;
    }
    std::size_t bridges = 0, gaps = 0;
    for (const auto& deal : fabric_.deals()) bridges += deal->bridge.size();
    for (const auto& gap : graph_.gaps) gaps += gap.size();
    if (bridges != gaps || graph_.stitches.size() != fabric_.stitch_count()) return "count of stitches";
    return grafts_differ();
  }

 private:
  std::string piece_differs(std::int32_t piece) {
    const auto& own = plan_.piece(piece);
    const auto& limb = graph_.limbs[static_cast<std::size_t>(piece)];
    const knit::LiveStitches& on = fabric_.row(own.rows.front()).on;
    if (!on.empty()) {
      if (on.size() != static_cast<std::int32_t>(limb.live.size())) return "what it begins on";
      // A loop of nothing but bridges can be laid several ways: one of them must do.
      bool found = false;
      const auto before = bridge_;
      const knit::Join& first = *fabric_.join_into(own.rows.front());
      for (std::int32_t turn = 0; turn < on.size() && !found; ++turn) {
        bridge_ = before;
        found = matches(limb.live, on, turn) &&
                (own.rounds.front().copied || row_is_same(first, limb.rows.front()));
      }
      if (!found) return "what it begins on, or its first round";
    }
    for (std::size_t r = 0; r < own.rows.size(); ++r) {
      const knit::Join* join = fabric_.join_into(own.rows[r]);
      if (join == nullptr) continue;
      const bool copied = own.rounds[own.is_cast_on() ? r - 1 : r].copied;
      if (!copied && !row_is_same(*join, limb.rows[r])) return "round " + std::to_string(r + 1);
    }
    return "";
  }
  bool matches(const std::vector<std::int32_t>& live, const knit::LiveStitches& on, std::int32_t turn) {
    auto bridges = bridge_;
    for (std::int32_t i = 0; i < on.size(); ++i) {
      const knit::StitchRef ref = on.at((i + turn) % on.size());
      const std::int32_t number = live[static_cast<std::size_t>(i)];
      const auto named = name_.find(number);
      if (named != name_.end() ? named->second != ref : !knit::is_bridge(ref)) return false;
      if (named == name_.end() && !bridges.emplace(number, ref).second && bridges.at(number) != ref)
        return false;
    }
    bridge_ = std::move(bridges);
    return true;
  }
  knit::StitchRef ref_of(std::int32_t number) const {
    if (number < 0) return {0, -1};
    const auto named = name_.find(number);
    return named != name_.end() ? named->second : bridge_.at(number);
  }
  using Worked = std::tuple<knit::Hand, knit::StitchRef, knit::StitchRef>;
  // Read off labels and links, without operations.
  bool row_is_same(const knit::Join& join, const std::vector<std::int32_t>& row) const {
    const auto n = join.from.size();
    const auto below = [&](std::int32_t i) { return join.from.at((i % n + n) % n); };
    std::map<knit::StitchRef, Worked> wanted;
    std::int32_t before = 0;
    if (join.change() >= 0) {
      for (std::size_t cell = 0; cell < join.labels.size(); ++cell) {
        const bool made = knit::is_increase(join.labels[cell]);
        const knit::StitchRef own{join.to, static_cast<std::int32_t>(cell)};
        wanted[own] = made ? Worked{knit::hand_of(join.labels[cell]), below(before - 1), below(before)}
                           : Worked{knit::Hand::knit, below(before), knit::StitchRef{0, -1}};
        before += made ? 0 : 1;
      }
    } else {
      std::map<std::int32_t, std::vector<std::int32_t>> taken;
      std::map<std::int32_t, knit::Hand> hands;
      for (std::size_t cell = 0; cell < join.labels.size(); ++cell) {
        taken[join.link[cell]].push_back(static_cast<std::int32_t>(cell));
        if (knit::is_decrease(join.labels[cell])) hands[join.link[cell]] = knit::hand_of(join.labels[cell]);
      }
      for (const auto& [stitch, cells] : taken)
        wanted[{join.to, stitch}] = {cells.size() > 1 ? hands[stitch] : knit::Hand::knit, below(cells[0]),
                                     cells.size() > 1 ? below(cells[1]) : knit::StitchRef{0, -1}};
    }
    for (const std::int32_t number : row) {
      const auto& stitch = graph_.stitches[static_cast<std::size_t>(number)];
      if (wanted.at(ref_of(number)) != Worked{stitch.hand, ref_of(stitch.first), ref_of(stitch.second)})
        return false;
    }
    return row.size() == wanted.size();
  }
  std::string grafts_differ() const {
    const knit::KnittingPath path(fabric_);
    std::set<std::pair<knit::StitchRef, knit::StitchRef>> wanted, there;
    const auto pair = [](knit::StitchRef a, knit::StitchRef b) {
      return a < b ? std::pair(a, b) : std::pair(b, a);
    };
    for (const auto& deal : fabric_.deals()) {
      if (deal->kind != knit::DealKind::ring_bind_off) continue;
      for (const auto& edge : deal->column_edges) wanted.insert(pair(path.at(edge[0]), path.at(edge[1])));
    }
    for (const auto& graft : graph_.grafts) there.insert(pair(ref_of(graft[0]), ref_of(graft[1])));
    if (wanted != there) return "grafts";
    // Rounds on loops of a provisional cast on.
    std::set<std::pair<knit::StitchRef, knit::StitchRef>> ring, loops;
    for (const auto& deal : fabric_.deals()) {
      if (deal->kind != knit::DealKind::ring_cast_on) continue;
      for (const auto& edge : deal->column_edges) ring.insert(pair(path.at(edge[0]), path.at(edge[1])));
    }
    bool copied = false;
    for (std::int32_t piece = 0; piece < plan_.count(); ++piece) {
      if (plan_.piece(piece).deals.front().kind != knit::LimbDealKind::loops) continue;
      copied = copied || plan_.piece(piece).rounds.front().copied;
      for (const std::int32_t number : graph_.limbs[static_cast<std::size_t>(piece)].rows.front()) {
        const auto& stitch = graph_.stitches[static_cast<std::size_t>(number)];
        // An increase hangs on the stitch before its bar.
        loops.insert(pair(ref_of(number), ref_of(stitch.first)));
        if (knit::consumed_by(stitch.hand) == 2) loops.insert(pair(ref_of(number), ref_of(stitch.second)));
      }
    }
    return ring == loops || copied ? "" : "loops of a ring";
  }
  const knit::LimbPlan& plan_;
  const knit::ReadLimbs& graph_;
  const knit::Fabric& fabric_;
  std::map<std::int32_t, knit::StitchRef> name_, bridge_;
};

}  // namespace test_support
