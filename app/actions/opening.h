// A large file on its way to be open: read, checked and prepared by a worker, while what is open stays as it is.
//
// Without a window, and for what is read in the blink of an eye, opening is done at once. A new opening takes the
// place of one under way. Likewise what makes a large mesh anew: welding it otherwise, repairing it.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/base/worker.h"
#include "app/files/session_file.h"
#include "app/session/action.h"
#include "knit/import/progress.h"

namespace app {

// A mesh made from another, or one sentence why not.
using Made = std::variant<Loaded, std::string>;

// What it is made for.
struct MadeFor {
  std::shared_ptr<const void> from;  // a mesh, a plan of repairs
  knit::Weld weld = knit::Weld::off;
  std::vector<knit::Cycle> curves;
  double width = 0.0;  // of a stitch, where curves may depend on it
  friend bool operator==(const MadeFor&, const MadeFor&) = default;
};

struct MadeMesh {
  MadeFor what_for;
  Made made;
};

struct Opening {
  using Result = std::variant<Loaded, NotOpened, OpenedSession, std::string, MadeMesh>;
  std::filesystem::path path;   // as asked for
  knit::RepairWish repairs;     // likewise
  bool rescued = false;         // it is the session that was saved aside before a crash
  std::optional<Action> again;  // done once more when what it asked for is ready
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
void begin_opening_mesh(Session& session, const OpenFile& file);
void begin_opening_session(Session& session, const std::filesystem::path& path);
// As begin_opening_session, for the session offered after a crash. Requires one.
void begin_opening_rescued(Session& session);

// What an action needs made of `from`, a mesh of so many triangles. Nothing: it is large and this is a window, so a
// worker makes it; then `again`, the same action, is done once more and has it. Changing parameters meanwhile gives
// it up.
struct MakeWish {
  std::filesystem::path path;  // what the mesh is called while it is made
  MadeFor what_for;
  std::size_t triangles = 0;
  std::function<Made(knit::Progress*)> make;
};
std::optional<Made> made_for(Session& session, const Action& again, const MakeWish& wish);
// Of the open mesh, welded as the parameters say and cut along the curves.
std::optional<Made> made_with(Session& session, const Action& again, const knit::Parameters& parameters,
                              const std::vector<knit::Cycle>& curves);
void give_up_making(Session& session);

// The clock's tick: shows what has become ready, or says why not.
void tend_opening(Session& session, double seconds);
// What is under way is given up, and nothing of it kept. Nothing happens when nothing is.
void cancel_opening(Session& session);

// "Reading big.obj": what the worker is at.
std::string words_of(const Opening& opening);

}  // namespace app
