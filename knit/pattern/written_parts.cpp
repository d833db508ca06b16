#include "knit/pattern/written_parts.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "knit/model/settings_table.h"
#include "knit/pattern/pattern_words.h"
#include "knit/pattern/yarn.h"

namespace knit {

namespace {

// Beside the one where the round begins.
std::size_t markers_in(const Round& round) {
  std::size_t markers = 0;
  for (std::size_t i = 1; i < round.operations.size(); ++i) markers += round.operations[i].at_main ? 1 : 0;
  return markers;
}

bool is_made(Hand hand) { return consumed_by(hand) == 0; }

}  // namespace

void add_used(const Rounds& rounds, const std::vector<RoundLine>& lines, Used& used) {
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
    used.most_markers = std::max(used.most_markers, markers_in(round));
    used.short_rows = used.short_rows || !round.pairs.empty();
    for (const ShortRowPair& pair : round.pairs) used.over_beginning = used.over_beginning || pair.first < 0;
  }
  for (const RoundLine& line : lines) {
    used.repeats = used.repeats || line.words.find('[') != std::string::npos;
    used.stars = used.stars || line.words.find('*') != std::string::npos;
    // A short row slips the marker of the round.
    used.markers = used.markers || (line.label.empty() && line.words.find("sm, ") != std::string::npos);
    const auto words = static_cast<std::size_t>(std::count(line.words.begin(), line.words.end(), ','));
    used.longest_text = std::max(used.longest_text, words + 1);
  }
}

std::string level_of(const Used& used) {
  constexpr std::size_t close_reading = 16;
  constexpr std::size_t too_long = 40;
  if (used.mixed || used.longest_text > too_long) return "Complex";
  if (used.short_rows || used.turned || used.longest_text > close_reading) return "Intermediate";
  return used.increases() || used.decreases() ? "Easy" : "Basic";
}

