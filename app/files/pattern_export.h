// The pattern, its chart and its picture of pieces as files; see docs/pattern.md.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/pattern_json.h"
#include "app/files/pattern_knitspeak.h"
#include "app/files/pattern_page.h"
#include "app/session/session.h"

namespace app {

// The pattern in the format that a file's name asks for, and the chart as a drawing.

enum class PatternFormat : std::uint8_t { text, markdown, html, json, knitspeak };

// By the ending: .txt, .md, .html, .json, .ks; "-" is plain text. None for any other.
std::optional<PatternFormat> pattern_format_of(const std::filesystem::path& path);
inline constexpr const char* pattern_endings = ".txt, .md, .html, .json or .ks";

// What a needle may measure, as text: nothing where that is no number from 0.5 to 50.
std::optional<double> needle_mm_of(std::string_view text);
inline constexpr const char* needle_range = "a number from 0.5 to 50";

// Why there is no pattern yet; nothing when it can be written.
std::optional<std::string> pattern_missing(const Session& session);

// Why there is no chart, no picture of the pieces, or no pattern in this format.
std::optional<std::string> chart_missing(const Session& session);
std::optional<std::string> pieces_missing(const Session& session);
std::optional<std::string> format_missing(const Session& session, PatternFormat format);

// How to begin, the rounds and the remarks between them, as on the written page; empty while there is no pattern.
std::vector<std::string> pattern_instructions(const Session& session);

// All require that nothing is missing. `picture_png`: of the finished object, for HTML; may be empty.
std::string pattern_file_text(const Session& session, PatternFormat format,
                              std::span<const std::uint8_t> picture_png = {});
// Of pieces one drawing with a chart for each.
std::string chart_file_text(const Session& session);
// Of the piece that is chosen (Gaze::chart_piece), else of the one with the round at hand, else of the first. In pieces.
std::string piece_chart_file_text(const Session& session);
std::string pieces_file_text(const Session& session);

}  // namespace app
