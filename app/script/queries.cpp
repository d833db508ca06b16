#include "app/script/queries.h"

#include <algorithm>
#include <array>

#include "app/actions/hosting.h"
#include "app/compare/compare_runs.h"
#include "app/compare/sweep_work.h"
#include "app/compare/ways_on.h"
#include "app/explain/code_variables.h"
#include "app/explain/destination.h"
#include "app/explain/destination_reader.h"
#include "app/explain/pseudo_code.h"
#include "app/explain/step_table.h"
#include "app/explain/why_words.h"
#include "app/files/load.h"
#include "app/files/session_file.h"
#include "app/session/action.h"
#include "app/session/at.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/program.h"
#include "knit/insight/causes.h"
#include "knit/insight/narrate.h"
#include "knit/insight/why_tubes.h"
#include "knit/model/settings_table.h"
#include "knit/model/words.h"

namespace app {

std::optional<std::string> fault_of_break(const std::string& condition) {
  const auto parsed = knit::parse_break(condition);
  const auto* error = std::get_if<std::string>(&parsed);
  return error != nullptr ? std::optional(*error) : std::nullopt;
}

std::vector<knit::BreakCondition> breaks_of(const std::vector<std::string>& texts) {
  std::vector<knit::BreakCondition> conditions;
  for (const std::string& text : texts) {
    const auto parsed = knit::parse_break(text);
    if (const auto* condition = std::get_if<knit::BreakCondition>(&parsed)) conditions.push_back(*condition);
  }
  return conditions;
}

Answer break_answer(Session& session) {
  const knit::Timeline& timeline = session.document->timeline;
  const Travel& travel = session.document->travel;
  const std::size_t here = timeline.position();
  apply(session, PassTime{0.0});  // hits are known as far as the run is
  if (travel.hits.condition_at(here) == nullptr) apply(session, RunToBreak{1});
  const knit::BreakCondition* condition = travel.hits.condition_at(timeline.position());
  if (condition != nullptr)
    return {exit_done, "", "break " + knit::text_of(*condition) + ": " + sentence(session)};
  apply(session, ToLast{});
  return {exit_no_break, "", "no break condition holds from there to the end of the run; showing the end."};
}

namespace {

std::variant<Loaded, std::string> load_source(const Session& session, const SavedRun& run) {
  const Source& source = run.source;
  auto read = source.file.empty() ? load_example(session.program->assets, source.example)
                                  : load_file(source.file, source.repairs, nullptr, source.curves);
  if (std::holds_alternative<std::string>(read)) return read;
  return load_again(std::get<Loaded>(read).original, run.base, nullptr, source.curves);
}

}  // namespace

Answer ways_answer(Session& session) {
  work_out(session);
  const knit::Timeline& timeline = session.document->timeline;
  if (timeline.stop() == nullptr)
    return {exit_done, "", "the run did not stop, so it needs no other way; leave --ways-on out."};
  const WaysOnWork work(timeline);
  work.wait();
  std::string lines;
  for (const FoundWay& found : work.found())
    lines += found.way.words + ": " + found.result() + ": " + found.way.options + "\n";
  return {exit_done, lines, lines.empty() ? words_of(work) : ""};
}

Answer diff_answer(Session& session, const std::filesystem::path& other) {
  const auto read = read_saved_run(other);
  if (const auto* error = std::get_if<std::string>(&read)) return {exit_usage, "", *error};
  const auto& saved = std::get<SavedRun>(read);
  const auto loaded = load_source(session, saved);
  if (const auto* error = std::get_if<std::string>(&loaded)) return {exit_usage, "", *error};
  const auto& input = *std::get<Loaded>(loaded).input;
  const Knobs knobs = resolved(Knobs{saved.base, saved.edits}, input);
  if (const auto fault = knit::fault_of(knobs.base, input))
    return {exit_usage, "", other.string() + ": " + *fault};
  const RunTally run = whole_run(input, knobs);
  const RunFigures figures = figures_of(run, knobs);

  work_out(session);
  const RunTally here = tally_of(session.document->timeline);
  const Knobs here_knobs = knobs_of(session.document->timeline);
  const RunFigures here_figures = figures_of(here, here_knobs);
  const auto uncovered = [](const knit::Input& mesh, const Knobs& of, const knit::State& state) {
    return uncovered_share(mesh, state, parameters_at(of, state.next).stitch);
  };
  const knit::Input& here_input = session.document->timeline.input();
  const RunDifference difference = difference_of(
      {input, knobs, run.state, figures, uncovered(input, knobs, run.state)},
      {here_input, here_knobs, here.state, here_figures, uncovered(here_input, here_knobs, here.state)});
  Pin pin;
  pin.input = std::get<Loaded>(loaded).input;
  pin.knobs = knobs;
  pin.end = run.state;
  pin.figures = figures;
  pin.known = true;
  app::pin(session, std::move(pin));
  return {exit_done, text_of(difference, other.filename().string(), "this run"), ""};
}

namespace {

// '>': the line that just ran; '|': others of the step.
char mark_of(const Explained& at, std::size_t line) {
  if (!at.lines || !at.lines->holds(line)) return ' ';
  return at.lines->last == line ? '>' : '|';
}

std::string place_line(const Explained& at) {
  if (at.step == nullptr) return "start";
  return text_of(at.step->place) + (at.stopped ? "\tstopped" : "");
}

std::string padded(std::size_t number) { return (number < 10 ? " " : "") + std::to_string(number); }

}  // namespace

Answer explain_answer(const Session& session) {
  const auto at = explained(session);
  if (!at) return {exit_usage, "", "nothing is open that could be explained."};
  const PseudoCode& code = *at->code;
  std::string text = place_line(*at) + "\t" + std::string(code.title) + "\n" + sentence(session) + "\n";
  if (const std::string why = cause(session); !why.empty()) text += why + "\n";
  for (std::size_t i = 0; i < code.lines.size(); ++i)
    text += std::string(1, mark_of(*at, i)) + " " + padded(i + 1) + "  " + shown_text(code.lines[i]) + "\n";
  for (const Variable& variable : variables_of(session)) {
    if (variable.value.empty()) continue;
    text += variable.of->key;
    text += "\t" + std::string(variable.of->symbol) + "\t" + variable.value + "\t";
    text += variable.of->meaning;
    text += "\n";
  }
  return {exit_done, text, ""};
}

std::optional<std::string> fault_of_point(const std::string& variable) {
  if (variable.empty() || variable_named(variable) != nullptr) return std::nullopt;
  return "--point cannot be \"" + variable +
         "\"; give the name of a variable, the first word of its line as --explain prints it.";
}

namespace {

std::variant<SweepPlan, std::string> plan_of(const std::vector<std::string>& axes) {
  if (axes.size() > 2) return "--sweep can be given once or twice; more than two parameters make no table.";
  SweepPlan plan;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    auto axis = parse_sweep_axis(axes[i]);
    if (auto* fault = std::get_if<std::string>(&axis)) return *fault;
    if (i == 0) plan.axis = std::get<SweepAxis>(axis);
    if (i == 1) plan.second = std::get<SweepAxis>(axis);
  }
  if (auto fault = fault_of(plan)) return *fault;
  return plan;
}

// In quotes where a comma or a quote would end the cell.
std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string cv_cell(const knit::LengthFigures& figures) {
  return figures.count > 0 ? knit::number_text(figures.cv) : "";
}

// Counted in columns of their own.
constexpr std::array swept_kinds{knit::ProblemKind::band_missed, knit::ProblemKind::row_resampled,
                                 knit::ProblemKind::gap_left_open, knit::ProblemKind::time_clamped};

std::string line_of(const SweepRun& run) {
  std::string line;
  for (const double value : run.values) line += knit::number_text(value) + ",";
  if (!run.refused.empty()) return line + "refused,,,,,,,,,," + cell(run.refused) + ",,,,,,,,,,,,\n";
  const RunFigures& f = run.figures;
  line += f.finished ? "finished" : "stopped";
  for (const std::size_t count : {f.steps, f.rows, f.stitches}) line += "," + std::to_string(count);
  for (const std::int32_t count : {f.increases, f.decreases, f.most_in_a_row})
    line += "," + std::to_string(count);
  line += "," + std::to_string(f.problems.total()) + "," + cv_cell(f.course) + "," + cv_cell(f.wale) + "," +
          cell(f.stop);
  const TubeFigures& t = run.tubes;
  for (const std::int32_t count : {t.tubes, t.splits, t.joins, t.genus, t.yarns, t.holders, t.left_out})
    line += "," + std::to_string(count);
  line += "," + (run.uncovered ? knit::number_text(*run.uncovered) : "");
  for (const knit::ProblemKind kind : swept_kinds) line += "," + std::to_string(f.problems.of(kind));
  return line + "\n";
}

}  // namespace

