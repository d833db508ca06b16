#include "app/window/run.h"

#include <cstdio>

#include "app/core/export.h"
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

}  // namespace

int run_headless(Session& session, const CommandLine& line) {
  for (const Notice& notice : session.notices) say(notice.text);
  session.notices.clear();
  if (const auto nearest = go_to(session, line.at.value_or(At(AtEnd{})))) say(*nearest);
  const knit::Step* stop = stop_shown(session);
  if (stop != nullptr) say(knit::narrate(*stop, session.timeline->parameters()));

  bool all_saved = true;
  for (const Export& wish : line.saves) {
    const auto error = wish.kind == ExportKind::picture ? save_picture(session, line, wish.path)
                                                        : export_to_file(session, wish.kind, wish.path);
    if (error) say(*error);
    all_saved = all_saved && !error;
  }
  if (!all_saved) return exit_usage;
  return stop != nullptr ? exit_stopped : exit_done;
}

}  // namespace app
