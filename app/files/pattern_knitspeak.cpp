#include "app/files/pattern_knitspeak.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "knit/model/words.h"
#include "knit/pattern/fold.h"
#include "knit/pattern/limb_groups.h"
#include "knit/pattern/limb_words.h"
#include "knit/pattern/pattern_words.h"
#include "knit/pattern/short_row_words.h"

namespace app {

namespace {

using knit::Hand;

// Increases are capitals there.
std::string_view speak_word(Hand hand) {
  if (hand == Hand::m1r) return "M1R";
  return hand == Hand::m1l ? "M1L" : knit::word_of(hand);
}

std::string speak(const knit::Run& run) {
  const std::string word(speak_word(run.hand));
  if (run.hand == Hand::knit) return word + std::to_string(run.count);
  return run.count == 1 ? word : "[" + word + "] " + std::to_string(run.count) + " times";
}

std::string speak(const std::vector<knit::Run>& runs) {
  std::string out;
  for (const knit::Run& run : runs) out += (out.empty() ? "" : ", ") + speak(run);
  return out;
}

std::string speak(const knit::Phrase& phrase) {
  if (const auto* run = std::get_if<knit::Run>(&phrase)) return speak(*run);
  const auto& repeat = std::get<knit::Repeat>(phrase);
  return "[" + speak(repeat.runs) + "] " + std::to_string(repeat.times) + " times";
}

std::string speak(const std::vector<knit::Phrase>& phrases) {
  if (phrases.size() == 1) {
    if (const auto* repeat = std::get_if<knit::Repeat>(&phrases.front()))
      return "*" + speak(repeat->runs) + ", repeat from *";
    const auto& run = std::get<knit::Run>(phrases.front());
    if (run.hand == Hand::knit) return "knit";
    if (run.count > 1) return "*" + std::string(speak_word(run.hand)) + ", repeat from *";
  }
  std::string out;
  for (const knit::Phrase& phrase : phrases) out += (out.empty() ? "" : ", ") + speak(phrase);
  return out;
}

bool same_work(const knit::Round& a, const knit::Round& b) {
  return a.operations == b.operations && a.after == b.after && a.pairs.empty() && b.pairs.empty();
}

std::string numbers_of(std::int32_t first, std::int32_t last) {
  if (first == last) return "Round " + std::to_string(first);
  return "Rounds " + std::to_string(first) + "-" + std::to_string(last);
}

constexpr const char* where_it_turns =
    "(Knitspeak has no word for turns. Lines that begin with Short row or Next row, and (cont.), are\n"
    "this program's: other tools may not read them.)\n";

bool has_pairs(const knit::Round& round) { return !round.pairs.empty(); }

// Before the round, or in place of it: then nothing is left to tell.
struct SpokenShortRows {
  std::string lines;
  bool rest_is_told = false;
};
SpokenShortRows speak_short_rows(const knit::Round& round, knit::ShortRowTurns turns) {
  if (!has_pairs(round)) return {};
  const knit::ShortRowLines told = knit::short_row_lines(round, turns);
  SpokenShortRows spoken{"", told.rest_is_told};
  for (const knit::RoundLine& line : told.lines) spoken.lines += line.text() + "\n";
  return spoken;
}

}  // namespace

std::string pattern_knitspeak(const knit::Rounds& rounds, knit::ShortRowTurns turns) {
  const bool turned = std::any_of(rounds.rounds.begin(), rounds.rounds.end(), has_pairs);
  std::string out = turned ? where_it_turns : "";
  out += "CO " + std::to_string(rounds.cast_on) + " sts (Rnd 1).\n";
  for (std::size_t i = 0, end = 0; i < rounds.rounds.size(); i = end) {
    const knit::Round& round = rounds.rounds[i];
    for (end = i + 1; end < rounds.rounds.size() && same_work(round, rounds.rounds[end]);) ++end;
    const SpokenShortRows spoken = speak_short_rows(round, turns);
    out += spoken.lines;
    if (spoken.rest_is_told) continue;
    out += numbers_of(round.number, rounds.rounds[end - 1].number) + ": " +
           speak(knit::fold(round.operations)) + ". (" + std::to_string(round.after) + " sts)\n";
  }
  return out;
}

namespace {

std::string speak_rounds(const knit::LimbPiece& piece, knit::ShortRowTurns turns) {
  const std::vector<knit::Round> rounds = knit::rounds_of(piece).rounds;
  std::string out;
  for (std::size_t i = 0, end = 0; i < rounds.size(); i = end) {
    const bool slips = piece.rounds[i].slips_back;
    for (end = i + 1;
         !slips && end < rounds.size() && !piece.rounds[end].slips_back && same_work(rounds[i], rounds[end]);)
      ++end;
    const SpokenShortRows spoken = speak_short_rows(rounds[i], turns);
    out += spoken.lines;
    if (spoken.rest_is_told) continue;
    out += numbers_of(rounds[i].number, rounds[end - 1].number) + ": " +
           (slips ? "Slip last st back, " : "") + speak(knit::fold(rounds[i].operations)) + ". (" +
           knit::stitches_text(rounds[i].after) + (slips ? ", marker moved back 1 st" : "") + ")\n";
  }
  return out;
}

constexpr const char* where_it_ends =
    "(Knitspeak has words for rounds. Headings, and lines that begin with Rejoin, Remove, Divide,\n"
    "Join, Break, Do not break, Bind off, Graft and Three-needle, are this program's: other tools may not "
    "read them.)\n";

}  // namespace

std::string pattern_knitspeak(const knit::LimbPlan& plan, const knit::PatternOptions& options) {
  const knit::LimbNames names(plan, options);
  const bool turned = std::any_of(plan.pieces.begin(), plan.pieces.end(), [](const knit::LimbPiece& piece) {
    const std::vector<knit::Round> rounds = knit::rounds_of(piece).rounds;
    return std::any_of(rounds.begin(), rounds.end(), has_pairs);
  });
  std::string out = where_it_ends + std::string(turned ? where_it_turns : "");
  for (std::int32_t number = 0; number < plan.count(); ++number) {
    const knit::LimbPiece& piece = plan.piece(number);
    out += "\n" + names(number) + ": " + knit::plural(piece.round_count(), "rnd", "rnds") + ", " +
           knit::stitches_text(piece.last_count()) + " at the end\n";
    for (const knit::LimbDeal& deal : piece.deals) {
      const bool casts_on =
          deal.kind == knit::LimbDealKind::cast_on || deal.kind == knit::LimbDealKind::provisional;
      out += casts_on
                 ? "Round 1: " + knit::cast_on_words(deal) + ". (" + knit::stitches_text(deal.after) + ")\n"
                 : knit::deal_sentence(plan, names, deal) + "\n";
    }
    out += speak_rounds(piece, options.turns) + knit::end_sentence(plan, names, piece) + "\n";
  }
  return out;
}

}  // namespace app
