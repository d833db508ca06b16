#include "knit/pattern/limb_needle.h"

#include <algorithm>
#include <map>
#include <utility>

#include "knit/model/bug.h"

namespace knit {

namespace {

using Needle = std::vector<NeedleStitch>;

class NeedleHands {
 public:
  explicit NeedleHands(const LimbPlan& plan) : plan_(plan), pieces_(plan.pieces.size()) {}

  std::vector<PieceNeedle> run() {
    for (now_ = 0; now_ < plan_.count(); ++now_) {
      for (const LimbDeal& deal : plan_.piece(now_).deals) lay(deal);
      work();
    }
    return std::move(pieces_);
  }
  [[nodiscard]] std::int32_t most() const { return most_; }

 private:
  using HolderKey = std::pair<std::int32_t, std::int32_t>;  // the piece it goes by, its number

  PieceNeedle& of(std::int32_t piece) { return pieces_[static_cast<std::size_t>(piece)]; }

  void hold(const LimbDeal& deal, Needle stitches) {
    for (const NeedleStitch& stitch : stitches) {
      if (stitch.use == NeedleUse::kept && stitch.piece >= 0 && stitch.gap == 0)
        of(stitch.piece).set_aside[static_cast<std::size_t>(stitch.stitch)] = deal.piece;
    }
    put({deal.piece, deal.holder}, std::move(stitches));
  }
  void put(HolderKey key, Needle stitches) {
    holders_[key] = std::move(stitches);
    most_ = std::max(most_, static_cast<std::int32_t>(holders_.size()));
  }

  static Needle across(std::int32_t gap, std::int32_t count) {
    Needle stitches;
    for (std::int32_t i = 0; i < count; ++i) stitches.push_back({NeedleUse::cast_on, -1, gap, i, -1});
    return stitches;
  }
  static void add(Needle& to, const Needle& from) { to.insert(to.end(), from.begin(), from.end()); }

  void lay(const LimbDeal& deal) {
    switch (deal.kind) {
      case LimbDealKind::cast_on:
      case LimbDealKind::provisional:
        needle_.clear();
        return;
      case LimbDealKind::loops:
        take_loops(deal);
        return;
      case LimbDealKind::set_aside:
        hold(deal, std::exchange(needle_, {}));
        return;
      case LimbDealKind::move:
        std::rotate(needle_.begin(), needle_.begin() + deal.before, needle_.end());
        return;
      case LimbDealKind::divide:
        divide(deal);
        return;
      case LimbDealKind::rejoin:
      case LimbDealKind::join:
        lay_items(deal);
        return;
    }
  }

  void take_loops(const LimbDeal& deal) {
    needle_.clear();
    for (std::int32_t i = deal.after; i-- > 0;)
      needle_.push_back({NeedleUse::taken, deal.piece, 0, i, deal.piece});
  }

  void divide(const LimbDeal& deal) {
    const auto begin = needle_.begin() + deal.before, end = begin + deal.held;
    Needle kept(needle_.begin(), begin);
    add(kept, across(deal.gap, deal.bridge));
    kept.insert(kept.end(), end, needle_.end());
    hold(deal, Needle(begin, end));
    needle_ = std::move(kept);
  }

  void lay_items(const LimbDeal& deal) {
    Needle laid;
    std::size_t kept = 0;
    for (const LimbItem& item : deal.items) {
      const auto count = static_cast<std::size_t>(item.count);
      switch (item.kind) {
        case LimbItemKind::keep:
          laid.insert(laid.end(), needle_.begin() + static_cast<std::ptrdiff_t>(kept),
                      needle_.begin() + static_cast<std::ptrdiff_t>(kept + count));
          kept += count;
          break;
        case LimbItemKind::take:
          take(item, laid);
          break;
        case LimbItemKind::cast_on:
          add(laid, across(item.gap, item.count));
          break;
        case LimbItemKind::pick_up:
          for (std::int32_t i = 0; i < item.count; ++i)
            laid.push_back({NeedleUse::picked_up, -1, item.gap, item.first - i, -1});
          break;
      }
    }
    for (const LimbItem& item : deal.items) {
      if (item.kind == LimbItemKind::take) holders_.erase({item.piece, item.holder});
    }
    needle_ = std::move(laid);
    if (static_cast<std::int32_t>(needle_.size()) != deal.after)
      throw Bug("a deal lays another number of stitches");
  }

  void take(const LimbItem& item, Needle& laid) {
    const Needle& holder = holders_.at({item.piece, item.holder});
    const auto held = static_cast<std::int32_t>(holder.size());
    for (std::int32_t i = 0; i < item.count; ++i) {
      NeedleStitch stitch = holder[static_cast<std::size_t>((item.first + i) % held)];
      stitch.use = NeedleUse::taken;
      stitch.holder = item.piece;
      laid.push_back(stitch);
      if (stitch.piece >= 0 && of(stitch.piece).entered < 0) of(stitch.piece).entered = stitch.stitch;
    }
  }

  void work() {
    PieceNeedle& own = of(now_);
    own.begin = needle_;
    own.held = static_cast<std::int32_t>(holders_.size());
    for (const NeedleStitch& stitch : needle_) {
      if (stitch.piece >= 0 && of(stitch.piece).next < 0) of(stitch.piece).next = now_;
    }
    const LimbPiece& piece = plan_.piece(now_);
    own.set_aside.assign(static_cast<std::size_t>(piece.last_count()), -1);
    Needle last;
    for (std::int32_t i = 0; i < piece.last_count(); ++i) last.push_back({NeedleUse::kept, now_, 0, i, -1});
    needle_.clear();
    switch (piece.end.kind) {
      case LimbEndKind::goes_on:
        needle_ = std::move(last);
        break;
      case LimbEndKind::held:
        put({now_, 0}, std::move(last));
        break;
      case LimbEndKind::grafted:
        holders_.erase({piece.end.piece, 0});
        break;
      case LimbEndKind::closed:
        break;
    }
  }

  const LimbPlan& plan_;
  std::vector<PieceNeedle> pieces_;
  std::int32_t now_ = 0, most_ = 0;
  Needle needle_;
  std::map<HolderKey, Needle> holders_;
};

}  // namespace

std::vector<PieceNeedle> needles_of(const LimbPlan& plan) { return NeedleHands(plan).run(); }

std::int32_t holders_needed(const LimbPlan& plan) {
  NeedleHands hands(plan);
  hands.run();
  return hands.most();
}

}  // namespace knit
