// A graphics driver that loses its window, for a test: loaded before GLFW, it answers for the reset status instead.
// The window is lost while a file "lose-once" or "lose-always" lies in the folder the program runs in. Each window
// adds a line to "windows" there and takes "lose-once" away.
#include <dlfcn.h>

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

using Function = void (*)();

namespace {

constexpr unsigned int unknown_context_reset = 0x8255;

unsigned int reset_status() {
  const bool lost = std::filesystem::exists("lose-once") || std::filesystem::exists("lose-always");
  return lost ? unknown_context_reset : 0;
}

}  // namespace

extern "C" int glfwExtensionSupported(const char* extension);
extern "C" Function glfwGetProcAddress(const char* name);

extern "C" int glfwExtensionSupported(const char* extension) {
  if (std::strcmp(extension, "GL_KHR_robustness") == 0) return 1;
  const auto real = reinterpret_cast<int (*)(const char*)>(dlsym(RTLD_NEXT, "glfwExtensionSupported"));
  return real(extension);
}

extern "C" Function glfwGetProcAddress(const char* name) {
  if (std::strcmp(name, "glGetGraphicsResetStatusKHR") == 0) {
    std::ofstream("windows", std::ios::app) << "a window\n";
    std::remove("lose-once");
    return reinterpret_cast<Function>(reset_status);
  }
  const auto real = reinterpret_cast<Function (*)(const char*)>(dlsym(RTLD_NEXT, "glfwGetProcAddress"));
  return real(name);
}
