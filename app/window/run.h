// The program's two ways to run: in a window, and without one.
#pragma once

#include "app/script/command_line.h"

namespace app {

// Messages go to standard error, one line each. Both return the exit code.
int run_headless(Session& session, const CommandLine& line);

// What the command line asks to be saved is written when the window is closed, as things then are.
int run_window(Session& session, const CommandLine& line);

}  // namespace app
