// Makes the patterns of world_model.h: every round is chosen so that it can be worked on what the needle holds.
#include <algorithm>
#include <numeric>

#include "tests/support/world_model.h"
#include "tests/support/world_text.h"

namespace world {

namespace {

constexpr std::array titles{"Bobble hat",
                            "Striped sock",
                            "Little bear",
                            "A mouse to knit",
                            "Hat No. 7",
                            "Egg cosy (version 2)",
                            "Cowl for two balls of yarn",
                            "Toy carrot"};

constexpr std::array front_notes{
    "Skill level: 2",
    "Difficulty: 2 of 5",
    "Finished size: 20 cm (8 in) tall",
    "Materials: 50 g of DK yarn, 3.25 mm dpns, stuffing, stitch holder",
    "Yarn: 100 g (200 m) of worsted weight",
    "Needles: 4 mm (US 6)",
    "Gauge: 22 sts and 30 rnds = 10 cm (4 in) in stockinette",
    "GAUGE: 20 sts = 4 inches",
    "Tension: 24 sts and 32 rows to 10 cm over st st",
    "Abbreviations: k, p, st(s), rnd(s), rep, pm, sm",
    "k2tog = knit 2 stitches together",
    "kfb: knit into the front and back of the same stitch",
    "m1l: make one stitch, leaning left",
    "ssk - slip, slip, knit the two slipped stitches together",
    "CO = cast on, BO = bind off",
    "The first 3 rounds make the brim.",
    "The stitch count stands in brackets after each round that changes it.",
    "Read the whole pattern before you begin.",
    "This hat fits an adult of average size.",
    "Copyright 2019. For personal use only.",
    "NOTES",
    "INSTRUCTIONS",
    "Pattern notes: the piece is worked from the bottom up.",
};
constexpr std::array inner_notes{
    "Stuff the head as you go.",
    "Change to dpns when needed.",
    "Change to larger needles.",
    "Begin stuffing now.",
    "The brim is done.",
    "Change to color B.",
    "Switch to the main colour.",
    "Check your gauge here.",
    "",
    "Stuff firmly.",
};
constexpr std::array end_notes{"Weave in ends.",
                               "Weave in all ends and block lightly.",
                               "Sew on two buttons for eyes.",
                               "FINISHING",
                               "Enjoy!",
                               "Block to measurements."};

Part knits(Num times, int look, std::size_t word = knit_word) {
  Part part;
  part.word = word;
  part.times = times;
  part.look = look;
  return part;
}

class Maker {
 public:
  explicit Maker(std::uint32_t seed) : dice_(seed) {}

  Pattern make() {
    if (dice_.chance(15)) made_.sizes = dice_.chance(50) ? 2 : 3;
    made_.size_look = dice_.roll(0, 2);
    made_.capitals = dice_.chance(4);
    made_.label = dice_.roll(0, 47);
    mark_ = dice_.chance(15) ? dice_.roll(1, 3) : 0;
    paragraph_ = mark_ == 0 && dice_.chance(7);
    note(dice_.of(titles));
    for (int many = dice_.roll(0, 6); many > 0; --many) note(dice_.of(front_notes));
    const int kind = dice_.roll(0, 99);
    if (kind < 12) {
      mitten();
    } else if (kind < 22) {
      two_legs();
    } else if (kind < 40) {
      flat_ = true;
      paragraph_ = false;
      piece();
    } else if (kind < 55) {
      note("Head");
      piece();
      note("");
      note(dice_.chance(50) ? "Leg (make 2)" : "LEGS (make two)");
      piece();
    } else {
      piece();
    }
    for (int many = dice_.roll(0, 2); many > 0; --many) note(dice_.of(end_notes));
    return std::move(made_);
  }

