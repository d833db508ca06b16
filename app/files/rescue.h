// The session saved aside while the program runs, so that it is not lost when the program is.
//
// Each running program has a file of its own, named after its process; at a clean end it is removed. A file whose
// process is gone is what a crash left behind. Where there is no folder to write into, nothing is rescued and
// nothing is said.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "app/session/program.h"
#include "app/session/session.h"

namespace app {

// $XDG_STATE_HOME/knit-mesh, or ~/.local/state/knit-mesh; none where neither is known.
std::optional<std::filesystem::path> rescue_folder();

// A process by its number and when it began, so that a number used again is not taken for it.
struct Process {
  std::int64_t id = 0;
  std::uint64_t began = 0;  // 0: not known
};
Process this_process();
bool is_running(const Process& process);

std::filesystem::path rescue_file(const std::filesystem::path& folder, const Process& process);
// The newest left behind by a process that is gone. Others' files are let be.
std::optional<Rescued> find_rescued(const std::filesystem::path& folder);

// Keeps this process's file up to date.
class RescueKeeper {
 public:
  static constexpr double seconds_between = 3.0;  // writings, at least

  // What the session is now needs no rescue. `folder` none: does nothing, ever.
  RescueKeeper(const Session& session, std::optional<std::filesystem::path> folder);

  // Time has passed; writes when it is due and something worth keeping has changed.
  void pass(const Session& session, double seconds);
  // Writes now. Whether something worth keeping lies aside.
  bool keep(const Session& session);
  // A clean end: nothing is left behind.
  void end();

 private:
  std::optional<std::filesystem::path> file_;
  std::string known_;  // what the file says, or what the session was at first
  double waited_ = 0.0;
  bool written_ = false;
};

}  // namespace app
