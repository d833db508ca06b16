// Labels as Appendix A of the thesis prints them: a list a row.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "knit/fabric/join.h"

namespace knit {

// A row that is both grown into and shrunk out of needs two lists, and so does a cast on that shrinks at once; `into`
// names the row that a second list leads to.
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
