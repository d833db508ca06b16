#include "knit/pattern/written_pattern.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "knit/pattern/pattern_words.h"
#include "knit/pattern/short_form.h"
#include "knit/pattern/written_parts.h"
#include "knit/pattern/yarn.h"

namespace knit {

namespace {

std::vector<std::string> size_lines(const PatternSizes& sizes, bool stuffed) {
  const std::string high = length_text(sizes.height_cm), longer = length_text(sizes.longer_cm);
  const bool bends = high != longer;
  const std::string around = length_text(sizes.around_cm),
                    about = "About " + high +
                            (bends ? " along its shorter side, " + longer + " along its longer" : " high");
  if (stuffed) {
    return {about + (bends ? ", and " : " and ") + length_text(sizes.around_cm / std::numbers::pi) +
            " across when stuffed; " + around + " around."};
  }
  return {about + ", " + around + " around at the widest."};
}

std::string needle_line(const Rounds& rounds, const PatternSizes& sizes, const PatternOptions& options) {
  const std::string size = needle_text(needle_of(sizes.gauge, options));
  const std::string line = "Needles: " + size + ", or the size that gives the gauge: ";
  const std::vector<std::int32_t> counts = counts_of(rounds);
  const std::int32_t fewest = *std::min_element(counts.begin(), counts.end());
  if (go_on_circular(fewest, sizes.gauge)) return line + "circular.";
  if (go_on_circular(rounds.cast_on, sizes.gauge))
    return line + "circular, and a set of five double-pointed.";
  return line + "a set of five double-pointed" +
         (needs_circular(sizes) ? " and, for the wide part, a 40 cm (16 in) circular." : ".");
}

std::vector<std::string> material_lines(const Rounds& rounds, const PatternSizes& sizes,
                                        const PatternOptions& options, const Used& used) {
  std::vector<std::string> lines{yarn_line(sizes, options), needle_line(rounds, sizes, options)};
  if (!stuffed_after(rounds).empty()) lines.emplace_back("Stuffing.");
  lines.push_back(marker_line(used));
  lines.emplace_back("Tapestry needle.");
  return lines;
}

std::vector<std::string> note_lines(const Rounds& rounds, std::span<const RoundLine> lines,
                                    const Used& used) {
  std::vector<std::string> notes{
      "Worked in the round from the cast on, right side out. Every round begins at the marker; "
      "slip it as you come to it.",
      "The number in parentheses at the end of a line is how many stitches there are after that round. "
      "The cast on counts as the first round."};
  const auto has_several = [](const RoundLine& line) { return line.counts.size() > 1; };
  if (std::any_of(lines.begin(), lines.end(), has_several)) {
    notes.emplace_back(
        "Where several numbers stand there, they are how many stitches there are after each of the line's "
        "shaping rounds, one after the other: tick them off. A number with + or - is how many a named round "
        "adds or takes away.");
  }
  const bool tight = !rounds.rounds.empty() && rounds.rounds.front().after > rounds.cast_on;
  add_shaping_notes(used, tight, notes);
  add_short_row_notes(used, notes);
  return notes;
}

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
    const bool complete = !line.short_row;
    instructions.push_back({std::move(line), {}});
    if (complete) tell_stuffing(first, last);
  }
  instructions.push_back({std::nullopt, closing_sentence(rounds.last_count(), ends_drawn_in(rounds))});
  return instructions;
}

std::vector<std::string> finishing_lines(const Rounds& rounds) {
  std::vector<std::string> lines;
  if (begins_drawn_in(rounds)) {
    lines.emplace_back("Thread the cast-on tail through the " + stitches_text(rounds.cast_on) +
                       " of the cast-on edge, pull the hole shut and fasten off.");
  } else {
    lines.emplace_back("The cast-on edge stays open.");
  }
  lines.emplace_back("Weave in all ends.");
  return lines;
}

std::string place_sections(const ShortForm& form) {
  if (form.marks.size() == 3) {
    return "Place markers (m) after " + std::to_string(form.marks[0]) + ", " + std::to_string(form.marks[1]) +
           " and " + stitches_text(form.marks[2]) + ": side, front and side; the round begins at the back.";
  }
  const std::string every = form.stitches_each == 1 ? "st" : stitches_text(form.stitches_each);
  return "Place a marker (m) after every " + every + ": " + std::to_string(form.sections) +
         " markers, the last where the round begins.";
}

}  // namespace

