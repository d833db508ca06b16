// knit-mesh: how a 3D mesh becomes something to knit by hand, step by step.

#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "app/actions/hosting.h"
#include "app/script/command_line.h"
#include "app/script/pieces.h"
#include "app/session/document.h"
#include "app/window/run.h"
#include "knit/model/bug.h"

namespace {

std::filesystem::path folder_of_program(const char* as_called) {
  std::error_code error;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
  return (error ? std::filesystem::absolute(as_called) : self).parent_path();
}

int say(const std::string& error) {
  std::fprintf(stderr, "knit-mesh: %s\n", error.c_str());
  return app::exit_usage;
}

int open_and_run(app::Session& session, const app::CommandLine& line) {
  if (const auto error = app::open_as_asked(session, line)) return say(*error);
  return line.headless ? app::run_headless(session, line) : app::run_window(session, line);
}

// The worst exit code of all pieces.
int run_each_piece(app::Session& session, const app::CommandLine& line) {
  const auto lines = app::lines_of_pieces(line);
  if (const auto* error = std::get_if<std::string>(&lines)) return say(*error);
  const auto& pieces = std::get<std::vector<app::CommandLine>>(lines);
  const std::filesystem::path assets = session.program->assets;
  int code = app::exit_done;
  for (const app::CommandLine& piece : pieces) {
    session = app::new_session(assets);
    code = std::max(code, open_and_run(session, piece));
  }
  if (const auto error = app::join_patterns(line, pieces)) code = say(*error);
  return code;
}

int run(const std::vector<std::string>& arguments, app::Session& session) {
  const auto parsed = app::parse_command_line(arguments, session.program->assets);
  if (const auto* answer = std::get_if<app::Answer>(&parsed)) {
    std::fputs(answer->out.c_str(), stdout);
    if (!answer->error.empty()) std::fprintf(stderr, "knit-mesh: %s\n", answer->error.c_str());
    return answer->exit_code;
  }
  const auto& line = std::get<app::CommandLine>(parsed);
  return line.every_piece ? run_each_piece(session, line) : open_and_run(session, line);
}

// A bug's message ends with the command line that leads back to the place.
void report_bug(const knit::Bug& bug, const std::vector<std::string>& arguments,
                const app::Session& session) {
  std::string command = "knit-mesh";
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    // Where it was asked to stop gives way to where it did.
    if (arguments[i] == "--at")
      ++i;
    else if (!arguments[i].starts_with("--at="))
      command += " '" + arguments[i] + "'";
  }
  if (session.document) command += " --at " + std::to_string(session.document->timeline.position());
  std::fprintf(stderr, "knit-mesh: this is a bug: %s. It happened at: %s\n", bug.what(), command.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  app::Session session;
  try {
    session = app::new_session(folder_of_program(argv[0]) / "assets");
    return run(arguments, session);
  } catch (const knit::Bug& bug) {
    report_bug(bug, arguments, session);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "knit-mesh: %s\n", error.what());
  }
  return 3;
}
