#include "app/core/action.h"
#include "app/core/code_variables.h"
#include "app/core/pseudo_code.h"
#include "app/core/queries.h"

namespace app {

namespace {

// '>': the line that just ran; '|': others of the step.
char mark_of(const Explained& at, std::size_t line) {
  if (!at.lines || !at.lines->holds(line)) return ' ';
  return at.lines->last == line ? '>' : '|';
}

std::string place_line(const Explained& at) {
  if (at.step == nullptr) return "start";
  const knit::Place& place = at.step->place;
  return std::string(knit::name_of(place.stage)) + ":" + std::to_string(place.row) + ":" +
         std::to_string(place.item) + (at.stopped ? "\tstopped" : "");
}

std::string padded(std::size_t number) { return (number < 10 ? " " : "") + std::to_string(number); }

}  // namespace

Answer explain_answer(const Session& session) {
  const auto at = explained(session);
  if (!at) return {exit_usage, "", "nothing is open that could be explained."};
  const PseudoCode& code = code_of(at->listing);
  std::string text = place_line(*at) + "\t" + std::string(code.title) + "\n" + sentence(session) + "\n";
  for (std::size_t i = 0; i < code.lines.size(); ++i)
    text += std::string(1, mark_of(*at, i)) + " " + padded(i + 1) + "  " + shown_text(code.lines[i]) + "\n";
  for (const Variable& variable : variables_of(session)) {
    if (variable.value.empty()) continue;
    text += variable.name;
    text += "\t" + std::string(variable.symbol) + "\t" + variable.value + "\t";
    text += variable.meaning;
    text += "\n";
  }
  return {exit_done, text, ""};
}

std::optional<std::string> fault_of_point(const std::string& variable) {
  if (variable.empty() || !variable_named(variable).name.empty()) return std::nullopt;
  return "--point cannot be \"" + variable +
         "\"; give the name of a variable, the first word of its line as --explain prints it.";
}

}  // namespace app
