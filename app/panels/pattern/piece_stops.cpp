#include "app/panels/pattern/piece_stops.h"

#include <algorithm>
#include <map>
#include <utility>

#include "knit/pattern/limb_chart.h"
#include "knit/pattern/limb_notes.h"
#include "knit/pattern/limb_words.h"
#include "knit/pattern/pattern_words.h"

namespace app {

namespace {

using knit::LimbDeal;
using knit::LimbDealKind;
using knit::LimbPiece;

bool casts_on(const LimbDeal& deal) {
  return deal.kind == LimbDealKind::cast_on || deal.kind == LimbDealKind::provisional;
}

std::string with_small_letter(std::string words) {
  if (!words.empty() && words.front() >= 'A' && words.front() <= 'Z')
    words.front() = static_cast<char>(words.front() - 'A' + 'a');
  return words;
}

// Of a cast on the first of its rows is no round that is worked.
// Of the lines of a round the one that turns so many times after its beginning, and what follows it to the next turn.
std::string short_row_words(const std::vector<knit::RoundLine>& lines, std::int32_t short_row) {
  std::string words;
  std::int32_t turns = 0;
  for (const knit::RoundLine& line : lines) {
    if (!line.short_row) break;
    if (line.label.starts_with("Short row ")) ++turns;
    if (turns == short_row) words += (words.empty() ? "" : "\n") + line.text();
  }
  return words;
}

// With short rows each has its own, with the way home behind it.
std::string round_words(const PlannedPieces& pieces, const LimbPiece& piece, std::int32_t number,
                        std::int32_t short_row) {
  const std::int32_t cast_on = piece.is_cast_on() ? 1 : 0;
  if (number == 1 && cast_on == 1)
    return knit::RoundLine{1, 1, knit::cast_on_words(piece.deals.back()), piece.first_count()}.text();
  const knit::LimbRound& round = piece.rounds[static_cast<std::size_t>(number - 1 - cast_on)];
  knit::Rounds one;
  one.cast_on = round.before;
  one.rounds = {{number, round.operations, round.before, round.after, round.pairs}};
  const std::vector<knit::RoundLine> lines = knit::round_lines(one, pieces.options);
  knit::RoundLine line = lines.back();
  if (short_row > 0) return short_row_words(lines, short_row);
  if (round.slips_back) line.words = "Slip last st back, " + with_small_letter(line.words);
  line.moves_marker = round.slips_back;
  return line.text();
}

// Holders by the piece that they go by and their number, and waste yarn by its piece.
class Holders {
 public:
  explicit Holders(const knit::LimbPlan& plan) : plan_(plan) {}

  void do_deals(std::int32_t piece, std::size_t count) {
    const auto& deals = plan_.piece(piece).deals;
    for (std::size_t i = 0; i < std::min(count, deals.size()); ++i) do_deal(piece, deals[i]);
  }
  void do_piece(std::int32_t piece) {
    do_deals(piece, plan_.piece(piece).deals.size());
    const LimbPiece& done = plan_.piece(piece);
    if (done.end.kind == knit::LimbEndKind::held) held_[{piece, 0}] = done.last_count();
    if (done.end.kind == knit::LimbEndKind::grafted) held_.erase({done.end.piece, 0});
  }
  [[nodiscard]] std::vector<HeldPiece> all(const knit::LimbNames& names) const {
    std::vector<HeldPiece> all;
    for (const auto& [holder, stitches] : held_)
      all.push_back({names.holder(holder.first, holder.second), stitches});
    for (const auto& [piece, stitches] : waste_) all.push_back({names(piece) + " (waste yarn)", stitches});
    return all;
  }

 private:
  void do_deal(std::int32_t piece, const LimbDeal& deal) {
    switch (deal.kind) {
      case LimbDealKind::provisional:
        waste_[piece] = deal.after;
        break;
      case LimbDealKind::loops:
        waste_.erase(deal.piece);
        break;
      case LimbDealKind::set_aside:
        held_[{deal.piece, deal.holder}] = deal.before;
        break;
      case LimbDealKind::divide:
        held_[{deal.piece, deal.holder}] = deal.held;
        break;
      case LimbDealKind::rejoin:
      case LimbDealKind::join:
        for (const knit::LimbItem& item : deal.items) {
          if (item.kind == knit::LimbItemKind::take) held_.erase({item.piece, item.holder});
        }
        break;
      case LimbDealKind::cast_on:
      case LimbDealKind::move:
        break;
    }
  }

