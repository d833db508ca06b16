// The judges' own parts: what each holds to be right. lesson_judge.cpp has the table of them.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "app/explain/why_words.h"
#include "app/lessons/lesson_judge.h"
#include "knit/insight/narrate.h"

namespace app::truths {

inline std::string str(std::int64_t number) { return std::to_string(number); }
inline std::string vertex_name(knit::VertexId vertex) { return "vertex:" + std::to_string(vertex); }

inline std::string capital(std::string words) {
  if (!words.empty() && words[0] >= 'a' && words[0] <= 'z')
    words[0] = static_cast<char>(words[0] - 'a' + 'A');
  return words;
}

inline Truth untold(std::string why) { return {{}, std::move(why), 0.0}; }
inline Truth not_yet() {
  return untold("The run has not come that far yet; wait a moment, then answer again.");
}

inline std::string said_by(const knit::Timeline& timeline, std::size_t step) {
  return knit::narrate(timeline.step(step), timeline.parameters_of_step(step));
}

// The first step from `from` on of a row and a stage for which `is` holds.
template <class Is>
std::optional<std::size_t> first_step(const knit::Timeline& timeline, knit::Stage stage, std::int32_t row,
                                      Is is) {
  const knit::StepRange steps = knit::steps_of_row(timeline, stage, row);
  for (std::size_t i = steps.begin; i < steps.end; ++i) {
    if (is(timeline.step(i).what)) return i;
  }
  return std::nullopt;
}

template <class What>
std::optional<std::size_t> first_of_kind(const knit::Timeline& timeline, knit::Stage stage,
                                         std::int32_t row) {
  return first_step(timeline, stage, row, [](const knit::Event& what) { return knit::is<What>(what); });
}

// How near a click must come to a place that is asked for, in mesh units.
double near_enough(const Session& session);

// What is right.
Truth next_vertex(const Session& session, const JudgeCall& call);
Truth next_verdict(const Session& session, const JudgeCall& call);
Truth band_edge(const Session& session, const JudgeCall& call);
Truth row_size(const Session& session, const JudgeCall& call);
Truth increases(const Session& session, const JudgeCall& call);
Truth decreases(const Session& session, const JudgeCall& call);
Truth mains(const Session& session, const JudgeCall& call);
Truth shaping(const Session& session, const JudgeCall& call);
Truth stitch_with_label(const Session& session, const JudgeCall& call);
Truth closing_gap(const Session& session, const JudgeCall& call);
Truth odd_row(const Session& session, const JudgeCall& call);
Truth end_vertex(const Session& session, const JudgeCall& call);
Truth ending(const Session& session, const JudgeCall& call);
Truth split_vertex(const Session& session, const JudgeCall& call);
Truth tube_count(const Session& session, const JudgeCall& call);
Truth begins_on(const Session& session, const JudgeCall& call);
Truth worked_on(const Session& session, const JudgeCall& call);
Truth waiting_tube(const Session& session, const JudgeCall& call);
Truth yarn_broken(const Session& session, const JudgeCall& call);
Truth join_vertex(const Session& session, const JudgeCall& call);
Truth stretched_row(const Session& session, const JudgeCall& call);
Truth longest_wale(const Session& session, const JudgeCall& call);
Truth knitted_size(const Session& session, const JudgeCall& call);
Truth short_rows(const Session& session, const JudgeCall& call);
Truth what_if(const Session& session, const JudgeCall& call);
Truth what_if_stops(const Session& session, const JudgeCall& call);
// Why an answer is not; empty: there is nothing to say.
std::string why_not_next(const Session& session, const JudgeCall& call, const std::string& answer);
std::string why_not_label(const Session& session, const JudgeCall& call, const std::string& answer);
std::string why_not_odd(const Session& session, const JudgeCall& call, const std::string& answer);
std::string why_not_broken(const Session& session, const JudgeCall& call, const std::string& answer);
std::string why_not_stretched(const Session& session, const JudgeCall& call, const std::string& answer);
std::string why_not_end(const Session& session, const JudgeCall& call, const std::string& answer);

}  // namespace app::truths
