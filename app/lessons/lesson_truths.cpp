// What is right about the next verdict, about rows and about labels.
#include "app/lessons/lesson_truths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "app/session/document.h"
#include "app/session/run_figures.h"
#include "knit/model/settings_table.h"
#include "knit/model/stitch_size.h"
#include "knit/model/words.h"
#include "knit/rows/rows.h"

namespace app::truths {

using knit::Stage;

// --- the next verdict --------------------------------------------------------------------------------------

namespace {

// The step that takes the next stitch of the row in the making.
std::optional<std::size_t> next_taken(const knit::Timeline& timeline) {
  for (std::size_t i = timeline.position(); i < timeline.known(); ++i) {
    const knit::Event& what = timeline.step(i).what;
    const auto* measured = knit::get_if<knit::CandidateMeasured>(what);
    if (measured != nullptr && measured->verdict == knit::Verdict::accepted) return i;
    if (knit::is<knit::BandMissed>(what)) return i;
    if (measured == nullptr) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

Truth next_vertex(const Session& session, const JudgeCall& /*call*/) {
  const knit::Timeline& timeline = session.document->timeline;
  const auto step = next_taken(timeline);
  if (!step) {
    return timeline.position() == timeline.known() && !timeline.complete()
               ? not_yet()
               : untold("No stitch is looked for at this place; set the page up again.");
  }
  const auto* measured = knit::get_if<knit::CandidateMeasured>(timeline.step(*step));
  const auto* missed = knit::get_if<knit::BandMissed>(timeline.step(*step));
  const knit::VertexId vertex = measured != nullptr ? measured->candidate
                                : missed != nullptr ? missed->taken
                                                    : knit::no_vertex;
  return {{vertex_name(vertex)}, said_by(timeline, *step), 0.0};
}

std::string why_not_next(const Session& session, const JudgeCall& /*call*/, const std::string& answer) {
  const knit::Timeline& timeline = session.document->timeline;
  const auto taken = next_taken(timeline);
  for (std::size_t i = timeline.position(); taken && i < *taken; ++i) {
    const auto* measured = knit::get_if<knit::CandidateMeasured>(timeline.step(i));
    if (measured != nullptr && vertex_name(measured->candidate) == answer) return said_by(timeline, i);
  }
  return "The vertices are tried one after another from the anchor on, and the first one in the band is "
         "taken.";
}

Truth next_verdict(const Session& session, const JudgeCall& /*call*/) {
  const knit::Timeline& timeline = session.document->timeline;
  if (timeline.position() == timeline.known())
    return timeline.complete() ? untold("The run is over here; set the page up again.") : not_yet();
  const auto* next = knit::get_if<knit::CandidateMeasured>(timeline.step(timeline.position()));
  if (next == nullptr) return untold("No vertex is measured next at this place; set the page up again.");
  constexpr std::array<const char*, 3> keys{"too-near", "accepted", "too-far"};
  return {{keys.at(static_cast<std::size_t>(next->verdict))}, said_by(timeline, timeline.position()), 0.0};
}

Truth band_edge(const Session& session, const JudgeCall& call) {
  knit::Parameters parameters = session.document->timeline.parameters();
  knit::set_values(call.settings, parameters);
  parameters = knit::resolved(parameters, session.document->timeline.input());
  const knit::Band band = knit::band_of(parameters.rows, parameters.stitch);
  const bool low = call.word == "low";
  const std::string w = knit::short_number(parameters.stitch.width);
  const std::string epsilon = knit::short_number(parameters.epsilon());
  const std::string edge = knit::short_number(low ? band.low : band.high);
  return {{edge},
          "The band " + std::string(low ? "begins" : "ends") + " at w " + (low ? "-" : "+") +
              " epsilon = " + w + (low ? " - " : " + ") + epsilon + " = " + edge + ".",
          0.005 * parameters.stitch.width};
}

// --- rows --------------------------------------------------------------------------------------------------

Truth row_size(const Session& session, const JudgeCall& call) {
  const knit::Timeline& timeline = session.document->timeline;
  const knit::Row* row = timeline.furthest().fabric.find_row(call.row);
  if (row == nullptr) {
    return timeline.complete() ? untold("This run has no row " + str(call.row) + "; set the page up again.")
                               : not_yet();
  }
  const auto decided = knit::count_decided_by(timeline, call.row);
  return {{std::to_string(row->stitches.size())}, decided ? said_by(timeline, *decided) : "", 0.0};
}

namespace {

const knit::Join* join_of(const knit::Timeline& timeline, std::int32_t row) {
  return timeline.furthest().fabric.join_into(row);
}

Truth no_join(const knit::Timeline& timeline, std::int32_t row) {
  return timeline.complete()
             ? untold("This run puts no labels on row " + str(row) + "; set the page up again.")
             : not_yet();
}

std::string counted_words(const knit::Timeline& timeline, std::int32_t row) {
  const auto counted = first_of_kind<knit::JoinCounted>(timeline, Stage::stitches, row);
  return counted ? said_by(timeline, *counted) : "";
}

template <class Counts>
Truth count_labels(const Session& session, const JudgeCall& call, Counts counts) {
  const knit::Join* join = join_of(session.document->timeline, call.row);
  if (join == nullptr) return no_join(session.document->timeline, call.row);
  const auto count = std::count_if(join->labels.begin(), join->labels.end(), counts);
  return {{str(count)}, counted_words(session.document->timeline, call.row), 0.0};
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
  const knit::Fabric& fabric = session.document->timeline.furthest().fabric;
  if (call.row < 2) return untold("The first row follows none.");
  if (!fabric.has_row(call.row)) return row_size(session, call);
  if (fabric.row(call.row).on.empty())
    return untold("Row " + str(call.row) + " is cast on; it follows none.");
  const std::int32_t below = fabric.live_below(call.row).size();
  const std::int32_t above = knit::size_of(fabric.row(call.row));
  const char* key = above > below ? "increases" : above < below ? "decreases" : "plain";
  return {{key},
          "Row " + str(call.row) + " has " + knit::stitch_count_text(above) +
              (fabric.row_below(call.row) != nullptr ? ", and the row below has "
                                                     : ", and what it is worked on has ") +
              std::to_string(below) + ".",
          0.0};
}

namespace {

bool is_meant(knit::Label label, const std::string& word) {
  if (word == "increase") return knit::is_increase(label);
  if (word == "decrease") return knit::is_decrease(label);
  if (word == "turn") return knit::is_turn(label);
  constexpr std::array<std::string_view, 10> keys{"knit", "m1r",  "m1l",       "k2tog",      "ssk",
                                                  "cast", "main", "turn left", "turn right", "marked"};
  return keys.at(static_cast<std::size_t>(label)) == word;
}

}  // namespace

// Labels stand on the larger of the two rows: an increase on the new one, a decrease on the one below.
Truth stitch_with_label(const Session& session, const JudgeCall& call) {
  const knit::Timeline& timeline = session.document->timeline;
  const knit::Join* join = join_of(timeline, call.row);
  if (join == nullptr) return no_join(timeline, call.row);
  const knit::LiveStitches cells = timeline.furthest().fabric.larger(*join);
  Truth truth;
  for (std::size_t cell = 0; cell < join->labels.size(); ++cell) {
    if (!is_meant(join->labels[cell], call.word)) continue;
    const knit::StitchRef at = cells.at(static_cast<std::int32_t>(cell));
    truth.answers.push_back(text_of(knit::Element(knit::StitchElement{at.row, at.stitch})));
  }
  if (truth.answers.empty())
    return untold("Row " + str(call.row) + " has no such stitch; set the page up again.");
  truth.reason = counted_words(timeline, call.row) + " One of these is " +
                 words_of(*thing_named(truth.answers.front())) + ".";
  return truth;
}

std::string why_not_label(const Session& session, const JudgeCall& call, const std::string& answer) {
  const knit::Join* join = join_of(session.document->timeline, call.row);
  const auto thing = thing_named(answer);
  const auto* stitch = thing ? std::get_if<knit::StitchElement>(&*thing) : nullptr;
  if (join == nullptr || stitch == nullptr) return "";
  // Where a row shrinks its cells are what it is worked on: of one row or of several.
  const knit::LiveStitches cells = session.document->timeline.furthest().fabric.larger(*join);
  const std::string name = capital(words_of(*thing));
  for (std::int32_t cell = 0; cell < cells.size(); ++cell) {
    if (cells.at(cell) == knit::StitchRef{stitch->row, stitch->stitch})
      return name + " is labelled " +
             std::string(knit::name_of(join->labels[static_cast<std::size_t>(cell)])) + ".";
  }
  const std::int32_t row = cells.at(0).row;
  if (row < 0 || cells.spans.size() > 1)
    return name + " is none that row " + str(call.row) + " is worked on.";
  return name + " is not in row " + str(row) + ".";
}

// What is right about odd rows, the mesh, how the run ends, and what other settings make of it.

// --- what is odd about a row -------------------------------------------------------------------------------

Truth closing_gap(const Session& session, const JudgeCall& call) {
  const knit::Timeline& timeline = session.document->timeline;
  const auto closed = first_of_kind<knit::RowClosed>(timeline, Stage::rows, call.row);
  if (!closed)
    return timeline.complete() ? untold("Row " + str(call.row) + " closes with no gap.") : not_yet();
  const auto& what = *knit::get_if<knit::RowClosed>(timeline.step(*closed));
  const knit::Parameters& parameters = timeline.parameters_of_step(*closed);
  const knit::Band band = knit::band_of(parameters.rows, parameters.stitch);
  constexpr std::array<const char*, 3> keys{"shorter", "inside", "longer"};
  return {
      {keys.at(static_cast<std::size_t>(knit::verdict_on(what.gap, band)))}, said_by(timeline, *closed), 0.0};
}

namespace {

bool is_odd(const knit::Event& what, const std::string& word) {
  if (word == "stall") return knit::is<knit::BandMissed>(what);
  return knit::is<knit::RowResampled>(what);
}

struct ClosedRowGap {
  std::size_t step = 0;
  double off = 0.0;  // from the stitch width
};

// The rows whose gap is farthest from the stitch width once they are finished; as good as equal ones too.
Truth widest_gaps(const knit::Timeline& timeline, std::int32_t answered) {
  std::vector<ClosedRowGap> rows;
  double farthest = 0.0;
  for (std::size_t i = 0; i < timeline.known(); ++i) {
    const auto* shared = knit::get_if<knit::GapShared>(timeline.step(i));
    if (shared == nullptr) continue;
    rows.push_back({i, std::abs(shared->gap_after - timeline.parameters_of_step(i).stitch.width)});
    farthest = std::max(farthest, rows.back().off);
  }
  Truth truth;
  for (const ClosedRowGap& row : rows) {
    if (row.off < 0.98 * farthest) continue;
    const std::int32_t number = timeline.step(row.step).place.row;
    if (truth.answers.empty() || number == answered) truth.reason = said_by(timeline, row.step);
    truth.answers.push_back("row:" + str(number));
  }
  return rows.empty() ? untold("No row was closed in this run; set the page up again.") : truth;
}

}  // namespace

Truth odd_row(const Session& session, const JudgeCall& call) {
  const knit::Timeline& timeline = session.document->timeline;
  if (!timeline.complete()) return not_yet();
  if (call.word == "gap") return widest_gaps(timeline, call.row);
  Truth truth;
  for (std::size_t i = 0; i < timeline.known(); ++i) {
    if (!is_odd(timeline.step(i).what, call.word)) continue;
    const std::int32_t row = timeline.step(i).place.row;
    if (!truth.answers.empty() && truth.answers.back() == "row:" + str(row)) continue;
    // Of the row that was answered, if it is one of them.
    if (truth.answers.empty() || row == call.row) truth.reason = said_by(timeline, i);
    truth.answers.push_back("row:" + str(row));
  }
  return truth.answers.empty() ? untold("No row of this run has that; set the page up again.") : truth;
}

std::string why_not_odd(const Session& session, const JudgeCall& /*call*/, const std::string& answer) {
  const knit::Timeline& timeline = session.document->timeline;
  const std::int32_t row = row_of_answer(answer);
  const auto shared = first_of_kind<knit::GapShared>(timeline, Stage::rows, row);
  return shared ? said_by(timeline, *shared) : "Row " + str(row) + " is none that was closed.";
}

// --- the mesh and the whole run ----------------------------------------------------------------------------

double near_enough(const Session& session) {
  const knit::Bounds& bounds = session.document->timeline.input().bounds;
  return 0.12 * glm::distance(bounds.low, bounds.high);
}

Truth end_vertex(const Session& session, const JudgeCall& call) {
  const knit::Timeline& timeline = session.document->timeline;
  const auto* ends = timeline.known() > 0 ? knit::get_if<knit::EndsFound>(timeline.step(0)) : nullptr;
  if (ends == nullptr) return not_yet();
  const knit::VertexId vertex = call.word == "start" ? ends->start : ends->end;
  return {{vertex_name(vertex)}, said_by(timeline, 0), near_enough(session)};
}

std::string why_not_end(const Session& session, const JudgeCall& /*call*/, const std::string& answer) {
  const auto thing = thing_named(answer);
  const auto* vertex = thing ? std::get_if<knit::VertexElement>(&*thing) : nullptr;
  const auto step = vertex ? knit::timed_by(session.document->timeline, vertex->vertex) : std::nullopt;
  return step ? said_by(session.document->timeline, *step) : "";
}

Truth ending(const Session& session, const JudgeCall& /*call*/) {
  const knit::Timeline& timeline = session.document->timeline;
  if (!timeline.complete()) return not_yet();
  const knit::Step* stop = timeline.stop();
  if (stop == nullptr) return {{"finishes"}, "The run goes on to its last stage; nothing stops it.", 0.0};
  std::string key(knit::name_of(knit::get_if<knit::Stopped>(*stop)->reason));
  std::replace(key.begin(), key.end(), ' ', '-');
  return {{key}, knit::narrate(*stop, timeline.parameters_of_stop()), 0.0};
}

// Where tubes part in the plan that is knitted.
Truth planned_splits(const Session& session, const knit::TubePlan& plan) {
  Truth truth{{}, "", near_enough(session)};
  for (const knit::TubeEvent& event : plan.events) {
    if (event.kind == knit::EventKind::split) truth.answers.push_back(vertex_name(event.vertex));
  }
  truth.reason = "The run parts at " + std::to_string(truth.answers.size()) +
                 (truth.answers.size() == 1 ? " saddle." : " saddles.");
  return truth.answers.empty() ? untold("Nothing splits in this run; set the page up again.") : truth;
}

Truth split_vertex(const Session& session, const JudgeCall& call) {
  const knit::Timeline& timeline = session.document->timeline;
  const knit::Step* stop = timeline.stop();
  const auto* what = stop != nullptr ? knit::get_if<knit::Stopped>(*stop) : nullptr;
  if (what == nullptr && timeline.furthest().tubes)
    return planned_splits(session, *timeline.furthest().tubes);
  if (what == nullptr || what->reason != knit::StopReason::splits) {
    return timeline.complete() ? untold("Nothing splits in this run; set the page up again.")
                               : ending(session, call);
  }
  return {
      {vertex_name(what->vertex)}, knit::narrate(*stop, timeline.parameters_of_stop()), near_enough(session)};
}

// --- another setting ---------------------------------------------------------------------------------------

namespace {

// The knobs with other settings, as tuning would make them.
Knobs changed_knobs(const knit::Timeline& timeline, const Settings& settings) {
  knit::Parameters wanted = timeline.parameters();
  knit::set_values(settings, wanted);
  return tuned(knobs_of(timeline), timeline.parameters(), wanted, timeline.input());
}

// The run as it would be, without recording it.
RunTally run_with(const knit::Timeline& timeline, const Knobs& knobs, Stage before) {
  RunTally run;
  go_on(run, timeline.input(), knobs, std::numeric_limits<std::size_t>::max(), before);
  return run;
}

std::size_t measure_of(const RunTally& run, const JudgeCall& call) {
  const knit::Fabric& fabric = run.state.fabric;
  if (call.word == "rows") return fabric.rows().size();
  if (call.word == "problems") return run.problems.total();
  if (call.word == "stitches") return fabric.stitch_count();
  const knit::Row* row = fabric.find_row(std::max(1, call.row));
  return row != nullptr ? row->stitches.size() : 0;
}

std::string measure_words(const JudgeCall& call) {
  if (call.word == "row-size") return "Stitches in row " + str(call.row);
  return capital(call.word) + " in the whole run";
}

std::string settings_words(const Settings& settings) {
  std::string words;
  for (const auto& [info, text] : settings)
    words += (words.empty() ? "" : ", ") + std::string(info->label) + " " + text;
  return words;
}

}  // namespace

Truth what_if(const Session& session, const JudgeCall& call) {
  const knit::Timeline& timeline = session.document->timeline;
  if (!timeline.complete()) return not_yet();
  const Stage before = call.word == "problems" ? Stage::done : Stage::stitches;
  const std::size_t now = measure_of(tally_of(timeline), call);
  const std::size_t then =
      measure_of(run_with(timeline, changed_knobs(timeline, call.settings), before), call);
  const char* key = then > now ? "more" : then < now ? "fewer" : "same";
  return {{key},
          measure_words(call) + ": " + std::to_string(now) + " now, " + std::to_string(then) + " with " +
              settings_words(call.settings) + ".",
          0.0};
}

Truth what_if_stops(const Session& session, const JudgeCall& call) {
  const Knobs knobs = changed_knobs(session.document->timeline, call.settings);
  const RunTally run = run_with(session.document->timeline, knobs, Stage::done);
  const std::string with = "With " + settings_words(call.settings);
  if (!run.stop)
    return {
        {"finishes"},
        with + " the run finishes, with " + knit::plural(run.state.fabric.row_count(), "row", "rows") + ".",
        0.0};
  return {
      {"stops"}, with + " it stops. " + knit::narrate(*run.stop, parameters_at(knobs, run.stop->place)), 0.0};
}

}  // namespace app::truths
