#include "knit/trade/world_needle.h"

#include <algorithm>
#include <numeric>

#include "knit/model/words.h"

namespace knit {

namespace {

using Kind = WorldNode::Kind;
using Until = WorldNode::Until;

std::int64_t sum(const Segments& segments) {
  return std::accumulate(segments.begin(), segments.end(), std::int64_t{0});
}
std::int64_t bounded(std::int64_t value) { return std::min(value, most_value); }
std::string many(std::int64_t count) { return stitch_count_text(count); }

class Hands {
 public:
  Hands(WorldNeedle& needle, const WorldHands& others, std::int64_t& budget)
      : needle_(needle), others_(others), budget_(budget) {}

  void run(const std::vector<WorldNode>& nodes) { sequence(nodes, 0); }
  WorldOutcome out;
  std::size_t first_marker = 0;  // of the left needle that is still ahead

 private:
  [[nodiscard]] bool stopped() const { return !out.sound() || out.turned; }
  void wrong(const WorldNode& node, std::string sentence) {
    if (!out.sound()) return;
    out.wrong = std::move(sentence);
    out.at = node.at;
    out.length = node.length;
  }
  void unknown(const WorldNode& node, std::string sentence) {
    if (!out.sound()) return;
    out.unknown = std::move(sentence);
    out.at = node.at;
    out.length = node.length;
  }
  // The segments of `left` are kept in order; the one worked from is `front`.
  [[nodiscard]] std::int64_t left() const {
    return std::accumulate(needle_.left.begin() + static_cast<std::ptrdiff_t>(first_marker),
                           needle_.left.end(), std::int64_t{0});
  }
  [[nodiscard]] bool none_yet() const {
    return std::all_of(needle_.right.begin(), needle_.right.end(),
                       [](std::int64_t stitches) { return stitches == 0; });
  }
  [[nodiscard]] bool marker_ahead() const { return first_marker + 1 < needle_.left.size(); }
  std::int64_t& front() { return needle_.left[first_marker]; }
  void cross() {
    ++first_marker;
    needle_.right.push_back(0);
  }

  // A step walks over the markers now and then, so it costs more where they pile up.
  bool spend(const WorldNode& node) {
    constexpr std::size_t few = 16;
    budget_ -=
        static_cast<std::int64_t>(1 + (needle_.left.size() - first_marker + needle_.right.size()) / few);
    if (budget_ < 0) unknown(node, "the pattern is longer than can be worked.");
    return budget_ >= 0;
  }

  // `times` stitches that take and make so many.
  void stitches(const WorldNode& node, std::int64_t takes, std::int64_t makes, std::int64_t times) {
    if (times <= 0) return;
    if (takes == 0) {
      needle_.right.back() = bounded(needle_.right.back() + bounded(makes * times));
      return;
    }
    if (takes > left() / times) return wrong(node, needs(takes * times));
    while (times > 0) {
      if (!spend(node)) return;
      while (front() == 0 && marker_ahead()) cross();
      const std::int64_t here = std::min(times, front() / takes);
      if (here > 0) {
        front() -= here * takes;
        needle_.right.back() = bounded(needle_.right.back() + bounded(here * makes));
        times -= here;
        continue;
      }
      std::int64_t missing = takes;  // a stitch that reaches across a marker
      while (missing > 0) {
        const std::int64_t part = std::min(missing, front());
        front() -= part;
        missing -= part;
        if (missing > 0) cross();
      }
      needle_.right.back() = bounded(needle_.right.back() + makes);
      --times;
    }
  }

  [[nodiscard]] std::string needs(std::int64_t wanted) const {
    return many(bounded(wanted)) + (wanted == 1 ? " is" : " are") + " to be worked, and " + many(left()) +
           (left() == 1 ? " is" : " are") + " left.";
  }

  void sequence(const std::vector<WorldNode>& nodes, std::int64_t behind) {
    for (std::size_t i = 0; i < nodes.size() && !stopped(); ++i) {
      if (!spend(nodes[i])) return;
      const bool open = nodes[i].until == Until::end && !nodes[i].tail;
      std::int64_t rest = behind;
      if (open) {
        for (std::size_t j = i + 1; j < nodes.size(); ++j) {
          const auto fixed = fixed_work({nodes[j]});
          if (fixed) rest = bounded(rest + fixed->takes);
        }
      }
      node(nodes[i], open ? rest : 0);
    }
  }

