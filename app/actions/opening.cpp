#include "app/actions/opening.h"

#include <new>
#include <system_error>
#include <utility>

#include "app/actions/apply_parts.h"
#include "app/actions/hosting.h"
#include "app/actions/navigate.h"
#include "app/files/load.h"
#include "app/files/session_file.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/outbox.h"
#include "app/session/program.h"

namespace app {

namespace fs = std::filesystem;

namespace {

bool is_large(const fs::path& path) {
  std::error_code error;
  const std::uintmax_t size = fs::is_regular_file(path, error) ? fs::file_size(path, error) : 0;
  return !error && size > opened_at_once_bytes;
}

// Made anew in less than a frame on a slow machine.
constexpr std::size_t made_at_once_triangles = 20000;

template <class Read>
Opening::Result read_or_say(const fs::path& path, const Read& read) {
  try {
    return std::visit([](auto&& what) { return Opening::Result(std::forward<decltype(what)>(what)); },
                      read());
  } catch (const std::bad_alloc&) {
    return path.string() + " does not fit into memory. Reduce the mesh and open it again.";
  }
}

Opening begun(const fs::path& path) {
  Opening opening;
  opening.path = path;
  opening.progress = std::make_shared<knit::Progress>();
  opening.start = std::chrono::steady_clock::now();
  return opening;
}

void begin(Session& session, Opening opening) {
  cancel_opening(session);
  session.jobs->opening = std::make_shared<Opening>(std::move(opening));
}

}  // namespace

bool is_long_to_open(const fs::path& path, bool is_session) {
  if (is_large(path) || !is_session) return is_large(path);
  const auto saved = read_saved_run(path);
  const auto* run = std::get_if<SavedRun>(&saved);
  return run != nullptr && is_large(run->source.file);
}

void begin_opening_mesh(Session& session, const OpenFile& file) {
  Opening opening = begun(file.path);
  opening.repairs = file.repairs;
  opening.work = Work<Opening::Result>([file, progress = opening.progress] {
    return read_or_say(file.path,
                       [&] { return open_mesh(file.path, file.repairs, progress.get(), file.curves); });
  });
  begin(session, std::move(opening));
}

void begin_opening_session(Session& session, const fs::path& path) {
  Opening opening = begun(path);
  opening.work = Work<Opening::Result>([assets = session.program->assets, path, progress = opening.progress] {
    return read_or_say(path, [&] { return read_session(assets, path, progress.get()); });
  });
  begin(session, std::move(opening));
}

void begin_opening_rescued(Session& session) {
  begin_opening_session(session, session.program->rescued->path);
  session.jobs->opening->rescued = true;
}

std::optional<Made> made_for(Session& session, const Action& again, const MakeWish& wish) {
  if (session.jobs->made_mesh && session.jobs->made_mesh->what_for == wish.what_for)
    return session.jobs->made_mesh->made;
  if (!session.jobs->beside || wish.triangles < made_at_once_triangles) return wish.make(nullptr);
  Opening opening = begun(wish.path);
  opening.again = again;
  opening.work = Work<Opening::Result>([wish, progress = opening.progress]() -> Opening::Result {
    progress->begin(knit::Progress::Task::checking);
    try {
      return MadeMesh{wish.what_for, wish.make(progress.get())};
    } catch (const std::bad_alloc&) {
      return MadeMesh{wish.what_for, "The mesh does not fit into memory a second time. Reduce it."};
    }
  });
  begin(session, std::move(opening));
  return std::nullopt;
}

std::optional<Made> made_with(Session& session, const Action& again, const knit::Parameters& parameters,
                              const std::vector<knit::Cycle>& curves) {
  const auto mesh = session.document->original;
  const fs::path path = session.document->source.file.empty() ? fs::path(session.document->source.example)
                                                              : session.document->source.file;
  return made_for(session, again,
                  {path,
                   {mesh, parameters.mesh.weld, curves, curves.empty() ? 0.0 : parameters.stitch.width},
                   mesh->triangles.size(),
                   [mesh, parameters, curves](knit::Progress* progress) {
                     return load_again(mesh, parameters, progress, curves);
                   }});
}

void give_up_making(Session& session) {
  if (session.jobs->opening && session.jobs->opening->again) cancel_opening(session);
}

void tend_opening(Session& session, double seconds) {
  if (!session.jobs->opening) return;
  session.jobs->opening->seconds += seconds;
  if (!session.jobs->opening->work.ready()) return;
  const std::shared_ptr<Opening> done = std::exchange(session.jobs->opening, nullptr);
  Opening::Result result = done->work.take();
  if (auto* made = std::get_if<MadeMesh>(&result)) {
    session.jobs->made_mesh = std::make_shared<const MadeMesh>(std::move(*made));
    apply(session, *done->again);
    session.jobs->made_mesh.reset();
    return;
  }
  forget_place(session);  // it was one of the other mesh
  if (auto* loaded = std::get_if<Loaded>(&result)) {
    show_opened(session, std::move(*loaded), done->path, done->repairs, done->start);
  } else if (auto* unfit = std::get_if<NotOpened>(&result)) {
    show_opened(session, std::move(*unfit), done->path, done->repairs, done->start);
  } else if (auto* opened = std::get_if<OpenedSession>(&result)) {
    take_opened(session, std::move(*opened), done->start, done->rescued);
  } else {
    notify(session, Notice::Kind::error, std::get<std::string>(std::move(result)));
    if (!done->rescued) note_not_opened(session, {{}, done->path, {}});
  }
}

void cancel_opening(Session& session) {
  if (!session.jobs->opening) return;
  session.jobs->opening->progress->stop();
  session.jobs->opening.reset();
}

std::string words_of(const Opening& opening) {
  const std::string name = opening.path.filename().string();
  switch (opening.progress->task()) {
    case knit::Progress::Task::reading:
      return "Reading " + name;
    case knit::Progress::Task::checking:
      return "Checking " + name;
    case knit::Progress::Task::preparing:
      return "Preparing " + name;
  }
  return "Opening " + name;
}

}  // namespace app