  const knit::LimbPlan& plan_;
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> held_;
  std::map<std::int32_t, std::int32_t> waste_;
};

}  // namespace

std::vector<PieceStop> stops_of(const knit::LimbPlan& plan) {
  std::vector<PieceStop> stops;
  for (std::int32_t i = 0; i < plan.count(); ++i) {
    const LimbPiece& piece = plan.piece(i);
    for (std::size_t deal = 0; deal < piece.deals.size(); ++deal) {
      if (!casts_on(piece.deals[deal]))
        stops.push_back({i, piece.rows.front(), static_cast<std::int16_t>(deal + 1), 0});
    }
    for (std::size_t round = 0; round < piece.rows.size(); ++round) {
      const auto number = static_cast<std::int32_t>(round) + 1;
      for (std::int32_t turn = 1; turn <= knit::short_rows_before(piece, round); ++turn)
        stops.push_back({i, knit::row_of(piece, {round, turn}), 0, number, turn});
      stops.push_back({i, piece.rows[round], 0, number});
    }
  }
  return stops;
}

std::size_t stop_at(const std::vector<PieceStop>& stops, std::int32_t row, std::int16_t deal) {
  const bool beyond =
      std::all_of(stops.begin(), stops.end(), [&](const PieceStop& stop) { return stop.row < row; });
  std::size_t found = beyond ? stops.size() - 1 : 0;
  for (std::size_t i = 0; i < stops.size(); ++i) {
    if (stops[i].row != row) continue;
    if (stops[i].deal == deal) return i;
    if (stops[i].deal == 0) found = i;
  }
  return found;
}

std::size_t stop_a_piece_on(const std::vector<PieceStop>& stops, std::size_t from, int direction) {
  const std::int32_t here = stops[from].piece;
  const bool at_first = from == 0 || stops[from - 1].piece != here;
  const std::int32_t wanted = direction > 0 ? here + 1 : at_first ? here - 1 : here;
  const auto at =
      std::find_if(stops.begin(), stops.end(), [&](const PieceStop& stop) { return stop.piece == wanted; });
  if (at != stops.end()) return static_cast<std::size_t>(at - stops.begin());
  return direction > 0 ? stops.size() - 1 : 0;
}

std::string words_of(const PlannedPieces& pieces, const PieceStop& stop) {
  const LimbPiece& piece = pieces.plan.piece(stop.piece);
  if (stop.deal == 0) return round_words(pieces, piece, stop.number, stop.short_row);
  const knit::LimbNames names(pieces.plan, pieces.options);
  return knit::deal_sentence(pieces.plan, names, piece.deals[static_cast<std::size_t>(stop.deal - 1)]);
}

std::string end_words(const PlannedPieces& pieces, const PieceStop& stop) {
  const LimbPiece& piece = pieces.plan.piece(stop.piece);
  if (stop.deal != 0 || stop.short_row != 0 || stop.number != piece.round_count()) return "";
  return knit::end_sentence(pieces.plan, knit::LimbNames(pieces.plan, pieces.options), piece);
}

std::string seam_words(const PlannedPieces& pieces, const PieceStop& stop) {
  const std::int32_t last = pieces.plan.piece(stop.piece).round_count();
  if (stop.deal != 0 || stop.short_row != 0 || stop.number != last) return "";
  std::string words;
  for (const std::string& remark :
       knit::seam_remarks(pieces.plan, knit::LimbNames(pieces.plan, pieces.options), stop.piece))
    words += (words.empty() ? "" : " ") + remark;
  return words;
}

std::string place_words(const PlannedPieces& pieces, const PieceStop& stop) {
  const std::string name = pieces.name_of(stop.piece);
  if (stop.deal != 0) return name + ", before round 1";
  const std::string short_row =
      stop.short_row > 0 ? "short row " + std::to_string(stop.short_row) + " before " : "";
  return name + ", " + short_row + "round " + std::to_string(stop.number) + " of " +
         std::to_string(pieces.plan.piece(stop.piece).round_count());
}

Holding holding_after(const PlannedPieces& pieces, const PieceStop& stop) {
  const LimbPiece& piece = pieces.plan.piece(stop.piece);
  Holders holders(pieces.plan);
  for (std::int32_t before = 0; before < stop.piece; ++before) holders.do_piece(before);
  holders.do_deals(stop.piece, stop.deal != 0 ? static_cast<std::size_t>(stop.deal) : piece.deals.size());
  Holding holding;
  // A short row leaves as many stitches as there were.
  const std::int32_t worked = stop.number - (piece.is_cast_on() ? 1 : 0) - (stop.short_row > 0 ? 1 : 0);
  if (stop.deal != 0)
    holding.needle = piece.deals[static_cast<std::size_t>(stop.deal - 1)].after;
  else if (worked > 0)
    holding.needle = piece.rounds[static_cast<std::size_t>(worked - 1)].after;
  else
    holding.needle = piece.first_count();
  holding.holders = holders.all(knit::LimbNames(pieces.plan, pieces.options));
  return holding;
}

}  // namespace app
