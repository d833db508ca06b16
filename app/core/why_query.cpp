#include "app/core/action.h"
#include "app/core/queries.h"
#include "app/core/step_table.h"
#include "app/core/why_words.h"
#include "knit/narrate.h"

namespace app {

namespace {

std::string place_text(const knit::Place& place) {
  return std::string(knit::name_of(place.stage)) + ":" + std::to_string(place.row) + ":" +
         std::to_string(place.item);
}

// A step: its number and place, its sentence, its numbers one a line.
std::string step_text(const knit::Timeline& timeline, const std::string& what, std::size_t index) {
  const knit::Step& step = timeline.step(index);
  std::string text = what + "\tstep " + std::to_string(index + 1) + "\t" + place_text(step.place) + "\t" +
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

std::string vertex_text(const knit::Timeline& timeline, const knit::VertexThing& thing) {
  const knit::VertexStory story = knit::story_of(timeline, thing.vertex);
  std::string text;
  for (const std::size_t step : story.measured) text += step_text(timeline, "measured", step);
  const bool among = !story.measured.empty() && story.decided == story.measured.back();
  if (story.decided && !among) text += step_text(timeline, "decided", *story.decided);
  return text;
}

std::string stitch_text(const knit::Timeline& timeline, const knit::StitchThing& stitch, std::size_t made) {
  std::string text;
  if (const auto chosen = knit::chosen_by(timeline, stitch)) text += step_text(timeline, "chosen", *chosen);
  text += step_text(timeline, "made", made);
  if (const auto moved = knit::moved_by(timeline, stitch)) text += step_text(timeline, "moved", *moved);
  return text;
}

}  // namespace

std::optional<std::string> fault_of_why(const std::string& thing) {
  if (thing_named(thing)) return std::nullopt;
  return "--why cannot be \"" + thing +
         "\"; give stitch:ROW:ITEM, edge:ROW:ITEM, column:ROW:ITEM, face:ROW:ITEM, label:ROW:ITEM or "
         "vertex:ID, rows from 1 and items from 0.";
}

Answer why_answer(Session& session, const std::string& thing) {
  const auto asked = thing_named(thing);
  if (!asked || !session.timeline) return {exit_usage, "", "nothing can be said about \"" + thing + "\"."};
  session.timeline->extend_to_end();
  const knit::Timeline& timeline = *session.timeline;
  const auto* vertex = std::get_if<knit::VertexThing>(&*asked);
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
  if (const auto* stitch = std::get_if<knit::StitchThing>(&*asked))
    return {exit_done, text + stitch_text(timeline, *stitch, *made), ""};
  return {exit_done, text + step_text(timeline, "made", *made), ""};
}

}  // namespace app
