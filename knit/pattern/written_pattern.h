// The written pattern: everything a knitter is told, in the order in which knitters expect it, as text parts that
// an exporter sets. Lines and words follow the usual conventions (docs/pattern.md).
//
// Every count is worked out from the operations; sizes in centimetres come from the gauge's own arithmetic:
// length along the fabric = rounds / rounds per cm, circumference = stitches / stitches per cm.
//
// The finished height is that of the fabric filled out round: where circumferences change, a round climbs less
// than its own height h. A round's line stands in the middle of its height, as the rows of the mesh do. From
// one line to the next it climbs sqrt(h^2 - dr^2), dr being the change of the radius, taken over six rounds
// because counts are whole numbers. A drawn-in end is one more such step, to radius 0; an open end adds half a
// round. So an open tube is as high as its fabric is long, and a ball about as high as it is wide: 1.5 % less at
// 12 cm, 22 stitches and 32 rounds; the coarser the stitches, the rougher (4 % at 16 and 22).
//
// A pair of short rows adds two rows, but only where it is worked. Round the tube, whose stitches lie evenly from the beginning of
// the round on, pairs are counted at 256 places: the side with the fewest is the shorter one, that with the most the longer. How
// high such a piece stands is not known, for it bends.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "knit/limbs/limb_plan.h"
#include "knit/model/settings.h"
#include "knit/pattern/fold.h"
#include "knit/pattern/rounds.h"

