// Labels as Appendix A of the thesis prints them: a list a row.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "knit/fabric/fabric.h"

namespace knit {

// A row that is both grown into and shrunk out of needs two lists, and so does a cast on that shrinks at once; `into`
// names the row that a second list leads to.
struct LabelRow {
  std::int32_t row = 1;  // 0: no row, but the live stitches that a tube begins on
  std::optional<std::int32_t> into;
  std::vector<Label> labels;
  // A short row after it: its number there, from 1, and on which stitch of the row its first cell stands, before the beginning
  // of the round negative. Its labels are in working order. 0: the row itself.
  std::int32_t short_row = 0, at = 0;
};
// `first`: the row that the first join hangs on, as in LabelRow; of 0 there is no list but that of a join.
// `complete`: the last join leads to the last row, which is cast off; else more rows are to come.
std::vector<LabelRow> appendix_view(std::int32_t cast_on, std::span<const Join* const> joins,
                                    bool complete = true, std::int32_t first = 1);

// Adds the short rows of a tube, each behind the lists of the row that it stands on; then rows are numbered as the pattern
// numbers rounds, without short rows. O(rows of the fabric).
void add_short_rows(const Fabric& fabric, TubeId tube, std::vector<LabelRow>& view);

// "3: [6, 1, 0, 0, 2]", "3 > 4: [...]", "> 4: [...]", "12.1 @-5: [0, 0, ...]"
std::string text_of(const LabelRow& row);

}  // namespace knit
