#include "tests/support/world_model.h"

#include <algorithm>
#include <map>

namespace world {

// Takes and makes as in the Craft Yarn Council's list of abbreviations and, for the UK, the UK Hand Knitting Association's.
const std::vector<Word>& words() {
  static const std::vector<Word> list{
      {1, 1, {"k"}},
      {1, 1, {"p"}},
      {0, 1, {"m1"}},
      {0, 1, {"m1l"}},
      {0, 1, {"m1r"}},
      {0, 1, {"M1-L"}},
      {0, 1, {"M1A"}},
      {0, 1, {"m1p"}},
      {0, 1, {"yo"}},
      {0, 1, {"LLI"}},
      {0, 1, {"RLI"}},
      {0, 1, {"make 1"}},
      {0, 1, {"yfwd"}},
      {1, 2, {"kfb"}},
      {1, 2, {"k1fb"}},
      {1, 2, {"kf&b"}},
      {1, 2, {"k1f&b"}},
      {1, 2, {"pfb"}},
      {1, 2, {"(k1, p1) in next st"}},
      {1, 3, {"kyok"}},
      {1, 3, {"(k1, yo, k1) in next st"}},
      {2, 1, {"k2tog"}},
      {2, 1, {"ssk"}},
      {2, 1, {"skp"}},
      {2, 1, {"skpo"}},
      {2, 1, {"p2tog"}},
      {2, 1, {"ssp"}},
      {2, 1, {"k2tog-tbl"}},
      {2, 1, {"k2togtbl"}},
      {2, 1, {"k 2 tog"}},
      {2, 1, {"k2 tog"}},
      {2, 1, {"knit 2 together"}},
      {2, 1, {"knit two together"}},
      {2, 1, {"sl 1, k1, psso"}},
      {2, 1, {"sl1, k1, psso"}},
      {3, 1, {"k3tog"}},
      {3, 1, {"sk2p"}},
      {3, 1, {"s2kp2"}},
      {3, 1, {"s2kp"}},
      {3, 1, {"CDD"}},
      {3, 1, {"sssk"}},
      {3, 1, {"p3tog"}},
      {3, 1, {"sl 1, k2tog, psso"}},
      {3, 1, {"sl 2, k1, p2sso"}},
      {1, 1, {"k1tbl"}},
      {1, 1, {"sl 1"}},
      {1, 1, {"sl1"}},
      {1, 1, {"slip 1"}},
      {1, 1, {"sl1 pwise"}},
  };
  return list;
}

namespace {

struct Stop {
  Truth truth;
};

// The needle in one round: `at` stitches taken of `before`, `out` made. Markers lie before the stitch of their number.
class Needle {
 public:
  Needle(int before, std::vector<int> markers, std::map<std::string, int>& holders, std::size_t size)
      : before_(before), markers_(std::move(markers)), holders_(holders), size_(size) {}

  void work(const std::vector<Part>& parts) {
    for (const Part& part : parts) work(part);
  }
  int finish() {
    if (at_ != before_) throw Stop{Truth::wrong};
    while (next_ < markers_.size()) pass_marker();
    return out_;
  }
  [[nodiscard]] const std::vector<int>& markers() const { return left_; }

 private:
  void work(const Part& part) {
    const int times = part.times.of[size_];
    switch (part.kind) {
      case Kind::stitch:
      case Kind::group:
        if (part.fill != Fill::times) return fill(part);
        if (times < 1) throw Stop{Truth::unclear};
        for (int i = 0; i < times; ++i) once(part);
        return;
      case Kind::place_marker:
        left_.push_back(out_);
        return;
      case Kind::slip_marker:
        if (markers_.empty()) return;
        if (next_ == markers_.size() || markers_[next_] != at_) throw Stop{Truth::unclear};
        return pass_marker();
      case Kind::evenly:
        if (at_ != 0 || times < 1 || (part.fewer ? 2 * times : times) > before_) throw Stop{Truth::unclear};
        at_ = before_;
        out_ = before_ + (part.fewer ? -times : times);
        if (!markers_.empty()) throw Stop{Truth::unclear};
        return;
      case Kind::hold:
        for (int i = 0; i < times; ++i) take(1, 0);
        holders_[part.name] = times;
        return;
      case Kind::gap:
        out_ += times;
        return;
      case Kind::from_holder: {
        const auto held = holders_.find(part.name);
        if (held == holders_.end() || held->second != times) throw Stop{Truth::wrong};
        holders_.erase(held);
        out_ += times;
        return;
      }
    }
  }

  void once(const Part& part) {
    if (part.kind == Kind::group) return work(part.parts);
    take(words()[part.word].takes, words()[part.word].makes);
  }

