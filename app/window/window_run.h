// A session in a window, turn by turn: who has a loop calls turn() in it, a page calls it for every frame. A window that
// the driver loses is opened again.
#pragma once

#include <memory>
#include <string_view>

#include "app/script/command_line.h"

namespace app {

struct Box;

class WindowRun {
 public:
  // Both outlive it.
  WindowRun(Session& session, const CommandLine& line);
  WindowRun(const WindowRun&) = delete;
  WindowRun& operator=(const WindowRun&) = delete;
  ~WindowRun();

  // Takes what hands and keyboard did, does it and draws; waits where nothing happens. False: it has ended, and all that
  // the command line wants saved at the end is saved.
  bool turn();
  // Where a control stood in the last frame, in window units; null: it is not there.
  [[nodiscard]] const Box* place_of(std::string_view control) const;
  [[nodiscard]] int code() const;  // the exit code, once it has ended

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace app
