// The written pattern with limbs: an overview, then for each piece a heading, what lies on the needle, its rounds and its end.
// Twins whose words are the same are written once. What proves nothing stands in brackets.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "knit/model/words.h"
#include "knit/pattern/limb_words.h"
#include "knit/pattern/pattern_words.h"
#include "knit/pattern/written_parts.h"
#include "knit/pattern/yarn.h"

namespace knit {

namespace {

using Instruction = WrittenPattern::Instruction;
using InstructionKind = WrittenPattern::Instruction::Kind;

std::int32_t first_round_of(const LimbPiece& piece) { return piece.is_cast_on() ? 2 : 1; }

Rounds rounds_of(const LimbPiece& piece) {
  Rounds rounds;
  rounds.cast_on = piece.first_count();
  std::int32_t number = first_round_of(piece);
  for (const LimbRound& round : piece.rounds)
    rounds.rounds.push_back({number++, round.operations, round.before, round.after});
  return rounds;
}

std::string lower_first(std::string text) {
  if (!text.empty() && text.front() >= 'A' && text.front() <= 'Z')
    text.front() = static_cast<char>(text.front() - 'A' + 'a');
  return text;
}

// A line a round, equal plain ones that follow each other on one; the cast on first.
std::vector<RoundLine> lines_of(const LimbPiece& piece, const PatternOptions& options) {
  std::vector<RoundLine> lines;
  const std::int32_t before = piece.rows.front() - 1;
  if (piece.is_cast_on())
    lines.push_back({1, 1, cast_on_words(piece.deals.back()), piece.first_count(), before, {}, false});
  const Rounds rounds = rounds_of(piece);
  for (std::size_t i = 0; i < piece.rounds.size(); ++i) {
    const bool slips = piece.rounds[i].slips_back;
    Rounds one;
    one.rounds = {rounds.rounds[i]};
    RoundLine line = round_lines(one, options).front();
    line.rows_before = before;
    line.moves_marker = slips;
    if (slips) line.words = "Slip last st back, " + lower_first(line.words);
    const bool same = !slips && !lines.empty() && !lines.back().moves_marker &&
                      lines.back().words == line.words && lines.back().stitches == line.stitches;
    if (same)
      lines.back().last = line.last;
    else
      lines.push_back(std::move(line));
  }
  return lines;
}

bool is_alone(const LimbPiece& piece) {
  return piece.deals.size() == 1 && piece.deals.front().kind == LimbDealKind::cast_on;
}

bool are_twins(const LimbPlan& plan, std::int32_t a, std::int32_t b) {
  const std::vector<std::int32_t>& twins = plan.piece(a).twins;
  return std::find(twins.begin(), twins.end(), b) != twins.end();
}

bool same_operations(const LimbRound& a, const LimbRound& b) {
  const auto same_hand = [](const Operation& x, const Operation& y) { return x.hand == y.hand; };
  return a.before == b.before && a.after == b.after && a.slips_back == b.slips_back &&
         std::equal(a.operations.begin(), a.operations.end(), b.operations.begin(), b.operations.end(),
                    same_hand);
}

// Which rounds of a twin before it say what to do: from this number on; 0: none.
std::int32_t alike_from(const LimbPiece& twin, const LimbPiece& piece) {
  if (twin.rounds.size() != piece.rounds.size() || twin.is_cast_on() != piece.is_cast_on()) return 0;
  std::size_t same = piece.rounds.size();
  while (same > 0 && same_operations(twin.rounds[same - 1], piece.rounds[same - 1])) --same;
  const bool all = same == 0 && piece.is_cast_on() && twin.deals.back().kind == piece.deals.back().kind;
  const std::int32_t from = all ? 1 : first_round_of(piece) + static_cast<std::int32_t>(same);
  return piece.round_count() - from + 1 >= 2 ? from : 0;
}

class Writer {
 public:
  Writer(const LimbPlan& plan, const Gauge& gauge, const PatternOptions& options)
      : plan_(plan), gauge_(gauge), names_(plan, options) {
    for (const LimbPiece& piece : plan.pieces) lines_.push_back(lines_of(piece, options));
  }

