// The written pattern with limbs: an overview, then for each piece a heading, what lies on the needle, its rounds and its end.
// Twins whose words are the same are written once. What proves nothing stands in brackets.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "knit/model/words.h"
#include "knit/pattern/limb_groups.h"
#include "knit/pattern/limb_needle.h"
#include "knit/pattern/limb_notes.h"
#include "knit/pattern/limb_overview.h"
#include "knit/pattern/limb_words.h"
#include "knit/pattern/pattern_words.h"
#include "knit/pattern/written_parts.h"

namespace knit {

namespace {

using Instruction = WrittenPattern::Instruction;
using InstructionKind = WrittenPattern::Instruction::Kind;

constexpr std::int32_t wide_enough_to_stuff = 12;  // stitches

std::string lower_first(std::string text) {
  if (!text.empty() && text.front() >= 'A' && text.front() <= 'Z')
    text.front() = static_cast<char>(text.front() - 'A' + 'a');
  return text;
}

// A line a round, equal plain ones that follow each other on one; the cast on first.
std::vector<RoundLine> lines_of(const LimbPiece& piece, const PatternOptions& options) {
  std::vector<RoundLine> lines;
  // The fabric numbers short rows too.
  const auto before_round = [&](std::int32_t number) {
    return piece.rows[static_cast<std::size_t>(number - 1)] - number;
  };
  if (piece.is_cast_on())
    lines.push_back(
        {1, 1, cast_on_words(piece.deals.back()), piece.first_count(), before_round(1), {}, false});
  const Rounds rounds = rounds_of(piece);
  for (std::size_t i = 0; i < piece.rounds.size(); ++i) {
    const bool slips = piece.rounds[i].slips_back;
    const std::int32_t before = before_round(rounds.rounds[i].number);
    Rounds one;
    one.rounds = {rounds.rounds[i]};
    std::vector<RoundLine> told = round_lines(one, options);
    RoundLine line = std::move(told.back());
    told.pop_back();
    for (RoundLine& row : told) {
      row.rows_before = before;
      lines.push_back(std::move(row));
    }
    line.rows_before = before;
    line.moves_marker = slips;
    if (slips) line.words = "Slip last st back, " + lower_first(line.words);
    const bool joins = i > 0 && rounds.rounds[i].pairs.empty() && rounds.rounds[i - 1].pairs.empty();
    const bool same = joins && !slips && !lines.empty() && !lines.back().moves_marker &&
                      lines.back().words == line.words && lines.back().stitches == line.stitches;
    if (same)
      lines.back().last = line.last;
    else
      lines.push_back(std::move(line));
  }
  return lines;
}

class Writer {
 public:
  Writer(const LimbPlan& plan, const Gauge& gauge, const PatternOptions& options)
      : plan_(plan),
        names_(plan, options),
        facts_(piece_facts(plan, names_, gauge)),
        late_(second_markers(plan)),
        stuffed_(is_stuffed(plan)) {
    for (const LimbPiece& piece : plan.pieces) lines_.push_back(lines_of(piece, options));
  }

  [[nodiscard]] const LimbNames& names() const { return names_; }
  [[nodiscard]] const std::vector<PieceFacts>& facts() const { return facts_; }
  [[nodiscard]] const std::vector<RoundLine>& lines(std::int32_t piece) const {
    return lines_[static_cast<std::size_t>(piece)];
  }

  std::vector<Instruction> instructions() {
    overview();
    for (const PieceFacts& facts : facts_) write(facts.pieces.front(), facts.pieces.back() + 1);
    return std::move(all_);
  }

 private:
  void remark(const std::string& words) { all_.push_back({std::nullopt, "(" + words + ")"}); }
  void step(std::string words) { all_.push_back({std::nullopt, std::move(words), InstructionKind::step}); }

