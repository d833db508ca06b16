#include "knit/pattern/written_pattern.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numbers>
#include <set>

#include "knit/model/settings_table.h"
#include "knit/pattern/pattern_words.h"
#include "knit/pattern/yarn.h"

namespace knit {

namespace {

// What the instructions use, so that nothing else is explained.
struct Used {
  std::set<Hand> hands;
  bool repeats = false, stars = false, markers = false;
  bool turned = false;           // shaping that leans to both sides
  bool mixed = false;            // increases and decreases in one round
  bool neighbours = false;       // two increases with no stitch between
  std::size_t longest_text = 0;  // of a round, in words
  [[nodiscard]] bool has(Hand hand) const { return hands.count(hand) != 0; }
  [[nodiscard]] bool increases() const { return has(Hand::m1l) || has(Hand::m1r); }
  [[nodiscard]] bool decreases() const { return has(Hand::k2tog) || has(Hand::ssk); }
};

bool is_made(Hand hand) { return consumed_by(hand) == 0; }

Used used_in(const Rounds& rounds, const std::vector<RoundLine>& lines) {
  Used used;
  for (const Round& round : rounds.rounds) {
    std::set<Hand> here;
    for (std::size_t i = 0; i < round.operations.size(); ++i) {
      const Hand hand = round.operations[i].hand;
      here.insert(hand);
      const std::size_t before = (i == 0 ? round.operations.size() : i) - 1;
      if (is_made(hand) && before != i && is_made(round.operations[before].hand)) used.neighbours = true;
    }
    const bool left = here.count(Hand::m1l) + here.count(Hand::ssk) > 0;
    const bool right = here.count(Hand::m1r) + here.count(Hand::k2tog) > 0;
    const bool up = here.count(Hand::m1l) + here.count(Hand::m1r) > 0;
    const bool down = here.count(Hand::k2tog) + here.count(Hand::ssk) > 0;
    used.turned = used.turned || (left && right);
    used.mixed = used.mixed || (up && down);
    used.hands.insert(here.begin(), here.end());
  }
  for (const RoundLine& line : lines) {
    used.repeats = used.repeats || line.words.find('[') != std::string::npos;
    used.stars = used.stars || line.words.find('*') != std::string::npos;
    used.markers = used.markers || line.words.find("sm, ") != std::string::npos;
    const auto words = static_cast<std::size_t>(std::count(line.words.begin(), line.words.end(), ','));
    used.longest_text = std::max(used.longest_text, words + 1);
  }
  return used;
}

// Basic: no shaping. Easy: shaping that leans one way in each round. Intermediate: mirrored shaping, or rounds
// that take close reading. Complex: increases and decreases in one round, or rounds too long to keep in mind.
std::string level_of(const Used& used) {
  constexpr std::size_t close_reading = 16;
  constexpr std::size_t too_long = 40;
  if (used.mixed || used.longest_text > too_long) return "Complex";
  if (used.turned || used.longest_text > close_reading) return "Intermediate";
  return used.increases() || used.decreases() ? "Easy" : "Basic";
}

double rounded_to(double value, double unit) { return std::round(value / unit) * unit; }

std::string shown(double value, double unit) {
  // The division by a whole number gives the double that is nearest to the decimal.
  return number_text(std::round(rounded_to(value, unit) * 10.0) / 10.0);
}

// "12 cm (4.7 in)": halves of a centimetre are as fine as a knitted thing is measured.
std::string length_text(double cm) {
  constexpr double cm_in_an_inch = 2.54;
  const double unit = cm < 5.0 ? 0.1 : 0.5;
  return shown(cm, unit) + " cm (" + shown(rounded_to(cm, unit) / cm_in_an_inch, 0.1) + " in)";
}

std::string capitalised(std::string text) {
  if (!text.empty()) text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

std::vector<std::string> size_lines(const PatternSizes& sizes, bool stuffed) {
  if (stuffed) {
    return {"About " + length_text(sizes.height_cm) + " high and " +
            length_text(sizes.around_cm / std::numbers::pi) + " across when stuffed; " +
            length_text(sizes.around_cm) + " around."};
  }
  return {"About " + length_text(sizes.height_cm) + " high, " + length_text(sizes.around_cm) +
          " around at the widest."};
}

double needle_of(const Gauge& gauge, const PatternOptions& options) {
  return options.needle_mm.value_or(weight_class_of(gauge).needle_mm);
}

std::string yarn_line(const PatternSizes& sizes, const PatternOptions& options) {
  constexpr double yards_in_a_metre = 1.0936;
  const WeightClass weight = weight_class_of(sizes.gauge);
  std::string line = "Yarn: " + std::string(weight.name) + " (" + std::to_string(weight.number) + ")";
  if (!options.yarn.empty()) line += ", " + options.yarn;
  if (!options.colour.empty()) line += ", in " + options.colour;
  const double metres = std::ceil(sizes.yarn_with_spare_m);
  line += ", about " + number_text(metres) + " m (" + number_text(std::ceil(metres * yards_in_a_metre)) +
          " yd), ";
  line += number_text(std::ceil(sizes.yarn_g)) + " g; " + number_text(std::round(100.0 * yarn_spare)) +
          " % spare is included.";
  return line;
}

// Stitches that go around a short circular needle (40 cm) without being stretched.
bool needs_circular(const PatternSizes& sizes) { return sizes.around_cm >= 42.0; }

constexpr std::int32_t most_on_double_points = 8;  // at the cast on

std::string needle_line(const Rounds& rounds, const PatternSizes& sizes, const PatternOptions& options) {
  const std::string size = needle_text(needle_of(sizes.gauge, options));
  const std::string line = "Needles: " + size + ", or the size that gives the gauge: ";
  const bool narrow = rounds.cast_on <= most_on_double_points || is_drawn_in(rounds.last_count());
  if (!narrow) return line + "circular.";
  if (rounds.cast_on > most_on_double_points) return line + "circular, and a set of five double-pointed.";
  return line + "a set of five double-pointed" +
         (needs_circular(sizes) ? " and, for the wide part, a 40 cm (16 in) circular." : ".");
}

// Beside the one where rounds begin.
std::size_t most_markers(const Rounds& rounds) {
  std::size_t most = 0;
  for (const Round& round : rounds.rounds) {
    std::size_t here = 0;
    for (std::size_t i = 1; i < round.operations.size(); ++i) here += round.operations[i].at_main ? 1 : 0;
    most = std::max(most, here);
  }
  return most;
}

std::vector<std::string> material_lines(const Rounds& rounds, const PatternSizes& sizes,
                                        const PatternOptions& options, const Used& used) {
  std::vector<std::string> lines{yarn_line(sizes, options), needle_line(rounds, sizes, options)};
  if (!stuffed_after(rounds).empty()) lines.emplace_back("Stuffing.");
  if (used.markers) {
    lines.push_back("Stitch markers: one for the beginning of the round and " +
                    std::to_string(most_markers(rounds)) + " in another colour.");
  } else {
    lines.emplace_back("Stitch marker.");
  }
  lines.emplace_back("Tapestry needle.");
  return lines;
}

std::string gauge_line(const Gauge& gauge, const PatternOptions& options) {
  return number_text(std::round(gauge.stitches * 10.0) / 10.0) + " sts and " +
         number_text(std::round(gauge.rounds * 10.0) / 10.0) +
         " rnds = 10 cm (4 in) in stockinette, in the round, on " + needle_text(needle_of(gauge, options)) +
         " needles.";
}

std::vector<std::pair<std::string, std::string>> abbreviations_of(const Rounds& rounds, const Used& used) {
  struct Entry {
    bool used;
    const char *word, *meaning;
  };
  const std::array<Entry, 11> entries{{
      {!is_drawn_in(rounds.last_count()), "BO", "bind off"},
      {true, "CO", "cast on"},
      {true, "k", "knit; K4 is knit 4 stitches"},
      {used.has(Hand::k2tog), "k2tog", "knit 2 stitches together; leans right"},
      {used.has(Hand::m1l), "m1l",
       "make 1 left: lift the bar between the stitches from front to back, knit it through the back"},
      {used.has(Hand::m1r), "m1r",
       "make 1 right: lift the bar between the stitches from back to front, knit it through the front"},
      {used.stars, "rep", "repeat"},
      {true, "rnd(s)", "round(s)"},
      {used.markers, "sm", "slip marker"},
      {used.has(Hand::ssk), "ssk",
       "slip 2 stitches knitwise one at a time, knit them together through the back; leans left"},
      {true, "st(s)", "stitch(es)"},
  }};
  std::vector<std::pair<std::string, std::string>> list;
  for (const Entry& entry : entries) {
    if (entry.used) list.emplace_back(entry.word, entry.meaning);
  }
  return list;
}

std::vector<std::string> note_lines(const Rounds& rounds, const Used& used) {
  std::vector<std::string> notes{
      "Worked from the bottom up in the round, right side out. Every round begins at the marker; slip it as "
      "you "
      "come to it.",
      "The number in brackets at the end of a line is how many stitches there are after that round. The cast "
      "on "
      "counts as the first round."};
  if (used.repeats)
    notes.emplace_back("Work what stands in square brackets as many times in all as is said after them.");
  if (used.increases()) {
    notes.emplace_back(
        "An increase is made between two stitches and uses none of them; at the end of a round it is made "
        "before "
        "the marker.");
  }
  if (used.neighbours)
    notes.emplace_back("Where two increases follow each other, lift the same bar again for the second.");
  if (!rounds.rounds.empty() && rounds.rounds.front().after > rounds.cast_on) {
    notes.emplace_back(
        "Right after the cast on the bars are tight: a loop of the working yarn twisted onto the needle may "
        "stand for an increase there.");
  }
  if (used.markers) {
    notes.emplace_back(
        "The other markers stand before the stitches of the main lines, along which the piece is shaped. "
        "Where "
        "sm is said and no marker stands yet, place one; take out one that a shaped round does not name. An "
        "sm "
        "that begins a round is the marker of the round itself. If a decrease takes in the stitch before a "
        "main "
        "stitch, move the marker to before both.");
  }
  return notes;
}

std::string start_sentence(const Rounds& rounds) {
  const std::string needles =
      rounds.cast_on <= most_on_double_points ? "double-pointed needles" : "a circular needle";
  return "Using " + needles + ", CO " + stitches_text(rounds.cast_on) +
         " (Rnd 1). Join to work in the round, being careful not to twist. Place marker.";
}

std::string closing_sentence(std::int32_t stitches) {
  if (!is_drawn_in(stitches)) return "BO all " + stitches_text(stitches) + ".";
  return "Break yarn, thread through remaining " + stitches_text(stitches) + " and pull tightly. Fasten off.";
}

constexpr const char* stuff_and_close =
    "Stuff the piece firmly now, while the opening is wide; add more as it closes.";
constexpr const char* stuff_before_neck = "Stuff the part made so far firmly now, before the piece narrows.";

std::vector<WrittenPattern::Instruction> instructions_of(const Rounds& rounds, std::vector<RoundLine> lines) {
  const std::vector<std::int32_t> stuffed = stuffed_after(rounds);
  std::vector<WrittenPattern::Instruction> instructions;
  const auto tell_stuffing = [&](std::int32_t first, std::int32_t last) {
    for (const std::int32_t round : stuffed) {
      if (round < first || round > last) continue;
      instructions.push_back({std::nullopt, round == stuffed.back() ? stuff_and_close : stuff_before_neck});
    }
  };
  tell_stuffing(1, 1);
  for (RoundLine& line : lines) {
    const std::int32_t first = line.first;
    const std::int32_t last = line.last;
    instructions.push_back({std::move(line), {}});
    tell_stuffing(first, last);
  }
  instructions.push_back({std::nullopt, closing_sentence(rounds.last_count())});
  return instructions;
}

std::vector<std::string> finishing_lines(const Rounds& rounds) {
  std::vector<std::string> lines;
  if (is_drawn_in(rounds.cast_on)) {
    lines.emplace_back("Thread the cast-on tail through the " + stitches_text(rounds.cast_on) +
                       " of the cast-on edge, pull the hole shut and fasten off.");
  } else {
    lines.emplace_back("The cast-on edge stays open.");
  }
  lines.emplace_back("Weave in all ends.");
  return lines;
}

}  // namespace

WrittenPattern write_pattern(const Rounds& rounds, const Gauge& gauge, const PatternOptions& options,
                             const std::string& mesh_name) {
  const PatternSizes sizes = sizes_of(rounds, gauge);
  std::vector<RoundLine> lines = round_lines(rounds, options);
  const Used used = used_in(rounds, lines);
  WrittenPattern pattern;
  pattern.title = options.title.empty() ? capitalised(mesh_name) : options.title;
  if (pattern.title.empty()) pattern.title = "Knitted piece";
  pattern.level = level_of(used);
  pattern.size = size_lines(sizes, !stuffed_after(rounds).empty());
  pattern.materials = material_lines(rounds, sizes, options, used);
  pattern.gauge = gauge_line(gauge, options);
  pattern.abbreviations = abbreviations_of(rounds, used);
  pattern.notes = note_lines(rounds, used);
  pattern.start = start_sentence(rounds);
  pattern.instructions = instructions_of(rounds, std::move(lines));
  pattern.finishing = finishing_lines(rounds);
  return pattern;
}

namespace {

std::vector<std::int32_t> counts_of(const Rounds& rounds) {
  std::vector<std::int32_t> counts{rounds.cast_on};
  for (const Round& round : rounds.rounds) counts.push_back(round.after);
  return counts;
}

// Radii from end to end, with 0 for each end that is drawn in, and carried on beyond both ends by turning them
// about the end point: a smooth tip does so itself.
class Profile {
 public:
  Profile(const std::vector<std::int32_t>& counts, double stitches_per_cm) {
    if (is_drawn_in(counts.front())) radii_.push_back(0.0);
    for (const std::int32_t count : counts)
      radii_.push_back(count / stitches_per_cm / (2.0 * std::numbers::pi));
    if (is_drawn_in(counts.back())) radii_.push_back(0.0);
  }

