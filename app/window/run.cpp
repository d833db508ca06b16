#include "app/window/run.h"

#include <cstdio>

#include "app/actions/hosting.h"
#include "app/actions/navigate.h"
#include "app/base/files.h"
#include "app/files/export.h"
#include "app/render/memory.h"
#include "app/script/figure_words.h"
#include "app/script/queries.h"
#include "app/session/document.h"
#include "app/session/learning.h"
#include "app/session/outbox.h"
#include "app/session/view.h"
#include "app/window/animation.h"
#include "app/window/frame.h"
#include "app/window/worksheet.h"
#include "knit/insight/narrate.h"
#include "knit/insight/problems.h"

namespace app {

namespace {

void say(const std::string& line) { std::fprintf(stderr, "knit-mesh: %s\n", line.c_str()); }

std::optional<std::string> save_picture(Session& session, const CommandLine& line,
                                        const std::filesystem::path& path) {
  make_whole(session);
  auto picture = picture_of(session, line.width, line.height);
  if (auto* error = std::get_if<std::string>(&picture)) return std::move(*error);
  return save_png(path.string(), std::get<Image>(picture));
}

// A page is worth having without its picture too.
std::optional<std::string> save_page(const Session& session, const Export& wish) {
  const auto picture = finished_picture_of(session, page_picture_px);
  if (const auto* trouble = std::get_if<std::string>(&picture)) {
    say(*trouble + " The page is written without a picture.");
    return export_to_file(session, wish);
  }
  return export_to_file(session, wish, png_bytes(std::get<Image>(picture)));
}

std::optional<std::string> save_sheet(const Session& session, const Export& wish) {
  std::string note;
  auto error = save_worksheet_headless(session, wish.path, note);
  if (!note.empty()) say(note);
  return error;
}

std::optional<std::string> missing_for(const Session& session, const Export& wish) {
  const auto missing = find_export(wish.what)->missing;
  return missing != nullptr ? missing(session) : std::nullopt;
}

std::optional<std::string> save(Session& session, const CommandLine& line, const Export& wish) {
  if (find_export(wish.what)->write == nullptr) return save_picture(session, line, wish.path);
  if (is_worksheet(wish)) return save_sheet(session, wish);
  return wants_picture(wish) && !missing_for(session, wish) ? save_page(session, wish)
                                                            : export_to_file(session, wish);
}

void look_at_all(Session& session, const FigureShape& shape) {
  apply(session, SetAspect{view_aspect_of(session, shape)});
  if (!session.view->gaze.camera_kept) apply(session, FrameAll{});
}

std::optional<std::string> save_figure(Session& session, const SavePicture& wish) {
  make_whole(session);
  look_at_all(session, {wish.width, wish.height, wish.panels, wish.transparent});
  return save_figure_headless(session, {wish.path, wish.width, wish.height, wish.panels, wish.transparent});
}

std::optional<std::string> save_animation(Session& session, const CommandLine& line) {
  SaveAnimation wish = *line.animation;
  make_whole(session);
  look_at_all(session, {wish.width, wish.height, wish.panels, false});
  const AskedStretch asked = asked_stretch(session, line);
  for (const std::string& note : asked.notes) say(note);
  wish.stretch = asked.stretch;
  return save_animation_headless(session, wish, error_is_terminal());
}

// What is not there because the run stopped is not the command line's mistake: the exit code speaks of the stop.
bool missing_as_stopped(const Session& session, const Export& wish) {
  return stop_shown(session) != nullptr && missing_for(session, wish);
}

// True when all that is asked for, and is there, has been written.
bool save_all(Session& session, const CommandLine& line) {
  bool all_saved = true;
  const auto note = [&](const std::optional<std::string>& error) {
    if (error) say(*error);
    all_saved = all_saved && !error;
  };
  for (const Export& wish : line.saves) {
    const auto error = save(session, line, wish);
    if (error && missing_as_stopped(session, wish))
      say(*error);
    else
      note(error);
  }
  if (line.picture) note(save_figure(session, *line.picture));
  if (line.animation) note(save_animation(session, line));
  return all_saved;
}

// The first exit code that is not 0, or 0.
int answer_queries(Session& session, const CommandLine& line) {
  int code = exit_done;
  const auto give = [&](const Answer& answer) {
    std::fputs(answer.out.c_str(), stdout);
    if (!answer.error.empty()) say(answer.error);
    if (code == exit_done) code = answer.exit_code;
  };
  if (line.ways_on) give(ways_answer(session));
  if (!line.go_to.empty()) give(go_to_answer(session, line.go_to));
  if (line.explain) give(explain_answer(session));
  if (!line.why.empty()) give(why_answer(session, line.why));
  if (!line.sweep.empty()) give(sweep_answer(session, line.sweep));
  if (!line.diff.empty()) give(diff_answer(session, line.diff));
  return code;
}

// At once, as far as it takes: each turn is judged anew from where it led.
void turn_to_step(Session& session) {
  constexpr int turns = 8;
  constexpr double long_s = 100.0;
  for (int i = 0; i < turns; ++i) apply(session, TurnToStep{long_s});
}

// What no row covers and which are stretched, of the finished run that is shown.
std::optional<std::string> covered_words(const Session& session) {
  if (!session.document || !session.document->timeline.state().finished()) return std::nullopt;
  const knit::Timeline& timeline = session.document->timeline;
  const knit::StitchSize& stitch = timeline.parameters().stitch;
  const auto coverage =
      knit::measure_coverage(timeline.input(), timeline.state(), stitch.width, stitch.height);
  if (!coverage || coverage->uncovered.places.empty()) return std::nullopt;
  return knit::summary_of(*coverage);
}

}  // namespace

int run_headless(Session& session, const CommandLine& line) {
  keep_freed_memory();
  for (const Notice& notice : take_notices(session)) say(notice.text);
  // A session or a lesson brings its own place.
  const bool stays = (!line.session.empty() || session.learning->lesson) && !line.at;
  const At otherwise = line.breaks.empty() ? At(AtEnd{}) : At(std::size_t{0});
  const auto nearest = stays || line.empty ? std::nullopt : go_to(session, line.at.value_or(otherwise));
  if (nearest) say(*nearest);
  select_as_asked(session, line.select);
  const Answer broke = line.breaks.empty() ? Answer{} : break_answer(session);
  if (!broke.error.empty()) say(broke.error);
  if (line.follow) turn_to_step(session);
  const knit::Step* stop = stop_shown(session);
  if (stop != nullptr) say(knit::narrate(*stop, session.document->timeline.parameters()));

  if (const auto words = covered_words(session)) say(*words);

  const int asked = answer_queries(session, line);
  if (!save_all(session, line)) return exit_usage;
  if (asked != exit_done) return asked;
  return stop != nullptr ? exit_stopped : broke.exit_code;
}

}  // namespace app
