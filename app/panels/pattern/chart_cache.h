// The chart and the written rounds of the run, made again only when its joins have changed.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "knit/pattern/chart.h"
#include "knit/pattern/written_pattern.h"
#include "knit/run/timeline.h"

namespace app {

class ChartCache {
 public:
  // Of the whole run as far as it is known.
  void refresh(const knit::Timeline& timeline, const knit::PatternOptions& options);

  // Without rows where the pattern is in pieces.
  [[nodiscard]] const knit::Chart& chart() const { return chart_; }
  [[nodiscard]] const knit::WrittenPattern& pattern() const { return pattern_; }
  // There are words; for knitting along and a chart there is one piece.
  [[nodiscard]] bool has_pattern() const { return !pattern_.instructions.empty(); }
  [[nodiscard]] bool in_pieces() const { return in_pieces_; }
  // Another whenever the chart or the pattern is.
  [[nodiscard]] std::uint64_t key() const { return key_; }
  // "Rnds 8-12: Knit. (30 sts)", or the start for round 1; empty where there is no such round.
  [[nodiscard]] std::string line_of(std::int32_t round) const;
  // The cast on is the first; the chart's last row, the bind off, is none.
  [[nodiscard]] std::int32_t rounds() const {
    return std::max(0, static_cast<std::int32_t>(chart_.rows.size()) - 1);
  }

 private:
  std::uint64_t key_ = 0;
  bool in_pieces_ = false;
  knit::Chart chart_;
  knit::WrittenPattern pattern_;
};

}  // namespace app
