// The options about the mesh that is opened: its repairs, which piece of it, and the curves that it is cut along.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/script/command_line.h"

namespace CLI {
class App;
}

namespace app {

// As given; empty: not.
struct OpeningWords {
  std::string mesh, repair, piece, curves, curves_scale;
};

void declare_opening_words(CLI::App& app, OpeningWords& words);

// Of the parameters' values (in the table's order) --start and --end may be curves: those are taken out into `line.curves`.
// Where one of the two is a curve, a vertex's number at the other stands for a circle about it. The error is one sentence.
std::optional<std::string> read_curve_words(const OpeningWords& words, std::vector<std::string>& settings,
                                            CommandLine& line);

// After `line.open` and `line.session` are known: repairs, the piece and the curves of a mesh's file go into line.open.
// Curves for an example or a session stay in `line.curves`.
std::optional<std::string> read_opening_words(const OpeningWords& words, bool headless, CommandLine& line);

}  // namespace app
