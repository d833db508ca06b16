#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "app/actions/apply_parts.h"
#include "app/actions/background_work.h"
#include "app/actions/framing.h"
#include "app/actions/hosting.h"
#include "app/actions/looking.h"
#include "app/actions/navigate.h"
#include "app/actions/opening.h"
#include "app/actions/playing.h"
#include "app/base/outside.h"
#include "app/facing/step_place.h"
#include "app/files/export.h"
#include "app/files/load.h"
#include "app/files/pattern_export.h"
#include "app/files/preferences_file.h"
#include "app/files/session_file.h"
#include "app/session/action.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/learning.h"
#include "app/session/outbox.h"
#include "app/session/presets.h"
#include "app/session/program.h"
#include "app/session/view.h"
#include "knit/model/settings_table.h"

namespace app {

namespace {

double milliseconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

Document document_of(Loaded loaded, Source source, std::chrono::steady_clock::time_point start) {
  Document document(knit::Timeline(std::move(loaded.input), loaded.parameters));
  document.source = std::move(source);
  document.source.repairs.clear();
  for (const knit::RepairStep& step : loaded.repaired) document.source.repairs.push_back(step.kind);
  document.source.curves = std::move(loaded.curves);
  document.original = std::move(loaded.original);
  document.mesh_hash = std::move(loaded.mesh_hash);
  document.findings = std::move(loaded.findings);
  document.repaired = std::move(loaded.repaired);
  document.defaults = loaded.parameters;
  document.load_ms = milliseconds_since(start);
  return document;
}

bool relaxes(const knit::Parameters& parameters) { return parameters.relax.relaxing == knit::Relaxing::on; }

// One overload an action. Actions about a run do nothing while nothing is open.
struct Apply {
  Session& session;

  [[nodiscard]] bool open() const { return session.document.has_value(); }
  [[nodiscard]] knit::Timeline& timeline() const { return session.document->timeline; }

  void operator()(const OpenExample& a) {
    cancel_opening(session);
    const auto start = std::chrono::steady_clock::now();
    auto loaded = load_example(session.program->assets, a.name);
    if (const auto* error = std::get_if<std::string>(&loaded)) {
      notify(session, Notice::Kind::error, *error);
      session.jobs->repair_offer.reset();
      return;
    }
    show_loaded(session, std::get<Loaded>(std::move(loaded)), {a.name, {}, {}}, start);
  }

  void operator()(const CloseMesh& /*a*/) {
    cancel_opening(session);
    if (session.learning->lesson) app::take(session, LeaveLesson{});
    if (!open()) return;
    show_instead(session, {});
    session.jobs->animation.reset();
    session.learning = Learning{};
  }

  // Does what may work the run out further, and counts the time if it did.
  template <class Work>
  auto counted(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    const std::size_t known = timeline().known();
    const auto result = work();
    if (timeline().known() != known) session.document->run_ms += milliseconds_since(start);
    return result;
  }

  void operator()(const StepBy& a) {
    if (!open()) return;
    session.view->playback.playing = false;
    if (session.jobs->beside && a.direction > 0) {
      counted([&] { return extend_now(steps_of_slice(timeline())); });
      if (const auto place = place_ahead(timeline(), a.unit)) return timeline().await(*place);
    }
    timeline().seek(counted([&] { return position_after(timeline(), a.unit, a.direction); }));
  }
  void operator()(const SeekTo& a) {
    if (!open()) return;
    const std::size_t known = timeline().known();
    // A drag along the track is one jump: it is remembered where it began.
    const bool goes_on = session.document->travel.left_by_seek == timeline().position();
    if (!goes_on && a.position != timeline().position()) remember_place(session);
    if (a.position > known) counted([&] { return extend_now(a.position - known); });
    timeline().seek(a.position);
    session.document->travel.left_by_seek = timeline().position();
  }
  void operator()(const SeekPlace& a) {
    if (!open()) return;
    remember_place(session);
    if (session.jobs->beside) return timeline().await(a.place);
    timeline().seek(counted([&] { return position_at(timeline(), a.place); }));
  }
  bool extend_now(std::size_t steps) {
    return session.jobs->beside ? timeline().extend_briefly(steps) : timeline().extend(steps);
  }
  void operator()(const ToFirst& /*a*/) {
    if (!open()) return;
    remember_place(session);
    timeline().seek(0);
  }
  void operator()(const ToLast& /*a*/) {
    if (!open()) return;
    remember_place(session);
    // In a window the rest follows with the clock's ticks.
    const std::size_t most = std::numeric_limits<std::size_t>::max();
    counted([&] { return extend_now(session.jobs->beside ? steps_of_slice(timeline()) : most); });
    if (timeline().complete()) return timeline().seek(timeline().known());
    timeline().await({knit::Stage::done, 0, 0});
  }
  void operator()(const SetPlaying& a) {
    if (!open()) return;
    const bool at_end = timeline().complete() && timeline().position() == timeline().known();
    // Play at the end begins again, as players do.
    if (a.playing && a.direction > 0 && at_end && !session.view->playback.playing) timeline().seek(0);
    session.view->playback.playing = a.playing;
    session.view->playback.direction = a.direction < 0 ? -1 : 1;
    session.view->playback.owed = 0.0;
  }
  void operator()(const SetSpeed& a) {
    session.view->playback.steps_per_second =
        std::clamp(a.steps_per_second, slowest_steps_per_second, fastest_steps_per_second);
  }

