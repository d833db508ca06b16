#include "app/lessons/lesson_judge.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>

#include "app/base/text.h"
#include "app/lessons/lesson_truths.h"
#include "app/session/document.h"

namespace app {

namespace {

const std::array judges{
    JudgeInfo{"next-vertex",
              "the vertex that the row in progress takes next",
              {AnswerKind::vertex},
              JudgeNeeds::nothing,
              {},
              truths::next_vertex,
              truths::why_not_next},
    JudgeInfo{"verdict",
              "the verdict on the vertex that is measured next",
              {AnswerKind::choice},
              JudgeNeeds::nothing,
              {"too-near", "accepted", "too-far"},
              truths::next_verdict,
              nullptr},
    JudgeInfo{"band-edge",
              "where the band begins (low) or ends (high)",
              {AnswerKind::number},
              JudgeNeeds::word,
              {"low", "high"},
              truths::band_edge,
              nullptr},
    JudgeInfo{"row-size",
              "how many stitches a row has",
              {AnswerKind::number},
              JudgeNeeds::row,
              {},
              truths::row_size,
              nullptr},
    JudgeInfo{"increases-in-row",
              "how many increases make a row",
              {AnswerKind::number},
              JudgeNeeds::row,
              {},
              truths::increases,
              nullptr},
    JudgeInfo{"decreases-in-row",
              "how many decreases make a row",
              {AnswerKind::number},
              JudgeNeeds::row,
              {},
              truths::decreases,
              nullptr},
    JudgeInfo{"mains-in-row",
              "around how many main stitches a row is shaped",
              {AnswerKind::number},
              JudgeNeeds::row,
              {},
              truths::mains,
              nullptr},
    JudgeInfo{"shaping",
              "whether a row grows, shrinks or neither",
              {AnswerKind::choice},
              JudgeNeeds::row,
              {"increases", "decreases", "plain"},
              truths::shaping,
              nullptr},
    JudgeInfo{"stitch-with-label",
              "any stitch with a label in the change that makes a row",
              {AnswerKind::stitch},
              JudgeNeeds::row_and_word,
              {"m1r", "m1l", "k2tog", "ssk", "main", "increase", "decrease", "turn", "marked"},
              truths::stitch_with_label,
              truths::why_not_label},
    JudgeInfo{"closing-gap",
              "where a row's closing gap lies beside the band",
              {AnswerKind::choice},
              JudgeNeeds::row,
              {"shorter", "inside", "longer"},
              truths::closing_gap,
              nullptr},
    JudgeInfo{"odd-row",
              "a row that missed the band (stall), was distributed again (resampled), or is left with "
              "the oddest gap (gap)",
              {AnswerKind::row},
              JudgeNeeds::word,
              {"stall", "resampled", "gap"},
              truths::odd_row,
              truths::why_not_odd},
    JudgeInfo{"end-vertex",
              "where the time starts or ends, nearly",
              {AnswerKind::vertex},
              JudgeNeeds::word,
              {"start", "end"},
              truths::end_vertex,
              truths::why_not_end},
    JudgeInfo{"ending",
              "how the run ends",
              {AnswerKind::choice},
              JudgeNeeds::nothing,
              {"finishes", "splits", "stall", "not-a-ring", "changes-too-much", "no-row-levels", "no-extent",
               "too-fine"},
              truths::ending,
              nullptr},
    JudgeInfo{"split-vertex",
              "where the surface parts, nearly",
              {AnswerKind::vertex},
              JudgeNeeds::nothing,
              {},
              truths::split_vertex,
              truths::why_not_end},
    JudgeInfo{"join-vertex",
              "where two tubes meet, nearly",
              {AnswerKind::vertex},
              JudgeNeeds::nothing,
              {},
              truths::join_vertex,
              truths::why_not_end},
    JudgeInfo{"tubes",
              "how many tubes, yarns, holders, splits, joins, rings or handles the plan has",
              {AnswerKind::number},
              JudgeNeeds::word,
              {"tubes", "yarns", "holders", "splits", "joins", "rings", "handles"},
              truths::tube_count,
              nullptr},
    JudgeInfo{"begins-on",
              "whether a tube begins on nothing (cast on), live stitches (loop) or another's cast on (edge)",
              {AnswerKind::choice},
              JudgeNeeds::tube,
              {"nothing", "loop", "edge"},
              truths::begins_on,
              nullptr},
    JudgeInfo{"worked-on",
              "how many live stitches a tube begins on",
              {AnswerKind::number},
              JudgeNeeds::tube,
              {},
              truths::worked_on,
              nullptr},
    JudgeInfo{"waits",
              "which tube's loop waits on a holder here",
              {AnswerKind::choice},
              JudgeNeeds::nothing,
              {"A", "B", "C", "D", "E", "F", "G", "H", "none"},
              truths::waiting_tube,
              nullptr},
    JudgeInfo{"yarn-broken",
              "a row after which the yarn is broken",
              {AnswerKind::row},
              JudgeNeeds::nothing,
              {},
              truths::yarn_broken,
              truths::why_not_broken},
    JudgeInfo{"stretched-row",
              "a row that wales lead to which are, as placed, the longest or nearly so",
              {AnswerKind::row},
              JudgeNeeds::nothing,
              {},
              truths::stretched_row,
              truths::why_not_stretched},
    JudgeInfo{"longest-wale",
              "how long the longest wale is, in h, where stitches were placed or have settled",
              {AnswerKind::number},
              JudgeNeeds::word,
              {"placed", "settled"},
              truths::longest_wale,
              nullptr},
    JudgeInfo{"pairs-of-short-rows",
              "how many pairs of short rows there are, or how many short rows",
              {AnswerKind::number},
              JudgeNeeds::word,
              {"pairs", "rows"},
              truths::short_rows,
              nullptr},
    JudgeInfo{"knitted-size",
              "how high or wide the piece comes off the needles, how high it was asked for (cm), and how far "
              "an end row sinks in (mm)",
              {AnswerKind::number},
              JudgeNeeds::word,
              {"height", "width", "asked-height", "first-sunk", "last-sunk"},
              truths::knitted_size,
              nullptr},
    JudgeInfo{"what-if",
              "what other settings make of a number",
              {AnswerKind::choice},
              JudgeNeeds::change,
              {"more", "fewer", "same"},
              truths::what_if,
              nullptr},
    JudgeInfo{"what-if-stops",
              "whether the run stops with other settings",
              {AnswerKind::choice},
              JudgeNeeds::change,
              {"stops", "finishes"},
              truths::what_if_stops,
              nullptr},
};

// --- comparing ---------------------------------------------------------------------------------------------

// A decimal comma is as good as a point.
std::optional<double> number_of(std::string text) {
  std::replace(text.begin(), text.end(), ',', '.');
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  const bool whole = end != text.c_str() && *end == '\0' && std::isfinite(value);
  return whole ? std::optional(value) : std::nullopt;
}

std::optional<glm::dvec3> place_of(const Session& session, const std::string& answer) {
  const auto thing = thing_named(answer);
  const auto* vertex = thing ? std::get_if<knit::VertexElement>(&*thing) : nullptr;
  const auto& positions = session.document->timeline.input().mesh.positions;
  if (vertex == nullptr || vertex->vertex >= positions.size()) return std::nullopt;
  return positions[vertex->vertex];
}

// Why it is no answer to such a question; empty: it is one.
std::string unclear_words(const Session& session, const Question& question, const std::string& answer) {
  switch (question.kind) {
    case AnswerKind::choice: {
      const bool known = std::any_of(question.choices.begin(), question.choices.end(),
                                     [&](const AnswerChoice& choice) { return choice.key == answer; });
      return known ? "" : "Choose one of the answers.";
    }
    case AnswerKind::number:
      return number_of(answer) ? "" : "Give a number, such as 12 or 0.05.";
    case AnswerKind::vertex:
      return place_of(session, answer) ? "" : "Click a vertex of the mesh.";
    case AnswerKind::row:
      return row_of_answer(answer) > 0
                 ? ""
                 : "Click a row: one of its stitches, edges or faces. Or type its number.";
    case AnswerKind::stitch: {
      const auto thing = thing_named(answer);
      return thing && std::holds_alternative<knit::StitchElement>(*thing) ? "" : "Click a stitch.";
    }
  }
  return "";
}

bool agrees(const Session& session, const Question& question, const Truth& truth, const std::string& right,
            const std::string& answer) {
  if (question.kind == AnswerKind::number)
    return std::abs(*number_of(right) - *number_of(answer)) <= truth.slack;
  if (question.kind == AnswerKind::row) return row_of_answer(right) == row_of_answer(answer);
  if (question.kind != AnswerKind::vertex) return right == answer;
  // A copy of a vertex at the same place is as good.
  return glm::distance(*place_of(session, right), *place_of(session, answer)) <= truth.slack;
}

std::string wrong_words(const Session& session, const Question& question, const Truth& truth,
                        const std::string& answer) {
  const JudgeInfo& info = judges.at(question.judge.judge);
  std::string words;
  if (question.kind == AnswerKind::number) {
    words = *number_of(answer) < *number_of(truth.answers.front()) ? "It is more than that."
                                                                   : "It is less than that.";
  } else if (info.why_not != nullptr) {
    words = info.why_not(session, question.judge, answer);
  }
  if (!question.hint.empty()) words += (words.empty() ? "" : " ") + question.hint;
  return words.empty() ? "Look again, or skip." : words;
}

}  // namespace

std::span<const JudgeInfo> judge_table() { return judges; }

bool Question::hides_candidates() const {
  const std::string_view name = judges.at(judge.judge).name;
  return name == "next-vertex" || name == "verdict";
}

Truth truth_of(const Session& session, const Question& question) {
  if (!session.document) return truths::untold("Nothing is open; set the page up again.");
  return judges.at(question.judge.judge).truth(session, question.judge);
}

std::int32_t row_of_answer(const std::string& answer) {
  const auto parts = split(answer, ':');
  const bool has_row =
      parts.size() > 1 && (parts[0] == "row" ? parts.size() == 2 : thing_named(answer).has_value());
  if (!has_row || parts[0] == "vertex") return 0;
  return std::max(0, whole_number<std::int32_t>(parts[1]).value_or(0));
}

Judgement judge(const Session& session, const Question& question, const std::string& answer) {
  Question asked = question;
  if (question.kind == AnswerKind::row) asked.judge.row = row_of_answer(answer);
  const Truth truth = truth_of(session, asked);
  if (truth.answers.empty()) return {Said::unclear, truth.reason};
  if (const std::string words = unclear_words(session, question, answer); !words.empty())
    return {Said::unclear, words};
  const bool right = std::any_of(truth.answers.begin(), truth.answers.end(), [&](const std::string& one) {
    return agrees(session, question, truth, one, answer);
  });
  if (right) return {Said::right, truth.reason};
  return {Said::wrong, wrong_words(session, question, truth, answer)};
}

}  // namespace app