  [[nodiscard]] double height(double step) const {
    double height = 0.0;
    for (std::ptrdiff_t i = 0; i + 1 < size(); ++i) {
      const double slope = std::min(std::abs(change_after(i)) / step, 1.0);
      height += step * std::sqrt(1.0 - slope * slope);
    }
    return height;
  }

 private:
  [[nodiscard]] std::ptrdiff_t size() const { return static_cast<std::ptrdiff_t>(radii_.size()); }
  [[nodiscard]] double radius(std::ptrdiff_t i) const {
    const std::ptrdiff_t last = size() - 1;
    if (i < 0) return 2.0 * radii_.front() - radius(std::min(-i, last));
    if (i > last) return 2.0 * radii_.back() - radius(std::max(2 * last - i, std::ptrdiff_t{0}));
    return radii_[static_cast<std::size_t>(i)];
  }
  // The straight line through six radii, three on each side.
  [[nodiscard]] double change_after(std::ptrdiff_t i) const {
    double products = 0.0;
    double squares = 0.0;
    for (std::ptrdiff_t k = 0; k < 3; ++k) {
      const double away = static_cast<double>(k) + 0.5;
      products += away * (radius(i + 1 + k) - radius(i - k));
      squares += 2.0 * away * away;
    }
    return products / squares;
  }

