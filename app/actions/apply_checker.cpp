// A written pattern that is checked: typed, pasted, opened. It is checked at once where that takes less than a part of a
// frame; else, in a window, by a worker on a copy, one at a time, and what was typed meanwhile is checked next.
#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <utility>

#include "app/actions/apply_parts.h"
#include "app/actions/hosting.h"
#include "app/base/files.h"
#include "app/checker/checked_shape.h"
#include "app/session/jobs.h"
#include "app/session/outbox.h"
#include "app/session/view.h"

namespace app {

namespace {

constexpr std::size_t checked_at_once_bytes = 50'000;
constexpr std::uintmax_t largest_pattern_bytes = 16 * 1024 * 1024;

Checker checker_of(const Session& session) {
  return session.view->checker ? *session.view->checker : Checker{};
}

void keep(Session& session, Checker checker) {
  session.view->checker = std::make_shared<const Checker>(std::move(checker));
}

void frame_shape(Checker& checker, double aspect) {
  const knit::CheckedSize* size = checker.shown();
  if (size == nullptr) return;
  const CheckedShape shape = shape_of(*size, checker.gauge);
  if (shape.pieces.empty()) return;
  checker.camera.frame(shape.bounds, aspect);
  checker.moved = false;
}

// The size that was looked at stays, and so does the view where it was moved; else it has all of the shape as this grows.
void show_checked(const Session& session, Checker& checker,
                  std::shared_ptr<const knit::CheckedPattern> checked, SharedText text) {
  checker.checked = std::move(checked);
  checker.checked_text = std::move(text);
  checker.size = std::min(checker.size, std::max<std::size_t>(1, checker.checked->sizes.size()) - 1);
  if (!checker.moved) frame_shape(checker, session.view->aspect);
}

std::shared_ptr<const knit::CheckedPattern> checked_now(const std::string& text) {
  return std::make_shared<const knit::CheckedPattern>(knit::check_pattern(text));
}

void begin_check(Session& session, const SharedText& text) {
  session.jobs->pattern_check.emplace(PatternCheck{
      text, Work<std::shared_ptr<const knit::CheckedPattern>>([text] { return checked_now(*text); })});
}

void check(Session& session, Checker& checker) {
  if (!session.jobs->beside || checker.text->size() <= checked_at_once_bytes)
    return show_checked(session, checker, checked_now(*checker.text), checker.text);
  if (!session.jobs->pattern_check) begin_check(session, checker.text);
}

// In place of all: seen from its beginning, and framed anew.
void replace_text(Session& session, Checker& checker, SharedText text) {
  if (*text == *checker.text) return;
  if (!checker.text->empty()) checker.before = checker.text;
  checker.text = std::move(text);
  checker.caret = {};
  checker.size = 0;
  checker.moved = false;
  check(session, checker);
}

std::variant<std::string, SharedText> read_pattern_file(const std::filesystem::path& path) {
  const auto refused = [&](const std::string& why) {
    return path.string() + " cannot be read: " + why + ".";
  };
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return refused("it does not exist");
  if (std::filesystem::is_directory(path, error)) return refused("it is a folder");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (!error && size > largest_pattern_bytes) return refused("it is larger than 16 MB, which no pattern is");
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (!in.is_open() || in.bad())
    return refused(errno != 0 ? std::strerror(errno) : "it could not be read whole");
  if (text.find('\0') != std::string::npos) return refused("it is no text");
  return std::make_shared<const std::string>(std::move(text));
}

}  // namespace

void take(Session& session, const ShowChecker& action) {
  if (action.open && !session.view->checker) {
    Checker begun;
    check(session, begun);
    keep(session, std::move(begun));
  }
  session.view->checking = action.open;
  session.view->presenting = session.view->presenting && !action.open;
}

void take(Session& session, const CheckFile& action) {
  auto read = read_pattern_file(action.path);
  if (auto* error = std::get_if<std::string>(&read))
    return notify(session, Notice::Kind::error, std::move(*error));
  Checker checker = checker_of(session);
  SharedText text = std::get<SharedText>(std::move(read));
  checker.path = action.path;
  checker.saved = text;
  replace_text(session, checker, std::move(text));
  if (checker.checked == nullptr) check(session, checker);  // it is empty, as what stood there
  keep(session, std::move(checker));
  session.view->checking = true;
  session.view->presenting = false;
  session.view->dialogs.open_dialog_open = false;
}

void take(Session& session, const SetCheckedText& action) {
  Checker checker = checker_of(session);
  auto text = std::make_shared<const std::string>(action.text);
  if (action.whole) {
    replace_text(session, checker, std::move(text));
    if (checker.checked == nullptr) check(session, checker);
    session.view->checking = true;
    session.view->presenting = false;
  } else if (*text != *checker.text) {
    checker.text = std::move(text);
    check(session, checker);
  }
  keep(session, std::move(checker));
}

void take(Session& session, const RestoreCheckedText& /*action*/) {
  if (!session.view->checker || session.view->checker->before == nullptr) return;
  Checker checker = checker_of(session);
  replace_text(session, checker, checker.before);
  keep(session, std::move(checker));
}

void take(Session& session, const SaveCheckedText& action) {
  if (!session.view->checker) return;
  Checker checker = checker_of(session);
  if (const auto error = write_file(action.path, *checker.text))
    return notify(session, Notice::Kind::error, *error);
  checker.path = action.path;
  checker.saved = checker.text;
  keep(session, std::move(checker));
  notify(session, Notice::Kind::info, "Saved " + action.path.string() + ".");
}

void take(Session& session, const GoToCheckedLine& action) {
  if (!session.view->checker) return;
  Checker checker = checker_of(session);
  const auto starts = line_starts(*checker.text);
  const TextCaret asked{std::clamp<std::size_t>(action.line, 1, starts.size()), action.at, action.length};
  const std::size_t from = byte_of(starts, checker.text->size(), asked);
  checker.caret = caret_at(starts, from);
  checker.caret.length = std::min(asked.length, checker.text->size() - from);
  keep(session, std::move(checker));
}

void take(Session& session, const ToMistake& action) {
  if (!session.view->checker) return;
  const knit::CheckedSize* size = session.view->checker->shown();
  if (size == nullptr) return;
  if (const auto* mistake = mistake_from(*size, session.view->checker->caret.line, action.direction)) {
    const TextCaret mark = mark_of(*session.view->checker, *mistake);
    return take(session, GoToCheckedLine{mark.line, mark.at, mark.length});
  }
  notify(session, Notice::Kind::info, "No line has a mistake.");
}

void take(Session& session, const ShowCheckedSize& action) {
  if (!session.view->checker || !session.view->checker->checked) return;
  Checker checker = checker_of(session);
  if (action.index >= checker.checked->sizes.size() || action.index == checker.size) return;
  checker.size = action.index;
  frame_shape(checker, session.view->aspect);
  keep(session, std::move(checker));
}

void take(Session& session, const SetCheckedGauge& action) {
  const auto possible = [](double count) {
    return std::isfinite(count) && count >= least_gauge && count <= most_gauge;
  };
  if (!possible(action.stitches) || !possible(action.rows))
    return notify(session, Notice::Kind::error,
                  "The preview's gauge is from 1 to 200 stitches and rows on 10 cm.");
  Checker checker = checker_of(session);
  checker.gauge = {action.stitches, action.rows};
  frame_shape(checker, session.view->aspect);
  keep(session, std::move(checker));
}

void tend_checker(Session& session) {
  if (!session.jobs->pattern_check || !session.jobs->pattern_check->work.ready()) return;
  PatternCheck done = std::move(*session.jobs->pattern_check);
  session.jobs->pattern_check.reset();
  auto checked = done.work.take();
  if (!session.view->checker) return;
  Checker checker = checker_of(session);
  if (checker.up_to_date()) return;  // it has become short meanwhile
  show_checked(session, checker, std::move(checked), done.text);
  if (!checker.up_to_date()) check(session, checker);
  keep(session, std::move(checker));
}

bool turn_checker(Session& session, const Action& action) {
  if (!session.view->checking || !session.view->checker) return false;
  Checker checker = checker_of(session);
  const double aspect = session.view->aspect;
  if (const auto* orbit = action.get_if<Orbit>()) {
    checker.camera.orbit(orbit->yaw, orbit->pitch);
  } else if (const auto* pan = action.get_if<Pan>()) {
    checker.camera.pan(pan->move, aspect);
    checker.moved = true;
  } else if (const auto* zoom = action.get_if<Zoom>()) {
    if (zoom->factor > 0.0) checker.camera.zoom(zoom->factor, zoom->cursor, aspect);
    checker.moved = true;
  } else if (action.is<FrameAll>()) {
    frame_shape(checker, aspect);
  } else {
    return false;
  }
  keep(session, std::move(checker));
  return true;
}

}  // namespace app