  // Repeats that go as far as the stitches do.
  void fill(const Part& part) {
    int end = before_;
    if (part.fill == Fill::to_marker || part.fill == Fill::to_before_marker) {
      if (next_ < markers_.size() && markers_[next_] == at_) throw Stop{Truth::unclear};
      if (next_ == markers_.size()) throw Stop{Truth::unclear};
      end = markers_[next_];
    }
    end -= part.fill == Fill::to_end || part.fill == Fill::to_marker ? 0 : part.reserve.of[size_];
    const int unit = takes(part);
    if (unit < 1 || end == at_) throw Stop{Truth::unclear};
    if (end < at_ || (end - at_) % unit != 0) throw Stop{Truth::wrong};
    for (int i = (end - at_) / unit; i > 0; --i) once(part);
  }

  [[nodiscard]] int takes(const Part& part) const {
    if (part.kind == Kind::stitch) return words()[part.word].takes;
    int sum = 0;
    for (const Part& inner : part.parts) {
      if (inner.fill != Fill::times || (inner.kind != Kind::stitch && inner.kind != Kind::group)) return 0;
      sum += takes(inner) * inner.times.of[size_];
    }
    return sum;
  }

  void take(int taken, int made) {
    if (taken > 0 && next_ < markers_.size() && markers_[next_] == at_) pass_marker();
    if (next_ < markers_.size() && markers_[next_] < at_ + taken && at_ + taken <= before_)
      throw Stop{Truth::unclear};
    at_ += taken;
    out_ += made;
    if (at_ > before_) throw Stop{Truth::wrong};
    if (out_ > 4000) throw Stop{Truth::unclear};
  }
  void pass_marker() {
    left_.push_back(out_);
    ++next_;
  }

  int before_, at_ = 0, out_ = 0;
  std::vector<int> markers_, left_;
  std::size_t next_ = 0;
  std::map<std::string, int>& holders_;
  std::size_t size_;
};

class Worker {
 public:
  Worker(const Pattern& pattern, std::size_t size) : pattern_(pattern), size_(size) {}

  Finding work() {
    for (std::size_t i = 0; i < pattern_.lines.size(); ++i) {
      try {
        line(pattern_.lines[i]);
      } catch (const Stop& stop) {
        return {stop.truth, i};
      }
    }
    return {};
  }

 private:
  void line(const Line& line) {
    const int count = line.count.of[size_];
    switch (line.kind) {
      case LineKind::note:
        if (line.name == "markers") markers_.clear();
        return;
      case LineKind::cast_on:
        needle_ = count;
        has_rule_ = false;
        markers_.clear();
        by_number_.clear();
        latest_.clear();
        break;
      case LineKind::round:
        round(line);
        break;
      case LineKind::even:
        if (count < 1) throw Stop{Truth::unclear};
        latest_.clear();
        break;
      case LineKind::again:
        again(line, count);
        break;
      case LineKind::close:
        if (line.says_count && count != needle_) throw Stop{Truth::wrong};
        needle_ = 0;
        return;
      case LineKind::put_aside:
        holders_[line.name] = needle_;
        needle_ = 0;
        return;
      case LineKind::take_back: {
        const auto held = holders_.find(line.name);
        if (held == holders_.end() || held->second != count) throw Stop{Truth::wrong};
        holders_.erase(held);
        needle_ = count + line.picked_up.of[size_];
        markers_.clear();
        by_number_.clear();
        latest_.clear();
        break;
      }
    }
    if (line.stated && line.stated->of[size_] != needle_) throw Stop{Truth::wrong};
  }

  void round(const Line& line) {
    if (!line.numbers.empty()) {
      for (const int number : line.numbers) by_number_[number] = &line;
      has_rule_ = has_rule_ || line.label >= 100;
      if (!line.whole) throw Stop{Truth::unclear};
      return;
    }
    const Line* told = &line;
    if (line.like > 0) {
      const auto found = by_number_.find(line.like);
      // "Rnd 2 and every alternate rnd" tells of rounds that have no line.
      if (found == by_number_.end()) throw Stop{has_rule_ ? Truth::unclear : Truth::wrong};
      told = found->second;
    }
    for (int i = line.first; i <= line.last; ++i) {
      one(*told);
      if (i > 0) by_number_[i] = told;
    }
    latest_.push_back(told);
  }

  void one(const Line& line) {
    if (needle_ < 1) throw Stop{Truth::unclear};
    if (line.whole) return;
    Needle needle(needle_, markers_, holders_, size_);
    needle.work(line.parts);
    needle_ = needle.finish();
    markers_ = needle.markers();
  }

  void again(const Line& line, int times) {
    std::vector<const Line*> rounds;
    if (line.from > 0) {
      for (int i = line.from; i <= line.to; ++i) {
        const auto found = by_number_.find(i);
        if (found == by_number_.end()) throw Stop{Truth::wrong};
        rounds.push_back(found->second);
      }
    } else {
      const auto many = static_cast<std::size_t>(line.to);
      if (latest_.size() < many) throw Stop{Truth::unclear};
      rounds.assign(latest_.end() - line.to, latest_.end());
      for (const Line* each : rounds) {
        if (each->first != each->last) throw Stop{Truth::unclear};
      }
    }
    if (!line.until) {
      if (times < 1) throw Stop{Truth::unclear};
      for (int i = 0; i < times; ++i) {
        for (const Line* each : rounds) one(*each);
      }
      return;
    }
    if (needle_ == line.until->of[size_]) throw Stop{Truth::unclear};
    for (int i = 0; i < 400 && needle_ != line.until->of[size_]; ++i) {
      for (const Line* each : rounds) one(*each);
    }
    if (needle_ != line.until->of[size_]) throw Stop{Truth::wrong};
  }