  [[nodiscard]] const LimbNames& names() const { return names_; }
  [[nodiscard]] const std::vector<RoundLine>& lines(std::int32_t piece) const {
    return lines_[static_cast<std::size_t>(piece)];
  }

  std::vector<Instruction> instructions() {
    overview();
    for (std::int32_t piece = 0; piece < plan_.count();) {
      std::int32_t end = piece + 1;
      while (end < plan_.count() && is_made_with(piece, end)) ++end;
      write(piece, end);
      piece = end;
    }
    return std::move(all_);
  }

  // Nothing is left open but what is drawn in, and nothing is pushed inside.
  [[nodiscard]] bool is_stuffed() const {
    return std::all_of(plan_.pieces.begin(), plan_.pieces.end(), [](const LimbPiece& piece) {
      const bool closed = piece.end.kind != LimbEndKind::closed || is_drawn_in(piece.last_count());
      const bool begun =
          piece.deals.front().kind != LimbDealKind::cast_on || is_drawn_in(piece.first_count());
      return closed && begun && !piece.inner;
    });
  }

 private:
  // Twins that follow each other, are cast on and have the same words.
  [[nodiscard]] bool is_made_with(std::int32_t first, std::int32_t other) const {
    const LimbPiece &a = plan_.piece(first), &b = plan_.piece(other);
    return are_twins(plan_, first, other) && is_alone(a) && is_alone(b) &&
           names_.word(first) == names_.word(other) && a.first_count() == b.first_count() &&
           a.rounds.size() == b.rounds.size() &&
           std::equal(a.rounds.begin(), a.rounds.end(), b.rounds.begin(), same_operations);
  }

  void remark(const std::string& words) { all_.push_back({std::nullopt, "(" + words + ")"}); }
  void step(std::string words) { all_.push_back({std::nullopt, std::move(words), InstructionKind::step}); }

  void overview() {
    const std::string holders = plan_.held_most == 0
                                    ? "no holder"
                                    : plural(plan_.held_most, "holder", "holders") + " at once at most";
    remark("Order of work; " + holders + ", " + plural(plan_.yarns, "yarn", "yarns") + " begun:");
    for (std::int32_t piece = 0; piece < plan_.count();) {
      std::vector<std::int32_t> together{piece++};
      while (piece < plan_.count() && is_made_with(together.front(), piece)) together.push_back(piece++);
      remark(overview_of(plan_, names_, together, gauge_));
    }
  }

  void heading(std::int32_t first, std::int32_t end) {
    const LimbPiece& piece = plan_.piece(first);
    std::vector<std::int32_t> together;
    for (std::int32_t i = first; i < end; ++i) together.push_back(i);
    std::string words = names_.together(together);
    if (end - first > 1) words += " (make " + std::to_string(end - first) + ")";
    all_.push_back({std::nullopt,
                    words + ": " + plural(piece.round_count(), "rnd", "rnds") + ", " +
                        stitches_text(piece.last_count()) + " at the end",
                    InstructionKind::heading});
  }

  void write(std::int32_t first, std::int32_t end) {
    const LimbPiece& piece = plan_.piece(first);
    heading(first, end);
    if (piece.inner)
      remark(
          "This tube is the inside of the work: knit it right side out like the others. It is pushed through "
          "at the end.");
    for (const LimbDeal& deal : piece.deals) {
      const bool casts_on = deal.kind == LimbDealKind::cast_on || deal.kind == LimbDealKind::provisional;
      if (deal.kind == LimbDealKind::provisional)
        remark("Its cast-on loops are worked later: see the notes.");
      if (!casts_on) step(deal_sentence(plan_, names_, deal));
    }
    rounds(first, end);
    ends(first, end);
  }

