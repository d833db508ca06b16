#include "knit/pattern/written_rows.h"

#include <algorithm>

#include "knit/stitches/short_join.h"

namespace knit {

std::vector<WrittenRow> written_rows(const Fabric& fabric) {
  std::vector<WrittenRow> written;
  std::int32_t round = 0, short_row = 0;
  for (const auto& row : fabric.rows()) {
    if (is_short(*row)) {
      written.push_back({round + 1, ++short_row});
    } else {
      written.push_back({++round, 0});
      short_row = 0;
    }
  }
  return written;
}

std::optional<WrittenRow> written_row(const Fabric& fabric, RowId row) {
  const std::vector<WrittenRow> written = written_rows(fabric);
  auto at = written.begin();
  for (const auto& one : fabric.rows()) {
    if (one->id == row) return *at;
    ++at;
  }
  return std::nullopt;
}

RowId row_called(const Fabric& fabric, const WrittenRow& called) {
  const std::vector<WrittenRow> written = written_rows(fabric);
  const auto found = std::find(written.begin(), written.end(), called);
  return found == written.end() ? 0 : static_cast<RowId>(found - written.begin()) + 1;
}

RowId row_of_round(const Fabric& fabric, std::int32_t round) {
  for (const auto& row : fabric.rows()) {
    if (!is_short(*row) && --round == 0) return row->id;
  }
  return 0;
}

ChartStitches::ChartStitches(const Fabric& fabric, const Chart& chart) {
  std::vector<RowId> rounds;
  std::vector<std::vector<RowId>> shorts;  // on each round
  for (const auto& row : fabric.rows()) {
    if (!is_short(*row)) {
      rounds.push_back(row->id);
      shorts.emplace_back();
      over_.emplace_back(row->stitches.size());
      continue;
    }
    shorts.back().push_back(row->id);
    const LiveStitches under = fabric.under_short_rows(row->on);
    for (std::int32_t i = 0; i < size_of(*row); ++i)
      over_.back()[static_cast<std::size_t>(under.at(i).stitch)].push_back({row->id, i});
  }
  for (const ChartRow& row : chart.rows) {
    const std::int32_t below = row.number - 2;
    if (row.short_row == 0) {
      const bool known = row.number >= 1 && row.number <= static_cast<std::int32_t>(rounds.size());
      rows_.push_back(known ? rounds[static_cast<std::size_t>(row.number - 1)] : 0);
      round_below_.push_back(-1);
      continue;
    }
    const auto gap = static_cast<std::size_t>(below);
    round_below_.push_back(below);
    const auto last = static_cast<std::int32_t>(shorts[gap].size());
    rows_.push_back(last == 0 ? 0 : shorts[gap][static_cast<std::size_t>(std::min(row.short_row, last) - 1)]);
  }
}

std::size_t ChartStitches::chart_row_of(RowId row) const {
  return static_cast<std::size_t>(std::find(rows_.begin(), rows_.end(), row) - rows_.begin());
}

std::optional<StitchRef> ChartStitches::stitch(std::size_t chart_row, const ChartSquare& square) const {
  if (chart_row >= rows_.size() || rows_[chart_row] == 0 || square.stitch < 0) return std::nullopt;
  const std::int32_t below = round_below_[chart_row];
  if (below < 0) return StitchRef{rows_[chart_row], square.stitch};
  const Stacks& stacks = over_[static_cast<std::size_t>(below)];
  const auto column = static_cast<std::size_t>(square.stitch),
             height = static_cast<std::size_t>(square.height);
  if (column >= stacks.size() || height >= stacks[column].size()) return std::nullopt;
  return stacks[column][height];
}

}  // namespace knit