  const Pattern& pattern_;
  std::size_t size_;
  int needle_ = 0;
  bool has_rule_ = false;
  std::vector<int> markers_;
  std::map<int, const Line*> by_number_;
  std::vector<const Line*> latest_;  // rounds since the last line of another kind
  std::map<std::string, int> holders_;
};

void numbers_of(std::vector<Part>& parts, std::vector<Num*>& found, bool is_inner) {
  for (Part& part : parts) {
    if (part.kind == Kind::group) numbers_of(part.parts, found, true);
    const bool is_counted = part.kind != Kind::place_marker && part.kind != Kind::slip_marker;
    // "k2tog" once says no number.
    const bool says = part.kind != Kind::stitch || part.word == knit_word || part.word == purl_word;
    if (is_counted && says && part.fill == Fill::times && (part.kind != Kind::evenly || !is_inner))
      found.push_back(&part.times);
    if (part.fill == Fill::to_last || part.fill == Fill::to_before_marker) found.push_back(&part.reserve);
  }
}

void stitches_of(std::vector<Part>& parts, std::vector<Part*>& found) {
  for (Part& part : parts) {
    if (part.kind == Kind::group) stitches_of(part.parts, found);
    const bool is_lone = part.fill == Fill::times && part.times == Num(1);
    if (part.kind == Kind::stitch && is_lone) found.push_back(&part);
  }
}

std::vector<Num*> numbers_of(Line& line) {
  std::vector<Num*> found;
  if (line.stated) found.push_back(&*line.stated);
  if (line.until) found.push_back(&*line.until);
  const bool is_counted = line.kind == LineKind::cast_on || line.kind == LineKind::take_back ||
                          (line.kind == LineKind::close && line.says_count) ||
                          (line.kind == LineKind::again && !line.until);
  if (is_counted) found.push_back(&line.count);
  if (line.kind == LineKind::take_back) found.push_back(&line.picked_up);
  if (!line.whole) numbers_of(line.parts, found, false);
  return found;
}

bool is_work(const Line& line) {
  return line.kind == LineKind::round || line.kind == LineKind::again || line.kind == LineKind::even;
}

}  // namespace

Finding work(const Pattern& pattern) {
  Finding worst;
  for (std::size_t size = 0; size < pattern.sizes; ++size) {
    const Finding found = Worker(pattern, size).work();
    if (found.truth == Truth::wrong) return found;
    if (found.truth == Truth::unclear) worst = found;
  }
  return worst;
}

std::optional<Changed> change(const Pattern& pattern, Dice& dice) {
  Changed made{pattern, ""};
  std::vector<std::size_t> of_work;
  for (std::size_t i = 0; i < pattern.lines.size(); ++i) {
    if (pattern.lines[i].kind != LineKind::note) of_work.push_back(i);
  }
  const std::size_t at = dice.of(of_work);
  Line& line = made.pattern.lines[at];
  const int kind = dice.roll(0, 9);
  if (kind < 6) {
    const std::vector<Num*> numbers = numbers_of(line);
    if (numbers.empty()) return std::nullopt;
    Num& number = *dice.of(numbers);
    const int by = dice.chance(50) ? 1 : -1;
    const bool all = pattern.sizes == 1 || number == Num(number.of[0]);
    const auto one = static_cast<std::size_t>(dice.roll(0, static_cast<int>(pattern.sizes) - 1));
    for (std::size_t size = 0; size < most_sizes; ++size) {
      if (all || size == one) number.of[size] += by;
    }
    if (*std::min_element(number.of.begin(), number.of.end()) < 1) return std::nullopt;
    made.what = "a number";
  } else if (kind < 8) {
    std::vector<Part*> stitches;
    if (!line.whole) stitches_of(line.parts, stitches);
    if (stitches.empty()) return std::nullopt;
    Part& stitch = *dice.of(stitches);
    const Word& was = words()[stitch.word];
    const auto other = static_cast<std::size_t>(dice.roll(0, static_cast<int>(words().size()) - 1));
    if (words()[other].takes == was.takes && words()[other].makes == was.makes) return std::nullopt;
    stitch.word = other;
    made.what = "a word";
  } else {
    if (!is_work(line)) return std::nullopt;
    const auto here = made.pattern.lines.begin() + static_cast<std::ptrdiff_t>(at);
    if (kind == 8) {
      made.pattern.lines.insert(here, Line(line));
      made.what = "a line twice";
    } else {
      made.pattern.lines.erase(here);
      made.what = "a line left out";
    }
  }
  return made;
}

}  // namespace world