  void rounds(std::int32_t first, std::int32_t end) {
    std::int32_t twin = -1, from = 0;
    for (const std::int32_t other : plan_.piece(first).twins) {
      if (other >= first || twin >= 0) continue;
      from = alike_from(plan_.piece(other), plan_.piece(first));
      if (from > 0) twin = other;
    }
    // Where the rounds of a twin say so, they say it.
    std::int32_t stuffed = is_stuffed() ? stuffed_in(plan_.piece(first)) : 0;
    if (twin >= 0 && stuffed >= from) stuffed = 0;
    bool told = false;
    const auto tell_stuffing = [&](std::int32_t last) {
      if (stuffed == 0 || told || last < stuffed) return;
      remark(stuff_and_close);
      told = true;
    };
    for (const RoundLine& line : lines(first)) {
      if (twin >= 0 && line.last >= from) break;
      add(line, first, end);
      tell_stuffing(line.last);
    }
    if (twin < 0) return;
    const LimbPiece& piece = plan_.piece(first);
    // Of rounds alike on one line some may come before.
    for (const RoundLine& line : lines(first)) {
      if (line.first < from && from <= line.last) {
        RoundLine before = line;
        before.last = from - 1;
        add(before, first, end);
      }
    }
    add({from,
         piece.round_count(),
         "Work as for " + names_(twin),
         piece.last_count(),
         piece.rows.front() - 1,
         {},
         false},
        first, end);
  }

  void add(RoundLine line, std::int32_t first, std::int32_t end) {
    for (std::int32_t i = first + 1; i < end; ++i)
      line.twins_before.push_back(plan_.piece(i).rows.front() - 1);
    all_.push_back({std::move(line), {}});
  }

  // The last round, by its number, at which a piece that closes is still wide; 0: it never is.
  static std::int32_t stuffed_in(const LimbPiece& piece) {
    constexpr double fewest = 12.0;
    if (piece.end.kind != LimbEndKind::closed) return 0;
    double most = 0.0;
    for (const LimbRound& round : piece.rounds) most = std::max<double>(most, round.after);
    const double wide = std::max(0.4 * most, fewest);
    std::int32_t last = 0, number = first_round_of(piece);
    for (const LimbRound& round : piece.rounds) {
      if (round.after >= wide) last = number;
      ++number;
    }
    return last;
  }

  void ends(std::int32_t first, std::int32_t end) {
    const LimbPiece& piece = plan_.piece(first);
    constexpr std::int32_t long_limb = 3, wide_limb = 12;
    const bool joined = piece.end.kind == LimbEndKind::held || piece.end.kind == LimbEndKind::goes_on;
    const bool wide = std::any_of(piece.rounds.begin(), piece.rounds.end(),
                                  [](const LimbRound& round) { return round.after >= wide_limb; });
    if (is_stuffed() && joined && wide && is_alone(piece) && piece.round_count() > long_limb)
      remark(end - first > 1 ? "Stuff each before it is joined." : "Stuff it before it is joined.");
    if (piece.end.kind == LimbEndKind::grafted) {
      const std::int32_t inner = piece.inner                          ? first
                                 : plan_.piece(piece.end.piece).inner ? piece.end.piece
                                                                      : -1;
      if (inner >= 0)
        remark("Push " + names_(inner) +
               " to the inside, wrong sides together; stuff the space between, if you like, "
               "before the last sts are grafted.");
    }
    for (std::int32_t i = first; i < end;) {
      const std::string words = end_sentence(plan_, names_, plan_.piece(i));
      std::vector<std::int32_t> same;
      while (i < end && end_sentence(plan_, names_, plan_.piece(i)) == words) same.push_back(i++);
      step(end - first > 1 ? names_.together(same) + ": " + words : words);
    }
    if (piece.end.kind == LimbEndKind::closed && piece.inner)
      remark("Push this tube through to the inside, wrong sides together.");
  }