  std::vector<double> radii_;
};

}  // namespace

PatternSizes sizes_of(const Rounds& rounds, const Gauge& gauge) {
  const std::vector<std::int32_t> counts = counts_of(rounds);
  const double stitches_per_cm = gauge.stitches / 10.0;
  const double step = 10.0 / gauge.rounds;
  PatternSizes sizes;
  sizes.gauge = gauge;
  sizes.length_cm = static_cast<double>(counts.size()) * step;
  sizes.around_cm = *std::max_element(counts.begin(), counts.end()) / stitches_per_cm;
  sizes.height_cm = Profile(counts, stitches_per_cm).height(step);
  if (!is_drawn_in(counts.front())) sizes.height_cm += step / 2.0;
  if (!is_drawn_in(counts.back())) sizes.height_cm += step / 2.0;
  std::int64_t stitches = 0;
  for (const std::int32_t count : counts) stitches += count;
  const YarnNeeded yarn = yarn_needed(stitches, gauge);
  sizes.yarn_m = yarn.metres;
  sizes.yarn_with_spare_m = yarn.metres_with_spare;
  sizes.yarn_g = yarn.grams;
  sizes.weight_class = weight_class_of(gauge).number;
  return sizes;
}

std::vector<std::int32_t> stuffed_after(const Rounds& rounds) {
  if (!is_drawn_in(rounds.cast_on) || !is_drawn_in(rounds.last_count())) return {};
  constexpr double fewest = 12.0;
  const std::vector<std::int32_t> counts = counts_of(rounds);
  const double most = *std::max_element(counts.begin(), counts.end());
  const double wide = std::max(0.4 * most, fewest);
  const double neck = std::max(0.25 * most, fewest);
  std::vector<std::int32_t> after;
  bool narrowed = true;  // below a neck's width since the last wide round
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double count = counts[i];
    if (count >= wide) {
      const auto number = static_cast<std::int32_t>(i) + 1;
      if (narrowed) after.push_back(number);
      after.back() = number;
      narrowed = false;
    }
    narrowed = narrowed || count < neck;
  }
  return after;
}

}  // namespace knit