  void node(const WorldNode& node, std::int64_t rest) {
    switch (node.kind) {
      case Kind::stitch:
      case Kind::repeat:
        return repeat(node, rest);
      case Kind::place_marker:
        needle_.right.push_back(0);
        needle_.marked = true;
        return;
      case Kind::slip_marker:
        return slip_marker(node);
      case Kind::remove_marker:
        if (front() == 0 && marker_ahead())
          ++first_marker;
        else if (needle_.right.size() > 1 && needle_.right.back() == 0)
          needle_.right.pop_back();
        return;
      case Kind::shape:
        return shape(node);
      case Kind::rest:
        return rest_of(node);
      case Kind::hold:
      case Kind::bind_off:
        return put_away(node);
      case Kind::take:
        return take(node);
      case Kind::add:
        needle_.right.back() = bounded(needle_.right.back() + node.times);
        return;
      case Kind::turn:
        out.turned = true;
        return;
      case Kind::insert:
        if (node.times > left()) wrong(node, needs(node.times));
        if (others_.hold && out.sound()) others_.hold(node, node.times);
        if (node.makes > 0 && out.sound()) stitches(node, 1, 1, node.times);
        return;
    }
  }

  void slip_marker(const WorldNode& node) {
    if (front() == 0 && marker_ahead()) return cross();
    const bool here = needle_.right.size() > 1 && needle_.right.back() == 0;
    const bool at_end = none_yet() || left() == 0;
    if (here || at_end || !needle_.marked) return;
    unknown(node, "no marker stands there.");
  }

  // All that is left is worked, with so many more or fewer.
  void shape(const WorldNode& node) {
    const std::int64_t there = left();
    if (node.makes < 0 && -node.makes * 2 > there + sum(needle_.right) && -node.makes >= there)
      return wrong(node, many(-node.makes) + " cannot be decreased among " + many(there) + ".");
    lay(there);
    std::int64_t change = node.makes;
    for (std::size_t i = needle_.right.size(); i-- > 0 && change != 0;) {
      const std::int64_t part = std::max(change, -needle_.right[i]);
      needle_.right[i] = bounded(needle_.right[i] + part);
      change -= part;
    }
    if (needle_.right.size() > 1) lost_ = true;
  }
  void lay(std::int64_t count) {
    WorldNode plain;
    stitches(plain, 1, 1, count);
  }
  void rest_of(const WorldNode& node) {
    if (node.until == Until::marker) return repeat(node, 0);
    const std::int64_t count = left() - node.tail.value_or(0);
    if (count < 0) return wrong(node, needs(node.tail.value_or(0)));
    lay(count);
  }

  void put_away(const WorldNode& node) {
    const std::int64_t count = node.times > 0 ? node.times : left();
    if (count > left()) return wrong(node, needs_away(count, node.kind == Kind::hold));
    stitches(node, 1, 0, count);
    if (node.kind != Kind::hold || !others_.hold) return;
    const std::string complaint = others_.hold(node, count);
    if (!complaint.empty()) wrong(node, complaint);
  }
  [[nodiscard]] std::string needs_away(std::int64_t count, bool hold) const {
    if (!hold)
      return many(count) + " are to be bound off, and " + many(left()) + (left() == 1 ? " is" : " are") +
             " left.";
    return many(count) + " are to go on a holder, and " + many(left()) + (left() == 1 ? " is" : " are") +
           " left.";
  }

  void take(const WorldNode& node) {
    if (!others_.take) return unknown(node, "no stitches are held.");
    std::string complaint;
    const auto count = others_.take(node, complaint);
    if (!complaint.empty()) return wrong(node, complaint);
    if (!count) return unknown(node, "it is not known how many stitches are held.");
    needle_.right.back() = bounded(needle_.right.back() + *count);
  }

  void once(const WorldNode& node) {
    if (node.kind == Kind::repeat)
      sequence(node.inside, 0);
    else
      stitches(node, node.takes, node.makes, 1);
  }

  void repeat(const WorldNode& node, std::int64_t rest) {
    const auto fixed = node.kind == Kind::repeat ? fixed_work(node.inside)
                                                 : std::optional(FixedWork{node.takes, node.makes});
    if (node.until == Until::marker) return to_marker(node, fixed);
    std::int64_t times = node.times;
    if (node.until == Until::end) {
      const std::int64_t there = left() - node.tail.value_or(rest);
      if (there < 0) return wrong(node, needs(node.tail.value_or(rest)));
      if (!fixed) return over_and_over(node, node.tail.value_or(rest));
      if (fixed->takes == 0) return unknown(node, "it takes no stitch, so it never comes to the end.");
      if (there % fixed->takes != 0) return wrong(node, uneven(there, fixed->takes));
      times = there / fixed->takes;
    }
    if (node.kind == Kind::stitch) return stitches(node, node.takes, node.makes, times);
    if (fixed && !marker_ahead()) {
      if (fixed->takes > 0 && times > left() / fixed->takes)
        return wrong(node, needs(bounded(times) * fixed->takes));
      front() -= fixed->takes * times;
      needle_.right.back() = bounded(needle_.right.back() + bounded(fixed->makes) * bounded(times));
      return;
    }
    for (std::int64_t i = 0; i < times && !stopped(); ++i) {
      if (!spend(node)) return;
      once(node);
    }
  }

