// What is right about the next verdict, about rows and about labels.
#include <algorithm>
#include <array>

#include "app/core/lesson_truths.h"
#include "knit/rows.h"

namespace app::truths {

using knit::Stage;

// --- the next verdict --------------------------------------------------------------------------------------

namespace {

// The step that takes the next stitch of the row in the making.
std::optional<std::size_t> next_taken(const knit::Timeline& timeline) {
  for (std::size_t i = timeline.position(); i < timeline.known(); ++i) {
    const knit::Happening& what = timeline.step(i).what;
    const auto* measured = std::get_if<knit::CandidateMeasured>(&what);
    if (measured != nullptr && measured->verdict == knit::Verdict::accepted) return i;
    if (std::holds_alternative<knit::BandMissed>(what)) return i;
    if (measured == nullptr) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

Truth next_vertex(const Session& session, const JudgeCall& /*call*/) {
  const knit::Timeline& timeline = *session.timeline;
  const auto step = next_taken(timeline);
  if (!step) {
    return timeline.position() == timeline.known() && !timeline.complete()
               ? not_yet()
               : untold("No stitch is looked for at this place; set the page up again.");
  }
  const auto* measured = std::get_if<knit::CandidateMeasured>(&timeline.step(*step).what);
  const knit::VertexId vertex =
      measured != nullptr ? measured->candidate : std::get<knit::BandMissed>(timeline.step(*step).what).taken;
  return {{vertex_name(vertex)}, said_by(timeline, *step), 0.0};
}

std::string why_not_next(const Session& session, const JudgeCall& /*call*/, const std::string& answer) {
  const knit::Timeline& timeline = *session.timeline;
  const auto taken = next_taken(timeline);
  for (std::size_t i = timeline.position(); taken && i < *taken; ++i) {
    const auto* measured = std::get_if<knit::CandidateMeasured>(&timeline.step(i).what);
    if (measured != nullptr && vertex_name(measured->candidate) == answer) return said_by(timeline, i);
  }
  return "The vertices are tried one after another from the anchor on, and the first one in the band is "
         "taken.";
}

Truth next_verdict(const Session& session, const JudgeCall& /*call*/) {
  const knit::Timeline& timeline = *session.timeline;
  if (timeline.position() == timeline.known())
    return timeline.complete() ? untold("The run is over here; set the page up again.") : not_yet();
  const auto* next = std::get_if<knit::CandidateMeasured>(&timeline.step(timeline.position()).what);
  if (next == nullptr) return untold("No vertex is measured next at this place; set the page up again.");
  constexpr std::array<const char*, 3> keys{"too-near", "accepted", "too-far"};
  return {{keys.at(static_cast<std::size_t>(next->verdict))}, said_by(timeline, timeline.position()), 0.0};
}

Truth band_edge(const Session& session, const JudgeCall& call) {
  knit::Parameters parameters = session.timeline->parameters();
  for (const auto& [info, text] : call.settings) knit::set_value(*info, parameters, text);
  const knit::Band band = knit::band_of(parameters);
  const bool low = call.word == "low";
  const std::string w = knit::short_number(parameters.stitch_width);
  const std::string epsilon = knit::short_number(parameters.epsilon);
  const std::string edge = knit::short_number(low ? band.low : band.high);
  return {{edge},
          "The band " + std::string(low ? "begins" : "ends") + " at w " + (low ? "-" : "+") +
              " epsilon = " + w + (low ? " - " : " + ") + epsilon + " = " + edge + ".",
          0.005 * parameters.stitch_width};
}

// --- rows --------------------------------------------------------------------------------------------------

Truth row_size(const Session& session, const JudgeCall& call) {
  const knit::Timeline& timeline = *session.timeline;
  const auto& rows = timeline.furthest().rows;
  if (static_cast<std::size_t>(call.row) > rows.size()) {
    return timeline.complete() ? untold("This run has no row " + str(call.row) + "; set the page up again.")
                               : not_yet();
  }
  const std::size_t size = rows[static_cast<std::size_t>(call.row) - 1]->stitches.size();
  const auto decided = knit::count_decided_by(timeline, call.row);
  return {{std::to_string(size)}, decided ? said_by(timeline, *decided) : "", 0.0};
}

namespace {

const knit::Transition* transition_of(const knit::Timeline& timeline, std::int32_t row) {
  const auto& all = timeline.furthest().transitions;
  const bool there = row >= 2 && static_cast<std::size_t>(row) - 2 < all.size();
  return there ? &*all[static_cast<std::size_t>(row) - 2] : nullptr;
}

Truth no_transition(const knit::Timeline& timeline, std::int32_t row) {
  return timeline.complete()
             ? untold("This run puts no labels on row " + str(row) + "; set the page up again.")
             : not_yet();
}

std::string counted_words(const knit::Timeline& timeline, std::int32_t row) {
  const auto counted = first_of_kind<knit::TransitionCounted>(timeline, Stage::stitches, row);
  return counted ? said_by(timeline, *counted) : "";
}

template <class Counts>
Truth count_labels(const Session& session, const JudgeCall& call, Counts counts) {
  const knit::Transition* transition = transition_of(*session.timeline, call.row);
  if (transition == nullptr) return no_transition(*session.timeline, call.row);
  const auto count = std::count_if(transition->labels.begin(), transition->labels.end(), counts);
  return {{str(count)}, counted_words(*session.timeline, call.row), 0.0};
}

}  // namespace

Truth increases(const Session& session, const JudgeCall& call) {
  return count_labels(session, call, [](knit::Label label) { return knit::is_increase(label); });
}
Truth decreases(const Session& session, const JudgeCall& call) {
  return count_labels(session, call, [](knit::Label label) { return knit::is_decrease(label); });
}
Truth mains(const Session& session, const JudgeCall& call) {
  return count_labels(session, call, [](knit::Label label) { return label == knit::Label::main; });
}

Truth shaping(const Session& session, const JudgeCall& call) {
  const auto& rows = session.timeline->furthest().rows;
  if (call.row < 2) return untold("The first row follows none.");
  const auto row = static_cast<std::size_t>(call.row);
  if (row > rows.size()) return row_size(session, call);
  const std::size_t below = rows[row - 2]->stitches.size();
  const std::size_t above = rows[row - 1]->stitches.size();
  const char* key = above > below ? "increases" : above < below ? "decreases" : "plain";
  return {{key},
          "Row " + str(call.row) + " has " + std::to_string(above) + " stitches, and the row below has " +
              std::to_string(below) + ".",
          0.0};
}

namespace {

bool is_meant(knit::Label label, const std::string& word) {
  if (word == "increase") return knit::is_increase(label);
  if (word == "decrease") return knit::is_decrease(label);
  constexpr std::array<std::string_view, 7> keys{"knit", "m1r", "m1l", "k2tog", "ssk", "cast", "main"};
  return keys.at(static_cast<std::size_t>(label)) == word;
}

}  // namespace

// Labels stand on the larger of the two rows: an increase on the new one, a decrease on the one below.
Truth stitch_with_label(const Session& session, const JudgeCall& call) {
  const knit::Timeline& timeline = *session.timeline;
  const knit::Transition* transition = transition_of(timeline, call.row);
  if (transition == nullptr) return no_transition(timeline, call.row);
  const std::int32_t row = transition->change() >= 0 ? call.row : call.row - 1;
  Truth truth;
  for (std::size_t cell = 0; cell < transition->labels.size(); ++cell) {
    if (is_meant(transition->labels[cell], call.word))
      truth.answers.push_back(text_of(knit::Thing(knit::StitchThing{row, static_cast<std::int32_t>(cell)})));
  }
  if (truth.answers.empty())
    return untold("Row " + str(call.row) + " has no such stitch; set the page up again.");
  truth.reason = counted_words(timeline, call.row) + " One of these is " +
                 words_of(*thing_named(truth.answers.front())) + ".";
  return truth;
}

std::string why_not_label(const Session& session, const JudgeCall& call, const std::string& answer) {
  const knit::Transition* transition = transition_of(*session.timeline, call.row);
  const auto thing = thing_named(answer);
  const auto* stitch = thing ? std::get_if<knit::StitchThing>(&*thing) : nullptr;
  if (transition == nullptr || stitch == nullptr) return "";
  const std::int32_t row = transition->change() >= 0 ? call.row : call.row - 1;
  const std::string name = capital(words_of(*thing));
  if (stitch->row != row) return name + " is not in row " + str(row) + ".";
  const auto cell = static_cast<std::size_t>(stitch->stitch);
  if (cell >= transition->labels.size()) return "";
  return name + " is labelled " + std::string(knit::name_of(transition->labels[cell])) + ".";
}

}  // namespace app::truths