namespace knit {

// How rounds are told. By itself: shortly where they were planned in a rhythm, written out elsewhere.
enum class PatternForm : std::uint8_t { by_itself, full, short_form };

// How hands turn in a short row: in German short rows, unless they are to wrap and turn. The fabric is the same.
enum class ShortRowTurns : std::uint8_t { usual, german, wrap };

struct PatternOptions {
  std::string title;                // empty: the mesh's name
  std::string yarn;                 // what the person calls it; empty: by weight class alone
  std::string colour;               // empty: not said
  std::optional<double> needle_mm;  // none: the usual one for the weight class
  bool markers = false;             // at main lines
  bool stars = false;               // *...; rep from * to end, where a round is one repeat
  // Told shortly where that says the same (short_form.h): named rounds, [Knit 2 rnds, inc rnd] 3 times. Then the words
  // have neither markers at main lines nor stars.
  PatternForm form = PatternForm::by_itself;
  // What a person calls pieces, by their letters: {"A", "Tail"}. One capitalised word each (is_piece_word).
  std::map<std::string, std::string> piece_names = {};
  ShortRowTurns turns = ShortRowTurns::usual;
  friend bool operator==(const PatternOptions&, const PatternOptions&) = default;
};

struct PatternSizes {
  Gauge gauge;             // stitches and rounds in 10 cm
  double length_cm = 0.0;  // along the fabric: the rounds, the cast on too
  double height_cm = 0.0;  // filled out round; with short rows that of the shorter side
  double longer_cm = 0.0;  // that of the longer side; without short rows the same
  double around_cm = 0.0;  // at the widest round
  double yarn_m = 0.0;     // without spare
  double yarn_with_spare_m = 0.0;
  double yarn_g = 0.0;   // with spare
  int weight_class = 3;  // Craft Yarn Council, 0 Lace to 7 Jumbo
};
PatternSizes sizes_of(const Rounds& rounds, const Gauge& gauge);
// Length and height are not known, and 0: they depend on how the pieces lie.
PatternSizes sizes_of(const LimbPlan& plan, const Gauge& gauge);

// Up to so many stitches are drawn together with the yarn's end, at the cast on too; more are bound off, or
// stay open.
inline constexpr std::int32_t most_drawn_in = 12;
inline bool is_drawn_in(std::int32_t stitches) { return stitches <= most_drawn_in; }

inline bool begins_drawn_in(const Rounds& rounds) {
  return !rounds.begins_open && is_drawn_in(rounds.cast_on);
}
inline bool ends_drawn_in(const Rounds& rounds) {
  return !rounds.ends_open && is_drawn_in(rounds.last_count());
}

// After which rounds (their numbers) a piece closed at both ends is stuffed: the last one that still has 40 %
// of the most stitches, and 12 at least; and alike before a neck of fewer than a quarter of them, or than 12.
// Empty: the piece stays open, or is too narrow all over.
std::vector<std::int32_t> stuffed_after(const Rounds& rounds);

// "Rnd 7: [K4, m1l] 6 times. (30 sts)" or "Rnds 8-12: Knit. (30 sts)"
struct RoundLine {
  std::int32_t first = 1, last = 1;
  std::string words;          // "[K4, m1l] 6 times", without label, stop and count
  std::int32_t stitches = 0;  // afterwards
  // Of the fabric, that come before round 1: rounds of a piece are numbered from 1.
  std::int32_t rows_before = 0;
  std::vector<std::int32_t> twins_before = {};  // the same of twins that are made by the same words
  bool moves_marker = false;                    // back by a stitch
  // In the short form, after each shaping round: "(64, 72, 80 sts)".
  std::vector<std::int32_t> counts = {};
  // Of short rows: "Short row 1 (RS)", "Next row (RS)" or "Rnd 8 (cont.)" in place of the round's label, and in place of the
  // count where the work is turned: "5 sts after BOR".
  std::string label = {}, place = {};
  bool short_row = false;  // it belongs to the round and does not complete it
  [[nodiscard]] std::string text() const;
};

// Of pieces that are made together: a line of the list of pieces.
struct PieceFacts {
  std::vector<std::int32_t> pieces;  // of the plan
  std::string name;                  // "Limbs B and C"
  std::string begins, ends;          // "cast on 5"; "held for Body D"
  std::int32_t rounds = 0, first = 0,
               last = 0;  // stitches before the first round, or cast on; after the last one
  double long_cm = 0.0, around_cm = 0.0;
};

struct WrittenPattern {
  std::string title, level;  // Basic, Easy, Intermediate or Complex
  std::vector<std::string> size;
  std::vector<std::string> materials;
  std::string gauge;
  std::vector<std::pair<std::string, std::string>> abbreviations;  // only those used
  std::vector<std::string> notes;
  // "Using double-pointed needles, CO 6 sts. Join ... Place marker." Of pieces: that they follow.
  std::string start;
  struct Instruction {
    // remark: stuffing, and last how the end is closed. heading: of a piece. step: how a piece begins, done like a round.
    enum class Kind : std::uint8_t { remark, heading, step };
    std::optional<RoundLine> round;  // or else words
    std::string remark;
    Kind kind = Kind::remark;
    std::int32_t row = 0;  // of the fabric, that a step casts on; 0: none
  };
  std::vector<Instruction> instructions;
  std::vector<std::string> finishing;
  bool in_pieces = false;  // each has a heading among the instructions
  std::vector<PieceFacts> pieces = {};
  std::size_t overview = 0;  // so many of the first instructions say no more than the list of pieces does
};

WrittenPattern write_pattern(const Rounds& rounds, const Gauge& gauge, const PatternOptions& options,
                             const std::string& mesh_name);
// `height_cm`: of the finished object as the shape stands, where it is known.
WrittenPattern write_pattern(const LimbPlan& plan, const Gauge& gauge, const PatternOptions& options,
                             const std::string& mesh_name, std::optional<double> height_cm = std::nullopt);

// A step of a piece that is too long for a line is told one item a line: "Join with Limb A:", "keep 7 sts,", ...
bool is_told_by_items(const WrittenPattern::Instruction& instruction);
std::vector<std::string> items_of_step(const std::string& step);

// Lines of at most 100 columns, but a round is always one line. No line begins like a round but the rounds.
std::string pattern_as_text(const WrittenPattern& pattern);
std::string pattern_as_markdown(const WrittenPattern& pattern);

}  // namespace knit
