// The charts and the written rounds of the run, made again only when its joins have changed, or what a person says.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "app/explain/rhythm_figures.h"
#include "app/session/planned_pieces.h"
#include "app/session/session.h"
#include "knit/pattern/chart.h"
#include "knit/pattern/limb_chart.h"
#include "knit/pattern/written_pattern.h"
#include "knit/pattern/written_rows.h"

namespace app {

class ChartCache {
 public:
  // Of the whole run as far as it is known. Requires something open.
  void refresh(const Session& session);

  // Without rows where the pattern is in pieces.
  [[nodiscard]] const knit::Chart& chart() const { return chart_; }
  [[nodiscard]] const knit::WrittenPattern& pattern() const { return pattern_; }
  // There are words.
  [[nodiscard]] bool has_pattern() const { return !pattern_.instructions.empty(); }
  [[nodiscard]] bool in_pieces() const { return in_pieces_; }
  // Of a pattern in pieces that has words: the plan that it is written from, and a chart of each.
  [[nodiscard]] const PlannedPieces& pieces() const { return pieces_; }
  [[nodiscard]] const std::vector<knit::PieceChart>& piece_charts() const { return piece_charts_; }
  // Another whenever the chart or the pattern is.
  [[nodiscard]] std::uint64_t key() const { return key_; }
  // Of a row of the fabric: "Rnds 8-12: Knit. (30 sts)", or the start for row 1; of a short row its own line, with the way home
  // behind it; empty where there is no such row. Written out, where the pattern is told in its short form.
  [[nodiscard]] std::string line_of(std::int32_t row) const;
  // "Rnds 2-13: [Knit 1 rnd, inc rnd] 6 times. (16, 24 sts)" of a pattern in its short form; empty: it says the same as line_of.
  [[nodiscard]] std::string short_line_of(std::int32_t row) const;
  // Where the round stands in its rhythm; empty: there is none.
  [[nodiscard]] std::string rhythm_of(std::int32_t row) const {
    const knit::WrittenRow at = written(row);
    return at.short_row > 0 ? "" : rhythm_place_words(rhythms_, at.round);
  }
  // The last row of the fabric that the chart has; the cast on is the first, the bind off none.
  [[nodiscard]] std::int32_t last_row() const {
    return chart_.rows.size() < 2 ? 0 : stitches_.row(chart_.rows.size() - 2);
  }
  // Which rows and stitches the chart's are; of a pattern that is not in pieces.
  [[nodiscard]] const knit::ChartStitches& stitches() const { return stitches_; }
  // What the pattern calls a row.
  [[nodiscard]] knit::WrittenRow written(std::int32_t row) const {
    constexpr std::int32_t first = 1;
    const bool known = row >= first && row <= std::ssize(written_);
    return known ? written_[static_cast<std::size_t>(row - first)] : knit::WrittenRow{row, 0};
  }

 private:
  void add_notes(const Session& session);  // what is not as asked
  void number_rows(const knit::Fabric& fabric);
  [[nodiscard]] std::string line_in_pattern(const knit::WrittenRow& row) const;
  void make_pieces(const Session& session, std::uint64_t planned);

  std::uint64_t key_ = 0;
  std::uint64_t planned_ = 0;  // the run and the order that `pieces_` is of: other words need no other plan
  bool in_pieces_ = false;
  knit::Chart chart_;
  knit::ChartStitches stitches_;
  std::vector<knit::WrittenRow> written_;
  knit::WrittenPattern pattern_;
  std::vector<knit::RoundLine> written_out_;  // of a pattern in its short form
  std::vector<RhythmFigures> rhythms_;
  PlannedPieces pieces_;
  std::vector<knit::PieceChart> piece_charts_;
  std::map<std::string, std::string> names_charted_;  // pieces that are called alike may be charted once
};

}  // namespace app
