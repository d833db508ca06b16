// What is right about short rows: how many pairs there are, and how many rows they add where they go.
#include <algorithm>

#include "app/lessons/lesson_truths.h"
#include "app/session/document.h"
#include "knit/fabric/row.h"
#include "knit/model/words.h"

namespace app::truths {

Truth short_rows(const Session& session, const JudgeCall& call) {
  const knit::Timeline& timeline = session.document->timeline;
  if (!timeline.complete()) return not_yet();
  const auto& all = timeline.furthest().fabric.rows();
  const auto rows = std::count_if(all.begin(), all.end(), [](const auto& row) { return is_short(*row); });
  const std::string pairs = knit::plural(rows / 2, "pair of short rows is", "pairs of short rows are");
  return {{str(call.word == "pairs" ? rows / 2 : rows)},
          pairs + " worked, each of two rows: out on the right side and back on the wrong side.",
          0.0};
}

}  // namespace app::truths
