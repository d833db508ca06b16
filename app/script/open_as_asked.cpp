// From a command line to an open session at the place that was asked for.
#include "app/script/open_as_asked.h"

#include <algorithm>
#include <utility>

#include "app/actions/hosting.h"
#include "app/actions/navigate.h"
#include "app/actions/opening.h"
#include "app/base/text.h"
#include "app/checker/checker.h"
#include "app/explain/fit_size.h"
#include "app/files/load.h"
#include "app/lessons/lesson.h"
#include "app/script/command_line.h"
#include "app/script/queries.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/learning.h"
#include "app/session/outbox.h"
#include "app/session/presets.h"
#include "app/session/view.h"
#include "knit/import/check_topology.h"
#include "knit/model/settings_table.h"
#include "knit/model/words.h"
#include "knit/pattern/written_rows.h"

namespace app {

namespace {

// Over the pattern options of a session go those that are given.
knit::PatternOptions with_options(knit::PatternOptions pattern, const knit::PatternOptions& given) {
  if (!given.title.empty()) pattern.title = given.title;
  if (!given.yarn.empty()) pattern.yarn = given.yarn;
  if (!given.colour.empty()) pattern.colour = given.colour;
  if (given.needle_mm) pattern.needle_mm = given.needle_mm;
  pattern.markers = pattern.markers || given.markers;
  pattern.stars = pattern.stars || given.stars;
  if (given.form != knit::PatternForm::by_itself) pattern.form = given.form;
  if (given.turns != knit::ShortRowTurns::usual) pattern.turns = given.turns;
  return pattern;
}

// Over the curves of a session go those that are given.
std::optional<std::string> cut_as_asked(Session& session, const CommandLine& line) {
  if (line.curves.none()) return std::nullopt;
  auto given = curves_for(line.curves, knit::bounds_of(session.document->original->positions));
  if (auto* fault = std::get_if<std::string>(&given)) return std::move(*fault);
  std::vector<knit::Cycle> curves = std::get<0>(std::move(given));
  if (line.curves.file.empty()) {
    curves = session.document->source.curves;
    for (const knit::Cycle& curve : line.curves.curves) curves = with_curve(std::move(curves), curve);
  }
  const std::size_t notices = session.outbox->notices.size();
  apply(session, SetCurves{curves});
  const auto& said = session.outbox->notices;
  for (std::size_t i = notices; i < said.size(); ++i)
    if (said[i].kind == Notice::Kind::error) return said[i].text;
  return std::nullopt;
}

std::optional<std::string> set_parameters(Session& session, const CommandLine& line) {
  if (line.settings.empty() && line.preset.empty()) return std::nullopt;
  knit::Parameters parameters = session.document->timeline.parameters();
  if (const Preset* preset = find_preset(line.preset)) parameters = with_preset(*preset, parameters);
  knit::set_values(line.settings, parameters);
  const std::size_t notices = session.outbox->notices.size();
  apply(session, Tune{parameters});
  if (session.outbox->notices.size() > notices &&
      session.outbox->notices.back().kind == Notice::Kind::error) {
    return session.outbox->notices.back().text;
  }
  return std::nullopt;
}

// The run is worked out for it first. What came of it is told, and what it cannot be done for is a fault.
std::optional<std::string> fit_size(Session& session, const CommandLine& line) {
  if (!line.fit_size) return std::nullopt;
  work_out(session);
  auto fitted = fitted_size(session.document->timeline);
  if (auto* why = std::get_if<std::string>(&fitted)) return "--fit-size: " + *why;
  auto& fit = std::get<FittedSize>(fitted);
  apply(session, Tune{fit.parameters});
  notify(session, Notice::Kind::info, std::move(fit.words));
  return std::nullopt;
}

// Without a window the run is worked out first, so that an order that cannot be worked is refused at once; with one the
// list of pieces says so.
std::optional<std::string> order_pieces(Session& session, const CommandLine& line) {
  if (line.piece_order.empty()) return std::nullopt;
  if (line.headless) work_out(session);
  const std::size_t notices = session.outbox->notices.size();
  apply(session, SetPieceOrder{line.piece_order});
  if (session.outbox->notices.size() == notices) return std::nullopt;
  return "--piece-order: " + session.outbox->notices.back().text;
}

// Likewise a piece that there is not.
std::optional<std::string> show_chart_of(Session& session, const CommandLine& line) {
  if (!line.chart_piece) return std::nullopt;
  if (line.headless) work_out(session);
  const std::size_t notices = session.outbox->notices.size();
  apply(session, ShowCentre{line.centre, line.chart_piece});
  if (session.outbox->notices.size() == notices) return std::nullopt;
  return "--centre: " + session.outbox->notices.back().text;
}

// Leaving it goes back to what else was asked for.
std::optional<std::string> begin_lesson(Session& session, const CommandLine& line) {
  if (line.lesson.empty()) return std::nullopt;
  const std::size_t notices = session.outbox->notices.size();
  apply(session, StartLesson{line.lesson});
  if (!session.learning->lesson)
    return session.outbox->notices.size() > notices ? session.outbox->notices.back().text : "no lesson.";
  return line.lesson_page ? go_to_lesson_page(session, *line.lesson_page) : std::nullopt;
}

// What is wrong, and which options would help.
std::string words_of(const RepairOffer& offer) {
  std::string keys;
  std::string piece;
  std::string effects;
  for (const knit::RepairStep& step : offer.plan->steps) {
    if (const std::size_t number = knit::piece_kept(step.kind))
      piece = " --piece " + std::to_string(number);
    else
      keys += (keys.empty() ? "" : ",") + knit::key_of(step.kind);
    effects += " " + step.would;
  }
  constexpr std::size_t most_told = 12;
  const std::size_t pieces = offer.plan->pieces.size();
  for (std::size_t number = 1; number <= std::min(pieces, most_told); ++number)
    effects += " " + piece_words(*offer.plan, number) + ".";
  if (pieces > most_told)
    effects += " " + knit::plural(static_cast<std::int64_t>(pieces - most_told), "more is", "more are") +
               " smaller.";
  return offer.finding + " Or give" + (keys.empty() ? "" : " --repair " + keys) + piece + "." + effects;
}

// Said before the run meets it somewhere along the way.
void warn_of_handles(Session& session) {
  const knit::Timeline& timeline = session.document->timeline;
  if (timeline.parameters().rows.source != knit::RowSource::rings) return;
  const std::size_t handles = knit::handles_of(timeline.input());
  if (handles == 0) return;
  notify(session, Notice::Kind::warning,
         "The shape has " + std::string(handles == 1 ? "a handle" : std::to_string(handles) + " handles") +
             ", like a ring or a mug, so it is one tube along no axis and no timing, and rows from rings "
             "cannot knit "
             "it. Take rows from contours: --rows contours, or --preset best-rows.");
}

// Only where nothing is asked about the run itself may a window come before a large mesh.
bool opens_beside(const CommandLine& line) {
  const bool may = !line.headless && !line.at && line.lesson.empty() && line.why.empty() &&
                   line.go_to.empty() && line.diff.empty() && !line.ways_on && line.sweep.empty() &&
                   !line.animation;
  if (!may) return false;
  if (!line.session.empty()) return is_long_to_open(line.session, true);
  const auto* file = line.open.get_if<OpenFile>();
  return file != nullptr && is_long_to_open(file->path, false);
}

// The fabric numbers short rows among its rows, so it must be known where there are any.
void knit_along(Session& session, const RoundWords& from) {
  const auto [round, short_row] = from;
  if (!session.document) return apply(session, KnitAlong{round});
  const knit::Timeline& timeline = session.document->timeline;
  const bool shorts = timeline.parameters().short_rows.rows != knit::ShortRows::off;
  if (shorts) work_out(session);
  const knit::WrittenRow called{round + (short_row > 0 ? 1 : 0), short_row};
  const std::int32_t row = shorts ? knit::row_called(timeline.furthest().fabric, called) : 0;
  if (row == 0 && short_row > 0) {
    notify(session, Notice::Kind::warning,
           "--knit-along: round " + std::to_string(round) + " has no short row " + std::to_string(short_row) +
               " on it; beginning with the round.");
  }
  apply(session, KnitAlong{row > 0 ? row : round});
}

void look_as_asked(Session& session, const CommandLine& line) {
  const bool saved = !line.session.empty();
  if (!saved || line.side_given) apply(session, ShowSide{line.side});
  if (line.theme) apply(session, SetTheme{*line.theme});
  if (line.scale) apply(session, SetScale{*line.scale});
  if (line.list) apply(session, ShowList{*line.list});
  if (line.row_columns)
    for (std::size_t i = 0; i < row_column_keys.size(); ++i)
      apply(session, ShowRowColumn{static_cast<RowColumn>(i), line.row_columns->at(i)});
  if (!saved || line.centre_given) apply(session, ShowCentre{line.centre});
  apply(session, SetPatternOptions{with_options(session.view->pattern, line.pattern)});
  if (!line.pattern.piece_names.empty()) apply(session, SetPieceNames{line.pattern.piece_names});
  apply_yarn_wish(session, line.yarn);
  if (line.positions) apply(session, SetPositions{*line.positions});
  if (line.presenting) apply(session, Present{});
  if (line.embedded) embed(session);
  if (!line.point.empty()) apply(session, PointAt{line.point});
  if (line.knit_along) knit_along(session, *line.knit_along);
  if (line.follow) apply(session, SetFollowing{true});
}

}  // namespace

namespace {

// By its name, or by its number.
std::optional<std::size_t> size_named(const Checker& checker, const std::string& name) {
  const auto& sizes = checker.checked->sizes;
  for (std::size_t i = 0; i < sizes.size(); ++i)
    if (sizes[i].name == name) return i;
  const auto number = whole_number<std::size_t>(name);
  return number && *number >= 1 && *number <= sizes.size() ? std::optional(*number - 1) : std::nullopt;
}

std::optional<std::string> check_as_asked(Session& session, const CommandLine& line) {
  if (line.checked.empty()) return std::nullopt;
  apply(session, CheckFile{line.checked});
  if (!session.view->checking) return session.outbox->notices.back().text;
  if (line.checked_gauge) apply(session, *line.checked_gauge);
  if (line.checked_line) apply(session, GoToCheckedLine{*line.checked_line});
  if (line.checked_size.empty()) return std::nullopt;
  const auto size = size_named(*session.view->checker, line.checked_size);
  if (!size) return "check: the pattern has no size \"" + line.checked_size + "\".";
  apply(session, ShowCheckedSize{*size});
  return std::nullopt;
}

}  // namespace

std::optional<std::string> open_as_asked(Session& session, const CommandLine& line) {
  set_beside(session, opens_beside(line));
  if (!line.empty) app::apply(session, line.session.empty() ? line.open : Action(OpenSession{line.session}));
  set_beside(session, false);
  look_as_asked(session, line);
  if (!line.checked.empty()) return check_as_asked(session, line);
  if (session.jobs->opening || line.empty) return std::nullopt;
  if (!session.document && session.jobs->repair_offer)
    return line.headless ? std::optional(words_of(*session.jobs->repair_offer))
                         : std::nullopt;  // a window offers it
  if (!session.document)
    return session.outbox->notices.empty() ? "nothing could be opened." : session.outbox->notices.back().text;
  return set_as_asked(session, line);
}

namespace {

// Pins a run with the values that --beside gives and comes back to the one at hand.
std::optional<std::string> show_beside(Session& session, const CommandLine& line) {
  if (line.beside.empty()) return std::nullopt;
  const knit::Parameters here = session.document->timeline.parameters();
  knit::Parameters there = here;
  knit::set_values(line.beside, there);
  if (auto fault = knit::fault_of(there, session.document->timeline.input())) return "--beside: " + *fault;
  apply(session, Tune{there});
  apply(session, PinRun{});
  apply(session, Tune{here});
  apply(session, ShowBoth{});
  return std::nullopt;
}

}  // namespace

std::optional<std::string> set_as_asked(Session& session, const CommandLine& line) {
  look_as_asked(session, line);  // what was opened brings its own look
  if (!line.breaks.empty()) {
    std::vector<knit::BreakCondition> breaks = session.view->breaks;  // a session file may have some
    for (const knit::BreakCondition& condition : breaks_of(line.breaks)) breaks.push_back(condition);
    apply(session, SetBreaks{std::move(breaks)});
  }
  auto error = cut_as_asked(session, line);
  if (!error) error = set_parameters(session, line);
  if (!error) error = fit_size(session, line);
  if (!error) error = show_beside(session, line);
  if (!error) error = order_pieces(session, line);
  if (!error) error = show_chart_of(session, line);
  if (!error) warn_of_handles(session);
  forget_changes(session);  // what was asked for at the start is where undoing ends
  return error ? error : begin_lesson(session, line);
}

namespace {

std::filesystem::path offered_in(const Session& session) {
  return session.jobs->repair_offer ? session.jobs->repair_offer->source.file : std::filesystem::path();
}

}  // namespace

AskedAtStart::AskedAtStart(const Session& session)
    : opening_(session.jobs->opening),
      offered_(session.document ? std::filesystem::path() : offered_in(session)) {}

AskedAtStart::Mesh AskedAtStart::mesh_in(const Session& session) const {
  if (opening_) {
    if (session.jobs->opening == opening_) return Mesh::pending;
    return session.document && !opening_->progress->stopped() ? Mesh::open : Mesh::other;
  }
  if (offered_in(session) == offered_ || session.jobs->opening) return Mesh::pending;
  return session.document && session.document->source.file == offered_ ? Mesh::open : Mesh::other;
}

bool AskedAtStart::tend(Session& session, const CommandLine& line) {
  if (!opening_ && offered_.empty()) return false;
  const Mesh mesh = mesh_in(session);
  if (mesh == Mesh::pending) return false;
  const auto opening = std::exchange(opening_, nullptr);
  offered_.clear();
  if (mesh == Mesh::other) {
    // Read, and unfit: the offer is the next thing to wait for.
    if (opening && offered_in(session) == opening->path) offered_ = opening->path;
    return false;
  }
  if (auto error = set_as_asked(session, line)) notify(session, Notice::Kind::error, std::move(*error));
  return true;
}

}  // namespace app
