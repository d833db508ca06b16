// An OpenGL context without a window and without a display, for pictures on the command line and for tests.
#pragma once

#include <memory>
#include <string>
#include <variant>

namespace app {

class HeadlessGl {
 public:
  // OpenGL 3.3 core, current on this thread, its functions loaded; or a sentence that says what is missing.
  static std::variant<HeadlessGl, std::string> open();

  HeadlessGl(HeadlessGl&&) noexcept;
  HeadlessGl& operator=(HeadlessGl&&) noexcept;
  ~HeadlessGl();

  // Who draws: "llvmpipe (...)" or a graphics card.
  std::string renderer() const;

 private:
  struct Context;
  explicit HeadlessGl(std::unique_ptr<Context> context);
  std::unique_ptr<Context> context_;
};

}  // namespace app