  void overview() {
    const std::int32_t needed = holders_needed(plan_);
    const std::string holders =
        needed == 0 ? "no holder" : plural(needed, "holder", "holders") + " at once at most";
    const std::string yarns = plan_.yarns == 1 ? "all with one yarn"
                              : plan_.yarns == 2
                                  ? "the yarn is begun twice"
                                  : "the yarn is begun " + std::to_string(plan_.yarns) + " times";
    remark("Order of work; " + holders + ", " + yarns + ":");
    for (const PieceFacts& facts : facts_) remark(overview_line(facts));
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
      remark("This tube is the inside of the work: knit it right side out like the others. " +
             std::string(is_put_inside(plan_, first) ? "It is turned inside out and put inside at the end."
                                                     : "It is pushed through at the end."));
    for (const LimbDeal& deal : piece.deals) begin_with(deal);
    rounds(first, end);
    ends(first, end);
  }

  void begin_with(const LimbDeal& deal) {
    if (deal.kind == LimbDealKind::provisional) remark("Its cast-on loops are worked later: see the notes.");
    if (deal.kind == LimbDealKind::cast_on || deal.kind == LimbDealKind::provisional) return;
    step(deal_sentence(plan_, names_, deal));
    if (deal.kind == LimbDealKind::divide || deal.kind == LimbDealKind::set_aside)
      second_marker(deal.piece, deal.holder,
                    " of those on the holder for " + names_.holder(deal.piece, deal.holder));
  }

  // Where a holder is entered elsewhere than at its first stitch.
  void second_marker(std::int32_t piece, std::int32_t holder, const std::string& of) {
    const auto late = late_.find({piece, holder});
    if (late == late_.end()) return;
    remark("Hang a second marker before st " + std::to_string(late->second.stitch) + of + ": " +
           names_(late->second.piece) + " takes them from there on.");
  }

  // Of held pieces; those that one piece takes are told in one remark.
  void second_markers_of(const std::vector<std::int32_t>& held, bool several) {
    for (std::size_t i = 0; i < held.size();) {
      const auto late = late_.find({held[i], 0});
      if (late == late_.end() || plan_.piece(held[i]).end.kind != LimbEndKind::held) {
        ++i;
        continue;
      }
      const std::int32_t taker = late->second.piece;
      std::string places;
      for (; i < held.size(); ++i) {
        const auto next = late_.find({held[i], 0});
        if (next == late_.end() || next->second.piece != taker) break;
        places += (places.empty() ? " before st " : "; before st ") + std::to_string(next->second.stitch) +
                  (several ? " of " + names_(held[i]) : "");
      }
      remark("Hang a second marker" + places + ": " + names_(taker) + " takes them from there on.");
    }
  }

  void rounds(std::int32_t first, std::int32_t end) {
    const auto [twin, from] = model_of(plan_, first);
    // Where the rounds of a twin say so, they say it.
    std::int32_t stuffed = stuffed_ ? stuffed_in(plan_.piece(first)) : 0;
    const bool as_twin = twin >= 0 && stuffed >= from;
    for (const RoundLine& line : lines(first)) {
      if (twin >= 0 && line.last >= from) break;
      add(line, first, end);
      if (stuffed > 0 && !as_twin && !line.short_row && line.last >= stuffed) {
        remark(stuff_and_close);
        stuffed = 0;
      }
    }
    if (twin < 0) return;
    add_as_twin(first, end, twin, from);
    if (as_twin) remark("Stuff it before it closes, like " + names_(twin) + ".");
  }

