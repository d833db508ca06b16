// A large file on its way to be open: read, checked and prepared by a worker, while what is open stays as it is.
//
// Without a window, and for what is read in the blink of an eye, opening is done at once. A new opening takes the
// place of one under way.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <variant>

#include "app/core/opened_session.h"
#include "app/core/worker.h"
#include "knit/progress.h"

namespace app {

struct Opening {
  using Result = std::variant<Loaded, NotOpened, OpenedSession, std::string>;
  std::filesystem::path path;  // as asked for
  knit::MendWish mends;        // likewise
  bool rescued = false;        // it is the session that was saved aside before a crash
  std::shared_ptr<knit::Progress> progress;
  Work<Result> work;
  double seconds = 0.0;  // since it began
  std::chrono::steady_clock::time_point start;
};

// Files below are opened at once: it takes less time than a frame on a slow machine.
inline constexpr std::uintmax_t opened_at_once_bytes = 512 * 1024;

// Whether the file at `path`, or the mesh of the session there, is worth a worker. A file that cannot be reached
// is not: the sentence about it is there at once.
bool is_long_to_open(const std::filesystem::path& path, bool is_session);

// Gives the work to a worker; `tend_opening` takes what comes of it.
void begin_opening_mesh(Session& session, const std::filesystem::path& path, const knit::MendWish& mends);
void begin_opening_session(Session& session, const std::filesystem::path& path);
// As begin_opening_session, for the session offered after a crash. Requires one.
void begin_opening_rescued(Session& session);
// The clock's tick: shows what has become ready, or says why not.
void tend_opening(Session& session, double seconds);
// What is under way is given up, and nothing of it kept. Nothing happens when nothing is.
void cancel_opening(Session& session);

// "Reading big.obj": what the worker is at.
std::string words_of(const Opening& opening);

}  // namespace app
