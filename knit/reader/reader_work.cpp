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

// Stitch by stitch, beside the markers.
class MarkedWorker {
 public:
  MarkedWorker(std::int64_t live, const Markers& markers, const MarkerNames& names)
      : live_(live), markers_(markers), names_(names) {}

  WorkedRound run(const std::vector<WorkNode>& nodes) {
    for (const WorkNode& node : nodes) {
      if (node.open)
        go_on(node);
      else
        repeat(node);
    }
    if (sound() && at_ < live_)
      round_.mistake = " leaves " + stitches_text(live_ - at_) + " of the round before unworked.";
    while (next_ < markers_.size()) pass();
    return std::move(round_);
  }

 private:
  [[nodiscard]] bool sound() const { return round_.mistake.empty(); }
  void fail(std::string mistake) {
    if (sound()) round_.mistake = std::move(mistake);
  }
  void pass() {
    round_.markers.push_back(round_.made);
    ++next_;
  }

  void stitch(const WorkNode& node) {
    const StitchKind& kind = *node.stitch;
    if (kind.takes > 0 && next_ < markers_.size() && markers_[next_] == at_) pass();
    if (at_ + kind.takes > live_)
      fail(": " + node.words + " takes " + stitches_text(kind.takes) + ", and " + are_left(live_ - at_));
    if (next_ < markers_.size() && markers_[next_] < at_ + kind.takes)
      fail(": " + node.words + " takes stitches from both sides of a marker.");
    if (round_.made + kind.makes > most_stitches)
      fail(": it makes more than " + stitches_text(most_stitches) + ".");
    if (!sound()) return;
    if (kind.operations == 0) round_.told = false;
    for (std::int32_t i = 0; i < kind.operations; ++i)
      round_.operations.push_back({kind.hands.at(static_cast<std::size_t>(i)), false});
    at_ += kind.takes;
    round_.made += kind.makes;
  }

  void once(const WorkNode& node) {
    if (node.stitch) return stitch(node);
    for (const WorkNode& inner : node.inside) repeat(inner);
  }

  void repeat(const WorkNode& node) {
    if (node.to_marker) return up_to_marker(node);
    for (std::int64_t i = 0; i < node.times && sound(); ++i) once(node);
  }

  // The one that the words mean.
  [[nodiscard]] Markers::const_iterator ahead_of_here(const WorkNode& node) const {
    if (node.marker == MarkerName::next) return std::upper_bound(markers_.begin(), markers_.end(), at_);
    for (std::size_t i = 0; i < std::min(markers_.size(), names_.size()); ++i) {
      if (markers_[i] >= at_ && names_[i] == node.marker)
        return markers_.begin() + static_cast<std::ptrdiff_t>(i);
    }
    return markers_.end();
  }

  void up_to_marker(const WorkNode& node) {
    const auto ahead = ahead_of_here(node);
    if (ahead == markers_.end() && node.marker != MarkerName::next)
      return fail(": it goes to the " + std::string(marker_names[static_cast<std::size_t>(node.marker)]) +
                  " marker, and none is ahead.");
    if (ahead == markers_.end())
      return fail(markers_.empty() ? ": it goes to the next marker, and none is placed."
                                   : ": it goes to the next marker, and none is ahead.");
    const std::int64_t room = *ahead - at_ - node.tail;
    if (room < 0)
      return fail(": " + stitches_text(node.tail) + " are to be kept before the marker, and " +
                  are_left(*ahead - at_));
    for (std::int64_t i = 0; i < room && sound(); ++i) once(node);
  }

  // Over and over up to the end.
  void go_on(const WorkNode& node) {
    while (sound() && at_ < live_ - node.tail) {
      const std::int64_t before = at_;
      once(node);
      if (sound() && at_ == before)
        fail(": " + node.words + " takes no stitches, so it never comes to the end.");
    }
    if (sound() && at_ != live_ - node.tail)
      fail(": " + stitches_text(node.tail) + " are to be kept, and " + are_left(live_ - at_));
  }

  std::int64_t live_;
  const Markers& markers_;
  const MarkerNames& names_;
  std::size_t next_ = 0;
  std::int64_t at_ = 0;
  WorkedRound round_;
};

bool varies(const std::vector<WorkNode>& nodes) {
  return std::any_of(nodes.begin(), nodes.end(), [](const WorkNode& node) { return node.varies; });
}

// Where they stand after operations whose words name no marker.
Markers moved_markers(const WorkedRound& round, const Markers& markers) {
  Markers moved;
  std::int64_t at = 0;
  std::int64_t made = 0;
  std::size_t next = 0;
  for (const Operation& operation : round.operations) {
    const std::int32_t takes = consumed_by(operation.hand);
    if (takes > 0 && next < markers.size() && markers[next] == at) {
      moved.push_back(made);
      ++next;
    }
    if (next < markers.size() && markers[next] < at + takes) return {};
    at += takes;
    ++made;
  }
  for (; next < markers.size(); ++next) moved.push_back(made);
  return moved;
}

}  // namespace

std::string stitches_text(std::int64_t count) {
  return std::to_string(count) + (count == 1 ? " stitch" : " stitches");
}

WorkedRound work_round(const std::vector<WorkNode>& nodes, std::int64_t live, const Markers& markers,
                       const MarkerNames& names) {
  if (varies(nodes)) return MarkedWorker(live, markers, names).run(nodes);
  WorkedRound round = Worker(live).run(nodes);
  if (!markers.empty() && round.mistake.empty() && round.told) round.markers = moved_markers(round, markers);
  return round;
}

std::optional<std::int64_t> fixed_takes(const std::vector<WorkNode>& nodes) {
  std::int64_t takes = 0;
  for (const WorkNode& node : nodes) {
    if (node.open || node.varies) return std::nullopt;
    takes = std::min(most_number, takes + std::min(most_number, node.takes * node.times));
  }
  return takes;
}

}  // namespace knit
