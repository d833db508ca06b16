#include "knit/pattern/limb_groups.h"

#include <algorithm>

namespace knit {

Rounds rounds_of(const LimbPiece& piece) {
  Rounds rounds;
  rounds.cast_on = piece.first_count();
  std::int32_t number = first_round_of(piece);
  for (const LimbRound& round : piece.rounds)
    rounds.rounds.push_back({number++, round.operations, round.before, round.after, round.pairs});
  return rounds;
}

std::vector<std::uint8_t> slips_of(const LimbPiece& piece) {
  std::vector<std::uint8_t> slips;
  for (const LimbRound& round : piece.rounds) slips.push_back(round.slips_back ? 1 : 0);
  return slips;
}

bool begins_alone(const LimbPiece& piece) {
  return piece.deals.size() == 1 && piece.deals.front().kind == LimbDealKind::cast_on;
}

bool are_twins(const LimbPlan& plan, std::int32_t a, std::int32_t b) {
  const std::vector<std::int32_t>& twins = plan.piece(a).twins;
  return std::find(twins.begin(), twins.end(), b) != twins.end();
}

bool same_operations(const LimbRound& a, const LimbRound& b) {
  const auto same_hand = [](const Operation& x, const Operation& y) { return x.hand == y.hand; };
  return a.before == b.before && a.after == b.after && a.slips_back == b.slips_back && a.pairs == b.pairs &&
         std::equal(a.operations.begin(), a.operations.end(), b.operations.begin(), b.operations.end(),
                    same_hand);
}

namespace {

bool is_made_with(const LimbPlan& plan, const LimbNames& names, std::int32_t first, std::int32_t other) {
  const LimbPiece &a = plan.piece(first), &b = plan.piece(other);
  return are_twins(plan, first, other) && begins_alone(a) && begins_alone(b) &&
         names.word(first) == names.word(other) && a.first_count() == b.first_count() &&
         a.rounds.size() == b.rounds.size() &&
         std::equal(a.rounds.begin(), a.rounds.end(), b.rounds.begin(), same_operations);
}

}  // namespace

std::vector<std::vector<std::int32_t>> groups_of(const LimbPlan& plan, const LimbNames& names) {
  std::vector<std::vector<std::int32_t>> groups;
  for (std::int32_t piece = 0; piece < plan.count(); ++piece) {
    if (groups.empty() || !is_made_with(plan, names, groups.back().front(), piece)) groups.emplace_back();
    groups.back().push_back(piece);
  }
  return groups;
}

std::int32_t alike_from(const LimbPiece& twin, const LimbPiece& piece) {
  if (twin.rounds.size() != piece.rounds.size() || twin.is_cast_on() != piece.is_cast_on()) return 0;
  std::size_t same = piece.rounds.size();
  while (same > 0 && same_operations(twin.rounds[same - 1], piece.rounds[same - 1])) --same;
  const bool all = same == 0 && piece.is_cast_on() && twin.deals.back().kind == piece.deals.back().kind;
  const std::int32_t from = all ? 1 : first_round_of(piece) + static_cast<std::int32_t>(same);
  return piece.round_count() - from + 1 >= 2 ? from : 0;
}

LimbModel model_of(const LimbPlan& plan, std::int32_t piece) {
  for (const std::int32_t other : plan.piece(piece).twins) {
    if (other >= piece) continue;
    const std::int32_t from = alike_from(plan.piece(other), plan.piece(piece));
    if (from > 0) return {other, from};
  }
  return {};
}

std::int32_t widest_of(const LimbPiece& piece) {
  std::int32_t widest = piece.first_count();
  for (const LimbRound& round : piece.rounds) widest = std::max(widest, round.after);
  return widest;
}

}  // namespace knit