  void operator()(const PassTime& a) {
    fly_on(session, a.seconds);
    if (!open()) return;
    work_beside(session, a.seconds);
    counted([&] { return extend_now(steps_of_slice(timeline())); });
    tend_travel(session);
    // A tuned run that has not come back to its place yet plays on from there, not from where it has got to.
    if (session.view->playback.playing && !timeline().sought()) play(session, a.seconds);
  }

  void operator()(const Tune& a) {
    if (!open()) return;
    if (refuse(a.parameters)) return;
    forget_refused();
    remember_knobs(session);
    note_before_change(session);
    show_as_relaxed(session, relaxes(timeline().parameters()), relaxes(a.parameters));
    if (!made_alike(a.parameters, timeline().parameters(), session.document->source.curves)) {
      reload(a);
    } else {
      tune_run(session, a.parameters);
    }
  }
  // Welding changes the mesh itself, and a stitch's width may change where it is cut: the run begins anew on the other
  // mesh, at the same place. Edits are kept.
  void reload(const Tune& a) {
    const knit::Parameters& parameters = a.parameters;
    const auto result = made_with(session, a, parameters, session.document->source.curves);
    if (!result) return;
    if (const auto* error = std::get_if<std::string>(&*result)) {
      notify(session, Notice::Kind::error, *error);
      return;
    }
    const auto& loaded = std::get<Loaded>(*result);
    if (const auto fault = knit::fault_of(parameters, *loaded.input)) {
      notify(session, Notice::Kind::error, *fault);
      return;
    }
    timeline().change_input(loaded.input, parameters);
  }
  void operator()(const EditFromHere& a) {
    if (!open() || refuse(a.parameters)) return;
    if (auto why = knit::why_not_from_here(timeline().parameters(), a.parameters, timeline().state().next)) {
      notify_refused(std::move(*why));
      return;
    }
    forget_refused();
    remember_knobs(session);
    note_before_change(session);
    show_as_relaxed(session, relaxes(timeline().parameters()), relaxes(a.parameters));
    timeline().edit_from_here(a.parameters);
  }
  void operator()(const ApplyPreset& a) {
    const Preset* preset = find_preset(a.key);
    if (preset == nullptr) {
      notify(session, Notice::Kind::error,
             "There is no preset \"" + a.key + "\"; choose " + preset_keys() + ".");
    } else if (open()) {
      (*this)(Tune{with_preset(*preset, timeline().parameters())});
    }
  }
  void operator()(const CancelWork& /*a*/) {
    if (session.jobs->opening) return cancel_opening(session);
    if (!open() || !session.jobs->run.long_step) return;
    knit::Parameters without = timeline().parameters();
    if (timeline().whole()) {
      without.settle.settling = knit::Settling::off;
    } else {
      without.timing.kind = knit::TimingKind::linear;
    }
    const knit::Parameters back = session.document->before_change.value_or(without);
    session.jobs->run.long_step.reset();
    remember_knobs(session);
    timeline().tune(back);
    // What is cancelled was never done.
    Changes& changes = session.document->changes;
    if (!changes.undo.empty() && changes.undo.back() == change_of(*session.document)) {
      changes.undo.pop_back();
      changes.before.reset();
    }
  }
  bool refuse(const knit::Parameters& wished) {
    const auto fault = knit::fault_of(wished, timeline().input());
    if (fault) notify_refused(*fault);
    return fault.has_value();
  }
  // What was said of refused values goes with the first that are taken.
  void notify_refused(std::string words) {
    notify(session, Notice::Kind::error, std::move(words));
    session.outbox->notices.back().of_values = true;
  }
  void forget_refused() {
    std::erase_if(session.outbox->notices, [](const Notice& notice) { return notice.of_values; });
  }
  void operator()(const RemoveEdit& a) {
    if (!open() || a.index >= timeline().edits().size()) return;
    remember_knobs(session);
    timeline().remove_edit(a.index);
  }
  void operator()(const SetPicking& a) { session.view->gaze.picking = a.picking; }
  void operator()(const PickVertex& a) {
    if (!open() || session.view->gaze.picking == Picking::nothing) return;
    knit::Parameters parameters = timeline().parameters();
    (session.view->gaze.picking == Picking::start ? parameters.timing.start : parameters.timing.end) =
        a.vertex;
    session.view->gaze.picking = Picking::nothing;
    (*this)(Tune{parameters});
  }

