#include "knit/pattern/limb_overview.h"

#include <algorithm>

#include "knit/pattern/limb_groups.h"
#include "knit/pattern/limb_needle.h"
#include "knit/pattern/pattern_words.h"
#include "knit/pattern/written_parts.h"

namespace knit {

namespace {

std::string words_of_begin(const LimbNames& names, const LimbPiece& piece) {
  std::string text;
  const auto add = [&](const std::string& words) { text += (text.empty() ? "" : ", ") + words; };
  for (const LimbDeal& deal : piece.deals) {
    switch (deal.kind) {
      case LimbDealKind::cast_on:
        add("cast on " + std::to_string(deal.after));
        break;
      case LimbDealKind::provisional:
        add("provisional cast on " + std::to_string(deal.after));
        break;
      case LimbDealKind::loops:
        add("from the cast-on loops of " + names(deal.piece));
        break;
      case LimbDealKind::rejoin:
        add("from its holder, new yarn");
        break;
      case LimbDealKind::divide:
        if (text.empty()) add("goes on");
        add(stitches_text(deal.held) + " held for " + names(deal.piece));
        break;
      case LimbDealKind::join:
        add("joins " + holders_joined(names, deal) + " to the needle");
        break;
      case LimbDealKind::set_aside:
      case LimbDealKind::move:
        break;
    }
  }
  return text;
}

// Of a piece that none goes on with: another is grafted to it.
std::string held_for_graft(const LimbPlan& plan, const LimbNames& names, std::int32_t number) {
  for (std::int32_t other = 0; other < plan.count(); ++other) {
    const LimbEnd& end = plan.piece(other).end;
    if (end.kind == LimbEndKind::grafted && end.piece == number)
      return "held for " + names(other) + (end.three_needle ? " (three-needle bind off)" : " (graft)");
  }
  return "held";
}

std::string words_of_end(const LimbPlan& plan, const LimbNames& names, std::int32_t number,
                         std::int32_t next) {
  const LimbPiece& piece = plan.piece(number);
  switch (piece.end.kind) {
    case LimbEndKind::held:
      return next < 0 ? held_for_graft(plan, names, number) : "held for " + names(next);
    case LimbEndKind::goes_on:
      return "goes on as " + names(piece.end.piece);
    case LimbEndKind::grafted:
      return (piece.end.three_needle ? "bound off with " : "grafted to ") + names(piece.end.piece);
    case LimbEndKind::closed:
      break;
  }
  return is_drawn_in(piece.last_count()) ? "drawn shut" : "bound off";
}

}  // namespace

std::vector<PieceFacts> piece_facts(const LimbPlan& plan, const LimbNames& names, const Gauge& gauge) {
  const std::vector<PieceNeedle> needles = needles_of(plan);
  std::vector<PieceFacts> all;
  for (std::vector<std::int32_t>& group : groups_of(plan, names)) {
    const LimbPiece& piece = plan.piece(group.front());
    PieceFacts facts;
    facts.name = names.together(group);
    facts.begins = words_of_begin(names, piece);
    facts.rounds = piece.round_count();
    facts.first = piece.first_count();
    facts.last = piece.last_count();
    facts.long_cm = piece.round_count() * 10.0 / gauge.rounds;
    facts.around_cm = widest_of(piece) * 10.0 / gauge.stitches;
    for (const std::int32_t one : group) {
      const std::string end = words_of_end(plan, names, one, needles[static_cast<std::size_t>(one)].next);
      if (facts.ends.empty())
        facts.ends = end;
      else if (!facts.ends.ends_with(end))
        facts.ends += ", " + names(one) + " " + end;
    }
    facts.pieces = std::move(group);
    all.push_back(std::move(facts));
  }
  return all;
}

std::string overview_line(const PieceFacts& facts) {
  const std::string rounds = std::to_string(facts.rounds) + (facts.rounds == 1 ? " rnd" : " rnds");
  return facts.name + (facts.pieces.size() > 1 ? ", each" : "") + ": " + facts.begins + "; " + rounds + ", " +
         stitches_text(facts.last) + " at the end, about " + length_text(facts.long_cm) + " long, " +
         length_text(facts.around_cm) + " around; " + facts.ends + ".";
}

SecondMarkers second_markers(const LimbPlan& plan) {
  SecondMarkers markers;
  std::map<std::pair<std::int32_t, std::int32_t>, bool> entered;
  for (std::int32_t number = 0; number < plan.count(); ++number) {
    for (const LimbDeal& deal : plan.piece(number).deals) {
      for (const LimbItem& item : deal.items) {
        if (item.kind != LimbItemKind::take ||
            !entered.emplace(std::pair(item.piece, item.holder), true).second)
          continue;
        if (item.first > 0) markers[{item.piece, item.holder}] = {item.first + 1, number};
      }
    }
  }
  return markers;
}

}  // namespace knit
