// The written pattern in pieces: a heading, what lies on the needle, the rounds, and how the piece ends. A line that says what
// lies on the needle knits nothing: the next round is worked over it.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "knit/model/words.h"
#include "knit/pattern/pattern_words.h"
#include "knit/pattern/written_parts.h"
#include "knit/pattern/written_pattern.h"
#include "knit/pattern/yarn.h"

namespace knit {

namespace {

using Instruction = WrittenPattern::Instruction;
using InstructionKind = WrittenPattern::Instruction::Kind;

// "Pieces B, C and D", "Piece B"
std::string names_of(const std::vector<std::int32_t>& pieces) {
  if (pieces.size() == 1) return piece_name(pieces.front());
  std::string names = "Pieces ";
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (i > 0) names += i + 1 == pieces.size() ? " and " : ", ";
    names += tube_name(pieces[i]);
  }
  return names;
}

std::string upper_first(std::string text) {
  text.front() = static_cast<char>(text.front() - 'a' + 'A');
  return text;
}

// --- what lies on the needle -------------------------------------------------------------------------------------

// A piece's last count.
std::int32_t size_of_end(const Pieces& pieces, std::int32_t piece) {
  return pieces.piece(piece).rounds.last_count();
}

// Whether a holder of this piece is emptied in order, from its first stitch on: then no numbers are needed.
bool takes_in_order(const Pieces& pieces, std::int32_t number, std::int32_t from) {
  const bool shared = pieces.piece(from).end.kind == PieceEndKind::held;
  std::int32_t last = -1;
  std::int32_t taken = 0;
  for (const Lay& lay : pieces.piece(number).laid) {
    if (lay.kind != LayKind::take || lay.piece != from) continue;
    if (lay.first < last || lay.first + lay.count > size_of_end(pieces, from)) return false;
    last = lay.first + lay.count;
    taken += lay.count;
  }
  return !shared || taken == size_of_end(pieces, from);
}

// " (its sts 11 to 29)", " (its sts 36 to 39 and 1 to 15)"
std::string range_text(const Lay& lay, std::int32_t size) {
  const auto stretch = [](std::int32_t first, std::int32_t last) {
    return std::to_string(first) + (first == last ? "" : " to " + std::to_string(last));
  };
  const std::string all = lay.count == 1 ? " (its st " : " (its sts ";
  const std::int32_t end = lay.first + lay.count;
  if (end <= size) return all + stretch(lay.first + 1, end) + ")";
  return all + stretch(lay.first + 1, size) + " and " + stretch(1, end - size) + ")";
}

std::string gap_text(const Pieces& pieces, const Lay& lay) {
  const std::string gap = "gap " + std::to_string(lay.gap);
  if (lay.kind == LayKind::cast_on) return "CO " + stitches_text(lay.count) + " over " + gap;
  const std::string along = " along " + gap;
  if (lay.count == pieces.gap(lay.gap)) return "pick up " + stitches_text(lay.count) + along;
  return "pick up " + std::to_string(lay.count) + " of the " + stitches_text(pieces.gap(lay.gap)) + along;
}

// Of a piece that is there already: each thing that is laid, in working order.
std::vector<std::string> laid_words(const Pieces& pieces, std::int32_t number) {
  std::vector<std::string> words;
  std::vector<std::int32_t> begun;  // for whom there is a holder
  for (const Lay& lay : pieces.piece(number).laid) {
    switch (lay.kind) {
      case LayKind::keep:
        words.push_back("keep " + stitches_text(lay.count));
        break;
      case LayKind::set_aside: {
        const bool again = std::find(begun.begin(), begun.end(), lay.piece) != begun.end();
        begun.push_back(lay.piece);
        words.push_back("place next " + stitches_text(lay.count) +
                        (again ? " on the holder for " : " on a holder for ") + piece_name(lay.piece));
        break;
      }
      case LayKind::take: {
        const std::string range =
            takes_in_order(pieces, number, lay.piece) ? "" : range_text(lay, size_of_end(pieces, lay.piece));
        words.push_back("take " + std::to_string(lay.count) + " held " + (lay.count == 1 ? "st" : "sts") +
                        " of " + piece_name(lay.piece) + range);
        break;
      }
      case LayKind::cast_on:
      case LayKind::pick_up:
        words.push_back(gap_text(pieces, lay));
        break;
      case LayKind::loops:
        break;
    }
  }
  return words;
}

// "(21 sts; Piece C 20 sts)": on the needle, and what was put on holders.
std::string laid_count(const Piece& piece) {
  std::string text = stitches_text(piece.rounds.cast_on);
  std::vector<std::pair<std::int32_t, std::int32_t>> aside;  // for whom, stitches
  for (const Lay& lay : piece.laid) {
    if (lay.kind != LayKind::set_aside) continue;
    const auto found =
        std::find_if(aside.begin(), aside.end(), [&](const auto& held) { return held.first == lay.piece; });
    if (found == aside.end())
      aside.emplace_back(lay.piece, lay.count);
    else
      found->second += lay.count;
  }
  for (const auto& [whom, count] : aside) text += "; " + piece_name(whom) + " " + stitches_text(count);
  return " (" + text + ")";
}

bool has_lay(const Piece& piece, LayKind kind) {
  return std::any_of(piece.laid.begin(), piece.laid.end(), [&](const Lay& lay) { return lay.kind == kind; });
}

// The pieces whose held stitches it takes, in that order.
std::vector<std::int32_t> taken_from(const Piece& piece) {
  std::vector<std::int32_t> from;
  for (const Lay& lay : piece.laid) {
    const bool known = std::find(from.begin(), from.end(), lay.piece) != from.end();
    if (lay.kind == LayKind::take && !known) from.push_back(lay.piece);
  }
  return from;
}

// What is done to the needle; of what is only on holders: what is done about the yarn.
std::string lead_of(const Piece& piece) {
  if (piece.start == PieceStart::rejoined) {
    if (piece.yarn == PieceYarn::begun) return "Rejoin yarn";
    return "Go on with the yarn that hangs there";
  }
  const std::vector<std::int32_t> from = taken_from(piece);
  std::string lead = has_lay(piece, LayKind::set_aside) ? "Divide" : "";
  if (!from.empty()) lead += (lead.empty() ? "Join with " : ", and join with ") + names_of(from);
  return lead.empty() ? "Go on" : lead;
}

std::string laid_sentence(const Pieces& pieces, std::int32_t number) {
  const Piece& piece = pieces.piece(number);
  std::string text;
  for (const std::string& words : laid_words(pieces, number)) text += (text.empty() ? "" : ", ") + words;
  text = lead_of(piece) + ": " + text + ".";
  const bool on_needle = piece.start == PieceStart::divided;
  if (on_needle && piece.yarn == PieceYarn::begun) text += " Join a new yarn at the first st kept.";
  return text + laid_count(piece);
}

std::string loops_sentence(const Piece& piece) {
  const Lay& lay = piece.laid.front();
  return "Remove the waste yarn of " + piece_name(lay.piece) + " and place its " + std::to_string(lay.count) +
         " loops on the needle; they run the other way. Begin with the loop below st " +
         std::to_string(lay.first + 1) + " of its Rnd 1. Join a new yarn there." + laid_count(piece);
}

std::string provisional_sentence(std::int32_t cast_on) {
  return "Provisionally CO " + stitches_text(cast_on) +
         " over waste yarn (Rnd 1). Join to work in the round, being careful not to twist. Place marker.";
}

// --- beginning and end of a piece --------------------------------------------------------------------------------

// The piece that is worked on a provisional cast on's loops; -1: none.
std::int32_t on_loops_of(const Pieces& pieces, std::int32_t number) {
  for (std::size_t i = 0; i < pieces.pieces.size(); ++i) {
    const Piece& piece = pieces.pieces[i];
    if (piece.start == PieceStart::loops && piece.laid.front().piece == number)
      return static_cast<std::int32_t>(i);
  }
  return -1;
}

constexpr const char* inner_remark =
    "This piece is the inside of the work: knit it right side out like the others. It is pushed through to "
    "the "
    "inside later.";

std::string push_sentence(const std::string& what) {
  return "First push " + what + " through to the inside, wrong sides together.";
}

// What is pushed inside before a piece is joined to it.
std::vector<std::int32_t> inner_of(const Pieces& pieces, const Piece& piece) {
  std::vector<std::int32_t> inner;
  for (const std::int32_t from : taken_from(piece)) {
    if (pieces.piece(from).inner && !piece.inner) inner.push_back(from);
  }
  return inner;
}

void begin_words(const Pieces& pieces, std::int32_t number, std::vector<Instruction>& lines) {
  const Piece& piece = pieces.piece(number);
  lines.push_back({std::nullopt,
                   piece_name(number) + ": " + plural(piece.round_count(), "rnd", "rnds") + ", " +
                       stitches_text(piece.rounds.last_count()) + " at the end",
                   InstructionKind::heading});
  if (piece.inner) lines.push_back({std::nullopt, inner_remark});
  const auto step = [&](std::string words, bool casts_on) {
    lines.push_back({std::nullopt, std::move(words), InstructionKind::step, casts_on ? piece.first_row : 0});
  };
  switch (piece.start) {
    case PieceStart::provisional:
      lines.push_back({std::nullopt, names_of({number, on_loops_of(pieces, number)}) +
                                         " start from one cast-on edge (provisional cast on)."});
      step(provisional_sentence(piece.rounds.cast_on), true);
      break;
    case PieceStart::cast_on:
      step(start_sentence(piece.rounds.cast_on), true);
      break;
    case PieceStart::loops:
      step(loops_sentence(piece), false);
      break;
    case PieceStart::divided:
    case PieceStart::rejoined:
      if (const auto inner = inner_of(pieces, piece); !inner.empty())
        lines.push_back({std::nullopt, push_sentence(names_of(inner))});
      step(laid_sentence(pieces, number), false);
      break;
  }
}

// Equal ones that follow each other are one: "graft 5", "graft 1 to 2".
std::vector<std::string> graft_runs(const std::vector<Grafted>& grafts) {
  std::vector<std::string> runs;
  for (std::size_t i = 0, end = 0; i < grafts.size(); i = end) {
    end = i + 1;
    if (grafts[i] == Grafted{}) {
      while (end < grafts.size() && grafts[end] == grafts[i]) ++end;
      runs.push_back("graft " + std::to_string(end - i));
    } else {
      runs.push_back("graft " + std::to_string(grafts[i].own) + " to " + std::to_string(grafts[i].others));
    }
  }
  return runs;
}

// How often the `period` words from `first` on come there one after the other.
std::size_t times_there(const std::vector<std::string>& words, std::size_t first, std::size_t period) {
  std::size_t end = first + period;
  while (end < words.size() && words[end] == words[end - period]) ++end;
  return (end - first) / period;
}

// What comes again at once is told once: of the periods up to four the one that covers most.
std::string graft_words(const std::vector<Grafted>& grafts) {
  constexpr std::size_t longest = 4;
  const std::vector<std::string> runs = graft_runs(grafts);
  std::string text;
  for (std::size_t i = 0; i < runs.size();) {
    std::size_t period = 1, times = 1;
    for (std::size_t tried = 1; tried <= longest && i + tried <= runs.size(); ++tried) {
      const std::size_t found = times_there(runs, i, tried);
      if (found > 1 && found * tried > period * times) period = tried, times = found;
    }
    std::string words;
    for (std::size_t k = 0; k < period; ++k) words += (k > 0 ? ", " : "") + runs[i + k];
    if (!text.empty()) text += ", ";
    text += times == 1 ? words : "[" + words + "] " + std::to_string(times) + " times";
    i += period * times;
  }
  return text;
}

std::string graft_sentence(const Pieces& pieces, const Piece& piece) {
  const std::int32_t other = piece.end.to.front();
  return "Graft to " + piece_name(other) + " (" + stitches_text(size_of_end(pieces, other)) +
         "), wrong sides together, beginning with st " + std::to_string(piece.end.own_first + 1) +
         " of this piece and st " + std::to_string(piece.end.other_first + 1) + " of " + piece_name(other) +
         ", whose sts come backwards: " + graft_words(piece.end.grafts) + ". Fasten off. (0 sts)";
}

std::string end_sentence(const Pieces& pieces, std::int32_t number) {
  const Piece& piece = pieces.piece(number);
  const PieceEnd& end = piece.end;
  const std::int32_t count = piece.rounds.last_count();
  const std::string next = piece_name(number + 1);
  std::string yarn = "break yarn";
  if (end.yarn_for == number + 1)
    yarn = "do not break yarn";
  else if (end.yarn_for >= 0)
    yarn = "do not break yarn, let it hang at " + piece_name(end.yarn_for);
  switch (end.kind) {
    case PieceEndKind::goes_on:
      return upper_first(yarn) + ". Leave the sts on the needle and go on with " + next + ".";
    case PieceEndKind::held:
      return upper_first(yarn) + ". Place " + stitches_text(count) + " on a holder for " + names_of(end.to) +
             ".";
    case PieceEndKind::grafted:
      return graft_sentence(pieces, piece);
    case PieceEndKind::closed:
      break;
  }
  return closing_sentence(count) + (is_drawn_in(count) ? "" : " Fasten off.");
}

// Nothing is left open but what is drawn in, and nothing is pushed inside.
bool is_stuffed(const Pieces& pieces) {
  return std::all_of(pieces.pieces.begin(), pieces.pieces.end(), [](const Piece& piece) {
    const bool closed = piece.end.kind != PieceEndKind::closed || is_drawn_in(piece.rounds.last_count());
    return closed && !piece.inner &&
           (piece.start != PieceStart::cast_on || is_drawn_in(piece.rounds.cast_on));
  });
}

// The last round, by its number, at which a piece that closes is still wide; 0: it never is.
std::int32_t stuffed_in(const Piece& piece) {
  constexpr double fewest = 12.0;
  if (piece.end.kind != PieceEndKind::closed) return 0;
  double most = 0.0;
  for (const Round& round : piece.rounds.rounds) most = std::max<double>(most, round.after);
  const double wide = std::max(0.4 * most, fewest);
  std::int32_t last = 0;
  for (const Round& round : piece.rounds.rounds) {
    if (round.after >= wide) last = round.number;
  }
  return last;
}

void end_words(const Pieces& pieces, std::int32_t number, bool stuffed, std::vector<Instruction>& lines) {
  const Piece& piece = pieces.piece(number);
  const PieceEnd& end = piece.end;
  const auto remark = [&](std::string words) { lines.push_back({std::nullopt, std::move(words)}); };
  constexpr std::int32_t long_limb = 3;
  if (stuffed && end.kind == PieceEndKind::held && piece.is_cast_on() && piece.round_count() > long_limb)
    remark("Stuff this piece before it is joined.");
  if (end.kind == PieceEndKind::grafted && piece.inner) remark(push_sentence("this piece"));
  if (end.kind == PieceEndKind::grafted && pieces.piece(end.to.front()).inner)
    remark(push_sentence(piece_name(end.to.front())));
  remark(end_sentence(pieces, number));
  if (end.kind == PieceEndKind::closed && piece.inner)
    remark("Push this piece through to the inside, wrong sides together.");
}

using PieceLines = std::vector<RoundLine>;

std::vector<Instruction> all_instructions(const Pieces& pieces, const std::vector<PieceLines>& lines) {
  std::vector<Instruction> all;
  const bool stuffed = is_stuffed(pieces);
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(pieces.pieces.size()); ++i) {
    begin_words(pieces, i, all);
    const std::int32_t stuffed_round = stuffed ? stuffed_in(pieces.piece(i)) : 0;
    for (const RoundLine& line : lines[static_cast<std::size_t>(i)]) {
      all.push_back({line, {}});
      if (line.first <= stuffed_round && stuffed_round <= line.last)
        all.push_back({std::nullopt, stuff_and_close});
    }
    end_words(pieces, i, stuffed, all);
  }
  return all;
}