 private:
  // Lines.
  void note(const char* text) {
    Line line;
    line.text = text;
    made_.lines.push_back(line);
  }
  Line& add(LineKind kind) {
    Line& line = made_.lines.emplace_back();
    line.kind = kind;
    line.flat = flat_;
    line.look = dice_.roll(0, 239);
    line.label = dice_.chance(85) ? made_.label : dice_.roll(0, 47);
    line.count_look = paragraph_ ? 0 : dice_.roll(0, 59);
    line.mark = mark_;
    return line;
  }
  void state(Line& line, int percent) {
    if (dice_.chance(percent)) line.stated = count_;
  }
  // A line for one round, with its number where rounds have them.
  Line& add_round(const char* shaping = "") {
    Line& line = add(LineKind::round);
    line.name = shaping;
    if (is_numbered_) {
      line.first = line.last = number_;
      const bool follows =
          made_.lines.size() > 1 && made_.lines[made_.lines.size() - 2].kind == LineKind::round;
      line.joined = paragraph_ && follows;
      if (paragraph_) line.label = made_.label % 2;
      line.look -= paragraph_ ? line.look % 2 : 0;
    }
    line.wrong_side = flat_ && number_ % 2 == 0;
    ++number_;
    return line;
  }

  // Counts.
  void cast_on(Num count) {
    Line& line = add(LineKind::cast_on);
    line.text = dice_.of(flat_ ? ways().cast_on_rows : ways().cast_on);
    line.count = count_ = count;
    number_ = 1;
    known_.reset();
    is_numbered_ = flat_ || paragraph_ || dice_.chance(75);
  }
  Num random_count() {
    const int groups = dice_.roll(2, 9);
    Num count(groups * dice_.roll(3, 6));
    if (made_.sizes > 1) {
      const int unit = dice_.of(std::array{4, 6, 8});
      for (std::size_t size = 0; size < most_sizes; ++size)
        count.of[size] = unit * (5 + static_cast<int>(size) + (size > 0 ? dice_.roll(0, 1) : 0));
      std::sort(count.of.begin(), count.of.end());
    }
    return count;
  }
  [[nodiscard]] int least_of(const Num& number) const {
    return *std::min_element(number.of.begin(), size_end(number));
  }
  [[nodiscard]] int least() const { return least_of(count_); }
  [[nodiscard]] int most() const { return *std::max_element(count_.of.begin(), size_end(count_)); }
  [[nodiscard]] std::array<int, most_sizes>::const_iterator size_end(const Num& number) const {
    return number.of.begin() + static_cast<std::ptrdiff_t>(made_.sizes);
  }
  [[nodiscard]] int common() const {
    int common = 0;
    for (std::size_t size = 0; size < made_.sizes; ++size) common = std::gcd(common, count_.of[size]);
    return common;
  }
  [[nodiscard]] Num with(int more) const {
    Num sum = count_;
    for (int& each : sum.of) each += more;
    return sum;
  }

  // Stitches.
  Part stitch(int takes, int makes) {
    std::vector<std::size_t> fit;
    for (std::size_t i = 0; i < words().size(); ++i) {
      const Word& word = words()[i];
      if (i > purl_word && word.takes == takes && word.makes == makes) fit.push_back(i);
    }
    return knits(Num(1), 0, dice_.of(fit));
  }
  Part knit(int times) { return knits(Num(times), look(), knit_word); }
  int look() { return dice_.roll(0, 239); }