  void add_as_twin(std::int32_t first, std::int32_t end, std::int32_t twin, std::int32_t from) {
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
    constexpr double fewest = wide_enough_to_stuff;
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

  [[nodiscard]] bool is_divided_next(std::int32_t piece) const {
    if (plan_.piece(piece).end.kind != LimbEndKind::goes_on) return false;
    const LimbDealKind next = plan_.piece(plan_.piece(piece).end.piece).deals.front().kind;
    return next == LimbDealKind::divide;
  }

  // Of a piece that does not close itself.
  void stuff_before_end(std::int32_t first, std::int32_t end) {
    const LimbPiece& piece = plan_.piece(first);
    constexpr std::int32_t long_limb = 3;
    const bool joined = piece.end.kind == LimbEndKind::held || piece.end.kind == LimbEndKind::goes_on;
    if (!stuffed_ || !joined || piece.round_count() <= long_limb) return;
    const bool divided = is_divided_next(first), alone = begins_alone(piece);
    const bool narrow = widest_of(piece) < wide_enough_to_stuff;
    if (!alone && (!divided || narrow)) return;
    std::string words = alone ? "Pull the cast-on hole shut with its tail. " : "";
    if (narrow)
      words += std::string("Stuff ") + (end - first > 1 ? "each" : "it") +
               " lightly, or leave it empty: it is narrow.";
    else if (divided)
      words += "Stuff what is made so far, up to a finger below the needle, before it is divided.";
    else
      words += std::string("Stuff ") + (end - first > 1 ? "each" : "it") + " before it is joined.";
    remark(words);
  }

  void ends(std::int32_t first, std::int32_t end) {
    const LimbPiece& piece = plan_.piece(first);
    stuff_before_end(first, end);
    for (const std::string& words : seam_remarks(plan_, names_, first)) remark(words);
    for (std::int32_t i = first; i < end;) {
      const std::string words = end_sentence(plan_, names_, plan_.piece(i));
      std::vector<std::int32_t> same;
      while (i < end && end_sentence(plan_, names_, plan_.piece(i)) == words) same.push_back(i++);
      step(end - first > 1 ? names_.together(same) + ": " + words : words);
      second_markers_of(same, end - first > 1);
    }
    if (piece.end.kind == LimbEndKind::closed && piece.inner)
      remark("Push this tube through to the inside, wrong sides together.");
  }

  const LimbPlan& plan_;
  LimbNames names_;
  std::vector<PieceFacts> facts_;
  SecondMarkers late_;
  bool stuffed_ = false;
  std::vector<std::vector<RoundLine>> lines_;
  std::vector<Instruction> all_;
};

}  // namespace

WrittenPattern write_pattern(const LimbPlan& plan, const Gauge& gauge, const PatternOptions& options,
                             const std::string& mesh_name, std::optional<double> height_cm) {
  const PatternSizes sizes = sizes_of(plan, gauge);
  Writer writer(plan, gauge, options);
  Used used;
  used.turns = options.turns;
  for (std::int32_t i = 0; i < plan.count(); ++i) add_used(rounds_of(plan.piece(i)), writer.lines(i), used);
  const bool binds_off = std::any_of(plan.pieces.begin(), plan.pieces.end(), [](const LimbPiece& piece) {
    return piece.end.kind == LimbEndKind::closed && !is_drawn_in(piece.last_count());
  });
  WrittenPattern pattern;
  pattern.title = title_of(options, mesh_name);
  pattern.level = level_of(used);
  pattern.size = {size_of_limbs(sizes, height_cm)};
  pattern.materials = materials_of_limbs(plan, sizes, options, used);
  pattern.gauge = gauge_line(gauge, options);
  pattern.abbreviations = abbreviations_of(used, binds_off);
  pattern.notes = notes_of_limbs(plan, writer.names(), used);
  pattern.start = "(Worked in " + worked_in(plan) + ".)";
  pattern.instructions = writer.instructions();
  pattern.finishing = finishing_of_limbs(plan, writer.names());
  pattern.in_pieces = true;
  pattern.pieces = writer.facts();
  pattern.overview = pattern.pieces.size() + 1;
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
      for (const ShortRowPair& pair : round.pairs) stitches += 2 * (pair.last - pair.first + 1);
      most = std::max(most, round.after);
    }
  }
  for (const std::int32_t gap : plan.gaps) stitches += gap;
  sizes.around_cm = most / (gauge.stitches / 10.0);
  add_yarn(stitches, sizes);
  return sizes;
}

}  // namespace knit
