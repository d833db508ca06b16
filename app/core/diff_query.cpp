#include "app/core/compare_runs.h"
#include "app/core/load.h"
#include "app/core/queries.h"
#include "app/core/saved_run.h"
#include "knit/gauge.h"

namespace app {

namespace {

std::variant<Loaded, std::string> load_source(const Session& session, const SavedRun& run) {
  const Source& source = run.source;
  auto read = source.file.empty() ? load_example(session.assets, source.example)
                                  : load_file(source.file, source.mends);
  if (std::holds_alternative<std::string>(read)) return read;
  return load_again(std::get<Loaded>(read).original, run.base);
}

}  // namespace

Answer diff_answer(Session& session, const std::filesystem::path& other) {
  const auto read = read_saved_run(other);
  if (const auto* error = std::get_if<std::string>(&read)) return {exit_usage, "", *error};
  const auto& saved = std::get<SavedRun>(read);
  const auto loaded = load_source(session, saved);
  if (const auto* error = std::get_if<std::string>(&loaded)) return {exit_usage, "", *error};
  const auto& input = *std::get<Loaded>(loaded).input;
  const Knobs knobs{knit::agreed(saved.base, input), saved.edits};
  if (const auto fault = knit::fault_of(knobs.base, input.mesh))
    return {exit_usage, "", other.string() + ": " + *fault};
  const RunTally run = whole_run(input, knobs);
  const RunFigures figures = figures_of(run, knobs);

  session.timeline->extend_to_end();
  const RunTally here = tally_of(*session.timeline);
  const Knobs here_knobs = knobs_of(*session.timeline);
  const RunFigures here_figures = figures_of(here, here_knobs);
  const RunDifference difference = difference_of(
      {input, knobs, run.state, figures}, {session.timeline->input(), here_knobs, here.state, here_figures});
  Pin pin;
  pin.input = std::get<Loaded>(loaded).input;
  pin.knobs = knobs;
  pin.end = run.state;
  pin.figures = figures;
  pin.known = true;
  session.pinned = std::move(pin);
  return {exit_done, text_of(difference, other.filename().string(), "this run"), ""};
}

}  // namespace app
