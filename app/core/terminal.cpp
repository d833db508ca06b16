#include "app/core/terminal.h"

#include <unistd.h>

namespace app {

bool error_is_terminal() { return ::isatty(STDERR_FILENO) == 1; }

}  // namespace app