  // "(k1, p1) twice, k2tog": a repeat within the repeat.
  std::vector<Part> nested_unit(int takes, int change) {
    Part inner;
    inner.kind = Kind::group;
    const int rest = change < 0 ? 2 : 1;
    const int each = (takes - rest) / 2 >= 3 && (takes - rest) % 3 == 0 ? 3 : 2;
    inner.times = Num((takes - rest) / each);
    inner.look = dice_.roll(0, 4);  // in brackets
    inner.parts = {knit(each - 1), knits(Num(1), look(), purl_word)};
    const int left = takes - inner.times.of[0] * each;
    std::vector<Part> parts{inner};
    if (change < 0) {
      parts.push_back(stitch(2, 1));
      if (left > 2) parts.push_back(knit(left - 2));
    } else {
      parts.push_back(knit(left));
      if (change > 0) parts.push_back(stitch(0, 1));
    }
    if (dice_.chance(30)) std::rotate(parts.begin(), parts.begin() + 1, parts.end());
    return parts;
  }
  // A repeat of `takes` stitches that grows, shrinks, or stays.
  std::vector<Part> unit(int takes, int change) {
    if (takes >= 6 && dice_.chance(20)) return nested_unit(takes, change);
    if (change > 0) {
      if (takes == 1) return {stitch(1, dice_.chance(80) ? 2 : 3)};
      if (dice_.chance(40)) return {knit(takes - 1), stitch(1, dice_.chance(85) ? 2 : 3)};
      if (dice_.chance(50)) return {knit(takes), stitch(0, 1)};
      const int first = dice_.roll(1, takes - 1);
      return {knit(first), stitch(0, 1), knit(takes - first)};
    }
    if (change < 0) {
      if (takes == 2) return {stitch(2, 1)};
      if (takes == 3 && dice_.chance(50)) return {stitch(3, 1)};
      if (takes >= 6 && dice_.chance(25)) return {stitch(2, 1), knit(takes - 4), stitch(2, 1)};
      if (takes >= 4 && dice_.chance(25)) return {knit(takes - 3), stitch(3, 1)};
      if (dice_.chance(30)) return {stitch(2, 1), knit(takes - 2)};
      return {knit(takes - 2), stitch(2, 1)};
    }
    if (takes == 2 && dice_.chance(30)) return {stitch(1, 1), knits(Num(1), look(), purl_word)};
    if (takes >= 3 && dice_.chance(20)) return {knit(takes - 2), stitch(0, 1), stitch(2, 1)};
    if (takes >= 4 && takes % 2 == 0 && dice_.chance(20)) {
      Part pair;
      pair.kind = Kind::group;
      pair.times = Num(takes / 2);
      pair.look = dice_.roll(0, 4);  // in brackets
      pair.parts = {knit(1)};
      return {pair, knits(Num(takes - takes / 2), look(), purl_word)};
    }
    const int first = dice_.roll(1, takes - 1);
    return {knit(first), knits(Num(takes - first), look(), purl_word)};
  }
  static int makes(const std::vector<Part>& parts) {
    int sum = 0;
    for (const Part& part : parts) {
      const int times = part.times.of[0];
      sum += times * (part.kind == Kind::group ? makes(part.parts) : words()[part.word].makes);
    }
    return sum;
  }

