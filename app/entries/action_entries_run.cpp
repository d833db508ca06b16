// Entries about the run: going to a place in it, why things are there, breaks, comparing and sweeping.
#include <array>
#include <cstdint>

#include "app/actions/parameters_text.h"
#include "app/base/text.h"
#include "app/entries/action_entries_parts.h"
#include "app/explain/destination.h"
#include "app/explain/glossary.h"
#include "app/explain/why_words.h"
#include "app/session/at.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/learning.h"
#include "app/session/presets.h"
#include "app/session/view.h"
#include "knit/model/settings_table.h"
#include "knit/model/words.h"

namespace app {

namespace {

using Read = std::variant<Action, std::string>;

std::string quoted(const std::string& typed) { return "\"" + typed + "\""; }

Read read_step(const Session& session, const std::string& typed) {
  const auto step = whole_number<std::size_t>(typed);
  if (!step) return "A step is a whole number, not " + quoted(typed) + ".";
  const knit::Timeline& timeline = session.document->timeline;
  if (timeline.complete() && *step > timeline.known())
    return "The run has only " + knit::plural(static_cast<std::int64_t>(timeline.known()), "step", "steps") +
           ".";
  return SeekTo{*step};
}

// The same stage's end of the row, where the stage has rows.
Read read_row(const Session& session, const std::string& typed) {
  const auto row = whole_number<std::int32_t>(typed);
  if (!row || *row < 1) return "A row is a whole number from 1 on, not " + quoted(typed) + ".";
  const knit::Timeline& timeline = session.document->timeline;
  const auto rows = static_cast<std::int32_t>(timeline.furthest().fabric.rows().size());
  if (timeline.complete() && *row > rows)
    return "The run has only " + knit::plural(rows, "row", "rows") + ".";
  const knit::Stage at = timeline.state().stage();
  const bool by_rows = at > knit::Stage::rows && at<knit::Stage::done&& * row> 1;
  return SeekPlace{{by_rows ? at : knit::Stage::rows, *row, INT32_MAX}};
}

Read read_place(const Session& /*session*/, const std::string& typed) {
  const auto at = parse_at(typed);
  if (!at)
    return quoted(typed) +
           " is no place; give STAGE, STAGE:ROW, STAGE:ROW:ITEM, a step's number or end; rows and items "
           "count "
           "from 1.";
  if (const auto* place = std::get_if<knit::Place>(&*at)) return SeekPlace{*place};
  if (const auto* stage = std::get_if<AtStage>(&*at)) return SeekPlace{{stage->stage, -1, 0}};
  if (const auto* step = std::get_if<std::size_t>(&*at)) return SeekTo{*step};
  return ToLast{};
}

Read read_speed(const Session& /*session*/, const std::string& typed) {
  const auto speed = whole_number<std::int64_t>(typed);
  if (!speed || *speed < static_cast<std::int64_t>(slowest_steps_per_second) ||
      *speed > static_cast<std::int64_t>(fastest_steps_per_second))
    return "The speed is from 1 to 100000 steps a second, not " + quoted(typed) + ".";
  return SetSpeed{static_cast<double>(*speed)};
}

Read read_break(const Session& session, const std::string& typed) {
  const auto parsed = knit::parse_break(typed);
  if (const auto* error = std::get_if<std::string>(&parsed)) return *error;
  auto conditions = session.view->breaks;
  conditions.push_back(std::get<knit::BreakCondition>(parsed));
  return SetBreaks{std::move(conditions)};
}

Read read_sweep(const Session& /*session*/, const std::string& typed) {
  auto axis = parse_sweep_axis(typed);
  if (const auto* error = std::get_if<std::string>(&axis)) return without_dashes(*error);
  SweepPlan plan{std::get<SweepAxis>(axis), std::nullopt};
  if (const auto fault = fault_of(plan)) return without_dashes(*fault);
  return StartSweep{std::move(plan)};
}

// "stitch:14:3", or a vertex's number alone.
std::variant<knit::Element, std::string> read_thing(const Session& session, const std::string& typed) {
  const auto vertex = whole_number<knit::VertexId>(typed);
  const auto thing = vertex ? std::optional<knit::Element>(knit::VertexElement{*vertex}) : thing_named(typed);
  if (!thing) {
    return quoted(typed) +
           " is no element; give stitch:ROW:ITEM, edge:ROW:ITEM, column:ROW:ITEM, face:ROW:ITEM, "
           "label:ROW:ITEM, rows and items from 1, or a vertex's number.";
  }
  const auto* mesh_vertex = std::get_if<knit::VertexElement>(&*thing);
  const std::size_t count = session.document->timeline.input().mesh.positions.size();
  if (mesh_vertex != nullptr && mesh_vertex->vertex >= count)
    return "The mesh has only " + knit::plural(static_cast<std::int64_t>(count), "vertex", "vertices") +
           ", counted from 0.";
  if (mesh_vertex == nullptr && !knit::exists(session.document->timeline.furthest(), *thing))
    return "The run has no " + words_of(*thing) + ", or not yet.";
  return *thing;
}

// "wale:1.5" or "wale:1.5:2".
Read read_sizes(const Session& /*session*/, const std::string& typed) {
  const auto range = knit::size_range_named(typed);
  if (range) return SelectSized{range};
  return quoted(typed) +
         " is no size; give course:FROM:TO in stitch widths, wale:FROM:TO in stitch heights or "
         "corner:FROM:TO in "
         "degrees; without TO: and more.";
}

template <class Wish>
Read read_about(const Session& session, const std::string& typed) {
  auto thing = read_thing(session, typed);
  if (const auto* error = std::get_if<std::string>(&thing)) return *error;
  return Wish{std::get<knit::Element>(thing)};
}

void add_stages(EntryList& list) {
  for (const knit::Stage stage : knit::machine_stages) {
    const std::string name(knit::name_of(stage));
    list.add({"Go to the beginning of " + name, group::the_run, "", SeekPlace{{stage, -1, 0}},
              list.unless_open(), "", true});
    list.add({"Go to the end of " + name, group::the_run, "", SeekPlace{{stage, INT32_MAX, INT32_MAX}},
              list.unless_open(), "", true});
  }
}

void add_breaks(EntryList& list) {
  const bool none = list.session.view->breaks.empty();
  list.add(
      {"Break when...", group::finding,
       "Playing stops there: row=14, stage=rows, stall, gap, over-double, grows>4, label=m1l, wider>1.3...",
       ActionPrompt{"Break when", "row=14", read_break}, list.unless_open()});
  list.add({"Forget all break conditions", group::finding, "", SetBreaks{{}}, none ? "There is none." : ""});
}

void add_things(EntryList& list) {
  list.add({"Select vertex...", group::finding,
            "Lights it in the view; the keys J and Shift+J go to the steps about it.",
            ActionPrompt{"Vertex", "12", read_about<Select>}, list.unless_open()});
  list.add({"Select stitch or face...", group::finding,
            "Also edge, column, face and label, or a vertex: lights it in the view, the chart and the lists.",
            ActionPrompt{"Element", "stitch:2:1", read_about<Select>}, list.unless_open()});
  list.add({"Look at a stitch or face...", group::finding, "As select; the view turns to it.",
            ActionPrompt{"Element", "stitch:2:1", read_about<LookAt>}, list.unless_open()});
  list.add({"Light edges of a size...", group::finding,
            "All course edges, wale edges or corners of a size: lights them in the view.",
            ActionPrompt{"Size", "wale:1.5", read_sizes}, list.unless_open()});
  list.add({"Why is it there...", group::finding,
            "Goes to the step that made it, or decided on it; a number alone is a vertex.",
            ActionPrompt{"Element", "stitch:2:1", read_about<ShowWhy>}, list.unless_open()});
  for (const WhyQuestion& question : why_questions())
    list.add({std::string(question.words), group::finding, std::string(question.help),
              GoTo{std::string(question.where)}, list.unless_open()});
  list.add({"Select nothing", group::finding, "", Select{},
            list.session.document &&
                    (list.session.document->travel.selected || list.session.document->travel.sized)
                ? ""
                : "Nothing is selected."});
}

void add_comparing(EntryList& list) {
  const Session& session = list.session;
  const bool sweeping = session.document && session.document->sweep;
  const bool pinned = session.document && session.document->pinned;
  list.add({"Let the pinned run go", group::changes, "", Unpin{}, pinned ? "" : "No run is pinned."});
  list.add({"Sweep a parameter...", group::changes, "Runs the whole pipeline for each of many values.",
            ActionPrompt{"Sweep", "epsilon=0.02:0.09:100", read_sweep}, list.unless_open()});
  list.add({"Cancel the sweep", group::changes, "", CancelSweep{}, sweeping ? "" : "No sweep is under way."});
  list.add({"Take the value of a sweep's run...", group::changes,
            "The runs count from 1, in the order of the values.",
            ActionPrompt{"Run", "1",
                         [](const Session& /*session*/, const std::string& typed) -> Read {
                           const auto run = whole_number<std::size_t>(typed);
                           if (!run || *run == 0)
                             return "A run is a whole number from 1 on, not " + quoted(typed) + ".";
                           return TakeSweepValue{*run - 1};
                         }},
            sweeping ? "" : "There is no sweep."});
}

}  // namespace

void add_run_entries(EntryList& list) {
  list.add({"Go to step...", group::the_run, "By its number, as the timeline counts.",
            ActionPrompt{"Step", "10", read_step}, list.unless_open()});
  list.add({"Go to row...", group::the_run, "To its end, in the current stage.",
            ActionPrompt{"Row", "2", read_row}, list.unless_open()});
  list.add({"Go to place...", group::the_run, "A stage, a row in it, an item in that.",
            ActionPrompt{"Place", "rows:5:12", read_place}, list.unless_open()});
  add_stages(list);
  list.add({"Set the speed to...", group::the_run, "Of playing, in steps a second.",
            ActionPrompt{"Steps a second", "60", read_speed}});
  list.add(
      {"Cancel long work", group::the_run, "Back to how it was before the change that asked for it.",
       CancelWork{},
       list.session.jobs->run.long_step || list.session.jobs->opening ? "" : "No long work is under way."});
  add_things(list);
  add_breaks(list);
  add_comparing(list);
}

// Entries about parameters: each can be set by its name, each choice is an entry, and changes from here on.

namespace {

using Read = std::variant<Action, std::string>;

std::optional<std::string> fault_in(const Session& session, const knit::Parameters& changed) {
  return knit::fault_of(changed, session.document->timeline.input());
}

Read tuned(const Session& session, const knit::ParameterInfo& info, const std::string& typed) {
  knit::Parameters changed = session.document->timeline.parameters();
  if (const auto error = knit::set_value(info, changed, typed)) return without_dashes(*error);
  if (const auto fault = fault_in(session, changed)) return without_dashes(*fault);
  return Tune{changed};
}

Read edited(const Session& session, const std::string& typed) {
  auto read = read_parameters_text(typed, session.document->timeline.parameters());
  if (const auto* error = std::get_if<std::string>(&read)) return *error;
  const auto& changed = std::get<knit::Parameters>(read);
  if (const auto fault = fault_in(session, changed)) return without_dashes(*fault);
  return EditFromHere{changed};
}

// "Set epsilon to..."; a direction's label is a sentence's beginning already.
std::string asking_for(const knit::ParameterInfo& info) {
  std::string name(info.label);
  if (std::holds_alternative<knit::DirectionChoice>(info.kind)) return name + "...";
  if (name[0] >= 'A' && name[0] <= 'Z') name[0] = static_cast<char>(name[0] - 'A' + 'a');
  return "Set " + name + " to...";
}

// Why it is of no use to set it now.
std::string why_not(const EntryList& list, const knit::ParameterInfo& info) {
  if (!list.session.document) return list.unless_open();
  return knit::is_read(info, list.session.document->timeline.parameters())
             ? ""
             : "With the parameters as they are nothing reads it.";
}

void add_choices(EntryList& list, const knit::ParameterInfo& info, const knit::Choice& choice) {
  const Session& session = list.session;
  for (std::size_t i = 0; i < choice.names.size(); ++i) {
    knit::Parameters changed =
        session.document ? session.document->timeline.parameters() : knit::Parameters();
    const bool now = session.document && choice.get(changed) == static_cast<int>(i);
    choice.set(changed, static_cast<int>(i));
    const std::string unused = why_not(list, info);
    list.add({std::string(info.label) + ": " + std::string(choice.names[i]), group::parameters,
              std::string(info.help), Tune{changed}, unused.empty() && now ? "It is so already." : unused, "",
              true});
  }
}

void add_parameter(EntryList& list, const knit::ParameterInfo& info) {
  if (const auto* choice = std::get_if<knit::Choice>(&info.kind)) return add_choices(list, info, *choice);
  const Session& session = list.session;
  const std::string now =
      knit::value_text(info, session.document ? session.document->timeline.parameters() : knit::Parameters());
  list.add({asking_for(info), group::parameters, std::string(info.help),
            ActionPrompt{std::string(info.label), now,
                         [&info](const Session& asked, const std::string& typed) {
                           return tuned(asked, info, typed);
                         }},
            why_not(list, info)});
}

// Picking in the view, instead of typing a number.
void add_picking(EntryList& list) {
  const bool picking = list.session.view->gaze.picking != Picking::nothing;
  list.add({"Pick the start vertex in the view", group::parameters, "Then click it; the time is 0 there.",
            SetPicking{Picking::start}, list.unless_open()});
  list.add({"Pick the end vertex in the view", group::parameters, "Then click it; the time is 1 there.",
            SetPicking{Picking::end}, list.unless_open()});
  list.add({"Pick nothing", group::parameters, "", SetPicking{Picking::nothing},
            picking ? "" : "Nothing is being picked."});
  list.add({"Pick vertex number...", group::parameters, "Instead of a click in the view.",
            ActionPrompt{"Vertex", "12",
                         [](const Session& session, const std::string& typed) -> Read {
                           const std::size_t count = session.document->timeline.input().mesh.positions.size();
                           const auto vertex = whole_number<knit::VertexId>(typed);
                           if (vertex && *vertex < count) return PickVertex{*vertex};
                           return "A vertex is a whole number from 0 to " + std::to_string(count - 1) +
                                  ", not \"" + typed + "\".";
                         }},
            picking ? list.unless_open() : "Nothing is being picked."});
}

void add_edits(EntryList& list) {
  const std::size_t edits = list.session.document ? list.session.document->timeline.edits().size() : 0;
  list.add({"Change a parameter from here on...", group::parameters,
            "What is past stays as it is; the rest is run again.",
            ActionPrompt{"From here on", "epsilon = 0.05", edited}, list.unless_open()});
  list.add({"Take back the last change on the way", group::parameters, "",
            RemoveEdit{edits > 0 ? edits - 1 : 0}, edits > 0 ? "" : "There is no change on the way."});
}

}  // namespace

void add_parameter_entries(EntryList& list) {
  for (const Preset& preset : presets()) {
    list.add({"Take the preset: " + std::string(preset.title), group::parameters, std::string(preset.about),
              ApplyPreset{std::string(preset.key)}, list.unless_open()});
  }
  for (const knit::ParameterInfo& info : knit::parameter_table()) add_parameter(list, info);
  add_picking(list);
  add_edits(list);
}

// Entries about learning: lessons, guessing, and every word of the glossary.

namespace {

using Read = std::variant<Action, std::string>;

void add_lessons(EntryList& list, const ActionSources& sources) {
  for (const ActionSources::Lesson& lesson : sources.lessons) {
    list.add({"Lesson: " + lesson.title, group::learning, "", StartLesson{lesson.key}});
  }
  const std::string none = list.session.learning->lesson ? "" : "No lesson is under way.";
  list.add({"Next page of the lesson", group::learning, "", TurnLesson{1}, none});
  list.add({"Page before in the lesson", group::learning, "", TurnLesson{-1}, none});
  list.add({"Answer the lesson's question...", group::learning, "",
            ActionPrompt{"Answer", "12",
                         [](const Session& /*session*/, const std::string& typed) -> Read {
                           if (typed.empty()) return "Give an answer.";
                           return AnswerLesson{typed};
                         }},
            none});
  list.add({"Leave the lesson", group::learning, "", LeaveLesson{}, none});
}

void add_guessing(EntryList& list) {
  const bool on = list.session.learning->prediction != nullptr;
  list.add({"Guess before each verdict: on or off", group::learning,
            "Predict mode: playing pauses before each verdict, and you say what it will be.",
            SetPredicting{!on}, list.unless_open()});
}

}  // namespace

void add_learning_entries(EntryList& list, const ActionSources& sources) {
  add_lessons(list, sources);
  add_guessing(list);
  for (const Term& term : glossary()) {
    const std::string word(term.word);
    list.add({"What is meant by: " + word, group::the_glossary, "", ShowGlossary{true, word}, "", "", true});
  }
}

}  // namespace app
