// What can be taken home: the knit mesh, the label map, the report, the log of steps. All show the session's
// position.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/session/action.h"

namespace app {

// Wavefront OBJ of quads and triangles: stitches row by row in knitting order, a group a row. Before faces
// are made, a row is a closed line.
std::string mesh_text(const Session& session);

// Appendix A's form: "1: [5, 5, 5, 5, 5, 5]".
std::string map_text(const Session& session);

// JSON; the fields are documented in docs/command-line.md.
std::string report_text(const Session& session);

// One JSON object a step, up to the position.
std::string steps_text(const Session& session);

// Requires an open mesh; every kind but `picture`. The error is one sentence.
std::optional<std::string> export_to_file(const Session& session, ExportKind kind,
                                          const std::filesystem::path& path);

// The written pattern; the format follows the file's ending. `picture_png` is for HTML and may be empty.
std::optional<std::string> export_pattern(const Session& session, const std::filesystem::path& path,
                                          std::span<const std::uint8_t> picture_png = {});

}  // namespace app
