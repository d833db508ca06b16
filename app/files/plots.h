// The plots of the panels as a file, for paper and for other programs.
//
// SVG: stitches a row with their ideal, those that a rhythm plans (where there is one), the mean course length of each row, and how course edges, wale edges
// and corner angles are spread; black on white, in millimetres, with axes. CSV: the same numbers, a header
// line and one value a line: plot,series,from,to,value. Of a plot by rows `from` and `to` are both the row's
// number; of a histogram they are the ends of a bin and the value is a count.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/session/session.h"

namespace app {

enum class PlotsFormat : std::uint8_t { svg, csv };

// By the ending: .svg or .csv. None for any other.
std::optional<PlotsFormat> plots_format_of(const std::filesystem::path& path);
inline constexpr const char* plots_endings = ".svg or .csv";

// Why there are none yet; nothing when they can be written.
std::optional<std::string> plots_missing(const Session& session);

// At the session's position. Requires that nothing is missing.
std::string plots_file_text(const Session& session, PlotsFormat format);

}  // namespace app