std::optional<std::string> fault_of_sweep(const std::vector<std::string>& axes) {
  if (axes.empty()) return std::nullopt;
  const auto plan = plan_of(axes);
  const auto* fault = std::get_if<std::string>(&plan);
  return fault != nullptr ? std::optional(*fault) : std::nullopt;
}

Answer sweep_answer(Session& session, const std::vector<std::string>& axes) {
  const auto plan = plan_of(axes);
  if (const auto* fault = std::get_if<std::string>(&plan)) return {exit_usage, "", *fault};
  app::apply(session, StartSweep{std::get<SweepPlan>(plan)});
  if (session.jobs->beside) return {};
  const SweepWork& work = *session.document->sweep->work;
  std::string text = work.plan().axis.key + ",";
  if (work.plan().second) text += work.plan().second->key + ",";
  text += "outcome,steps,rows,stitches,increases,decreases,most_in_a_row,problems,course_cv,wale_cv,why,";
  text += "tubes,splits,joins,genus,yarns,holders,left_out,uncovered";
  for (const knit::ProblemKind kind : swept_kinds) {
    std::string head(knit::key_of(kind));
    std::replace(head.begin(), head.end(), '-', '_');
    text += "," + head;
  }
  text += "\n";
  for (std::size_t i = 0; i < work.total(); ++i) text += line_of(*work.run(i));
  return {exit_done, text, ""};
}

