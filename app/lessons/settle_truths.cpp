// What is right about wales: how long they are where stitches were placed, and once these have settled.
#include <algorithm>
#include <glm/geometric.hpp>

#include "app/lessons/lesson_truths.h"
#include "app/session/document.h"
#include "knit/model/words.h"

namespace app::truths {

namespace {

constexpr double as_good_as_longest = 0.9;
constexpr double wale_slack = 0.06;  // in h: two digits are enough

// Of all wales that lead to a row; lengths in h.
struct LongestWale {
  std::int32_t row = 0;
  double length = 0.0;
};

std::vector<LongestWale> longest_wales(const knit::Fabric& fabric, double height) {
  std::vector<LongestWale> rows;
  const knit::KnittingPath path(fabric);
  for (const auto& strip : fabric.strips()) {
    double longest = 0.0;
    for (const auto& [lower, upper] : strip->column_edges)
      longest = std::max(longest, glm::distance(path.position(lower), path.position(upper)));
    rows.push_back({strip->to, longest / height});
  }
  return rows;
}

std::vector<LongestWale> placed_wales(const Session& session) {
  const knit::Timeline& timeline = session.document->timeline;
  return longest_wales(knit::placed_fabric(timeline.furthest()), timeline.parameters().stitch.height);
}

double longest_of(const std::vector<LongestWale>& rows) {
  double longest = 0.0;
  for (const LongestWale& row : rows) longest = std::max(longest, row.length);
  return longest;
}

std::string wale_words(const LongestWale& row) {
  return "The longest wale that leads to row " + str(row.row) + " is " + knit::short_number(row.length) +
         " h long";
}

}  // namespace

Truth stretched_row(const Session& session, const JudgeCall& call) {
  if (!session.document->timeline.complete()) return not_yet();
  const std::vector<LongestWale> rows = placed_wales(session);
  const double longest = longest_of(rows);
  Truth truth;
  for (const LongestWale& row : rows) {
    if (row.length < as_good_as_longest * longest) continue;
    if (truth.answers.empty() || row.row == call.row)
      truth.reason = wale_words(row) + "; on a level set it could be no shorter.";
    truth.answers.push_back("row:" + str(row.row));
  }
  return truth.answers.empty() ? untold("This run has no wales; set the page up again.") : truth;
}

std::string why_not_stretched(const Session& session, const JudgeCall& /*call*/, const std::string& answer) {
  const std::int32_t number = row_of_answer(answer);
  for (const LongestWale& row : placed_wales(session)) {
    if (row.row == number) return wale_words(row) + ", and others are longer.";
  }
  return "No wale leads to row " + str(number) + ".";
}

Truth longest_wale(const Session& session, const JudgeCall& call) {
  const knit::Timeline& timeline = session.document->timeline;
  if (!timeline.complete()) return not_yet();
  const knit::State& end = timeline.furthest();
  const bool settled = call.word == "settled";
  if (settled && !end.placed) return untold("Nothing settles in this run; set the page up again.");
  const double height = timeline.parameters().stitch.height;
  const double longest = longest_of(longest_wales(settled ? end.fabric : knit::placed_fabric(end), height));
  if (longest <= 0.0) return untold("This run has no wales; set the page up again.");
  const std::string number = knit::short_number(longest);
  return {{number},
          "The longest wale is " + number + " h long where its stitches " +
              (settled ? "settled." : "were placed."),
          wale_slack};
}

}  // namespace app::truths
