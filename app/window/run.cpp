#include "app/window/run.h"

#include <cstdio>

#include "app/core/export.h"
#include "app/core/pattern_file.h"
#include "app/core/work_beside.h"
#include "app/window/frame.h"
#include "knit/narrate.h"

namespace app {

namespace {

void say(const std::string& line) { std::fprintf(stderr, "knit-mesh: %s\n", line.c_str()); }

std::optional<std::string> save_picture(Session& session, const CommandLine& line,
                                        const std::filesystem::path& path) {
  session.timeline->extend_to_end();  // so that the timeline in the picture is whole
  if (session.side == SidePanel::report) session.closeness = closeness_now(session);
  auto picture = picture_of(session, line.width, line.height);
  if (auto* error = std::get_if<std::string>(&picture)) return std::move(*error);
  return save_png(path.string(), std::get<Image>(picture));
}

// A page is worth having without its picture too.
std::optional<std::string> save_page(const Session& session, const std::filesystem::path& path) {
  const auto picture = finished_picture_of(session, page_picture_px);
  if (const auto* trouble = std::get_if<std::string>(&picture)) {
    say(*trouble + " The page is written without a picture.");
    return export_pattern(session, path);
  }
  return export_pattern(session, path, png_bytes(std::get<Image>(picture)));
}

std::optional<std::string> save(Session& session, const CommandLine& line, const Export& wish) {
  if (wish.kind == ExportKind::picture) return save_picture(session, line, wish.path);
  const bool page = wish.kind == ExportKind::pattern && pattern_format_of(wish.path) == PatternFormat::html;
  return page && !pattern_missing(session) ? save_page(session, wish.path)
                                           : export_to_file(session, wish.kind, wish.path);
}

}  // namespace

int run_headless(Session& session, const CommandLine& line) {
  for (const Notice& notice : session.notices) say(notice.text);
  session.notices.clear();
  if (const auto nearest = go_to(session, line.at.value_or(At(AtEnd{})))) say(*nearest);
  const knit::Step* stop = stop_shown(session);
  if (stop != nullptr) say(knit::narrate(*stop, session.timeline->parameters()));

  bool all_saved = true;
  for (const Export& wish : line.saves) {
    const auto error = save(session, line, wish);
    if (error) say(*error);
    all_saved = all_saved && !error;
  }
  if (!all_saved) return exit_usage;
  return stop != nullptr ? exit_stopped : exit_done;
}

}  // namespace app