namespace {

// A step: its number and place, its sentence, its numbers one a line.
std::string step_text(const knit::Timeline& timeline, const std::string& what, std::size_t index) {
  const knit::Step& step = timeline.step(index);
  std::string text = what + "\tstep " + std::to_string(index + 1) + "\t" + text_of(step.place) + "\t" +
                     std::string(knit::kind_name(step)) + "\n";
  text += knit::narrate(step, timeline.parameters_of_step(index)) + "\n";
  for (const auto& [name, value] : numbers_of(step)) {
    text += "  ";
    text += name;
    text += "\t";
    text += value;
    text += "\n";
  }
  return text;
}

std::string vertex_text(const knit::Timeline& timeline, const knit::VertexElement& thing) {
  const knit::VertexStory story = knit::story_of(timeline, thing.vertex);
  const auto critical = knit::critical_story(timeline, thing.vertex);
  std::string text;
  for (const std::size_t step : story.measured) text += step_text(timeline, "measured", step);
  if (critical) {
    for (const std::size_t step : critical->found) text += step_text(timeline, "found", step);
    for (const std::size_t step : critical->leaving_out) text += step_text(timeline, "left out", step);
    for (const std::size_t step : critical->dealt) text += step_text(timeline, "dealt", step);
    return text;
  }
  const bool among = !story.measured.empty() && story.decided == story.measured.back();
  if (story.decided && !among) text += step_text(timeline, "decided", *story.decided);
  return text;
}

std::string stitch_text(const knit::Timeline& timeline, const knit::StitchElement& stitch, std::size_t made) {
  std::string text;
  for (const std::size_t step : knit::refused_before(timeline, stitch))
    text += step_text(timeline, "refused", step);
  if (const auto chosen = knit::chosen_by(timeline, stitch)) text += step_text(timeline, "chosen", *chosen);
  text += step_text(timeline, "made", made);
  if (const auto moved = knit::moved_by(timeline, stitch)) text += step_text(timeline, "moved", *moved);
  if (const auto settled = knit::settled_by(timeline)) text += step_text(timeline, "settled", *settled);
  return text;
}

}  // namespace

namespace {

constexpr std::string_view longest_wale_words = "longest wale";

}  // namespace

std::optional<std::string> fault_of_why(const std::string& thing) {
  if (thing_named(thing) || row_named(thing) || thing == longest_wale_words) return std::nullopt;
  return "--why cannot be \"" + thing +
         "\"; give row:ROW, longest wale, stitch:ROW:ITEM, edge:ROW:ITEM, column:ROW:ITEM, face:ROW:ITEM, "
         "label:ROW:ITEM or vertex:ID, rows and items from 1; ROW -1 is the first deal, with its "
         "bridge.";
}

