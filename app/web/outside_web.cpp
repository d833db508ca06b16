// Files in a page: what is written is kept by the browser or offered as a download, what is wanted is asked for.
#include "app/base/outside.h"

#include <emscripten.h>

// clang-format off
EM_JS(void, page_written, (const char* path), { Module.knit.written(UTF8ToString(path)); });
EM_JS(void, page_wanted, (), { Module.knit.wanted(); });
// clang-format on

namespace app {

void tell_written(const std::filesystem::path& path) {
  std::error_code error;
  const auto whole = std::filesystem::absolute(path, error);
  page_written((error ? path : whole).c_str());
}

bool tell_wanted() {
  page_wanted();
  return true;
}

}  // namespace app
