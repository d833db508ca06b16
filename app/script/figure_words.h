// The command line's part about pictures and animations.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/script/command_line.h"

namespace CLI {
class App;
}

namespace app {

struct FigureWords {
  std::string picture, animation;
  std::string from, to, frames, rate;
  bool alone = false, transparent = false;
};

void declare_figures(CLI::App& app, FigureWords& words);

// After the size has been read. A sentence where something cannot be.
std::optional<std::string> read_figures(const FigureWords& words, bool size_given, CommandLine& line);

// The stretch that --from and --to ask for; the session stays where it is. `notes`: a sentence for each that
// the run does not have.
struct AskedStretch {
  Stretch stretch;
  std::vector<std::string> notes;
};
AskedStretch asked_stretch(Session& session, const CommandLine& line);

}  // namespace app
