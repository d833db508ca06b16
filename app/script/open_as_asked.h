// What the command line asks of a mesh that is not open yet when the window comes: it is read by a worker, or repairs
// are offered for it first. What was asked waits until it is open, and is dropped when something else is.
#pragma once

#include <filesystem>
#include <memory>

#include "app/script/command_line.h"

namespace app {

struct Opening;  // jobs.h

class AskedAtStart {
 public:
  // After open_as_asked, which has set what could be set.
  explicit AskedAtStart(const Session& session);
  // After each turn of a loop. True once: now the mesh is open, and what the command line sets is set. What is asked
  // about the run (--at, --why, --diff, --sweep) is left to whoever calls.
  bool tend(Session& session, const CommandLine& line);

 private:
  enum class Mesh { pending, open, other };
  [[nodiscard]] Mesh mesh_in(const Session& session) const;
  std::shared_ptr<const Opening> opening_;  // null: not under way
  std::filesystem::path offered_;           // the file that repairs are offered for; empty: none
};

}  // namespace app