namespace {

// Of the whole run, where it has to be known to tell which is meant.
std::optional<knit::Element> thing_asked(Session& session, const std::string& thing) {
  if (!session.document) return std::nullopt;
  if (thing != longest_wale_words) return thing_named(thing);
  work_out(session);
  const auto longest = longest_wale_of(session.document->timeline);
  return longest ? std::optional<knit::Element>(*longest) : std::nullopt;
}

// "row 7": why it has its number of stitches, and the step that decided.
Answer why_row_answer(Session& session, std::int32_t row) {
  work_out(session);
  const knit::Timeline& timeline = session.document->timeline;
  const std::string why = knit::why_count(timeline, row);
  const auto decided = knit::count_decided_by(timeline, row);
  if (why.empty() || !decided)
    return {exit_usage, "",
            "the run has no row " + std::to_string(row) + "; its last is " +
                std::to_string(timeline.furthest().fabric.row_count()) + "."};
  apply(session, SeekTo{*decided + 1});
  return {exit_done, why + "\n" + step_text(timeline, "decided", *decided), ""};
}

}  // namespace

std::optional<std::string> fault_of_select(const std::string& what) {
  if (what.empty() || thing_named(what) || knit::size_range_named(what)) return std::nullopt;
  return "--select cannot be \"" + what +
         "\"; give stitch:ROW:ITEM, edge:ROW:ITEM, column:ROW:ITEM, face:ROW:ITEM, label:ROW:ITEM or "
         "vertex:ID, "
         "or all of a size: course:FROM:TO in stitch widths, wale:FROM:TO in stitch heights, corner:FROM:TO "
         "in "
         "degrees.";
}

void select_as_asked(Session& session, const std::string& what) {
  if (what.empty() || !session.document) return;
  if (const auto thing = thing_named(what)) return apply(session, LookAt{*thing});
  apply(session, SelectSized{knit::size_range_named(what)});
}

Answer why_answer(Session& session, const std::string& thing) {
  const auto row = row_named(thing);
  if (row && session.document) return why_row_answer(session, *row);
  const auto asked = thing_asked(session, thing);
  if (!asked) return {exit_usage, "", "nothing can be said about \"" + thing + "\"."};
  work_out(session);
  const knit::Timeline& timeline = session.document->timeline;
  const auto* vertex = std::get_if<knit::VertexElement>(&*asked);
  const std::size_t vertices = timeline.input().mesh.positions.size();
  if (vertex != nullptr && vertex->vertex >= vertices) {
    return {exit_usage, "",
            "the mesh has no " + words_of(*asked) + "; its last is " + std::to_string(vertices - 1) + "."};
  }
  const auto made = knit::made_by(timeline, *asked);
  if (!made && vertex == nullptr)
    return {exit_usage, "", "the run has no " + words_of(*asked) + " (" + thing + ")."};
  apply(session, ShowWhy{*asked});
  std::string text = words_of(*asked) + ": " + why_words(timeline, *asked) + "\n";
  if (vertex != nullptr) return {exit_done, text + vertex_text(timeline, *vertex), ""};
  if (const auto* stitch = std::get_if<knit::StitchElement>(&*asked))
    return {exit_done, text + stitch_text(timeline, *stitch, *made), ""};
  return {exit_done, text + step_text(timeline, "made", *made), ""};
}

std::optional<std::string> fault_of_go_to(const std::string& words) {
  if (words.empty() || read_place_wish(words)) return std::nullopt;
  return "--go-to cannot be \"" + words + "\". " + destination_forms();
}

Answer go_to_answer(Session& session, const std::string& words) {
  if (!session.document) return {exit_usage, "", "nothing is open to go to \"" + words + "\" in."};
  work_out(session);
  const auto found = destination_of(session, words);
  if (const auto* none = std::get_if<NoDestination>(&found)) return {exit_usage, "", "--go-to: " + none->why};
  apply(session, GoTo{words});
  return {exit_done, std::get<Destination>(found).words + "\n", ""};
}

}  // namespace app