  void operator()(const SetLayer& a) { session.view->layers[static_cast<std::size_t>(a.layer)] = a.on; }
  void operator()(const Orbit& a) { session.view->gaze.camera.orbit(a.yaw, a.pitch); }
  void operator()(const Pan& a) { session.view->gaze.camera.pan(a.move, session.view->aspect); }
  void operator()(const Zoom& a) {
    if (a.factor > 0.0) session.view->gaze.camera.zoom(a.factor, a.cursor, session.view->aspect);
  }
  void operator()(const FrameAll& /*a*/) {
    if (open()) frame_all(session);
  }
  void operator()(const SetFollowing& a) { session.view->following = a.on; }
  void operator()(const TurnToStep& a) {
    if (const auto place = step_place(session))
      session.view->gaze.camera = turned_to(session.view->gaze.camera, *place, a.seconds);
  }
  void operator()(const SetAspect& a) {
    if (a.aspect > 0.0 && std::isfinite(a.aspect)) session.view->aspect = a.aspect;
  }

  void operator()(const ShowSide& a) { session.view->side = a.side; }
  void operator()(const ShowList& a) { session.view->list = a.list; }
  void operator()(const SetPositions& a) { session.view->positions = a.positions; }
  void operator()(const SetYarnLook& a) { session.view->yarn = within_limits(a.look); }
  void operator()(const ShowAs& a) { show_as(session, a.looking); }
  void operator()(const Present& a) {
    session.view->presenting = a.on;
    session.view->checking = session.view->checking && !a.on;
  }
  void operator()(const SetRing& a) { session.view->ring = a.on; }

  void operator()(const Export& a) {
    if (!open()) return;
    const ExportInfo* info = find_export(a.what);
    if (info != nullptr && info->write == nullptr) {
      session.outbox->screenshots.push_back(a.path);
      return;
    }
    // A page with a picture of the finished piece is made where pictures are.
    if (wants_picture(a)) {
      session.outbox->pages.push_back(a.path);
      return;
    }
    if (is_worksheet(a)) {
      session.outbox->worksheets.push_back(a.path);
      return;
    }
    if (const auto error = export_to_file(session, a)) {
      notify(session, Notice::Kind::error, *error);
    } else if (a.path != "-") {
      if (info->opens_again) {
        session.document->saved = saved_as(session, a.path);
        note_recent(session.program->preferences, recent_name(a.path));
      }
      notify(session, Notice::Kind::info, "Saved " + a.path.string() + ".");
    }
  }