// --- everything about them ---------------------------------------------------------------------------------------

std::vector<std::string> material_words(const Pieces& pieces, const PatternSizes& sizes,
                                        const PatternOptions& options, const Used& used) {
  std::vector<std::string> lines{yarn_line(sizes, options)};
  lines.push_back("Needles: " + needle_text(needle_of(sizes.gauge, options)) +
                  ", or the size that gives the gauge: a set of five double-pointed" +
                  (needs_circular(sizes) ? " and, for the wide parts, a 40 cm (16 in) circular." : "."));
  if (pieces.held_most > 0)
    lines.push_back("Stitch holders: " + std::to_string(pieces.held_most) +
                    "; a length of waste yarn will do.");
  const bool waste = std::any_of(pieces.pieces.begin(), pieces.pieces.end(),
                                 [](const Piece& piece) { return piece.start == PieceStart::provisional; });
  if (waste) lines.emplace_back("Waste yarn.");
  if (is_stuffed(pieces)) lines.emplace_back("Stuffing.");
  lines.push_back(marker_line(used));
  lines.emplace_back("Tapestry needle.");
  return lines;
}

std::string worked_in(const Pieces& pieces) {
  const auto count = static_cast<std::int32_t>(pieces.pieces.size());
  return plural(count, "piece", "pieces") + ", one after the other, from A to " + tube_name(count - 1);
}

