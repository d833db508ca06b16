// What can be taken home: one table, from which the options, the File menu, the dialog and the list of all actions
// follow. All show the session's position.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/session/action.h"

namespace app {

// Wavefront OBJ of quads and triangles: stitches row by row in knitting order, a group a row. Before faces
// are made, a row is a closed line.
std::string mesh_text(const Session& session);
// The same of any fabric; `remark`: lines of comment, or empty.
std::string mesh_text_of(const knit::Fabric& fabric, std::string_view remark);

// Appendix A's form: "1: [5, 5, 5, 5, 5, 5]".
std::string map_text(const Session& session);

// JSON; the fields are documented in docs/command-line.md.
std::string report_text(const Session& session);

// One JSON object a step, up to the position.
std::string steps_text(const Session& session);

// What an export is about: the File menu lists them by it.
enum class ExportAbout : std::uint8_t { piece, figures, pattern, run, session };

// The formats among which the file's ending chooses.
struct ExportEndings {
  std::string_view what;   // "glTF" cannot be written as ...
  std::string_view words;  // ".glb or .gltf"; empty: any name will do
  bool (*fit)(const std::filesystem::path& path) = nullptr;
};

struct ExportInfo {
  std::string_view key;     // Export and the option --save-KEY call it so
  std::string_view words;   // "stitch map"; empty: neither in the menu nor in the list of all actions
  std::string_view ending;  // of the suggested name: "-map.txt"
  ExportAbout about = ExportAbout::piece;
  std::string_view help;  // of the option
  // Null: a picture, which the window takes.
  std::optional<std::string> (*write)(const Session& session, const std::filesystem::path& path,
                                      std::span<const std::uint8_t> picture_png) = nullptr;
  // Why there is nothing to write yet, in one sentence; null: there always is.
  std::optional<std::string> (*missing)(const Session& session) = nullptr;
  ExportEndings endings = {};
  bool opens_again = false;  // with File, Open
};

// In the order of the options.
std::span<const ExportInfo> exports();
// Those with words, in the order of the File menu.
std::vector<const ExportInfo*> exports_of_menu();
// Null: nothing has this key.
const ExportInfo* find_export(std::string_view key);

// "--save-map", "--screenshot"
std::string option_of(const ExportInfo& info);
// One sentence where the ending is none of its formats; `blamed` begins it: "--save-gltf cannot be \"a.b\"".
std::optional<std::string> fault_of_ending(const ExportInfo& info, const std::filesystem::path& path,
                                           const std::string& blamed);
// A pattern's page, for which a picture of the finished piece is made where pictures are.
bool wants_picture(const Export& wish);
// A worksheet, which is written where pictures are: it has one a page.
inline bool is_worksheet(const Export& wish) { return wish.what == "worksheet"; }

// The error is one sentence.
std::optional<std::string> export_to_file(const Session& session, const Export& wish,
                                          std::span<const std::uint8_t> picture_png = {});

}  // namespace app
