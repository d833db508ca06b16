// A mesh in several pieces, knitted one after the other: `--piece all`.
//
// Each piece is a command line of its own, which differs in the piece and in the names of what is written: out.obj
// becomes out-1.obj, out-2.obj. Standard output has them one after the other. A pattern as text or Markdown is one
// file in the end, with a heading a piece. Pieces are counted as in knit/import/repair.h.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/script/command_line.h"

namespace app {

// What opens that piece, with the other repairs that are wished.
OpenFile of_piece(OpenFile open, std::size_t number);

// More are hardly meant: the faces do not hang together.
inline constexpr std::size_t most_pieces_knitted = 64;

// Requires line.every_piece. The error is one sentence.
std::variant<std::vector<CommandLine>, std::string> lines_of_pieces(const CommandLine& line);

// Afterwards: the pieces' patterns as one file, where the format is text or Markdown; those that were not written are
// passed over. The error is one sentence.
std::optional<std::string> join_patterns(const CommandLine& line, const std::vector<CommandLine>& pieces);

}  // namespace app
