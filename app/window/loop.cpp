// The window's loop where a program has one of its own: turns until it ends.
#include "app/window/run.h"
#include "app/window/window_run.h"

namespace app {

int run_window(Session& session, const CommandLine& line) {
  WindowRun run(session, line);
  while (run.turn()) {
  }
  return run.code();
}

}  // namespace app
