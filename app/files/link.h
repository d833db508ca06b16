// The command line that opens exactly this state.
#pragma once

#include <optional>
#include <string>

#include "app/session/session.h"

namespace app {

// One word of a shell's command line, quoted where the shell would take it apart.
std::string shell_quoted(const std::string& word);

// Mesh, parameters, place and what is shown, as options; none while there are edits, breaks or a pinned run,
// which options cannot say, or nothing is open. The camera and the layers are not in it.
std::optional<std::string> link_by_options(const Session& session);
// By the session file, if one says exactly what the session is now.
std::optional<std::string> link_by_session(const Session& session);

}  // namespace app
