// Work beside the loop in a page, which has one thread: at once, or some milliseconds of it between two frames.
#include "app/base/beside.h"

#include <emscripten.h>

#include <memory>
#include <utility>

namespace app {

namespace {

using Piece = std::function<bool()>;
constexpr double slice_ms = 12.0;

void go_on(void* pieces) {
  std::unique_ptr<Piece> piece(static_cast<Piece*>(pieces));
  const double until = emscripten_get_now() + slice_ms;
  do {
    if (!(*piece)()) return;
  } while (emscripten_get_now() < until);
  emscripten_async_call(go_on, piece.release(), 1);
}

}  // namespace

void start_beside(std::function<void()> work) { work(); }

void start_in_pieces(Piece piece) {
  emscripten_async_call(go_on, std::make_unique<Piece>(std::move(piece)).release(), 1);
}

unsigned hands_beside() { return 1; }

}  // namespace app
