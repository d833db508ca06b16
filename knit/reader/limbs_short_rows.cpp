// Short rows in pieces.
#include <utility>

#include "knit/reader/limbs_work.h"

namespace knit {

bool LimbWorker::short_row(const ShortRowLine& row) {
  const auto next = static_cast<std::int32_t>(read_.limbs.back().rows.size()) + 1;
  const bool is_round = row.kind == ShortRowLine::Kind::round;
  if (is_round && row.number != next)
    return fail("Rnd " + std::to_string(next) + " is next, the line says " + std::to_string(row.number) +
                ".");
  if (next > heading_->rounds)
    return fail("short rows are told after Rnd " + std::to_string(next - 1) +
                ", the last one of the heading.");
  if (!row.mistake.empty()) return fail(row.mistake);
  if (!begin_round(next)) return false;
  if (!needles_) needles_.emplace(on_needle());
  if (const std::string mistake = needles_->work(row); !mistake.empty()) return fail(mistake);
  return !is_round || end_short_rows(row);
}

bool LimbWorker::end_short_rows(const ShortRowLine& row) {
  ShortNeedles::Worked worked = needles_->worked();
  needles_.reset();
  if (!worked.told) return fail("a short row is shaped, which this checker cannot hold.");
  Worked round;
  round.operations = std::move(worked.operations);
  round.after = static_cast<std::int32_t>(worked.made);
  round.short_rows = std::move(worked.short_rows);
  return work(static_cast<std::int32_t>(row.number), round);
}

bool LimbWorker::take_short_rows(std::int32_t number, Worked& round) {
  round.short_rows.clear();
  if (!needles_) return true;
  if (const std::string why = needles_->keeps_from_round(); !why.empty())
    return fail("Rnd " + std::to_string(number) + " " + why);
  if (round.slips) return fail("the last st is not slipped back after short rows: they begin at the marker.");
  round.short_rows = needles_->worked().short_rows;
  needles_.reset();
  return true;
}

}  // namespace knit