namespace {

double rounded_to(double value, double unit) { return std::round(value / unit) * unit; }

std::string shown(double value, double unit) {
  // The division by a whole number gives the double that is nearest to the decimal.
  return number_text(std::round(rounded_to(value, unit) * 10.0) / 10.0);
}

std::string capitalised(std::string text) {
  if (!text.empty()) text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

}  // namespace

std::string length_text(double cm) {
  constexpr double cm_in_an_inch = 2.54;
  const double unit = cm < 5.0 ? 0.1 : 0.5;
  return shown(cm, unit) + " cm (" + shown(rounded_to(cm, unit) / cm_in_an_inch, 0.1) + " in)";
}

std::string title_of(const PatternOptions& options, const std::string& mesh_name) {
  const std::string title = options.title.empty() ? capitalised(mesh_name) : options.title;
  return title.empty() ? "Knitted piece" : title;
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

std::string marker_line(const Used& used) {
  if (!used.markers && !used.sections) return "Stitch marker.";
  return "Stitch markers: one for the beginning of the round and " + std::to_string(used.most_markers) +
         " in another colour.";
}

std::string gauge_line(const Gauge& gauge, const PatternOptions& options) {
  return number_text(std::round(gauge.stitches * 10.0) / 10.0) + " sts and " +
         number_text(std::round(gauge.rounds * 10.0) / 10.0) +
         " rnds = 10 cm (4 in) in stockinette, in the round, on " + needle_text(needle_of(gauge, options)) +
         " needles.";
}

std::vector<std::pair<std::string, std::string>> abbreviations_of(const Used& used, bool binds_off) {
  struct Entry {
    bool used;
    const char *word, *meaning;
  };
  const bool german = used.short_rows && used.turns != ShortRowTurns::wrap;
  const std::array<Entry, 18> entries{{
      {binds_off, "BO", "bind off"},
      {used.short_rows, "BOR", "beginning of the round, at its marker"},
      {true, "CO", "cast on"},
      {german, "DS", "double stitch: the stitch worked last, turned and pulled up; see the notes"},
      {true, "k", "knit; K4 is knit 4 stitches"},
      {used.has(Hand::k2tog), "k2tog", "knit 2 stitches together; leans right"},
      {used.sections, "m", "marker"},
      {used.has(Hand::m1l), "m1l",
       "make 1 left: lift the bar between the stitches from front to back, knit it through the back"},
      {used.has(Hand::m1r), "m1r",
       "make 1 right: lift the bar between the stitches from back to front, knit it through the front"},
      {used.short_rows, "p", "purl; p4 is purl 4 stitches"},
      {used.stars, "rep", "repeat"},
      {true, "rnd(s)", "round(s)"},
      {used.short_rows, "RS, WS", "right side, wrong side of the work"},
      {used.markers || used.over_beginning, "sm", "slip marker"},
      {used.has(Hand::ssk), "ssk",
       "slip 2 stitches knitwise one at a time, knit them together through the back; leans left"},
      {true, "st(s)", "stitch(es)"},
      {german, "turn", "turn the work"},
      {used.short_rows && !german, "w&t", "wrap and turn; see the notes"},
  }};
  std::vector<std::pair<std::string, std::string>> list;
  for (const Entry& entry : entries) {
    if (entry.used) list.emplace_back(entry.word, entry.meaning);
  }
  return list;
}

void add_shaping_notes(const Used& used, bool tight_start, std::vector<std::string>& notes) {
  if (used.repeats) notes.emplace_back("Repeat the instructions in [ ] the total number of times given.");
  if (used.sections) {
    notes.emplace_back(
        "Markers (m) stand between sections that are shaped alike. A named round says what is done in each "
        "of them; slip the marker after it. Where a named round does not fit yet, or no longer, the round is "
        "written out.");
  }
  if (used.increases()) {
    notes.emplace_back(
        "An increase is made between two stitches and uses none of them; at the end of a round it is made "
        "before "
        "the marker.");
  }
  if (used.neighbours)
    notes.emplace_back("Where two increases follow each other, lift the same bar again for the second.");
  if (tight_start) {
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
}

void add_short_row_notes(const Used& used, std::vector<std::string>& notes) {
  if (!used.short_rows) return;
  if (used.turns != ShortRowTurns::wrap) {
    notes.emplace_back(
        "Short rows are German: turn where it is said, slip the stitch worked last to the right needle with "
        "the "
        "yarn in front, and pull the yarn up and over to the back until both legs of the stitch below lie on "
        "the "
        "needle: a double stitch (DS). It counts one; work both legs as one stitch when you come to it. "
        "Before a "
        "purl stitch bring the yarn to the front again.");
  } else {
    notes.emplace_back(
        "To wrap and turn (w&t), slip the next stitch, bring the yarn to the other side of the work, slip "
        "the "
        "stitch back and turn. A wrapped stitch counts one; work it together with its wrap when you come to "
        "it.");
  }
  notes.emplace_back(
      "A short row leaves as many stitches as there were. In parentheses after it stands where the work is "
      "turned: so many stitches, double or wrapped ones too, after the beginning of the round (BOR) or "
      "before "
      "it. (cont.) says that the round was begun in the first of the short rows.");
  if (used.over_beginning)
    notes.emplace_back(
        "A short row that goes past the BOR slips its marker (sm); to BOR means up to the marker.");
  if (used.markers)
    notes.emplace_back(
        "Short rows do not name the markers of the main lines: slip them as you come to them.");
}

std::string start_sentence(std::int32_t cast_on, const Gauge& gauge, const std::string& place_marker) {
  const std::string needles = go_on_circular(cast_on, gauge) ? "a circular needle" : "double-pointed needles";
  return "Using " + needles + ", CO " + stitches_text(cast_on) +
         " (Rnd 1). Join to work in the round, being careful not to twist. " + place_marker;
}

std::string closing_sentence(std::int32_t stitches, bool drawn_in) {
  if (!drawn_in) return "BO all " + stitches_text(stitches) + ".";
  return "Break yarn, thread through remaining " + stitches_text(stitches) + " and pull tightly. Fasten off.";
}

std::vector<std::int32_t> counts_of(const Rounds& rounds) {
  std::vector<std::int32_t> counts{rounds.cast_on};
  for (const Round& round : rounds.rounds) counts.push_back(round.after);
  return counts;
}

void add_yarn(std::int64_t stitches, PatternSizes& sizes) {
  const YarnNeeded yarn = yarn_needed(stitches, sizes.gauge);
  sizes.yarn_m = yarn.metres;
  sizes.yarn_with_spare_m = yarn.metres_with_spare;
  sizes.yarn_g = yarn.grams;
  sizes.weight_class = weight_class_of(sizes.gauge).number;
}

}  // namespace knit
