#include "app/script/pieces.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <utility>

#include "app/base/files.h"
#include "app/files/load.h"
#include "app/files/pattern_export.h"
#include "knit/import/quoting.h"

namespace app {

namespace fs = std::filesystem;

namespace {

// "out.obj" of the second piece: "out-2.obj".
fs::path path_of_piece(const fs::path& path, std::size_t number) {
  if (path == "-") return path;
  return path.parent_path() /
         (path.stem().string() + "-" + std::to_string(number) + path.extension().string());
}

CommandLine line_of_piece(CommandLine line, std::size_t number, std::size_t count) {
  const OpenFile file = line.open.get<OpenFile>();
  line.open = of_piece(file, number);
  line.every_piece = false;
  if (count == 1) return line;
  const std::string title =
      line.pattern.title.empty() ? knit::printable(file.path.stem().string()) : line.pattern.title;
  line.pattern.title = title + ", piece " + std::to_string(number) + " of " + std::to_string(count);
  for (Export& wish : line.saves) wish.path = path_of_piece(wish.path, number);
  if (line.picture) line.picture->path = path_of_piece(line.picture->path, number);
  if (line.animation) line.animation->path = path_of_piece(line.animation->path, number);
  return line;
}

bool is_joined(const Export& wish) {
  if (wish.what != "pattern" || wish.path == "-") return false;
  const auto format = pattern_format_of(wish.path);
  return format == PatternFormat::text || format == PatternFormat::markdown;
}

std::string joined_text(const std::vector<fs::path>& paths) {
  std::string text;
  for (const fs::path& path : paths) {
    std::ifstream in(path, std::ios::binary);
    if (!in) continue;
    if (!text.empty()) text += "\n\n";
    text.append(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  return text;
}

}  // namespace

OpenFile of_piece(OpenFile open, std::size_t number) {
  std::erase_if(open.repairs.kinds, [](knit::RepairKind kind) {
    return kind == knit::RepairKind::largest_piece || knit::piece_kept(kind) > 0;
  });
  open.repairs.kinds.push_back(knit::keeping_piece(number));
  return open;
}

std::variant<std::vector<CommandLine>, std::string> lines_of_pieces(const CommandLine& line) {
  const OpenFile& file = line.open.get<OpenFile>();
  const auto counted = count_pieces(file.path, file.repairs);
  if (const auto* error = std::get_if<std::string>(&counted)) return *error;
  const std::size_t count = std::max<std::size_t>(std::get<std::size_t>(counted), 1);
  if (count > most_pieces_knitted) {
    return "--piece all knits at most " + std::to_string(most_pieces_knitted) + " pieces, and " +
           knit::printable(file.path.string()) + " is in " + std::to_string(count) +
           "; give --repair weld, if they should hang together, or one piece.";
  }
  std::vector<CommandLine> lines;
  for (std::size_t number = 1; number <= count; ++number) lines.push_back(line_of_piece(line, number, count));
  return lines;
}

std::optional<std::string> join_patterns(const CommandLine& line, const std::vector<CommandLine>& pieces) {
  if (pieces.size() < 2) return std::nullopt;
  for (std::size_t i = 0; i < line.saves.size(); ++i) {
    if (!is_joined(line.saves[i])) continue;
    std::vector<fs::path> parts;
    parts.reserve(pieces.size());
    for (const CommandLine& piece : pieces) parts.push_back(piece.saves[i].path);
    const std::string text = joined_text(parts);
    if (text.empty()) continue;
    if (auto error = write_file(line.saves[i].path, text)) return error;
    std::error_code ignored;
    for (const fs::path& part : parts) fs::remove(part, ignored);
  }
  return std::nullopt;
}

}  // namespace app
