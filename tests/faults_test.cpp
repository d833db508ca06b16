// A program killed in the middle of a save: the old file is whole, and the next save clears away what was left.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <glad/gl.h>

#include <csignal>

#include "app/base/files.h"
#include "app/render/animation_file.h"
#include "app/render/gl_handle.h"
#include "app/render/headless_gl.h"
#include "app/render/renderer.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace app;
using namespace test_support;
namespace fs = std::filesystem;

namespace {

// Does it in a process of its own; what ended it: the signal, or 0.
template <class Deed>
int signal_that_ends(Deed deed) {
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    deed();
    ::_exit(0);
  }
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

// The system kills this process as soon as a file grows beyond a few bytes: in the middle of a write.
void die_while_writing() {
  std::signal(SIGXFSZ, SIG_DFL);
  rlimit tight{};
  ::getrlimit(RLIMIT_FSIZE, &tight);
  tight.rlim_cur = 64;
  ::setrlimit(RLIMIT_FSIZE, &tight);
  rlimit no_core{};
  ::setrlimit(RLIMIT_CORE, &no_core);
}

Image grey() {
  Image image;
  image.width = image.height = 8;
  image.rgba.assign(std::size_t{8} * 8 * 4, 128);
  return image;
}

// While this lives the driver gets no shader's text, so that none compiles.
class NoShaders {
 public:
  NoShaders() : before_(glad_glShaderSource) {
    glad_glShaderSource = [](GLuint, GLsizei, const GLchar* const*, const GLint*) {};
  }
  ~NoShaders() { glad_glShaderSource = before_; }
  NoShaders(const NoShaders&) = delete;
  NoShaders& operator=(const NoShaders&) = delete;

 private:
  PFNGLSHADERSOURCEPROC before_;
};

std::vector<std::uint8_t> bytes_of(const std::string& text) { return {text.begin(), text.end()}; }

}  // namespace

TEST_CASE("faults: a crash in the middle of a save leaves the old file whole, and the next save tidies up") {
  const Folder folder;
  const fs::path path = folder.path() / "ball.json";
  write_text(path, "the old one");
  const int ended_by = signal_that_ends([&] {
    die_while_writing();
    write_file(path, std::string(100000, 'x'));
  });
  CHECK(ended_by == SIGXFSZ);
  CHECK(read_text(path) == "the old one");
  CHECK(folder.files() == 2);  // and half of the new one, aside

  CHECK_FALSE(write_file(folder.path() / "other.json", "another"));
  CHECK(folder.files() == 3);  // not this one's business
  CHECK_FALSE(write_file(path, "the new one"));
  CHECK(read_text(path) == "the new one");
  CHECK(folder.files() == 2);
}

TEST_CASE("faults: killed while a file is written piece by piece") {
  const Folder folder;
  const fs::path path = folder.path() / "film.gif";
  write_text(path, "the old one");
  const int ended_by = signal_that_ends([&] {
    auto file = AsideFile::open(path);
    std::get<AsideFile>(file).write(bytes_of("half of"));
    ::raise(SIGKILL);
  });
  CHECK(ended_by == SIGKILL);
  CHECK(read_text(path) == "the old one");
  CHECK(folder.files() == 2);

  auto file = AsideFile::open(path);
  REQUIRE(std::holds_alternative<AsideFile>(file));
  CHECK(std::get<AsideFile>(file).write(bytes_of("whole")));
  CHECK_FALSE(std::get<AsideFile>(file).finish());
  CHECK(read_text(path) == "whole");
  CHECK(folder.files() == 1);
}

TEST_CASE("faults: killed while numbered pictures are gathered") {
  const Folder folder;
  const fs::path path = folder.path() / "frames";
  fs::create_directory(path);
  write_text(path / "frame_0001.png", "the old one");
  const AnimationShape shape{8, 8, 3, 20.0};
  const int ended_by = signal_that_ends([&] {
    auto frames = open_frame_folder(path, shape);
    std::get<std::unique_ptr<AnimationFile>>(frames)->add(grey());
    ::raise(SIGKILL);
  });
  CHECK(ended_by == SIGKILL);
  CHECK(read_text(path / "frame_0001.png") == "the old one");
  CHECK(folder.files() == 2);

  auto frames = open_frame_folder(path, shape);
  REQUIRE(std::holds_alternative<std::unique_ptr<AnimationFile>>(frames));
  auto& writer = *std::get<std::unique_ptr<AnimationFile>>(frames);
  CHECK_FALSE(writer.add(grey()));
  CHECK_FALSE(writer.finish());
  CHECK(read_text(path / "frame_0001.png").substr(1, 3) == "PNG");
  std::get<std::unique_ptr<AnimationFile>>(frames).reset();
  CHECK(folder.files() == 1);
}

TEST_CASE("faults: what another program still writes is left alone, and so is what only looks like it") {
  const Folder folder;
  const fs::path path = folder.path() / "ball.json";
  const std::string beside = path.string() + ".part-";
  write_text(beside + std::to_string(::getppid()), "in the making");
  for (const char* name : {"x", "", "12a", "-1", "0"}) write_text(beside + name, "mine");
  fs::create_directory(beside + "abc");
  CHECK_FALSE(write_file(path, "new"));
  CHECK(folder.files() == 8);
}

TEST_CASE("faults: a file that somebody has open is replaced, and they keep what they had") {
  const Folder folder;
  const fs::path path = folder.path() / "ball.obj";
  write_text(path, "the old one");
  std::ifstream reader(path);
  CHECK_FALSE(write_file(path, "the new one"));
  std::string seen;
  std::getline(reader, seen);
  CHECK(seen == "the old one");
  CHECK(read_text(path) == "the new one");
}

TEST_CASE("faults: where nobody may write, the sentence says so") {
  // Even who may do everything cannot make files there.
  if (!fs::is_directory("/proc/self")) return;
  const auto error = write_file("/proc/self/ball.json", "new");
  REQUIRE(error);
  CHECK(is_one_sentence(*error));
  CHECK(contains(*error, "/proc/self/ball.json"));
  const auto opened = AsideFile::open("/proc/self/film.gif");
  REQUIRE(std::holds_alternative<std::string>(opened));
  CHECK(is_one_sentence(std::get<std::string>(opened)));
}

TEST_CASE("faults: a shader that does not compile is named") {
  auto context = HeadlessGl::open();
  if (const auto* why = std::get_if<std::string>(&context)) {
    WARN("skipped: " << *why);
    return;
  }
  std::string said;
  try {
    const NoShaders none;
    const Renderer renderer;
  } catch (const GlError& error) {
    said = error.what();
  }
  CHECK(contains(said, "rejects the shader"));
  CHECK(contains(said, ".vert"));
  CHECK_NOTHROW(Renderer());
}
