// Entries about the run: going to a place in it, why things are there, breaks, comparing and sweeping.
#include <array>
#include <cstdint>

#include "app/core/action_entries_parts.h"
#include "app/core/command_line.h"
#include "app/core/why_words.h"
#include "app/core/words.h"

namespace app {

namespace {

using Read = std::variant<Action, std::string>;

constexpr const char* the_run = "The run";
constexpr const char* finding = "Finding why";
constexpr const char* changes = "Changes";

std::string quoted(const std::string& typed) { return "\"" + typed + "\""; }

Read read_step(const Session& session, const std::string& typed) {
  const auto step = whole_number<std::size_t>(typed);
  if (!step) return "A step is a whole number, not " + quoted(typed) + ".";
  const knit::Timeline& timeline = *session.timeline;
  if (timeline.complete() && *step > timeline.known())
    return "The run has only " + std::to_string(timeline.known()) + " steps.";
  return SeekTo{*step};
}

// The same stage's end of the row, where the stage has rows.
Read read_row(const Session& session, const std::string& typed) {
  const auto row = whole_number<std::int32_t>(typed);
  if (!row || *row < 1) return "A row is a whole number from 1 on, not " + quoted(typed) + ".";
  const knit::Timeline& timeline = *session.timeline;
  const auto rows = static_cast<std::int32_t>(timeline.furthest().rows.size());
  if (timeline.complete() && *row > rows) return "The run has only " + std::to_string(rows) + " rows.";
  const knit::Stage at = timeline.state().stage();
  const bool by_rows = at > knit::Stage::rows && at<knit::Stage::done&& * row> 1;
  return SeekPlace{{by_rows ? at : knit::Stage::rows, *row, INT32_MAX}};
}

Read read_place(const Session& /*session*/, const std::string& typed) {
  const auto at = parse_at(typed);
  if (!at)
    return quoted(typed) + " is no place; give STAGE, STAGE:ROW, STAGE:ROW:ITEM, a step's number or end.";
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
  auto conditions = session.travel.breaks;
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
std::variant<knit::Thing, std::string> read_thing(const Session& session, const std::string& typed) {
  const auto vertex = whole_number<knit::VertexId>(typed);
  const auto thing = vertex ? std::optional<knit::Thing>(knit::VertexThing{*vertex}) : thing_named(typed);
  if (!thing) {
    return quoted(typed) +
           " is no thing; give stitch:ROW:ITEM, edge:ROW:ITEM, column:ROW:ITEM, face:ROW:ITEM, "
           "label:ROW:ITEM or "
           "a vertex's number.";
  }
  const auto* mesh_vertex = std::get_if<knit::VertexThing>(&*thing);
  const std::size_t count = session.timeline->input().mesh.positions.size();
  if (mesh_vertex != nullptr && mesh_vertex->vertex >= count)
    return "The mesh has only " + std::to_string(count) + " vertices, counted from 0.";
  if (mesh_vertex == nullptr && !knit::exists(session.timeline->furthest(), *thing))
    return "The run has no " + words_of(*thing) + ", or not yet.";
  return *thing;
}

template <class Wish>
Read read_about(const Session& session, const std::string& typed) {
  auto thing = read_thing(session, typed);
  if (const auto* error = std::get_if<std::string>(&thing)) return *error;
  return Wish{std::get<knit::Thing>(thing)};
}

void add_stages(EntryList& list) {
  for (const knit::Stage stage : knit::machine_stages) {
    const std::string name(knit::name_of(stage));
    list.add({"Go to the beginning of " + name, the_run, "", SeekPlace{{stage, -1, 0}}, list.unless_open(),
              "", true});
    list.add({"Go to the end of " + name, the_run, "", SeekPlace{{stage, INT32_MAX, INT32_MAX}},
              list.unless_open(), "", true});
  }
}

void add_breaks(EntryList& list) {
  const bool none = list.session.travel.breaks.empty();
  list.add(
      {"Break when...", finding,
       "Playing stops there: row=14, stage=rows, stall, gap, over-double, grows>4, label=m1l, wider>1.3...",
       ActionPrompt{"Break when", "row=14", read_break}, list.unless_open()});
  list.add({"Forget all break conditions", finding, "", SetBreaks{{}}, none ? "There is none." : ""});
}

void add_things(EntryList& list) {
  list.add({"Select vertex...", finding,
            "Lights it in the view; the keys J and Shift+J go to the steps about it.",
            ActionPrompt{"Vertex", "12", read_about<Select>}, list.unless_open()});
  list.add({"Select stitch or face...", finding,
            "Also edge, column, face and label, or a vertex: lights it in the view, the chart and the lists.",
            ActionPrompt{"Thing", "stitch:2:0", read_about<Select>}, list.unless_open()});
  list.add({"Why is it there...", finding,
            "Goes to the step that made it, or decided on it; a number alone is a vertex.",
            ActionPrompt{"Thing", "stitch:2:0", read_about<ShowWhy>}, list.unless_open()});
  list.add(
      {"Select nothing", finding, "", Select{}, list.session.travel.selected ? "" : "Nothing is selected."});
}

void add_comparing(EntryList& list) {
  const Session& session = list.session;
  const bool sweeping = session.sweep.has_value();
  list.add({"Let the pinned run go", changes, "", Unpin{}, session.pinned ? "" : "No run is pinned."});
  list.add({"Sweep a parameter...", changes, "Runs the whole pipeline for each of many values.",
            ActionPrompt{"Sweep", "epsilon=0.02:0.09:100", read_sweep}, list.unless_open()});
  list.add({"Cancel the sweep", changes, "", CancelSweep{}, sweeping ? "" : "No sweep is under way."});
  list.add({"Take the value of a sweep's run...", changes,
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
  list.add({"Go to step...", the_run, "By its number, as the timeline counts.",
            ActionPrompt{"Step", "10", read_step}, list.unless_open()});
  list.add({"Go to row...", the_run, "To its end, in the stage at hand.", ActionPrompt{"Row", "2", read_row},
            list.unless_open()});
  list.add({"Go to place...", the_run, "A stage, a row in it, an item in that.",
            ActionPrompt{"Place", "rows:5:12", read_place}, list.unless_open()});
  add_stages(list);
  list.add({"Set the speed to...", the_run, "Of playing, in steps a second.",
            ActionPrompt{"Steps a second", "60", read_speed}});
  list.add({"Cancel long work", the_run, "Back to how it was before the change that asked for it.",
            CancelWork{},
            list.session.long_step || list.session.opening ? "" : "No long work is under way."});
  add_things(list);
  add_breaks(list);
  add_comparing(list);
}

}  // namespace app