  void operator()(const SetPatternOptions& a) { session.view->pattern = a.options; }
  void operator()(const ShowCentre& a) { take(session, a); }
  void operator()(const HoverStitch& a) {
    session.view->gaze.hovered_stitch = a.stitch;
    session.view->gaze.hovered_twin_stitches = a.twins;
  }
  void operator()(const HoverRounds& a) {
    session.view->gaze.hovered_rounds = a.rounds;
    session.view->gaze.hovered_twins = a.twins;
  }
  void operator()(const KnitAlong& a) {
    session.view->gaze.knit_along = a.round;
    session.view->gaze.knit_along_deal = a.round ? a.deal : session.view->gaze.knit_along_deal;
    if (a.round) session.view->gaze.knit_along_round = *a.round;
  }
  void operator()(const PointAt& a) { session.learning->pointed_variable = a.variable; }
  void operator()(const ShowActionPalette& a) { session.view->dialogs.action_palette_open = a.open; }
  void operator()(const ShowGoTo& a) { session.view->dialogs.go_to_open = a.open; }
  void operator()(const ShowGlossary& a) {
    session.view->dialogs.glossary_open = a.open;
    session.view->dialogs.glossary_term = a.term;
  }
  void operator()(const ShowHelp& a) { session.view->dialogs.help_open = a.open; }
  void operator()(const ShowOpenDialog& a) {
    session.view->dialogs.open_dialog_open = a.open && !tell_wanted();
  }
  void operator()(const DismissNotice& a) {
    if (a.index < session.outbox->notices.size()) {
      session.outbox->notices.erase(session.outbox->notices.begin() + static_cast<std::ptrdiff_t>(a.index));
    }
  }
  void operator()(const PutNoteAway& /*a*/) {
    if (session.document) session.document->place_note.clear();
  }
  void operator()(const Quit& /*a*/) { session.outbox->quit = true; }

  // The others: apply_parts.h.
  template <class Other>
  void operator()(const Other& other) {
    app::take(session, other);
  }
};

}  // namespace

Part<Document> show_instead(Session& session, Part<Document> document) {
  std::swap(session.document, document);
  session.view->gaze = {};
  session.jobs->run = {};
  session.jobs->flight.reset();
  session.jobs->repair_offer.reset();
  session.outbox->notices.clear();
  stop_playing(session);
  return document;
}

void go_back_to(Session& session, const Session& before) {
  cancel_opening(session);
  const double aspect = session.view->aspect;
  const auto checker = session.view->checker;  // it is no part of what is undone
  show_instead(session, before.document);
  session.view = before.view;
  session.view->aspect = aspect;
  session.view->checker = checker;
  session.jobs->repair_offer = before.jobs->repair_offer;
  session.outbox->notices = before.outbox->notices;
}

void stop_playing(Session& session) {
  session.view->playback = {false, 1, session.view->playback.steps_per_second, 0.0};
}

void apply(Session& session, const Action& action) {
  if (const auto* tick = action.get_if<PassTime>()) {
    tend_opening(session, tick->seconds);
    tend_checker(session);
  }
  if (turn_checker(session, action)) return;
  const Whereabouts before = before_action(session, action);
  const auto framed = framed_whole(session);
  ActionKinds::visit(Apply{session}, action);
  if (framed) frame_again(session, *framed);
  if (session.document && session.document->changes.before) {
    const auto* tune = action.get_if<Tune>();
    const auto* edit = action.get_if<EditFromHere>();
    const bool held = tune != nullptr ? tune->held : edit != nullptr && edit->held;
    note_change(session.document->changes, change_of(*session.document), held);
  }
  after_action(session, before);
  tend_lesson(session, action);
}

Part<Document> show_loaded(Session& session, Loaded loaded, Source source,
                           std::chrono::steady_clock::time_point start) {
  Document document = document_of(std::move(loaded), std::move(source), start);
  if (session.document) document.pinned = session.document->pinned;  // another mesh may be compared with it
  Part<Document> before = show_instead(session, std::move(document));
  session.view->dialogs.open_dialog_open = false;
  session.view->checking = false;  // what was opened is to be seen
  for (const knit::RepairStep& step : session.document->repaired)
    notify(session, Notice::Kind::info, step.did);
  for (const knit::Finding& finding : session.document->findings)
    notify(session, Notice::Kind::warning, finding.sentence);
  frame_all(session);
  note_opened(session);
  return before;
}

}  // namespace app
