// The pattern in the format that a file's name asks for, and the chart as a drawing.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "app/core/session.h"

namespace app {

enum class PatternFormat : std::uint8_t { text, markdown, html, json, knitspeak };

// By the ending: .txt, .md, .html, .json, .ks; "-" is plain text. None for any other.
std::optional<PatternFormat> pattern_format_of(const std::filesystem::path& path);
inline constexpr const char* pattern_endings = ".txt, .md, .html, .json or .ks";

// What a needle may measure, as text: nothing where that is no number from 0.5 to 50.
std::optional<double> needle_mm_of(std::string_view text);
inline constexpr const char* needle_range = "a number from 0.5 to 50";

// Why there is no pattern yet; nothing when it can be written.
std::optional<std::string> pattern_missing(const Session& session);

// Both require that nothing is missing. `picture_png`: of the finished object, for HTML; may be empty.
std::string pattern_file_text(const Session& session, PatternFormat format,
                              std::span<const std::uint8_t> picture_png = {});
std::string chart_file_text(const Session& session);

}  // namespace app