std::vector<std::string> pieces_notes(const Pieces& pieces, const Used& used) {
  std::vector<std::string> notes{"Worked in the round, right side out, in " + worked_in(pieces) +
                                     ". Every round begins at the marker; slip it as you come to it. Where a "
                                     "piece begins on stitches that "
                                     "are there already, its round begins with the first stitch that is "
                                     "kept, taken, picked up or cast on: "
                                     "place the marker before it.",
                                 "The number in brackets at the end of a line is how many stitches there are "
                                 "after it. Rounds are numbered "
                                 "from 1 in each piece; a cast on counts as a round."};
  const std::int32_t held = pieces.held_most;
  notes.push_back(plural(pieces.yarns, "yarn is", "yarns are") +
                  " begun in all, those of cast ons counted. " +
                  (held == 0 ? "No holder is needed."
                             : "At most " + plural(held, "holder is", "holders are") + " in use at once."));
  notes.emplace_back(
      "Lines that begin with Divide, Join, Rejoin or Go on knit nothing. They list what lies on the needle, "
      "from the "
      "marker on, when the next round begins. Stitches of a finished piece are numbered from the beginning "
      "of its "
      "last round.");
  if (!pieces.gaps.empty()) {
    notes.emplace_back(
        "Gaps are bridged by a few stitches that are used from both sides. Cast them on when the next round "
        "comes to "
        "them, onto the left needle (knitted cast on), and knit on over them. To pick up along a gap, lift a "
        "loop of "
        "that cast-on edge onto the needle for each stitch, without knitting.");
  }
  const bool tight = std::any_of(pieces.pieces.begin(), pieces.pieces.end(), [](const Piece& piece) {
    const Rounds& rounds = piece.rounds;
    return piece.is_cast_on() && !rounds.rounds.empty() && rounds.rounds.front().after > rounds.cast_on;
  });
  add_shaping_notes(used, tight, notes);
  notes.emplace_back(
      "The checker (knit-mesh check) cannot read patterns in pieces yet, and there is no chart for them "
      "yet.");
  return notes;
}

