#include "app/explain/pseudo_code.h"

#include <algorithm>
#include <array>

#include "app/session/document.h"
#include "knit/relax/relax_code.h"
#include "knit/rows/row_code.h"
#include "knit/settle/settle_code.h"
#include "knit/short_rows/short_row_code.h"
#include "knit/stitches/stitch_code.h"
#include "knit/timing/timing_code.h"
#include "knit/tubes/tubes_code.h"

namespace app {

namespace {

constexpr std::array all_listings{
    &knit::linear_code,        &knit::arc_length_code,   &knit::geodesic_code,     &knit::harmonic_code,
    &knit::timing_choice_code, &knit::rows_choice_code,  &knit::tubes_code,        &knit::cast_on_code,
    &knit::ring_code,          &knit::contour_code,      &knit::thesis_index_code, &knit::even_index_code,
    &knit::nearest_index_code, &knit::repeat_index_code, &knit::faces_code,        &knit::settle_code,
    &knit::relax_code,         &knit::pattern_code,      &knit::short_rows_code};

constexpr std::array<std::string_view, 6> keywords{"for", "each", "if", "else", "not", "write"};

const PseudoCode& listing_at(knit::Stage stage, const knit::Parameters& parameters) {
  const auto at = std::find_if(all_listings.begin(), all_listings.end(), [&](const PseudoCode* code) {
    return code->tells_of(stage) && code->chosen(parameters);
  });
  return at != all_listings.end() ? **at : *all_listings.front();
}

// From the first line that the event was to the last.
std::optional<LinesRun> run_in(const PseudoCode& code, const knit::AnyEvent& event) {
  std::optional<LinesRun> run;
  for (std::size_t line = 0; line < code.lines.size(); ++line) {
    if (code.lines[line].lit(event)) run = LinesRun{run ? run->first : line, line};
  }
  return run;
}

bool is_word(char c) { return c >= 'a' && c <= 'z'; }

// Keywords of a stretch without variables.
void add_words(std::string_view text, std::vector<CodePart>& parts) {
  std::size_t from = 0;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() && is_word(text[end])) ++end;
    const std::string_view word = text.substr(at, end - at);
    if (std::find(keywords.begin(), keywords.end(), word) != keywords.end()) {
      if (at > from) parts.push_back({CodePart::Kind::plain, text.substr(from, at - from)});
      parts.push_back({CodePart::Kind::keyword, word});
      from = end;
    }
    at = std::max(end, at + 1);
  }
  if (from < text.size()) parts.push_back({CodePart::Kind::plain, text.substr(from)});
}

}  // namespace

std::span<const PseudoCode* const> listings() { return all_listings; }

const PseudoCode& listing_of(const knit::Step& step, const knit::Parameters& parameters) {
  const knit::AnyEvent event = knit::any_event(step);
  const PseudoCode& chosen = listing_at(step.place.stage, parameters);
  if (run_in(chosen, event)) return chosen;
  const auto other = std::find_if(all_listings.begin(), all_listings.end(), [&](const PseudoCode* code) {
    return code->tells_of(step.place.stage) && run_in(*code, event);
  });
  return other != all_listings.end() ? **other : chosen;
}

LinesRun lines_of(const knit::Step& step, const knit::Parameters& parameters) {
  return run_in(listing_of(step, parameters), knit::any_event(step)).value_or(LinesRun{});
}

std::size_t line_of(const knit::Step& step, const knit::Parameters& parameters) {
  return lines_of(step, parameters).last;
}

std::vector<CodePart> parts_of(const CodeLine& line) {
  std::vector<CodePart> parts;
  std::string_view rest = line.text;
  const auto* variable = line.variables.begin();
  while (!rest.empty()) {
    const std::size_t open = std::min(rest.find("{}"), rest.size());
    add_words(rest.substr(0, open), parts);
    if (open == rest.size()) break;
    parts.push_back({CodePart::Kind::variable, (*variable)->symbol, *variable});
    ++variable;
    rest.remove_prefix(open + 2);
  }
  return parts;
}

std::string shown_text(const CodeLine& line) {
  std::string text;
  for (const CodePart& part : parts_of(line)) text += part.text;
  return text;
}

std::vector<const knit::CodeVariable*> variables_in(const PseudoCode& code) {
  std::vector<const knit::CodeVariable*> variables;
  const auto add = [&](const knit::CodeVariable* variable) {
    const bool there = std::find(variables.begin(), variables.end(), variable) != variables.end();
    if (variable != nullptr && !there) variables.push_back(variable);
  };
  for (const CodeLine& line : code.lines) {
    for (const knit::CodeVariable* variable : line.variables) add(variable);
    add(line.value);
  }
  for (const knit::CodeVariable* variable : code.aside) add(variable);
  return variables;
}

std::optional<Explained> explained(const Session& session) {
  if (!session.document) return std::nullopt;
  const knit::Timeline& timeline = session.document->timeline;
  Explained at;
  const knit::Step* stop = stop_shown(session);
  at.stopped = stop != nullptr;
  at.step = at.stopped ? stop : last_step(session);
  if (at.step == nullptr) {
    at.code = &listing_at(timeline.state().stage(), as_chosen(timeline.parameters(), timeline.state()));
    return at;
  }
  const knit::Parameters& given =
      at.stopped ? timeline.parameters_of_stop() : timeline.parameters_of_step(timeline.position() - 1);
  const knit::Parameters parameters = as_chosen(given, timeline.state());
  at.code = &listing_of(*at.step, parameters);
  at.lines = lines_of(*at.step, parameters);
  return at;
}

}  // namespace app
