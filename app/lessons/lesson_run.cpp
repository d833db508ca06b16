// How it is seen that what pages of lessons wait for was done.
#include <algorithm>
#include <array>

#include "app/lessons/lesson.h"
#include "app/session/document.h"
#include "app/session/run_figures.h"

namespace app {

namespace {

// --- waits -------------------------------------------------------------------------------------------------

struct DeedName {
  std::string_view name;
  bool (*is)(const Action&);
};
template <class T>
bool is_a(const Action& action) {
  return action.template is<T>();
}
constexpr std::array deed_table{
    DeedName{"orbit", is_a<Orbit>},
    DeedName{"zoom", is_a<Zoom>},
    DeedName{"frame", is_a<FrameAll>},
    DeedName{"play",
             [](const Action& a) {
               const auto* play = a.get_if<SetPlaying>();
               return play != nullptr && play->playing;
             }},
    DeedName{"step", [](const Action& a) { return is_a<StepBy>(a) || is_a<StepDeep>(a); }},
    DeedName{"seek", [](const Action& a) { return is_a<SeekTo>(a) || is_a<SeekPlace>(a); }},
    DeedName{"tune", [](const Action& a) { return is_a<Tune>(a) || is_a<EditFromHere>(a); }},
    DeedName{"undo", is_a<Undo>},
    DeedName{"preset", is_a<ApplyPreset>},
    DeedName{"layer", is_a<SetLayer>},
    DeedName{"show-as", is_a<ShowAs>},
    DeedName{"side", is_a<ShowSide>},
    DeedName{"list", is_a<ShowList>},
    DeedName{"centre", is_a<ShowCentre>},
    DeedName{"why", is_a<ShowWhy>},
    DeedName{"select", [](const Action& a) { return is_a<Select>(a) || is_a<ShowWhy>(a); }},
    DeedName{"break", is_a<RunToBreak>},
    DeedName{"pin", is_a<PinRun>},
    DeedName{"guess", is_a<Guess>},
};

std::size_t count_problems(const knit::Timeline& timeline, PageProgress& progress) {
  const RunKey run = run_key(timeline);
  if (progress.counted_run != run || progress.counted_known != timeline.known()) {
    progress.counted_run = run;
    progress.counted_known = timeline.known();
    progress.problems = tally_of(timeline).problems.total();
  }
  return progress.problems;
}

bool row_size_holds(const Wait& wait, const knit::Timeline& timeline) {
  const knit::Row* row = timeline.furthest().fabric.find_row(wait.row);
  if (row == nullptr) return false;
  const auto size = static_cast<double>(row->stitches.size());
  return size >= wait.low && size <= wait.high;
}

bool number_holds(const Wait& wait, const knit::Parameters& parameters) {
  const auto* number = std::get_if<knit::Number>(&wait.parameter->kind);
  if (number == nullptr) return false;
  const double value = number->get(parameters);
  return value >= wait.low && value <= wait.high;
}

// Of a run that is open.
bool run_holds(const Wait& wait, const knit::Timeline& timeline, PageProgress& progress) {
  const knit::Parameters& parameters = timeline.parameters();
  const std::size_t position = timeline.position();
  switch (wait.kind) {
    case WaitKind::steps:
      return progress.from && position >= *progress.from + static_cast<std::size_t>(wait.count);
    case WaitKind::reach:
      return position > 0 && !timeline.sought() && timeline.place() >= wait.place;
    case WaitKind::range:
      return number_holds(wait, parameters);
    case WaitKind::value:
      return knit::value_text(*wait.parameter, parameters) == wait.word;
    case WaitKind::changed:
      return knit::value_text(*wait.parameter, parameters) != progress.value;
    case WaitKind::problems:
      return timeline.complete() &&
             count_problems(timeline, progress) <= static_cast<std::size_t>(wait.count);
    case WaitKind::stopped:
      return timeline.complete() && (timeline.stop() != nullptr) == wait.flag;
    case WaitKind::row_size:
      return row_size_holds(wait, timeline);
    case WaitKind::at_end:
      return (timeline.complete() && position == timeline.known()) == wait.flag;
    case WaitKind::did:
    case WaitKind::guesses:
      break;
  }
  return false;
}

}  // namespace

bool is_deed_name(const std::string& name) {
  return std::any_of(deed_table.begin(), deed_table.end(), [&](const DeedName& d) { return d.name == name; });
}

std::string deed_names() {
  std::string names;
  for (const DeedName& deed : deed_table) names += (names.empty() ? "" : ", ") + std::string(deed.name);
  return names;
}

bool is_deed(const std::string& name, const Action& action) {
  return std::any_of(deed_table.begin(), deed_table.end(),
                     [&](const DeedName& d) { return d.name == name && d.is(action); });
}

bool holds(const Wait& wait, const Session& session, const Action& action, PageProgress& progress) {
  if (wait.kind == WaitKind::did) return is_deed(wait.word, action);
  if (wait.kind == WaitKind::guesses) {
    if (action.is<Guess>()) ++progress.guesses;
    return progress.guesses >= wait.count;
  }
  return session.document && run_holds(wait, session.document->timeline, progress);
}

}  // namespace app
