// What pages of lessons do as they open, and how it is seen that what they wait for was done.
#include <algorithm>
#include <array>
#include <numbers>

#include "app/lessons/lesson.h"
#include "app/session/document.h"
#include "app/session/outbox.h"
#include "app/session/run_figures.h"
#include "app/session/view.h"
#include "knit/model/settings_table.h"

namespace app {

namespace {

// --- deeds -------------------------------------------------------------------------------------------------

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

// What is written and shown of the program itself stays.
void look_as_at_first(View& view) {
  View first;
  first.aspect = view.aspect;
  first.pattern = std::move(view.pattern);
  first.dialogs = std::move(view.dialogs);
  view = std::move(first);
}

struct DoDeed {
  Session& session;

  // What is open already keeps its run where its parameters are its own; everything else is as at the start.
  void operator()(const OpenAsItComes& deed) const {
    const Document* open = session.document ? &*session.document : nullptr;
    if (open == nullptr || open->source.example != deed.example ||
        open->timeline.base_parameters().mesh.weld != open->defaults.mesh.weld)
      apply(session, OpenExample{deed.example});
    // What could not be opened has said so.
    if (!session.document || session.document->source.example != deed.example) return;
    Document& document = *session.document;
    const Knobs wanted{document.defaults, {}};
    if (knobs_of(document.timeline) != wanted) document.timeline.set_knobs(wanted.base, wanted.edits);
    document.before_change.reset();
    document.travel = {};
    document.place_note.clear();
    session.outbox->notices.clear();
    look_as_at_first(*session.view);
    apply(session, Unpin{});
    apply(session, SetPredicting{false});
    (*this)(LookFrom{});
  }
  void operator()(const SetParameters& deed) const {
    if (!session.document) return;
    knit::Parameters parameters = session.document->timeline.parameters();
    knit::set_values(deed.settings, parameters);
    apply(session, Tune{parameters});
  }
  void operator()(const SeekAt& deed) const {
    if (session.document) go_to(session, deed.at);
  }
  void operator()(const LookFrom& deed) const {
    if (!session.document) return;
    const knit::Input& input = session.document->timeline.input();
    Camera camera;
    camera.yaw = radians(deed.yaw);
    camera.pitch = radians(deed.pitch);
    camera.frame(input.bounds, session.view->aspect);
    camera.distance /= deed.near;
    if (deed.at && *deed.at < input.mesh.positions.size()) camera.target = input.mesh.positions[*deed.at];
    session.view->gaze.camera = camera;
    session.view->gaze.camera_kept = true;
  }
  void operator()(const Action& action) const { apply(session, action); }
};

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
    progress.problems = tally_of(timeline).problems;
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

void do_deed(Session& session, const Deed& deed) { std::visit(DoDeed{session}, deed); }

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
