// What both kinds of written pattern are put together from, of one chain of rounds and of pieces: sentences and lists.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "knit/pattern/written_pattern.h"

namespace knit {

// What the instructions use, so that nothing else is explained.
struct Used {
  std::set<Hand> hands;
  bool repeats = false, stars = false, markers = false;
  bool short_rows = false;      // told by `turns`
  bool over_beginning = false;  // short rows past the beginning of the round
  ShortRowTurns turns = ShortRowTurns::usual;
  bool sections = false;         // markers part the round into sections, each shaped alike
  bool turned = false;           // shaping that leans to both sides
  bool mixed = false;            // increases and decreases in one round
  bool neighbours = false;       // two increases with no stitch between
  std::size_t longest_text = 0;  // of a round, in words
  std::size_t most_markers = 0;  // of a round, beside the one where it begins
  [[nodiscard]] bool has(Hand hand) const { return hands.count(hand) != 0; }
  [[nodiscard]] bool increases() const { return has(Hand::m1l) || has(Hand::m1r); }
  [[nodiscard]] bool decreases() const { return has(Hand::k2tog) || has(Hand::ssk); }
};

void add_used(const Rounds& rounds, const std::vector<RoundLine>& lines, Used& used);

// Basic: no shaping. Easy: shaping that leans one way in each round. Intermediate: mirrored shaping, or rounds
// that take close reading. Complex: increases and decreases in one round, or rounds too long to keep in mind.
std::string level_of(const Used& used);

std::string title_of(const PatternOptions& options, const std::string& mesh_name);

// "12 cm (4.7 in)": halves of a centimetre are as fine as a knitted thing is measured.
std::string length_text(double cm);

double needle_of(const Gauge& gauge, const PatternOptions& options);
std::string yarn_line(const PatternSizes& sizes, const PatternOptions& options);
std::string marker_line(const Used& used);
std::string gauge_line(const Gauge& gauge, const PatternOptions& options);

// Stitches that go around a short circular needle (40 cm) without being stretched; fewer take double-pointed needles.
inline constexpr double least_on_circular_cm = 42.0;
inline bool needs_circular(const PatternSizes& sizes) { return sizes.around_cm >= least_on_circular_cm; }
inline bool go_on_circular(std::int32_t stitches, const Gauge& gauge) {
  return 10.0 * stitches / gauge.stitches >= least_on_circular_cm;
}

std::vector<std::pair<std::string, std::string>> abbreviations_of(const Used& used, bool binds_off);
// `tight_start`: increases follow right on a cast on.
void add_shaping_notes(const Used& used, bool tight_start, std::vector<std::string>& notes);
void add_short_row_notes(const Used& used, std::vector<std::string>& notes);

// `place_marker`: how the markers are placed.
std::string start_sentence(std::int32_t cast_on, const Gauge& gauge,
                           const std::string& place_marker = "Place marker.");
std::string closing_sentence(std::int32_t stitches, bool drawn_in);
inline constexpr const char* stuff_and_close =
    "Stuff the piece firmly now, while the opening is wide; add more as it closes.";

// After each round, the cast on first.
std::vector<std::int32_t> counts_of(const Rounds& rounds);
void add_yarn(std::int64_t stitches, PatternSizes& sizes);

}  // namespace knit
