// The window's loop where the browser has it: it calls for every frame, and run_window returns at once.
#include <emscripten.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <memory>
#include <utility>

#include "app/panels/kit/layout.h"
#include "app/session/document.h"
#include "app/window/run.h"
#include "app/window/window_run.h"

// clang-format off
EM_JS(void, page_started, (void* run), { Module.knit.started(run); });
EM_JS(void, page_drawn, (), { Module.knit.drawn(); });
EM_JS(void, page_ended, (), { Module.knit.ended(); });
// clang-format on

namespace app {

namespace {

// Whoever calls run_window gives up the session, which goes on living here.
struct PageRun {
  PageRun(Session&& given, const CommandLine& asked)
      : session(std::move(given)), line(asked), run(session, line) {}
  Session session;
  CommandLine line;
  WindowRun run;
};

bool turned(PageRun& page) {
  try {
    return page.run.turn();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "knit-mesh: %s\n", error.what());
    return false;
  }
}

void turn_for_frame(void* page) {
  auto* const run = static_cast<PageRun*>(page);
  if (turned(*run)) return page_drawn();
  emscripten_cancel_main_loop();
  delete run;  // NOLINT(cppcoreguidelines-owning-memory): it came through the browser
  page_ended();
}

}  // namespace

// Where a control stands: its box's corner and size in the canvas's units. 0: nowhere.
extern "C" EMSCRIPTEN_KEEPALIVE int knit_place(void* page, const char* control, float* into) {
  const Box* place = static_cast<PageRun*>(page)->run.place_of(control);
  if (place == nullptr) return 0;
  const std::array<float, 4> box{place->x, place->y, place->width, place->height};
  std::copy(box.begin(), box.end(), into);
  return 1;
}

int run_window(Session& session, const CommandLine& line) {
  auto page = std::make_unique<PageRun>(std::move(session), line);
  page_started(page.get());
  emscripten_set_main_loop_arg(turn_for_frame, page.release(), 0, false);
  return 0;
}

}  // namespace app
