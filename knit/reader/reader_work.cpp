#include "knit/reader/reader_work.h"

#include <algorithm>

namespace knit {

namespace {

std::string are_left(std::int64_t left) {
  return std::to_string(left) + (left == 1 ? " is left." : " are left.");
}

class Worker {
 public:
  explicit Worker(std::int64_t live) : left_(live) {}

  WorkedRound run(const std::vector<WorkNode>& nodes) {
    for (const WorkNode& node : nodes) {
      const std::int64_t times = node.open ? times_to_tail(node) : times_given(node);
      if (!round_.mistake.empty()) return std::move(round_);
      if (node.makes * times > most_stitches - round_.made) {
        round_.mistake = ": it makes more than " + stitches_text(most_stitches) + ".";
        return std::move(round_);
      }
      left_ -= node.takes * times;
      round_.made += node.makes * times;
      for (std::int64_t i = 0; i < times; ++i) once(node);
    }
    if (left_ > 0) round_.mistake = " leaves " + stitches_text(left_) + " of the round before unworked.";
    return std::move(round_);
  }

 private:
  // Products stay below 1e18: both factors are at most `most_number`.
  std::int64_t times_given(const WorkNode& node) {
    const std::int64_t all = node.takes * node.times;
    if (all <= left_) return node.times;
    const std::string how_often = node.times > 1 ? " " + std::to_string(node.times) + " times" : "";
    round_.mistake =
        ": " + node.words + how_often + " takes " + stitches_text(all) + ", and " + are_left(left_);
    return 0;
  }

  std::int64_t times_to_tail(const WorkNode& node) {
    const std::int64_t room = left_ - node.tail;
    if (node.takes == 0) {
      round_.mistake = ": " + node.words + " takes no stitches, so it never comes to the end.";
    } else if (room < 0) {
      round_.mistake = ": " + stitches_text(node.tail) + " are to be kept, and " + are_left(left_);
    } else if (room % node.takes != 0 || (room == 0 && !node.stitch)) {
      round_.mistake = ": " + node.words + " takes " + stitches_text(node.takes) + ", and " + are_left(room);
    } else {
      return room / node.takes;
    }
    return 0;
  }

  void once(const WorkNode& node) {
    if (node.stitch) {
      const StitchKind& kind = *node.stitch;
      if (kind.operations == 0) round_.told = false;
      for (std::int32_t i = 0; i < kind.operations; ++i)
        round_.operations.push_back({kind.hands.at(static_cast<std::size_t>(i)), false});
      return;
    }
    for (const WorkNode& inner : node.inside) {
      for (std::int64_t i = 0; i < inner.times; ++i) once(inner);
    }
  }

  std::int64_t left_;
  WorkedRound round_;
};

}  // namespace

std::string stitches_text(std::int64_t count) {
  return std::to_string(count) + (count == 1 ? " stitch" : " stitches");
}

WorkedRound work_round(const std::vector<WorkNode>& nodes, std::int64_t live) {
  return Worker(live).run(nodes);
}

std::optional<std::int64_t> fixed_takes(const std::vector<WorkNode>& nodes) {
  std::int64_t takes = 0;
  for (const WorkNode& node : nodes) {
    if (node.open) return std::nullopt;
    takes = std::min(most_number, takes + std::min(most_number, node.takes * node.times));
  }
  return takes;
}

}  // namespace knit
