// Pictures in a page: drawn with the window's own context where there is one, else with one of the canvas that nobody
// shows.
#include <emscripten/html5.h>

#include <utility>

#include "app/render/gl.h"
#include "app/render/headless_gl.h"
#include "app/web/page_calls.h"

namespace app {

struct HeadlessGl::Context {
  EMSCRIPTEN_WEBGL_CONTEXT_HANDLE own = 0;  // 0: the window's is current

  Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  ~Context() {
    if (own > 0) emscripten_webgl_destroy_context(own);
  }
};

std::variant<HeadlessGl, std::string> HeadlessGl::open() {
  auto made = std::make_unique<Context>();
  if (emscripten_webgl_get_current_context() == 0) {
    made->own = open_canvas();
    if (made->own <= 0) return std::string(no_webgl);
  }
  return HeadlessGl(std::move(made));
}

HeadlessGl::HeadlessGl(std::unique_ptr<Context> context) : context_(std::move(context)) {}
HeadlessGl::HeadlessGl(HeadlessGl&&) noexcept = default;
HeadlessGl& HeadlessGl::operator=(HeadlessGl&&) noexcept = default;
HeadlessGl::~HeadlessGl() = default;

std::string HeadlessGl::renderer() const {
  const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  return name != nullptr ? name : "";
}

}  // namespace app