  static std::string uneven(std::int64_t there, std::int64_t takes) {
    return "the repeat takes " + many(takes) + ", and " + many(there) + " do not divide by it.";
  }

  void over_and_over(const WorldNode& node, std::int64_t tail) {
    while (left() > tail && !stopped()) {
      const std::int64_t before = left();
      if (!spend(node)) return;
      once(node);
      if (left() == before && !stopped())
        return unknown(node, "it takes no stitch, so it never comes to the end.");
    }
    if (left() < tail) wrong(node, needs(tail));
  }

  void to_marker(const WorldNode& node, const std::optional<FixedWork>& fixed) {
    const std::int64_t tail = node.tail.value_or(0);
    if (!fixed || fixed->takes == 0) return unknown(node, "what is repeated up to the marker is not clear.");
    if (front() == 0 && marker_ahead() && (tail == 0 || node.next)) cross();
    if (!marker_ahead() && needle_.marked && first_marker + 1 == needle_.left.size() && none_yet() &&
        tail == 0 && left() == 0)
      return unknown(node, "no marker stands ahead.");
    const std::int64_t there = front() - tail;
    if (there < 0)
      return wrong(node, many(tail) + " before the marker, and " + many(front()) + " are there.");
    if (there % fixed->takes != 0) return wrong(node, uneven(there, fixed->takes));
    const std::int64_t times = there / fixed->takes;
    front() -= there;
    needle_.right.back() = bounded(needle_.right.back() + bounded(fixed->makes * times));
  }

  WorldNeedle& needle_;
  const WorldHands& others_;
  std::int64_t& budget_;
  bool lost_ = false;
};

}  // namespace

std::int64_t WorldNeedle::count() const { return bounded(sum(left) + sum(right)); }
std::int64_t WorldNeedle::left_count() const { return sum(left); }
void WorldNeedle::set(std::int64_t stitches) {
  left = {stitches};
  right = {0};
  marked = false;
}

std::optional<FixedWork> fixed_work(const std::vector<WorldNode>& nodes) {
  FixedWork all;
  for (const WorldNode& node : nodes) {
    FixedWork one{node.takes, node.makes};
    if (node.kind == Kind::bind_off || node.kind == Kind::hold) {
      if (node.times == 0) return std::nullopt;
      one = {1, 0};
    } else if (node.kind == Kind::add) {
      one = {0, 1};
    } else if (node.kind == Kind::repeat && node.until == Until::times) {
      const auto inside = fixed_work(node.inside);
      if (!inside) return std::nullopt;
      one = *inside;
    } else if (node.kind != Kind::stitch || node.until != Until::times) {
      return std::nullopt;
    }
    all.takes = bounded(all.takes + bounded(one.takes) * bounded(node.times));
    all.makes = bounded(all.makes + bounded(one.makes) * bounded(node.times));
  }
  return all;
}

WorldOutcome work_on(WorldNeedle& needle, const std::vector<WorldNode>& nodes, bool flat,
                     const WorldHands& hands, std::int64_t& budget) {
  Hands worker(needle, hands, budget);
  worker.run(nodes);
  needle.left.erase(needle.left.begin(),
                    needle.left.begin() + static_cast<std::ptrdiff_t>(worker.first_marker));
  if (!worker.out.sound()) return worker.out;
  const auto swapped = [&] {
    std::reverse(needle.left.begin(), needle.left.end());
    std::reverse(needle.right.begin(), needle.right.end());
    std::swap(needle.left, needle.right);
  };
  if (worker.out.turned) {
    swapped();
    return worker.out;
  }
  if (needle.left_count() > 0) {
    worker.out.wrong = "leaves " + many(needle.left_count()) + " of the round before unworked.";
    return worker.out;
  }
  for (std::size_t i = 1; i < needle.left.size(); ++i) needle.right.push_back(0);
  needle.left = {0};
  if (flat)
    swapped();
  else
    std::swap(needle.left, needle.right);
  return worker.out;
}

}  // namespace knit