std::vector<std::string> finishing_words(const Pieces& pieces) {
  std::vector<std::int32_t> drawn, open;
  for (std::size_t i = 0; i < pieces.pieces.size(); ++i) {
    const Piece& piece = pieces.pieces[i];
    if (piece.start != PieceStart::cast_on) continue;
    (is_drawn_in(piece.rounds.cast_on) ? drawn : open).push_back(static_cast<std::int32_t>(i));
  }
  std::vector<std::string> lines;
  if (!drawn.empty())
    lines.push_back(names_of(drawn) + (drawn.size() > 1 ? ", each" : "") +
                    ": thread the cast-on tail through the sts of the cast-on edge, pull the hole shut and "
                    "fasten off.");
  if (!open.empty())
    lines.push_back(names_of(open) + (open.size() > 1 ? ", each" : "") + ": the cast-on edge stays open.");
  lines.emplace_back("Weave in all ends; close small holes beside the gaps with them.");
  return lines;
}

bool bind_off_somewhere(const Pieces& pieces) {
  return std::any_of(pieces.pieces.begin(), pieces.pieces.end(), [](const Piece& piece) {
    return piece.end.kind == PieceEndKind::closed && !is_drawn_in(piece.rounds.last_count());
  });
}

}  // namespace

WrittenPattern write_pattern(const Pieces& pieces, const Gauge& gauge, const PatternOptions& options,
                             const std::string& mesh_name) {
  const PatternSizes sizes = sizes_of(pieces, gauge);
  std::vector<PieceLines> lines;
  Used used;
  for (const Piece& piece : pieces.pieces) {
    lines.push_back(round_lines(piece.rounds, options));
    for (RoundLine& line : lines.back()) line.rows_before = piece.rows_before;
    add_used(piece.rounds, lines.back(), used);
  }
  WrittenPattern pattern;
  pattern.title = title_of(options, mesh_name);
  pattern.level = level_of(used);
  pattern.size = {"About " + length_text(sizes.around_cm) + " around at the widest round."};
  pattern.materials = material_words(pieces, sizes, options, used);
  pattern.gauge = gauge_line(gauge, options);
  pattern.abbreviations = abbreviations_of(used, bind_off_somewhere(pieces));
  pattern.notes = pieces_notes(pieces, used);
  pattern.start = "Worked in " + worked_in(pieces) + ".";
  pattern.instructions = all_instructions(pieces, lines);
  pattern.finishing = finishing_words(pieces);
  pattern.in_pieces = true;
  return pattern;
}

PatternSizes sizes_of(const Pieces& pieces, const Gauge& gauge) {
  PatternSizes sizes;
  sizes.gauge = gauge;
  std::int64_t stitches = 0;
  std::int32_t most = 0;
  for (const Piece& piece : pieces.pieces) {
    if (piece.is_cast_on()) stitches += piece.rounds.cast_on;
    for (const Round& round : piece.rounds.rounds) stitches += round.after;
    for (const std::int32_t count : counts_of(piece.rounds)) most = std::max(most, count);
  }
  for (const std::int32_t gap : pieces.gaps) stitches += gap;
  sizes.around_cm = most / (gauge.stitches / 10.0);
  add_yarn(stitches, sizes);
  return sizes;
}

}  // namespace knit