  const LimbPlan& plan_;
  const Gauge& gauge_;
  LimbNames names_;
  std::vector<std::vector<RoundLine>> lines_;
  std::vector<Instruction> all_;
};

// --- everything about them ---------------------------------------------------------------------------------------

bool has_deal(const LimbPlan& plan, LimbDealKind kind) {
  return std::any_of(plan.pieces.begin(), plan.pieces.end(), [&](const LimbPiece& piece) {
    return std::any_of(piece.deals.begin(), piece.deals.end(),
                       [&](const LimbDeal& deal) { return deal.kind == kind; });
  });
}

std::vector<std::string> material_words(const LimbPlan& plan, const PatternSizes& sizes,
                                        const PatternOptions& options, const Used& used, bool stuffed) {
  std::vector<std::string> lines{yarn_line(sizes, options)};
  lines.push_back("Needles: " + needle_text(needle_of(sizes.gauge, options)) +
                  ", or the size that gives the gauge: a set of five double-pointed" +
                  (needs_circular(sizes) ? " and, for the wide parts, a 40 cm (16 in) circular." : "."));
  if (plan.held_most > 0)
    lines.push_back("Stitch holders: " + std::to_string(plan.held_most) +
                    "; a length of waste yarn will do.");
  if (has_deal(plan, LimbDealKind::provisional))
    lines.emplace_back("Waste yarn for the provisional cast on.");
  if (stuffed) lines.emplace_back("Stuffing.");
  lines.push_back(marker_line(used));
  if (plan.held_most > 0) lines.emplace_back("Removable markers, one for each holder.");
  lines.emplace_back("Tapestry needle.");
  return lines;
}

std::string worked_in(const LimbPlan& plan) {
  return plural(plan.count(), "piece", "pieces") + ", one after the other, from A to " +
         tube_name(plan.count() - 1);
}

// A span in brackets stands where a holder is entered elsewhere than at its first stitch.
const LimbItem* entered_late(const LimbPlan& plan) {
  for (const LimbPiece& piece : plan.pieces) {
    for (const LimbDeal& deal : piece.deals) {
      for (const LimbItem& item : deal.items) {
        if (item.kind == LimbItemKind::take && item.first > 0 && item.count == item.held) return &item;
      }
    }
  }
  return nullptr;
}

void add_marker_notes(const LimbPlan& plan, const LimbNames& names, std::vector<std::string>& notes) {
  if (plan.held_most > 0)
    notes.emplace_back(
        "When you put the sts of a finished piece on a holder, hang a removable marker before the first st "
        "of "
        "its rnd; where a needle is divided, before the first st that is placed. Held sts are counted from "
        "there.");
  if (const LimbItem* late = entered_late(plan)) {
    const std::string first = std::to_string(late->first + 1), last = std::to_string(late->first);
    notes.push_back("\"" + stitches_text(late->count) + " of " + names(late->piece) + " (" + first + " to " +
                    last + ")\": begin with its held st " + first +
                    ", counted from its marker, and go round to st " + last +
                    ", so that all of them are worked.");
  }
  const bool slips = std::any_of(plan.pieces.begin(), plan.pieces.end(), [](const LimbPiece& piece) {
    return std::any_of(piece.rounds.begin(), piece.rounds.end(),
                       [](const LimbRound& r) { return r.slips_back; });
  });
  if (slips)
    notes.emplace_back(
        "\"Slip last st back\": put the last st of the rnd before back on the left needle; the marker moves "
        "with it.");
}

std::vector<std::string> note_words(const LimbPlan& plan, const LimbNames& names, const Used& used) {
  std::vector<std::string> notes{"Worked in the round, right side out, in " + worked_in(plan) +
                                     ". Every rnd begins at the marker, which stays where the yarn hangs; "
                                     "slip it as you come to it. Rnds are numbered "
                                     "from 1 in each piece; a cast on counts as a rnd.",
                                 "The number in brackets at the end of a line is how many sts are on the "
                                 "needle after it. What stands in brackets by "
                                 "itself is a remark."};
  notes.emplace_back(
      "Lines that begin with Divide, Join or Rejoin knit nothing. They list, from the marker on, what lies "
      "on "
      "the needle when Rnd 1 begins; \"keep\" means that sts stay there.");
  if (!plan.gaps.empty()) {
    notes.emplace_back(
        "\"CO 2 sts over gap 1\": when Rnd 1 comes to the gap, cast the sts on to the left needle (knitted "
        "cast "
        "on) and knit on over them. Hang a thread in each gap to know it by.");
    notes.emplace_back(
        "\"Pick up 2 sts along gap 1\": lift one loop of that cast-on edge onto the needle for each st, "
        "without "
        "knitting; the next rnd works them. Each gap is cast on once and picked up once, so it closes "
        "without "
        "a hole.");
  }
  add_marker_notes(plan, names, notes);
  if (has_deal(plan, LimbDealKind::provisional))
    notes.emplace_back(
        "A provisional cast on leaves live loops on waste yarn. The other piece of the ring begins on them.");
  notes.emplace_back("\"Work as for\": the same rnds, with the same numbers, as of the piece that is named.");
  if (has_deal(plan, LimbDealKind::join))
    notes.emplace_back("Lay pieces side by side, untwisted, right sides out, before you join them.");
  const bool tight = std::any_of(plan.pieces.begin(), plan.pieces.end(), [](const LimbPiece& piece) {
    return piece.is_cast_on() && !piece.rounds.empty() && piece.rounds.front().after > piece.first_count();
  });
  add_shaping_notes(used, tight, notes);
  return notes;
}

std::vector<std::string> finishing_words(const LimbPlan& plan, const LimbNames& names) {
  std::vector<std::int32_t> drawn, open;
  for (std::int32_t i = 0; i < plan.count(); ++i) {
    if (plan.piece(i).deals.front().kind == LimbDealKind::cast_on)
      (is_drawn_in(plan.piece(i).first_count()) ? drawn : open).push_back(i);
  }
  std::vector<std::string> lines;
  if (!drawn.empty() && open.empty()) {
    lines.emplace_back(
        "Of each piece that was cast on: thread the tail through the sts of the cast-on edge, pull the hole "
        "shut and "
        "fasten off.");
  } else if (!drawn.empty()) {
    lines.push_back(
        names.listed(drawn) +
        ": thread the cast-on tail through the sts of the cast-on edge, pull the hole shut and fasten off.");
  }
  if (!open.empty())
    lines.push_back(names.listed(open) + (open.size() > 1 ? ", each" : "") +
                    ": the cast-on edge stays open.");
  lines.emplace_back("Weave in all ends; close small holes beside the gaps with them.");
  return lines;
}

}  // namespace

WrittenPattern write_pattern(const LimbPlan& plan, const Gauge& gauge, const PatternOptions& options,
                             const std::string& mesh_name) {
  const PatternSizes sizes = sizes_of(plan, gauge);
  Writer writer(plan, gauge, options);
  Used used;
  for (std::int32_t i = 0; i < plan.count(); ++i) add_used(rounds_of(plan.piece(i)), writer.lines(i), used);
  const bool binds_off = std::any_of(plan.pieces.begin(), plan.pieces.end(), [](const LimbPiece& piece) {
    return piece.end.kind == LimbEndKind::closed && !is_drawn_in(piece.last_count());
  });
  WrittenPattern pattern;
  pattern.title = title_of(options, mesh_name);
  pattern.level = level_of(used);
  pattern.size = {"About " + length_text(sizes.around_cm) +
                  " around at the widest rnd; the sizes of the pieces stand before "
                  "them."};
  pattern.materials = material_words(plan, sizes, options, used, writer.is_stuffed());
  pattern.gauge = gauge_line(gauge, options);
  pattern.abbreviations = abbreviations_of(used, binds_off);
  pattern.notes = note_words(plan, writer.names(), used);
  pattern.start = "(Worked in " + worked_in(plan) + ".)";
  pattern.instructions = writer.instructions();
  pattern.finishing = finishing_words(plan, writer.names());
  pattern.in_pieces = true;
  return pattern;
}

PatternSizes sizes_of(const LimbPlan& plan, const Gauge& gauge) {
  PatternSizes sizes;
  sizes.gauge = gauge;
  std::int64_t stitches = 0;
  std::int32_t most = 0;
  for (const LimbPiece& piece : plan.pieces) {
    if (piece.is_cast_on()) stitches += piece.first_count();
    most = std::max(most, piece.first_count());
    for (const LimbRound& round : piece.rounds) {
      stitches += round.after;
      most = std::max(most, round.after);
    }
  }
  for (const std::int32_t gap : plan.gaps) stitches += gap;
  sizes.around_cm = most / (gauge.stitches / 10.0);
  add_yarn(stitches, sizes);
  return sizes;
}

}  // namespace knit
