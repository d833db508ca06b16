// Sessions that tests of the app need, and a folder of their own to write into.
#pragma once

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include "app/session/action.h"
#include "app/session/document.h"
#include "app/session/program.h"
#include "app/session/view.h"
#include "tests/support/run.h"

namespace test_support {

// The small sphere, open and not yet run; with closing copies it has something to weld.
inline app::Session small_session(bool closing_copy = false) {
  app::Session session;
  session.program->assets = KNIT_ASSETS_DIR;
  const auto mesh = std::make_shared<const knit::Mesh>(knit::sphere(40, 16, closing_copy));
  session.document = app::Document(knit::Timeline(knit::make_input(*mesh), small_parameters()));
  session.document->original = mesh;
  session.document->defaults = small_parameters();
  session.view->gaze.camera.frame(session.document->timeline.input().bounds, session.view->aspect);
  return session;
}

inline app::Session finished_small_session() {
  app::Session session = small_session();
  app::apply(session, app::ToLast{});
  return session;
}

// An example as the program opens it.
inline app::Session example_session(const std::string& name) {
  app::Session session;
  session.program->assets = KNIT_ASSETS_DIR;
  app::apply(session, app::OpenExample{name});
  return session;
}

// The torus with rows from its rings: it must stop, because its level sets split.
inline app::Session torus_from_rings() {
  app::Session session = example_session("torus");
  knit::Parameters parameters = session.document->timeline.parameters();
  parameters.rows.source = knit::RowSource::rings;
  parameters.stitches.placement = knit::PlacementPolicy::thesis;
  app::apply(session, app::Tune{parameters});
  return session;
}

// A new folder in the system's place for such, gone with the test.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "knit-mesh-test-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no folder to test in: " + name);
    path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::size_t files() const {
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(path_)) ++count;
    return count;
  }

 private:
  std::filesystem::path path_;
};

inline std::string read_text(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

inline void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// What the program owes a person who got something wrong: one line, and not a bare word.
inline bool is_one_sentence(const std::string& text) {
  return text.size() > 20 && (text.back() == '.' || text.back() == '?') &&
         text.find('\n') == std::string::npos && text.find(' ') != std::string::npos;
}

}  // namespace test_support