  // Rounds.
  void plain() {
    Line& line = add_round();
    line.whole = true;
    line.purl = flat_ ? line.wrong_side : dice_.chance(15);
    if (is_numbered_ && !line.joined && dice_.chance(30)) {
      line.last = line.first + dice_.roll(1, 5);
      number_ = line.last + 1;
      line.purl = flat_ ? false : line.purl;
    }
    state(line, 30);
  }
  void spelled_plain() {
    Line& line = add_round();
    if (made_.sizes == 1 && dice_.chance(50)) {
      line.parts = {knit(count_.of[0])};
      if (dice_.chance(40) && count_.of[0] > 4) line.parts = {stitch(1, 1), knit(count_.of[0] - 1)};
    } else {
      line.parts = {knits(count_, look())};
    }
    state(line, 30);
  }
  // One repeat over the whole, or up to the last few.
  void repeated(int change) {
    std::vector<int> fit;
    for (int takes = 1; takes <= std::min(14, least() / 2); ++takes) {
      const bool is_some = change > 0 || takes > 1;
      if (is_some && common() % takes == 0) fit.push_back(takes);
    }
    const bool has_tail = made_.sizes == 1 && (fit.empty() || dice_.chance(25)) && least() >= 10;
    if (fit.empty() && !has_tail) return edges(change < 0);
    const int takes = has_tail ? dice_.roll(3, 5) : dice_.of(fit);
    const int tail = has_tail ? count_.of[0] % takes : 0;
    if (has_tail && tail == 0) return repeated_over(takes, 0, change);
    repeated_over(takes, tail, change);
  }
  void repeated_over(int takes, int tail, int change) {
    const std::vector<Part> parts = unit(takes, change);
    Num after(0), times(0);
    for (std::size_t size = 0; size < most_sizes; ++size) {
      times.of[size] = (count_.of[size] - tail) / takes;
      after.of[size] = times.of[size] * makes(parts) + tail;
    }
    if (after.of[0] > 150 || least_of(after) < 4) return plain();
    Line& line = add_round(change > 0 ? "inc" : change < 0 ? "dec" : "");
    Part group;
    group.kind = Kind::group;
    group.parts = parts;
    group.times = times;
    group.look = look();
    // "(k1, p1) in next st to end" is nobody's way.
    const bool is_nested = std::any_of(parts.begin(), parts.end(), [](const Part& part) {
      return part.kind == Kind::group || words()[part.word].names.front()[0] == '(';
    });
    if (is_nested && group.look % 3 == 0) ++group.look;
    group.fill = dice_.chance(55) ? (tail > 0 ? Fill::to_last : Fill::to_end) : Fill::times;
    group.reserve = Num(tail);
    const bool tail_first = tail > 0 && dice_.chance(30);
    if (tail_first && group.fill == Fill::to_last) group.fill = Fill::to_end;
    if (tail_first) line.parts.push_back(knit(tail));
    line.parts.push_back(group);
    if (tail > 0 && !tail_first) line.parts.push_back(knit(tail));
    if (change == 0) remember(line, 0, count_);
    count_ = after;
    state(line, change == 0 ? 40 : 85);
    if (tail == 0 && is_ambiguous(group)) line.stated = count_;
  }
  // "K4, m1l to end" may be one repeat, or only its last word: then the count tells which.
  static bool is_ambiguous(const Part& group) { return group.fill == Fill::to_end && group.parts.size() > 1; }
  // Shaping at the beginning, at the end, or at both.
  std::vector<Part> edge_parts(bool fewer, int& by) {
    Part fill = knit(1);
    const int kind = dice_.roll(0, 3);
    const Part change = fewer ? stitch(2, 1) : dice_.chance(50) ? stitch(0, 1) : stitch(1, 2);
    const Part other = fewer ? stitch(2, 1) : stitch(0, 1);
    by = kind == 3 ? 2 : 1;
    by = fewer ? -by : by;
    fill.fill = Fill::to_end;
    if (kind == 0) return {change, fill};
    if (kind == 1) return {knit(1), change, fill};
    fill.fill = Fill::to_last;
    const int taken = words()[kind == 2 ? change.word : other.word].takes;
    if (kind == 2) {
      fill.reserve = Num(taken + 1);
      return {fill, change, knit(1)};
    }
    fill.reserve = Num(taken + 1);
    return {knit(1), change, fill, other, knit(1)};
  }
  void edges(bool fewer) {
    if (least() < 12 && fewer) return plain();
    Line& line = add_round(fewer ? "dec" : "inc");
    int by = 0;
    line.parts = edge_parts(fewer, by);
    remember(line, by, {});
    count_ = with(by);
    state(line, 85);
  }
  // "Rnd 7: As rnd 3."
  struct Known {
    int number = 0, by = 0;
    std::optional<Num> count;  // only on so many
  };
  void remember(const Line& line, int by, std::optional<Num> count) {
    if (is_numbered_ && line.first > 0 && line.first == line.last) known_ = Known{line.first, by, count};
  }
  void like_before() {
    const bool fits = known_ && is_numbered_ && known_->number < number_ &&
                      (!known_->count || *known_->count == count_) && least() + known_->by >= 10;
    if (!fits || (flat_ && (number_ - known_->number) % 2 != 0)) return plain();
    Line& line = add_round();
    line.like = known_->number;
    count_ = with(known_->by);
    state(line, 60);
  }
  void evenly() {
    const int by = dice_.roll(2, 8);
    const bool fewer = least() > 30 && dice_.chance(60);
    Line& line = add_round(fewer ? "dec" : "inc");
    Part part;
    part.kind = Kind::evenly;
    part.times = Num(std::min(by, least() / 3));
    part.fewer = fewer;
    part.look = look();
    line.parts = {part};
    count_ = with(fewer ? -part.times.of[0] : part.times.of[0]);
    line.stated = count_;
  }
  void even() {
    Line& line = add(LineKind::even);
    line.count = Num(dice_.roll(1, 9));
    number_ += line.count.of[0];
    state(line, 25);
  }
  // "Rnd 3: K2tog, k to end. Rnd 4: Knit. Repeat rnds 3 and 4 five times more."
  void pair_again() {
    const bool fewer = least() > 16 && dice_.chance(60);
    const int room = fewer ? (least() - 10) / 2 : (150 - most()) / 2;
    if (room < 2) return plain();
    const int a = number_;
    edges(fewer);
    const Line shaped = made_.lines.back();
    if (shaped.name.empty()) return;
    const int by = change_of(shaped);
    const int plains = dice_.chance(15) ? 0 : dice_.chance(85) ? 1 : 2;
    for (int i = 0; i < plains; ++i) {
      Line& second = add_round();
      second.whole = true;
      second.purl = flat_ && second.wrong_side;
    }
    const int most_times = std::min(7, (fewer ? least() - 8 : 150 - most()) / std::abs(by));
    if (most_times < 1) return;
    const int times = dice_.roll(1, most_times);
    Line& line = add(LineKind::again);
    line.count = Num(times);
    const bool by_number = is_numbered_ && dice_.chance(65);
    line.from = by_number ? a : 0;
    line.to = by_number ? number_ - 1 : plains + 1;
    if (line.from == 0 && plains == 0) {
      made_.lines.pop_back();
      return;
    }
    const int many = plains + 1;
    if (by_number && dice_.chance(25)) line.first = number_;
    number_ += many * times;
    count_ = with(by * times);
    if (line.first == 0 && many == 2 && dice_.chance(40)) {
      line.until = count_;
      if (dice_.chance(50)) line.stated = count_;
    } else {
      state(line, 85);
    }
    if (!flat_ && !paragraph_ && dice_.chance(30)) is_numbered_ = false;
  }
  static int change_of(const Line& line) {
    int by = 0;
    for (const Part& part : line.parts) by += words()[part.word].makes - words()[part.word].takes;
    return by;
  }
  // "Rnds 2, 4 and 6: Knit." above the rounds between them, or "All even rounds".
  void alternate() {
    if (!is_numbered_ || paragraph_ || flat_ || number_ % 2 == 0 || least() < 16) return plain();
    const int many = dice_.roll(2, 3), first = number_;
    const bool listed = dice_.chance(50), above = dice_.chance(30);
    const auto group = [&] {
      Line& line = add(LineKind::round);
      line.whole = true;
      for (int i = 0; i < many; ++i) line.numbers.push_back(first + 1 + 2 * i);
      line.label = (listed ? 0 : 102) + dice_.roll(0, 5);
    };
    if (above) group();
    for (int i = 0; i < many; ++i) {
      const bool fewer = least() > 24;
      repeated(fewer ? -1 : 1);
      if (made_.lines.back().kind != LineKind::round || made_.lines.back().last != first + 2 * i) return;
      number_ = first + 2 * i + 2;
      if (i == 0 && !above) group();
    }
  }
  void markers() {
    if (made_.sizes > 1 || least() < 14 || flat_) return plain();
    Line& set = add_round();
    const int first = dice_.roll(5, count_.of[0] - 6);
    Part place, slip, rest = knit(1), near = knit(1);
    place.kind = Kind::place_marker;
    slip.kind = Kind::slip_marker;
    place.look = look();
    slip.look = look();
    rest.fill = Fill::to_end;
    set.parts = {knit(first), place, dice_.chance(50) ? knit(count_.of[0] - first) : rest};
    for (int i = dice_.roll(1, 3); i > 0; --i) {
      const int kind = dice_.roll(0, 2);
      Line& line = add_round(kind == 2 ? "inc" : "dec");
      near.fill = kind == 1 ? Fill::to_before_marker : Fill::to_marker;
      near.reserve = Num(2);
      if (kind == 0) line.parts = {near, slip, stitch(2, 1), rest};
      if (kind == 1) line.parts = {near, stitch(2, 1), slip, rest};
      if (kind == 2) line.parts = {near, stitch(0, 1), slip, knit(1), stitch(0, 1), rest};
      count_ = with(kind == 2 ? 2 : -1);
      state(line, 85);
    }
    note("Remove marker.");
    made_.lines.back().name = "markers";
  }

