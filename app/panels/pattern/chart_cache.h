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
  // "Rnds 8-12: Knit. (30 sts)", or the start for round 1; empty where there is no such round. Written out, where the pattern
  // is told in its short form.
  [[nodiscard]] std::string line_of(std::int32_t round) const;
  // "Rnds 2-13: [Knit 1 rnd, inc rnd] 6 times. (16, 24 sts)" of a pattern in its short form; empty: it says the same as line_of.
  [[nodiscard]] std::string short_line_of(std::int32_t round) const;
  // Where the round stands in its rhythm; empty: there is none.
  [[nodiscard]] std::string rhythm_of(std::int32_t round) const {
    return rhythm_place_words(rhythms_, round);
  }
  // The cast on is the first; the chart's last row, the bind off, is none.
  [[nodiscard]] std::int32_t rounds() const {
    const auto short_rows = std::count_if(chart_.rows.begin(), chart_.rows.end(),
                                          [](const knit::ChartRow& row) { return row.short_row > 0; });
    return std::max(0, static_cast<std::int32_t>(std::ssize(chart_.rows) - short_rows) - 1);
  }

 private:
  void add_notes(const Session& session);  // what is not as asked
  [[nodiscard]] std::string line_in_pattern(std::int32_t round) const;
  void make_pieces(const Session& session, std::uint64_t planned);

  std::uint64_t key_ = 0;
  std::uint64_t planned_ = 0;  // the run and the order that `pieces_` is of: other words need no other plan
  bool in_pieces_ = false;
  knit::Chart chart_;
  knit::WrittenPattern pattern_;
  std::vector<knit::RoundLine> written_out_;  // of a pattern in its short form
  std::vector<RhythmFigures> rhythms_;
  PlannedPieces pieces_;
  std::vector<knit::PieceChart> piece_charts_;
  std::map<std::string, std::string> names_charted_;  // pieces that are called alike may be charted once
};

}  // namespace app
