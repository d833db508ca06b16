// What the world outside is told about files. A page has no folder that a person sees: what is written there is
// offered as a download, or kept by the browser, and what is wanted is asked for by its picker. Elsewhere nothing is to do.
#pragma once

#include <filesystem>

namespace app {

// A whole file stands there now.
void tell_written(const std::filesystem::path& path);

// A person wants to open a file. True: it is asked for outside and comes as one dropped; no list is to be shown.
bool tell_wanted();

}  // namespace app