  void segment() {
    const int kind = dice_.roll(0, 99);
    const bool fewer = least() > 60 || (least() > 14 && dice_.chance(45));
    if (kind < 16) return plain();
    if (kind < 24) return spelled_plain();
    if (kind < 34) return repeated(0);
    if (kind < 58) return repeated(fewer ? -1 : 1);
    if (kind < 66) return edges(fewer);
    if (kind < 72) return evenly();
    if (kind < 78) return paragraph_ ? plain() : even();
    if (kind < 86) return paragraph_ ? plain() : pair_again();
    if (kind < 90) return like_before();
    if (kind < 95) return alternate();
    return markers();
  }
  void segments(int many) {
    for (int i = 0; i < many; ++i) {
      segment();
      if (!paragraph_ && dice_.chance(8)) note(dice_.of(inner_notes));
    }
  }
  void close() {
    Line& line = add(LineKind::close);
    line.count = count_;
    line.says_count = dice_.chance(65);
  }
  void piece() {
    cast_on(random_count());
    segments(dice_.roll(3, 9));
    close();
  }

  void take_back(const char* name, int held, int more) {
    Line& line = add(LineKind::take_back);
    line.name = name;
    line.count = Num(held);
    line.picked_up = Num(more);
    count_ = Num(held + more);
    line.stated = count_;
    number_ = 1;
    known_.reset();
  }
  void mitten() {
    made_.sizes = 1;
    note("MITTEN");
    cast_on(Num(2 * dice_.roll(12, 20)));
    segments(dice_.roll(1, 2));
    const int thumb = dice_.roll(4, 8), gap = dice_.roll(2, 3), before = dice_.roll(3, 6);
    if (least() < thumb + before + 4) return close();
    Line& line = add_round();
    Part hold, over;
    hold.kind = Kind::hold;
    over.kind = Kind::gap;
    hold.name = "thumb";
    hold.times = Num(thumb);
    over.times = Num(gap);
    hold.look = look();
    over.look = look();
    Part rest = knit(1);
    rest.fill = Fill::to_end;
    line.parts = {knit(before), hold, over, rest};
    count_ = with(gap - thumb);
    line.stated = count_;
    segments(dice_.roll(1, 4));
    close();
    note("");
    note("THUMB");
    take_back("thumb", thumb, dice_.roll(1, 3));
    if (!flat_) segments(dice_.roll(1, 3));
    close();
  }
  void two_legs() {
    made_.sizes = 1;
    const Num leg(2 * dice_.roll(4, 9));
    note("First leg");
    cast_on(leg);
    const bool numbered = is_numbered_;
    even_leg();
    Line& aside = add(LineKind::put_aside);
    aside.name = "first leg";
    const Num first = count_;
    note("");
    note("Second leg");
    cast_on(leg);
    is_numbered_ = numbered;
    even_leg();
    note("");
    note("Body");
    Line& line = add_round();
    Part across;
    across.kind = Kind::from_holder;
    across.name = "first leg";
    across.times = first;
    across.look = look();
    line.parts = {knits(count_, look()), across};
    for (std::size_t size = 0; size < most_sizes; ++size) count_.of[size] += first.of[size];
    line.stated = count_;
    segments(dice_.roll(2, 5));
    close();
  }
  void even_leg() {
    if (paragraph_ || dice_.chance(50)) return plain();
    even();
  }

  Dice dice_;
  Pattern made_;
  Num count_;
  int number_ = 1, mark_ = 0;
  bool is_numbered_ = true, paragraph_ = false, flat_ = false;
  std::optional<Known> known_;  // a round of this piece that another may be like
};

}  // namespace

Pattern make(std::uint32_t seed) { return Maker(seed).make(); }

}  // namespace world
