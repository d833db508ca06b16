// Stage 6, pattern: one written line a row, from the label joins. Thesis 3.2.5; words after the usual
// abbreviations.
//
// Each line counts for itself what it consumes and produces, word by word, so that a line that does not add
// up shows.
#pragma once

#include <optional>

#include "knit/fabric/join.h"
#include "knit/model/products.h"

namespace knit {

PatternLine cast_on_line(std::int32_t stitches);
PatternLine round_line(const Join& join);
PatternLine bind_off_line(std::int32_t row, std::int32_t stitches);

// The labels of all rows in Appendix A's form. A row that is both grown into and shrunk out of needs two
// lists, and so does a cast on that shrinks at once; `into` names the row that a second list leads to.
struct LabelRow {
  std::int32_t row = 1;
  std::optional<std::int32_t> into;
  std::vector<Label> labels;
};
// `complete`: the last join leads to the last row, which is cast off; else more rows are to come.
std::vector<LabelRow> appendix_view(std::int32_t cast_on, std::span<const Join* const> joins,
                                    bool complete = true);

// "3: [6, 1, 0, 0, 2]"
std::string text_of(const LabelRow& row);

}  // namespace knit
