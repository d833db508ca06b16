#include "app/render/headless_gl.h"

#if KNIT_HAVE_EGL
#include <EGL/egl.h>
#include <EGL/eglext.h>
#endif

#include <array>
#include <string_view>
#include <utility>

#include "app/render/gl.h"

namespace app {

#if KNIT_HAVE_EGL

struct HeadlessGl::Context {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;

  Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  ~Context() {
    if (display == EGL_NO_DISPLAY) {
      return;
    }
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context != EGL_NO_CONTEXT) {
      eglDestroyContext(display, context);
    }
    eglTerminate(display);
    eglReleaseThread();
  }
};

namespace {

bool lists(const char* extensions, std::string_view wanted) {
  return extensions != nullptr && std::string_view(extensions).find(wanted) != std::string_view::npos;
}

template <class Function>
Function egl_function(const char* name) {
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}

// Mesa draws without any device; other drivers need to be told which.
EGLDisplay find_display() {
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const auto platform_display = egl_function<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  EGLDisplay display = EGL_NO_DISPLAY;
  const auto starts = [&] { return display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr); };
  if (platform_display != nullptr && lists(extensions, "EGL_MESA_platform_surfaceless")) {
    display = platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (starts()) {
      return display;
    }
  }
  const auto query_devices = egl_function<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  if (platform_display != nullptr && query_devices != nullptr &&
      lists(extensions, "EGL_EXT_platform_device")) {
    EGLDeviceEXT device = nullptr;
    EGLint count = 0;
    if (query_devices(1, &device, &count) && count > 0) {
      display = platform_display(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
      if (starts()) {
        return display;
      }
    }
  }
  display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  return starts() ? display : EGL_NO_DISPLAY;
}

EGLContext make_context(EGLDisplay display) {
  constexpr std::array<EGLint, 3> config_wish = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  constexpr std::array<EGLint, 7> context_wish = {EGL_CONTEXT_MAJOR_VERSION,
                                                  3,
                                                  EGL_CONTEXT_MINOR_VERSION,
                                                  3,
                                                  EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                                  EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                                  EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglBindAPI(EGL_OPENGL_API) || !eglChooseConfig(display, config_wish.data(), &config, 1, &count)) {
    return EGL_NO_CONTEXT;
  }
  // Surfaceless displays may have no configuration at all.
  return eglCreateContext(display, count > 0 ? config : EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT,
                          context_wish.data());
}

}  // namespace

std::variant<HeadlessGl, std::string> HeadlessGl::open() {
  auto made = std::make_unique<Context>();
  made->display = find_display();
  if (made->display == EGL_NO_DISPLAY) {
    return "No picture without a display: EGL finds no graphics driver. On Debian install libgl1-mesa-dri.";
  }
  made->context = make_context(made->display);
  if (made->context == EGL_NO_CONTEXT ||
      !eglMakeCurrent(made->display, EGL_NO_SURFACE, EGL_NO_SURFACE, made->context)) {
    return "No picture without a display: the graphics driver offers no OpenGL 3.3. On Debian install "
           "libgl1-mesa-dri.";
  }
  if (gladLoadGL(reinterpret_cast<GLADloadfunc>(eglGetProcAddress)) < GLAD_MAKE_VERSION(3, 3)) {
    return "No picture without a display: the functions of OpenGL 3.3 could not be loaded.";
  }
  return HeadlessGl(std::move(made));
}

#else

struct HeadlessGl::Context {};

std::variant<HeadlessGl, std::string> HeadlessGl::open() {
  return "No picture without a display: this program was built without EGL. On Debian install libegl-dev and "
         "libopengl-dev, and build again.";
}

#endif

HeadlessGl::HeadlessGl(std::unique_ptr<Context> context) : context_(std::move(context)) {}
HeadlessGl::HeadlessGl(HeadlessGl&&) noexcept = default;
HeadlessGl& HeadlessGl::operator=(HeadlessGl&&) noexcept = default;
HeadlessGl::~HeadlessGl() = default;

std::string HeadlessGl::renderer() const {
  const GLubyte* name = glGetString(GL_RENDERER);
  return name != nullptr ? reinterpret_cast<const char*>(name) : "";
}

}  // namespace app