WrittenPattern write_pattern(const Rounds& rounds, const Gauge& gauge, const PatternOptions& options,
                             const std::string& mesh_name) {
  const PatternSizes sizes = sizes_of(rounds, gauge);
  // The short form has no words for short rows.
  const bool has_pairs = std::any_of(rounds.rounds.begin(), rounds.rounds.end(),
                                     [](const Round& round) { return !round.pairs.empty(); });
  const std::optional<ShortForm> form = options.form == PatternForm::short_form && !has_pairs
                                            ? short_form(rounds, stuffed_after(rounds))
                                            : std::nullopt;
  std::vector<RoundLine> lines = form ? form->lines : round_lines(rounds, options);
  Used used;
  used.turns = options.turns;
  add_used(rounds, lines, used);
  if (form) {
    used.sections = true;
    used.most_markers = static_cast<std::size_t>(form->sections) - 1;
  }
  WrittenPattern pattern;
  pattern.title = title_of(options, mesh_name);
  pattern.level = level_of(used);
  pattern.size = size_lines(sizes, !stuffed_after(rounds).empty());
  pattern.materials = material_lines(rounds, sizes, options, used);
  pattern.gauge = gauge_line(gauge, options);
  pattern.abbreviations = abbreviations_of(used, !ends_drawn_in(rounds));
  pattern.notes = note_lines(rounds, lines, used);
  pattern.start = form ? start_sentence(rounds.cast_on, gauge, place_sections(*form))
                       : start_sentence(rounds.cast_on, gauge);
  pattern.instructions = instructions_of(rounds, std::move(lines));
  if (form) {
    std::vector<WrittenPattern::Instruction> named;
    for (const NamedRound& round : form->named)
      named.push_back({std::nullopt, round.text(), WrittenPattern::Instruction::Kind::step, 0});
    pattern.instructions.insert(pattern.instructions.begin(), named.begin(), named.end());
  }
  pattern.finishing = finishing_lines(rounds);
  return pattern;
}

namespace {

// Radii from end to end, with 0 for each end that is drawn in, and carried on beyond both ends by turning them
// about the end point: a smooth tip does so itself.
class Profile {
 public:
  Profile(const Rounds& rounds, double stitches_per_cm) {
    const std::vector<std::int32_t> counts = counts_of(rounds);
    if (begins_drawn_in(rounds)) radii_.push_back(0.0);
    for (const std::int32_t count : counts)
      radii_.push_back(count / stitches_per_cm / (2.0 * std::numbers::pi));
    if (ends_drawn_in(rounds)) radii_.push_back(0.0);
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

struct PairsOver {
  std::int32_t fewest = 0, most = 0;
};

// Of places spread evenly round the tube, how many pairs are worked there.
PairsOver pairs_over_places(const Rounds& rounds) {
  constexpr std::int32_t places = 256;
  std::vector<std::int32_t> over(places, 0);
  for (const Round& round : rounds.rounds) {
    for (const ShortRowPair& pair : round.pairs) {
      for (std::int32_t place = 0; place < places; ++place) {
        const std::int32_t stitch = place * round.before / places;
        if (((stitch - pair.first) % round.before + round.before) % round.before <= pair.last - pair.first)
          ++over[static_cast<std::size_t>(place)];
      }
    }
  }
  const auto [fewest, most] = std::minmax_element(over.begin(), over.end());
  return {*fewest, *most};
}

}  // namespace

PatternSizes sizes_of(const Rounds& rounds, const Gauge& gauge) {
  const std::vector<std::int32_t> counts = counts_of(rounds);
  const double stitches_per_cm = gauge.stitches / 10.0;
  const double step = 10.0 / gauge.rounds;
  PatternSizes sizes;
  sizes.gauge = gauge;
  sizes.length_cm = static_cast<double>(counts.size()) * step;
  sizes.around_cm = *std::max_element(counts.begin(), counts.end()) / stitches_per_cm;
  sizes.height_cm = Profile(rounds, stitches_per_cm).height(step);
  if (!begins_drawn_in(rounds)) sizes.height_cm += step / 2.0;
  if (!ends_drawn_in(rounds)) sizes.height_cm += step / 2.0;
  const PairsOver pairs = pairs_over_places(rounds);
  sizes.longer_cm = sizes.height_cm + 2.0 * pairs.most * step;
  sizes.height_cm += 2.0 * pairs.fewest * step;
  std::int64_t stitches = 0;
  for (const std::int32_t count : counts) stitches += count;
  for (const Round& round : rounds.rounds) {
    for (const ShortRowPair& pair : round.pairs) stitches += 2 * (pair.last - pair.first + 1);
  }
  add_yarn(stitches, sizes);
  return sizes;
}

std::vector<std::int32_t> stuffed_after(const Rounds& rounds) {
  if (!begins_drawn_in(rounds) || !ends_drawn_in(rounds)) return {};
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
